#!/bin/sh
# client.sh -- runs a test that needs a program of others: client.sh PROGRAM COMMAND...
#
# Without the program the test fails, or is skipped (exit status 77) when PELAGE_CLIENTS_OPTIONAL
# is set. "npm" stands for the packages of package-lock.json in this folder.
program=$1
shift
folder=$(dirname "$0")

missing() {
    echo "$1"
    [ -n "$PELAGE_CLIENTS_OPTIONAL" ] && exit 77
    echo "./dev test installs it; set PELAGE_CLIENTS_OPTIONAL=1 to skip what needs it"
    exit 1
}

if [ "$program" = npm ]; then
    command -v node >/dev/null || missing "node is not installed (Debian: nodejs)"
    [ -d "$folder/node_modules/three" ] && [ -d "$folder/node_modules/gltf-validator" ] ||
        missing "the npm packages are not installed (npm ci in tests/clients)"
else
    command -v "$program" >/dev/null || missing "$program is not installed (Debian: $program)"
fi
exec "$@"
