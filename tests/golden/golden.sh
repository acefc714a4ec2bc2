#!/bin/bash
# golden.sh PROGRAM COMPARE NAME -- draws one case of cases.txt and compares it with NAME.png.
# With BLESS=1 the picture becomes the accepted one. On failure it leaves NAME.out.png and
# NAME.diff.png here.
set -euo pipefail
program=$1 compare=$2 name=$3
cd "$(dirname "${BASH_SOURCE[0]}")"

line=$(grep -E "^$name +" cases.txt) || {
    echo "golden: cases.txt has no case $name"
    exit 1
}
read -r _ mean box coverage options <<<"$line"
read -ra options <<<"$options"
# Names of presets hold spaces, words of this file do not.
for i in "${!options[@]}"; do
    [ "${options[$i]}" = --preset ] && options[i + 1]=${options[$((i + 1))]//_/ }
done

out=$name.out.png
"$program" render "${options[@]}" --size 256x256 --samples 16 --repeat 1 -o "$out"
if [ "${BLESS:-}" = 1 ]; then
    mv "$out" "$name.png"
    rm -f "$name.diff.png"
    echo "golden: accepted $name.png"
    exit 0
fi
if [ ! -f "$name.png" ]; then
    echo "golden: $name.png is not there; accept $out with tests/golden/bless.sh"
    exit 1
fi
if "$compare" "$name.png" "$out" "$mean" "$box" "$coverage" "$name.diff.png"; then
    rm -f "$out" "$name.diff.png"
else
    echo "golden: $name differs; see tests/golden/$out and tests/golden/$name.diff.png"
    exit 1
fi
