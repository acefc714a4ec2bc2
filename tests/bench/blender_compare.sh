#!/bin/bash
# blender_compare.sh PROGRAM [BENCH] -- hair in Blender and in Pelage, one after the other in one run.
#
# Both get the same mesh of 126,000 triangles, 8 segments a hair and 900x900 pixels; Blender 90,000
# hairs, Pelage 100,000. Times are medians except Blender's first generation.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(realpath "$1")
bench=$(realpath "${2:-$(dirname "$program")/pelage_bench}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$program" animal --triangles 126000 -o "$work/animal.glb" >"$work/animal.txt"

# Workbench draws with OpenGL and wants a display, also in the background.
xvfb-run -a -s "-screen 0 1280x1024x24" blender -b --factory-startup \
    --python-exit-code 1 --python "$here/blender_compare.py" \
    -- "$work/animal.glb" 90000 8 "$work/blender.json" >"$work/blender.txt" 2>&1 || {
    tail -5 "$work/blender.txt"
    echo "blender_compare: Blender failed"
    exit 1
}
"$program" render "$work/animal.glb" --hairs 100000 --detail all --size 900x900 --samples 1 \
    --repeat 15 -o "$work/frame.png" --json >"$work/frame.json"
"$bench" --benchmark_filter='BM_(Scatter/hairs:90000|GrowCurves/hairs:90000/rods:0)' --benchmark_format=json \
    --benchmark_min_time=0.02 --benchmark_repetitions=25 \
    >"$work/bench.json" 2>/dev/null

python3 - "$work" <<'PYTHON'
import json
import sys

work = sys.argv[1]
blender, frame, bench = (
    json.load(open(f"{work}/{name}.json")) for name in ("blender", "frame", "bench")
)
ms = {
    run["name"].split("/")[0]: run["real_time"]
    for run in bench["benchmarks"]
    if run.get("aggregate_name") == "median"
}
grow = ms["BM_GrowCurves"]
scatter = ms["BM_Scatter"]


def row(what, theirs, ours):
    print(f"{what:<44} {theirs:>10.1f} {ours:>10.1f} {theirs / ours:>8.1f}")


print(f"Blender {blender['version']}: {blender['hairs']} hairs, {blender['triangles']} triangles")
print(
    f"Pelage: {frame['hairsDrawn']} of {frame['hairsTotal']} hairs not hidden, none culled by distance, "
    f"{frame['triangles']} triangles, {frame['device']}"
)
print(f"{'ms':<44} {'Blender':>10} {'Pelage':>10} {'ratio':>8}")
row("frame of 900x900 (Workbench; strands)", blender["msRender"], frame["msFrame"])
row("frame after an edit of the mesh or the fur", blender["msEdit"] + blender["msRender"], frame["msFrame"])
row("hairs of 8 segments on the CPU, roots known", blender["msEdit"], grow)
row("hairs of 8 segments on the CPU, with roots", blender["msGenerate"], grow + scatter)
PYTHON
