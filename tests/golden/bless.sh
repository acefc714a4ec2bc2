#!/bin/bash
# bless.sh [PROGRAM] [NAME...] -- draws the cases (all, or those named) and accepts what comes out.
# Look at every picture that changed before you commit it.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(realpath "${1:-$here/../../build/release/pelage}")
[ $# -gt 0 ] && shift
names=("$@")
[ ${#names[@]} -gt 0 ] || mapfile -t names < <(sed -n 's/^\([a-z][^ ]*\) .*/\1/p' "$here/cases.txt")
for name in "${names[@]}"; do
    BLESS=1 "$here/golden.sh" "$program" none "$name"
done
