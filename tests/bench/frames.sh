#!/bin/bash
# frames.sh PROGRAM -- ms of a frame with skin, hair of 8 segments and color at 900x900.
set -euo pipefail
program=$1
picture=$(mktemp --suffix=.png)
trap 'rm -f "$picture"' EXIT
for hairs in 100000 500000; do
    "$program" render --animal 126000 --hairs "$hairs" --size 900x900 --samples 1 --repeat 15 \
        -o "$picture" --json
done
