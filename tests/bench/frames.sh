#!/bin/bash
# frames.sh PROGRAM -- ms of a frame with skin, hair of 8 segments and color at 900x900.
set -euo pipefail
program=$1
picture=$(mktemp --suffix=.png)
trap 'rm -f "$picture"' EXIT
# All hairs; those that the paper's rule keeps at this distance; and a drag, at most 45 ms a frame.
for options in "--hairs 100000 --detail all" "--hairs 500000 --detail all" "--hairs 500000" \
    "--hairs 500000 --detail distance,ms:45"; do
    echo "$options"
    # shellcheck disable=SC2086 -- several options in one word
    "$program" render --animal 126000 $options --size 900x900 --samples 1 --repeat 15 \
        -o "$picture" --json
done
