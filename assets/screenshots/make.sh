#!/bin/bash
# make.sh [PROGRAM] [MESHES] -- makes the pictures of the README. MESHES is a folder with
# stanford-bunny.obj and Fox.glb; without them their pictures stay as they are.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(realpath "${1:-$here/../../build/release/pelage}")
meshes=${2:-$here/../../../shared/meshes}
cd "$here"

picture() {
    "$program" render --size 1000x750 --samples 64 --repeat 1 -o "$1" "${@:2}"
}
picture animal.png --animal 100000 --yaw 40 --pitch 12 --distance 1.65
picture close-up.png --animal 100000 --yaw 50 --pitch 15 --distance 0.75
if [ -f "$meshes/stanford-bunny.obj" ]; then
    picture bunny.png --hairs 300000 --yaw -20 --pitch 10 -- "$meshes/stanford-bunny.obj"
fi
if [ -f "$meshes/Fox.glb" ]; then
    picture fox.png --yaw 50 --pitch 10 -- "$meshes/Fox.glb"
fi

# The paper's figures 4 to 10 as the golden pictures have them, and its figure 8 on another mesh.
sheet=$(mktemp -d)
trap 'rm -rf "$sheet"' EXIT
if [ -f "$meshes/suzanne.obj" ]; then
    for style in line polyline ribbon nurbs-curve nurbs-surface; do
        "$program" render --size 256x256 --samples 16 --repeat 1 --yaw 25 --pitch 8 \
            --preset "monkey 9" --technique "$style" -o "$sheet/suzanne-$style.png" \
            -- "$meshes/suzanne.obj" >"$sheet/log"
    done
    font=$(find /usr/share/fonts -iname Roboto-Regular.ttf | head -1)
    montage ${font:+-font "$font"} -label '%t' ../../tests/golden/paper-*.png "$sheet"/suzanne-*.png -tile 6x \
        -geometry 200x200+2+2 -background white -quality 90 paper.jpg
fi

# The field in shells, in the wind.
"$program" render --size 1000x560 --samples 64 --repeat 1 --field 60000 --technique shells \
    --shell-shadows --time 1 --yaw 20 --pitch 22 --distance 1.35 -o "$sheet/field.png" >"$sheet/log"
convert "$sheet/field.png" -quality 90 field.jpg

# Every preset on the animal.
names=(default doormat fox grass "house cat short hair" meadow mink "monkey 8" "monkey 9" plush rabbit
    "wolf winter coat")
font=$(find /usr/share/fonts -iname Roboto-Regular.ttf | head -1)
files=()
for name in "${names[@]}"; do
    files+=("$sheet/$name.png")
    "$program" render --size 480x400 --samples 32 --repeat 1 --animal 60000 --yaw 62 --pitch 12 \
        --distance 1.9 --preset "$name" -o "$sheet/$name.png" >"$sheet/log"
done
montage ${font:+-font "$font"} -label '%t' "${files[@]}" -tile 6x -geometry 240x200+2+2 \
    -background white -quality 85 presets.jpg

# The same fur as strands and in shells with fins: close, as framed, and far.
tiles=()
pair() {
    local name=$1 framed technique factor
    shift
    framed=$("$program" render --size 32x32 --repeat 1 -o "$sheet/framed.png" --json "$@" |
        grep -o '"distance":[0-9.]*' | cut -d: -f2)
    for factor in 0.45 1 2.5; do
        for technique in strands shells-fins; do
            "$program" render --size 300x300 --samples 32 --repeat 1 --yaw 50 --pitch 12 \
                --distance "$(awk "BEGIN { print $framed * $factor }")" --over "$technique" \
                --under "$technique" -o "$sheet/$name-$factor-$technique.png" "$@" >"$sheet/log"
            tiles+=(-label "$technique" "$sheet/$name-$factor-$technique.png")
        done
    done
}
if [ -f "$meshes/stanford-bunny.obj" ] && [ -f "$meshes/Fox.glb" ]; then
    pair animal --animal 100000
    pair bunny -- "$meshes/stanford-bunny.obj"
    pair fox -- "$meshes/Fox.glb"
    montage ${font:+-font "$font"} "${tiles[@]}" -tile 6x -geometry 200x200+2+2 \
        -background white -quality 88 shells.jpg
fi

# The real window, on a display of its own.
export XDG_STATE_HOME=$(mktemp -d) XDG_CONFIG_HOME=$(mktemp -d)
trap 'rm -rf "$sheet" "$XDG_STATE_HOME" "$XDG_CONFIG_HOME"' EXIT
xvfb-run -a -s "-screen 0 1280x720x24" bash -c '
    "$1" &
    editor=$!
    sleep "${SECONDS_TO_SETTLE:-30}"
    import -window root window.png
    xdotool key shift+n
    sleep "${SECONDS_TO_MEASURE:-60}"
    import -window root -quality 90 accuracy.jpg
    kill "$editor"
    wait "$editor" || true
' _ "$program"
