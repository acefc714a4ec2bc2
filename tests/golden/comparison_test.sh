#!/bin/bash
# comparison_test.sh COMPARE -- the comparer itself: equal pictures pass, others fail for their reason.
set -euo pipefail
compare=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# picture NAME GRAY X Y W H: 64x64, gray background, a white rectangle
picture() {
    convert -size 64x64 "xc:gray($2)" -fill white \
        -draw "rectangle $3,$4 $(($3 + $5 - 1)),$(($4 + $6 - 1))" -depth 8 "PNG24:$1.png"
}
# expect STATUS WORD NEW MEAN BOX COVERAGE
expect() {
    local status=0
    "$compare" a.png "$3.png" "$4" "$5" "$6" diff.png >out.txt 2>&1 || status=$?
    cat out.txt
    if [ "$status" != "$1" ] || ! grep -q "$2" out.txt; then
        echo "expected status $1 with \"$2\", got $status for $3"
        exit 1
    fi
}

picture a 50 8 8 24 24
picture shifted 50 9 8 24 24
picture bigger 50 8 8 25 24
picture darker 49 8 8 24 24
convert -size 32x32 xc:gray PNG24:small.png

expect 0 "mean .*0.00000" a 0 0 0
[ ! -e diff.png ] || { echo "a difference was written for equal pictures"; exit 1; }
expect 0 "coverage .*0.14062" a 0 0 0
expect 1 "largest 4x4 .*FAILED" shifted 255 10 1
[ -s diff.png ] || { echo "no difference was written"; exit 1; }
expect 1 "its difference .*FAILED" bigger 255 255 0.005
expect 0 "its difference .*0.00586" bigger 255 255 0.006
expect 1 "mean .*FAILED" darker 0.8 255 1
expect 1 "small.png: 32x32 pixels, expected 64x64" small 255 255 1
expect 1 "none.png: " none 255 255 1
echo "the comparer is right"
