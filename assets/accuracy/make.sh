#!/bin/bash
# make.sh [BUILD] [MESHES] -- makes the small reports of this folder anew: speed against error of the
# animal, the bunny and the fox, and how costs grow. BUILD is a configured build folder. MESHES has
# stanford-bunny.obj and Fox.glb; what is not there keeps its report as it was.
#
# SIZE, SPP and HAIRS in the environment make it faster: pixels of a side, samples of a reference,
# and hairs on each model. OUT is another folder to write to.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$(realpath "${1:-$here/../../build/release}")
meshes=${2:-$here/../../../shared/meshes}
out=${OUT:-$here}
cmake --build "$build" --target pelage pelage_costs
report=$(mktemp -d)
trap 'rm -rf "$report"' EXIT

measure() {
    echo "$1:" >&2
    "$build/pelage" measure --size "${SIZE:-256}" --spp "${SPP:-256}" -o "$report" \
        ${HAIRS:+--hairs "$HAIRS"} "${@:2}"
    cp "$report/report.csv" "$out/$1.csv"
    cp "$report/plot.svg" "$out/$1.svg"
}
measure_file() {
    if [ -f "$2" ]; then
        measure "$1" -- "$2"
    else
        echo "$2 is not there: no report of the $1"
    fi
}
measure animal --animal 100000
measure_file bunny "$meshes/stanford-bunny.obj"
measure_file fox "$meshes/Fox.glb"
"$build/pelage_costs" "$out"
