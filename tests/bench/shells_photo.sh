#!/bin/bash
# shells_photo.sh PROGRAM MESHES -- the two meshes of Ukaji et al. in 16 layers of one photograph of
# 256x256 pixels, in one run: frames a second, and how many times as fast the smaller mesh is.
#
# The paper has 1,648 frames a second for a teapot of 2,082 vertices and 138 for the bunny of 34,832, at
# 256x256 pixels. The photograph is one of our own strands, from above.
set -euo pipefail
program=$(realpath "$1")
meshes=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cat >"$work/sheet.obj" <<'OBJ'
v -0.5 0 -0.5
v 0.5 0 -0.5
v 0.5 0 0.5
v -0.5 0 0.5
f 1 4 3 2
OBJ
"$program" render "$work/sheet.obj" --preset "house cat short hair" --hairs 60000 --yaw 0 --pitch 88 \
    --distance 0.55 --size 256x256 --samples 16 -o "$work/fur.png" >"$work/fur.txt"
for mesh in teapot stanford-bunny; do
    for size in 256 900; do
        for technique in shells shells-instanced; do
            "$program" render "$meshes/$mesh.obj" --technique "$technique" --shell-photo "$work/fur.png" \
                --layers 16 --size "${size}x$size" --samples 1 --repeat 15 \
                -o "$work/$mesh-$technique-$size.png" --json >"$work/$mesh-$technique-$size.json"
        done
        "$program" compare "$work/$mesh-shells-$size.png" "$work/$mesh-shells-instanced-$size.png" --json \
            >"$work/$mesh-$size.json"
    done
done

python3 - "$work" <<'PYTHON'
import json
import sys

work = sys.argv[1]


def of(name):
    with open(f"{work}/{name}.json") as file:
        return json.load(file)


pixels = of("teapot-shells-256")
print(f"16 layers, texture with its mips {pixels['textureBytes'] / 1024:.0f} KiB, "
      f"stored {pixels['storedLayersBytes'] / 1024:.0f} KiB, on {pixels['device']}")
for size in (256, 900):
    for technique in ("shells", "shells-instanced"):
        teapot, bunny = (1000.0 / of(f"{mesh}-{technique}-{size}")["msFrame"]
                         for mesh in ("teapot", "stanford-bunny"))
        print(f"{size}x{size} {technique:<17} teapot {teapot:6.1f}, bunny {bunny:6.1f} frames a second, "
              f"{teapot / bunny:.2f} : 1 (Ukaji et al. 12 : 1)")
    for mesh in ("teapot", "stanford-bunny"):
        compared = of(f"{mesh}-{size}")
        print(f"{size}x{size} {mesh}: shells against shells-instanced: FLIP {compared['flipMean']:.4f}, "
              f"brightness {compared['luminanceBias']:+.1%}")
PYTHON
