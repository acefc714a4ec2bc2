#!/bin/bash
# shells_compare.sh PROGRAM -- fur in layers, in one run: one pass of Pelage against the skin drawn
# once for each layer, by Pelage and by three.js in Chromium.
#
# All draw the same animal of 126,000 triangles at 900x900 with LAYERS (32) layers; times are medians.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(realpath "$1")
layers=${LAYERS:-32}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$program" animal --triangles 126000 -o "$work/animal.glb" >"$work/animal.txt"
for technique in shells shells-plain shells-instanced; do
    "$program" render "$work/animal.glb" --hairs 100000 --size 900x900 --samples 1 --repeat 7 \
        --yaw 40 --pitch 12 --technique "$technique" --layers "$layers" -o "$work/$technique.png" \
        --json >"$work/$technique.json"
done
python3 "$here/three_shells.py" "$work" "$here/../clients/node_modules" "$layers"
"$program" compare "$work/shells.png" "$work/shells-instanced.png" --json >"$work/compare.json"

python3 - "$work" <<'PYTHON'
import json
import statistics
import sys

work = sys.argv[1]


def of(name):
    return json.load(open(f"{work}/{name}.json"))


three = of("three")
one = of("shells")["msFrame"]
print(f"{three['triangles']:.0f} triangles, {three['layers']} layers, 900x900; ms of a frame")
rows = [(name, of(name)["msFrame"]) for name in ("shells", "shells-plain", "shells-instanced")]
rows.append((f"three.js {three['version']}", statistics.median(three["times"])))
for name, ms in rows:
    print(f"{name:<20} {ms:>8.1f}   {ms / one:>5.1f} x")
print(f"three.js on {three['renderer']}, {three['covered']:.0%} of the picture covered")
compared = of("compare")
print(
    f"shells against shells-instanced: FLIP {compared['flipMean']:.4f}, "
    f"brightness {compared['luminanceBias']:+.1%}"
)
PYTHON
