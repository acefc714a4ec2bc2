#!/bin/bash
# figures.sh -- runs the tests that say figures (tests/figures.h) and writes them as a table.
# Usage: tests/figures.sh [BUILD] > assets/accuracy/figures.md. BUILD, build/release if none is
# named, has the tests built.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build/release}

# All suites of the files of a folder that include figures.h, as gtest filters.
suites() {
    grep -l 'figures\.h"' "tests/$1"/*.cpp | xargs -r sed -n 's/^TEST(\([A-Za-z]*\),.*/\1.*/p' |
        sort -u | paste -sd:
}

figures() {
    local part
    for part in core hard gl; do
        "$build/${part}_tests" --gtest_filter="$(suites "$part")" >"$log" || {
            grep -B 5 FAILED "$log" >&2
            exit 1
        }
        sed -n 's/^figure //p' "$log"
    done
}

log=$(mktemp)
trap 'rm -f "$log"' EXIT
lines=$(figures)
cat <<'TEXT'
# What was promised and what was reached
Each line is said by a test, which fails where the figure is worse than what is allowed; costs, which
depend on the machine, are only measured. Lengths are those of the hair where nothing else is said.
H: the shape of hair. R: roots and levels of detail. I: images. S: shading.
U: layers from a photograph.
Made by `tests/figures.sh`.

| row | what | reached | allowed | test |
|---|---|---|---|---|
TEXT
sort -s -t'|' -k2,2V <<<"$lines"
