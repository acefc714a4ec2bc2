#!/bin/bash
# make.sh [BUILD] [MESHES] -- makes the small reports of this folder anew: speed against error of the
# animal, the bunny and the fox, and how costs grow. BUILD holds pelage and pelage_costs. MESHES is a
# folder with stanford-bunny.obj and Fox.glb; without them theirs stay as they are.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$(realpath "${1:-$here/../../build/release}")
meshes=${2:-$here/../../../shared/meshes}
report=$(mktemp -d)
trap 'rm -rf "$report"' EXIT

measure() {
    "$build/pelage" measure --size "${SIZE:-320}" --spp "${SPP:-256}" -o "$report" "${@:2}"
    cp "$report/report.csv" "$here/$1.csv"
    cp "$report/plot.svg" "$here/$1.svg"
}
measure animal --animal 100000
if [ -f "$meshes/stanford-bunny.obj" ]; then
    measure bunny --hairs 300000 -- "$meshes/stanford-bunny.obj"
fi
if [ -f "$meshes/Fox.glb" ]; then
    measure fox -- "$meshes/Fox.glb"
fi
"$build/pelage_costs" "$here"
