#!/bin/bash
# cli_test.sh PROGRAM -- every verb: what it prints, its errors of one line, its exit status.
set -uo pipefail
program=$(realpath "$1")
tail=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../golden/tail.gltf")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
unset DISPLAY WAYLAND_DISPLAY
export XDG_DATA_HOME=$work/data
for tool in node identify convert compare xmllint; do
    command -v $tool >/dev/null && continue
    echo "$tool is not installed (Debian: nodejs, imagemagick, libxml2-utils)"
    exit 1
done
failures=0

fail() {
    echo "FAILED: $*"
    failures=$((failures + 1))
}

# expect STATUS ARGUMENTS...: runs the program; its output is then in out.txt and err.txt.
expect() {
    local wanted=$1 status=0
    shift
    "$program" "$@" >out.txt 2>err.txt || status=$?
    [ "$status" = "$wanted" ] || fail "exit status $status, expected $wanted: pelage $* ($(cat err.txt))"
}
# Success: nothing on stderr but what was done in how many seconds.
good() {
    expect 0 "$@"
    ! grep -qvE '^[^:]+(: [^:]+)?: [0-9]+\.[0-9] s$' err.txt || fail "stderr of pelage $*: $(cat err.txt)"
}
# good, and stdout is one JSON object for which every JavaScript expression over j is true.
json() {
    local checks=()
    while [ "$1" != -- ]; do
        checks+=("$1")
        shift
    done
    shift
    good "$@"
    for check in "${checks[@]}"; do
        node -e '
            const text = require("fs").readFileSync("out.txt", "utf8");
            if (text.indexOf("\n") !== text.length - 1) throw Error("not one line");
            const j = JSON.parse(text);
            if (!eval(process.argv[1])) throw Error(text);
        ' "$check" 2>node.txt || fail "pelage $*: not ($check): $(grep -m1 Error node.txt)"
    done
}
# bad STATUS PATTERN ARGUMENTS...: one line on stderr that matches, nothing on stdout.
bad() {
    local status=$1 pattern=$2
    shift 2
    expect "$status" "$@"
    [ ! -s out.txt ] || fail "stdout of pelage $*: $(head -1 out.txt)"
    [ "$(wc -l <err.txt)" = 1 ] || fail "stderr of pelage $* is not one line: $(cat err.txt)"
    grep -qE "^pelage: $pattern" err.txt || fail "stderr of pelage $*: $(cat err.txt)"
}
png_size() {
    identify -format '%wx%h' "$1" 2>&1
}

cat >tetra.obj <<'OBJ'
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
OBJ

# Help and version.
good --version
grep -qE '^pelage [0-9]+\.[0-9]+\.[0-9]+$' out.txt || fail "version: $(cat out.txt)"
good --help
for verb in info render export compare measure animal preset presets shells; do
    good --help
    grep -q "  $verb " out.txt || fail "help does not name $verb"
    good "$verb" --help
    grep -q -- --json out.txt || fail "help of $verb does not name --json"
done

# Presets.
good presets
grep -q '^house cat short hair  ' out.txt || fail "presets: $(cat out.txt)"
json 'j.presets.length >= 10' 'j.presets.some(p => p.name === "mink" && p.fur.over.stiffness > 0)' \
    -- presets --json
json 'j.presets.length >= 10' -- --json presets

# Animal.
good animal -o animal.glb --triangles 2000
[ "$(head -c 4 animal.glb)" = glTF ] || fail "animal.glb is no .glb"
json 'j.triangles >= 1800 && j.triangles <= 2200' 'j.output === "animal.glb"' 'j.bytes > 1000' \
    -- animal -o animal.glb --triangles 2000 --json
bad 2 'animal .*--triangles' animal -o animal.glb --triangles 1999
bad 2 'animal .*--triangles' animal -o animal.glb --triangles 2000001
bad 2 'animal .*--triangles' animal -o animal.glb --triangles many
bad 2 'animal .*--output is required' animal
bad 1 'no/such/folder/x.glb: ' animal --triangles 2000 -o no/such/folder/x.glb

# Info.
json 'j.vertices === 4' 'j.triangles === 4' 'j.weldedVertices === 4' 'j.nonManifoldEdges === 0' \
    'j.boundaryEdges === 0' 'j.degenerateFaces === 0' 'j.hasFur === false' 'j.joints === 0' \
    'j.animations === 0' 'Array.isArray(j.warnings)' 'Array.isArray(j.segments)' \
    'j.bounds.min.join() === "0,0,0"' 'j.bounds.max.join() === "1,1,1"' \
    'Object.keys(j.fields).length === 0' -- info tetra.obj --json
json 'j.hasFur === true' 'j.fields.length.max > j.fields.length.min' 'j.fields.density.max <= 1' \
    'j.fields.direction.max <= 1.0001' -- info animal.glb --json
good info tetra.obj
grep -qE '^  triangles +4$' out.txt || fail "info: $(cat out.txt)"
bad 1 'none\.obj: ' info none.obj
bad 1 'none\.obj: ' info none.obj --json
bad 1 '\.: ' info .
bad 2 'info .*FILE is required' info
bad 2 'info .*not expected: animal\.glb' info tetra.obj animal.glb
bad 2 'info .*--no-such-option' info --no-such-option tetra.obj
head -c 100 animal.glb >cut.glb
bad 1 'cut\.glb: ' info cut.glb
printf 'v 0 0 0\nf 1 2 3\n' >index.obj
bad 1 'index\.obj: ' info index.obj --json

# Any file name.
for name in info -x.obj --help 'a b.obj' '[x].obj' '{}' 'ü.obj' $'new\nline.obj' 'it"s.obj'; do
    case $name in *.obj) file=$name ;; *) file=$name.obj ;; esac
    cp tetra.obj "./$file"
    json 'j.triangles === 4' -- info --json -- "$file"
    good export -o named.glb -- "$file"
    json 'j.triangles === 4' 'j.hasFur' -- info --json named.glb
    rm named.glb
done
cp animal.glb ./info
cp animal.glb ./--json
json 'j.triangles > 4' 'j.hasFur' -- info --json info
json 'j.triangles > 4' -- info --json -- --json
cp tetra.obj $'bad\xffutf.obj'
json 'j.triangles === 4' -- info --json -- $'bad\xffutf.obj'
bad 1 'no such line.obj: ' info $'no\nsuch\nline.obj'

# Export.
json 'j.triangles === 4' 'j.vertices === 4' 'j.hairs === 5000' \
    -- export tetra.obj -o tetra.glb --preset mink --hairs 5000 --set over.stiffness=0.25 --set fur.seed=9 --json
json 'j.hasFur' -- info tetra.glb --json
grep -aq '"stiffness":0.25' tetra.glb || fail "--set is not in the export"
grep -aq '"seed":9' tetra.glb || fail "the second --set is not in the export"
good export --animal 2000 -o a.glb
good export --animal 2000 -o b.glb
cmp -s a.glb b.glb || fail "the same export twice differs"
good export --animal 2000 --compatibility-uvs -o c.glb
grep -aq TEXCOORD_4 c.glb || fail "no compatibility UVs"
printf 'set over.stiffness 0.75\nflood density set 0.5 strength 1\n' >lines.txt
good export --animal 2000 --script lines.txt -o d.glb
json 'j.fields.density.min === 0.5' 'j.fields.density.max === 0.5' -- info d.glb --json
printf 'set over.stiffness 0.75\nset over.stiffness 7\n' >wrong.txt
bad 1 'wrong\.txt: line 2: .*over\.stiffness is 7, range 0\.\.1' \
    export tetra.obj --script wrong.txt -o never.glb
printf 'save tetra.obj\n' >over.txt
bad 1 'over\.txt: line 1: save: "tetra\.obj" does not end in \.glb' \
    export tetra.obj --script over.txt -o never.glb
head -1 tetra.obj | grep -q '^v 0 0 0$' || fail "a script saved over the source"
json 'j.triangles === 64' -- export tetra.obj --subdivide 2 -o fine.glb --json
json 'j.triangles === 64' 'j.boundaryEdges === 0' 'j.spacing > 0' -- info fine.glb --json
good export tetra.obj --transfer tetra.glb -o taken.glb
grep -aq '"stiffness":0.25' taken.glb || fail "--transfer did not take the coats over"
expect 0 export fine.glb --transfer tetra.glb -o rounded.glb
grep -q 'tetra\.glb: .* farther than 5 %' err.txt || fail "--transfer did not tell of far vertices"
bad 1 'none\.glb: ' export tetra.obj --transfer none.glb -o never.glb
bad 2 'export .*--subdivide' export tetra.obj --subdivide 9 -o never.glb
bad 1 'none\.txt: ' export tetra.obj --script none.txt -o never.glb
bad 2 '--set over\.stiffness=3: over\.stiffness is 3, range 0\.\.1' \
    export tetra.obj --set over.stiffness=3 -o never.glb
bad 2 '--set over\.fluffiness=3: there is no parameter' export tetra.obj --set over.fluffiness=3 -o never.glb
bad 2 '--set stiff: expected NAME=VALUE' export tetra.obj --set stiff -o never.glb
bad 2 '--preset: there is no preset "poodle"' export tetra.obj --preset poodle -o never.glb
bad 2 'export .*--hairs' export tetra.obj --hairs 5000001 -o never.glb
bad 2 'expected a FILE, --animal N or --field N' export -o never.glb
bad 2 'export .*"tetra\.obj" does not end in \.glb' export tetra.obj -o tetra.obj
bad 2 'render .*"r\.jpg" does not end in \.png' render tetra.obj -o r.jpg
bad 2 'expected a FILE, --animal N or --field N' export tetra.obj --animal 2000 -o never.glb
bad 2 'export .*--output is required' export tetra.obj
[ ! -e never.glb ] || fail "a refused export wrote a file"

# Presets as files.
json 'j.name === "grey"' 'j.bytes < 60000' 'j.output === "grey.fur.json"' \
    -- preset --animal 2000 --preset 'wolf winter coat' --set over.stiffness=0.25 --set fur.seed=9 \
    --name grey --author Ann --note 'A sentence.' -o grey.fur.json --json
node -e '
    const j = JSON.parse(require("fs").readFileSync("grey.fur.json"));
    const jpeg = Buffer.from(j.thumbnail.replace("data:image/jpeg;base64,", ""), "base64");
    require("fs").writeFileSync("grey.jpg", jpeg);
    if (j.version !== 1 || j.author !== "Ann" || j.note !== "A sentence.") throw Error("texts");
    if (j.fur.over.stiffness !== 0.25 || j.fur.seed !== 9) throw Error("fur");
' || fail "grey.fur.json is not what was asked for"
[ "$(png_size grey.jpg)" = 192x192 ] || fail "grey.jpg: $(png_size grey.jpg)"
good export tetra.obj --preset grey.fur.json -o grey.glb
grep -aq '"stiffness":0.25' grey.glb || fail "the preset of a file is not in the export"
grep -aq '"seed":9' grey.glb || fail "the seed of a preset is not in the export"
printf 'preset ./grey.fur.json\n' >grey.txt
good export tetra.obj --script grey.txt -o grey2.glb
cmp -s grey.glb grey2.glb || fail "a preset by script differs from one by option"
json 'j.name === "again"' -- preset grey.glb -o again.fur.json --json
node -e '
    const [a, b] = ["grey", "again"].map(n => JSON.parse(require("fs").readFileSync(n + ".fur.json")));
    if (b.name !== undefined) throw Error(b.name);
    if (JSON.stringify([a.fur, a.thumbnail]) !== JSON.stringify([b.fur, b.thumbnail])) throw Error("fur");
' || fail "a preset of a groomed file differs"
mkdir -p data/pelage/presets
cp grey.fur.json data/pelage/presets/x.fur.json
json 'j.presets.some(p => p.name === "mink" && p.source === "program")' \
    'j.presets.some(p => p.name === "grey" && p.author === "Ann" && p.source === j.folder + "/x.fur.json")' \
    'j.warnings.length === 0' -- presets --json
good presets
grep -q '^grey  .*A sentence\. By Ann\. (.*/x\.fur\.json)$' out.txt || fail "presets: $(cat out.txt)"
good export tetra.obj --preset grey -o grey3.glb
cmp -s grey.glb grey3.glb || fail "one's own preset by name differs"
echo '{"fur": {"over": {"stiffness": 3}}}' >data/pelage/presets/bad.fur.json
json 'j.warnings.length === 1' -- presets --json
expect 0 presets
[ "$(wc -l <err.txt)" = 1 ] || fail "a damaged preset: $(cat err.txt)"
bad 2 '--preset: .*bad\.fur\.json: fur: over\.stiffness is 3, range 0\.\.1' \
    export tetra.obj --preset data/pelage/presets/bad.fur.json -o never.glb
bad 2 '--preset: none\.fur\.json: ' export tetra.obj --preset none.fur.json -o never.glb
bad 2 'preset .*"wolf\.json" does not end in \.fur\.json' preset tetra.obj -o wolf.json
bad 1 'long\.fur\.json: name: is 61 bytes long, at most 60' \
    preset tetra.obj -o long.fur.json --name "$(printf 'x%.0s' {1..61})"
bad 1 'no/such/x\.fur\.json: ' preset tetra.obj -o no/such/x.fur.json
[ ! -e never.glb ] && [ ! -e long.fur.json ] || fail "a refused preset wrote a file"

# Render.
json 'j.width === 96 && j.height === 64' 'j.hairsTotal > 1000' 'j.hairsDrawn <= j.hairsTotal' \
    'j.msFrame > 0' 'j.msFrames.length === 3' 'j.technique === "polyline"' 'j.bytesPerHair <= 16' \
    'j.samples === 2' 'j.device.length > 0' 'j.triangles >= 1800' \
    -- render --animal 2000 --hairs 3000 --size 96x64 --samples 2 --repeat 3 -o r.png --json
[ "$(png_size r.png)" = 96x64 ] || fail "r.png: $(png_size r.png)"
good render tetra.obj --size 64x64 --samples 1 --yaw -30 --pitch -10 --distance 3.5 \
    --technique polyline --preset fox --script lines.txt -o r2.png
grep -qE '^wrote r2\.png: 64x64, [0-9]+ of [0-9]+ hairs, ' out.txt || fail "render: $(cat out.txt)"
good render --animal 2000 --hairs 0 --size 32x32 --samples 1 -o bald.png
json 'j.detail === "flip:0.1" && j.flip > 0 && j.flip <= 0.1 && j.deviation > 0' \
    -- render --animal 2000 --hairs 3000 --size 64x64 --samples 2 --detail flip:0.1 -o f.png --json
json 'j.technique === "shells" && j.layers === 12' 'j.textureBytes > 0 && j.msShellPass > 0' \
    -- render --animal 2000 --hairs 3000 --size 64x64 --samples 1 --repeat 1 --technique shells \
    --layers 12 -o s.png --json
json 'j.shellShadows' -- render --field 2000 --size 64x64 --samples 1 --repeat 1 --technique shells \
    --shell-shadows -o s.png --json
good render tetra.obj --size 32x32 --technique shells-instanced --layers 3 --samples 1 -o s.png
grep -q '^wrote s\.png: 32x32, in shells, ' out.txt || fail "render: $(cat out.txt)"
json 'j.technique === "shells-fins" && j.fins > 0' -- render --animal 2000 --hairs 3000 --size 64x64 \
    --samples 1 --repeat 1 --technique shells-fins -o s.png --json
json 'j.technique === "polyline/shells-fins" && j.fins > 0 && j.hairsDrawn > 0' -- render --animal 2000 \
    --hairs 3000 --size 64x64 --samples 1 --repeat 1 --technique polyline --under shells-fins -o s.png --json
json 'j.technique === "polyline/shells"' 'j.hairsDrawn > 0 && j.textureBytes > 0 && j.msShellPass > 0' \
    -- render --animal 2000 --hairs 3000 --size 64x64 --samples 1 --repeat 1 --under shells -o s.png --json
json 'j.technique === "shells-plain/polyline"' 'j.hairsDrawn > 0' -- render --animal 2000 --hairs 3000 \
    --size 64x64 --samples 1 --repeat 1 --technique shells-plain --under strands -o s.png --json
json 'j.technique === "auto" && j.inShells.join() === "0,0"' 'j.hairsDrawn > 0' -- render --animal 2000 \
    --hairs 3000 --size 64x64 --samples 2 --repeat 1 --technique auto -o s.png --json
json 'j.inShells[0] === 0 && j.inShells[1] > 0 && j.technique === "polyline/auto"' -- render --animal 2000 \
    --hairs 300000 --size 64x64 --samples 2 --repeat 1 --under auto --detail share:1 -o s.png --json
good render tetra.obj --size 32x32 --over shells --samples 1 -o s.png
grep -q '^wrote s\.png: 32x32, .* hairs and shells, ' out.txt || fail "render: $(cat out.txt)"
json 'j.technique === "reference" && j.samples === 4 && j.segments === 7' 'j.hairs > 400' \
    'j.noise > 0 && j.noise < 0.2 && j.rays > 4 * 48 * 32' \
    -- render --animal 2000 --hairs 500 --size 48x32 --technique reference --spp 3 --segments 7 \
    -o reference.png --json
good render --animal 2000 --hairs 500 --size 48x32 --technique reference --spp 2 --shadows live \
    -o reference.png
[ "$(identify -format %wx%h reference.png)" = 48x32 ] || fail "the reference is of a wrong size"
grep -qE '^wrote reference\.png: 48x32, [0-9]+ hairs of [0-9]+ segments, 2 samples, noise ' out.txt ||
    fail "render: $(cat out.txt)"
# A sequence in the wind: its pictures are those of their times, and differ.
for technique in ribbon shells; do
    json 'j.frames === 2' -- render --field 2000 --hairs 5000 --size 48x48 --samples 1 --repeat 1 \
        --technique $technique --time 1 --frames 2 --rate 2 -o wind.png --json
    good render --field 2000 --hairs 5000 --size 48x48 --samples 1 --repeat 1 \
        --technique $technique --time 1.5 -o later.png
    cmp -s wind-0002.png later.png || fail "a sequence in $technique is not that of its times"
    if cmp -s wind-0001.png wind-0002.png; then fail "no wind in $technique"; fi
done
good render --animal 2000 --hairs 3000 --size 64x64 --samples 2 -o one.png
good render --animal 2000 --hairs 3000 --size 64x64 --samples 2 -o two.png
cmp -s one.png two.png || fail "the same picture twice differs"
json 'j.animations === 2' 'j.clips.map(c => c.name).join() === "curl,rise"' \
    'j.clips[0].seconds === 1' -- info "$tail" --json
for pose in "--clip curl --time 0.5" "--clip 1 --time 0.5" "--clip curl" ""; do
    # shellcheck disable=SC2086 -- several options in one word
    good render "$tail" $pose --hairs 2000 --size 64x64 --samples 1 -o "pose-${pose// /_}.png"
done
cmp -s pose---clip_curl_--time_0.5.png pose---clip_1_--time_0.5.png || fail "a clip by its number"
cmp -s pose---clip_curl_--time_0.5.png pose-.png && fail "a pose changes nothing"
cmp -s pose---clip_curl.png pose-.png || fail "the first key of curl is the rest pose"
bad 1 '.*tail\.gltf: no clip "Walk"; there are "curl", "rise"' \
    render "$tail" --clip Walk -o never.png
bad 1 'tetra\.obj: nothing of this animal can move' render tetra.obj --clip 1 -o never.png
bad 2 'render .*--time' render "$tail" --clip 1 --time soon -o never.png
printf 'pose curl 0.5\nflood length set 0.01\npose rest\n' >pose.txt
good export "$tail" --script pose.txt -o posed.glb
printf 'pose 3 0.5\n' >pose.txt
bad 1 'pose\.txt: line 1: pose: no clip "3"' export "$tail" --script pose.txt -o never.glb

bad 1 'no/such/x\.png: ' render tetra.obj --size 8x8 --samples 1 -o no/such/x.png
for size in 0x8 8x 8 8x8x8 x8 -1x8 8x9000 '8 x8' ''; do
    bad 2 'render .*--size' render tetra.obj --size "$size" -o never.png
done
bad 2 'render .*--technique' render tetra.obj --technique magic -o never.png
bad 2 'render .*--samples' render tetra.obj --samples 0 -o never.png
bad 2 'render .*--frames' render tetra.obj --frames 0 -o never.png
bad 2 'render --frames: not of the reference' \
    render tetra.obj --frames 2 --technique reference -o never.png
bad 2 'render .*--field' render --field 1999 -o never.png
bad 2 'render .*--layers' render tetra.obj --technique shells --layers 257 -o never.png
bad 2 'render .*--over' render tetra.obj --over shells-plain -o never.png
bad 2 'render .*--spp' render tetra.obj --technique reference --spp 0 -o never.png
bad 2 'render .*--shadows' render tetra.obj --technique reference --shadows none -o never.png
bad 2 'render .*--pitch' render tetra.obj --pitch nan -o never.png
bad 2 'render .*--distance' render tetra.obj --distance 0 -o never.png
bad 2 'render .*--distance' render tetra.obj --distance nan -o never.png
[ ! -e never.png ] || fail "a refused render wrote a file"

# Compare.
convert -size 64x48 'xc:gray(50%)' PNG24:plain.png
convert plain.png -fill white -draw 'rectangle 20,10 39,29' PNG24:spot.png
convert -size 64x48 xc:none -fill white -draw 'rectangle 20,10 39,29' PNG32:cut.png
convert -size 64x48 xc:none -fill white -draw 'rectangle 20,10 39,19' PNG32:half.png
convert plain.png -depth 16 PNG48:deep.png
convert -size 64x48 xc:black PNG24:black.png
json 'j.rmse === 0' 'j.flipMean === 0' 'j.flip99 === 0' 'j.ssim === 1' 'j.luminanceBias === 0' \
    'j.coverage === null' 'j.width === 64 && j.height === 48' 'j.image === "plain.png"' \
    'j.reference === "plain.png"' '!("heat" in j)' -- compare plain.png plain.png --json
json 'j.rmse < 1e-3' 'j.flipMean < 0.01' -- compare deep.png plain.png --json
# 400 of 3072 pixels are white, the others 0.2122 or 0.2159 in linear light, by how 50 % is rounded.
json 'Math.abs(j.rmse - 0.784 * Math.sqrt(400 / 3072)) < 0.003' 'j.luminanceBias > 0.4' \
    'j.flipMean > 0.1 && j.flipMean < j.flip99' 'j.heat === "heat.png"' \
    -- compare spot.png plain.png --heat heat.png --json
[ "$(png_size heat.png)" = 64x48 ] || fail "heat.png: $(png_size heat.png)"
json 'j.coverage.areaRatio === 0.5' 'j.coverage.silhouette === 0.5' 'j.coverage.bandPixels === 0' \
    -- compare half.png cut.png --json
json 'j.coverage.areaRatio === 2' 'j.luminanceBias === 1' -- compare cut.png half.png --json
json 'j.luminanceBias === null' -- compare plain.png black.png --json
good compare half.png cut.png
grep -qE '^half\.png against cut\.png, 64x48 pixels$' out.txt || fail "compare: $(cat out.txt)"
grep -qE '^  covered area +0\.5 of the reference' out.txt || fail "compare: $(cat out.txt)"
bad 1 'r\.png against plain\.png: 96x64 pixels, the reference has 64x48$' compare r.png plain.png
bad 1 'none\.png: ' compare plain.png none.png
bad 1 'tetra\.obj: is no PNG or JPEG picture' compare tetra.obj plain.png
bad 1 'no/such/h\.png: ' compare plain.png plain.png --heat no/such/h.png
bad 2 'compare .*"h\.jpg" does not end in \.png' compare plain.png plain.png --heat h.jpg
bad 2 'compare .*REFERENCE is required' compare plain.png

# Pictures without a background have the coverage as their alpha.
for technique in polyline reference; do
    json 'j.output' -- render --animal 2000 --hairs 3000 --size 64x64 --technique $technique \
        --transparent -o t_$technique.png --json
    json 'j.rmse === 0' 'j.coverage.areaRatio === 1' 'j.coverage.silhouette === 0' \
        'j.coverage.bandPixels > 50 && j.coverage.bandPixels < 64 * 64 / 2' \
        -- compare t_$technique.png t_$technique.png --json
done
json 'Math.abs(j.coverage.areaRatio - 1) < 0.03' 'j.coverage.silhouette < 0.1' \
    -- compare t_polyline.png t_reference.png --json

# Measure.
json 'j.rows.length === 8' 'j.views.map(v => v.name).join() === "middle"' 'j.output === "new/r"' \
    'j.rows.every(r => r.view === "middle" && r.ms > 0 && r.msLeast <= r.msFrame)' \
    'j.rows.map(r => r.technique + " " + r.value).join() ===
        "hairs 1/8,hairs 1/4,hairs 1/2,hairs 1,samples 1,samples 4,samples 16,samples 64"' \
    'j.rows.every(r => r.ms === r.samples * r.msFrame && r.framesTimed >= 2)' 'j.rows.some(r => r.front)' \
    'j.rows.every(r => r.drawing.noiseShare === r.drawing.noise / r.drawing.rmse)' \
    'j.rows.every(r => r.light.trusted === (r.light.noiseShare <= 0.2))' \
    'j.rows[3].drawing.rmse < j.rows[0].drawing.rmse' 'j.rows[0].hairsDrawn < j.rows[3].hairsDrawn' \
    'Math.abs(j.rows[3].drawing.coverage.areaRatio - 1) < 0.1' \
    'j.approaches.map(a => a.technique).join() === "hairs,samples"' 'j.cores > 0 && j.processor' \
    '/^20[0-9]{2}-[0-9]{2}-[0-9]{2}$/.test(j.date)' 'j.width === 64 && j.spp === 16' \
    -- measure --animal 2000 --hairs 3000 --views middle --techniques samples,hairs --size 64 \
    --spp 16 --repeat 2 -o new/r --json
[ "$(grep -c '^middle: ' err.txt)" = 9 ] || fail "measure told stderr: $(cat err.txt)"
for file in html csv json; do
    [ -s "new/r/report.$file" ] || fail "measure wrote no report.$file"
done
for file in new/r/report.html new/r/plot.svg; do
    xmllint --noout "$file" 2>xml.txt || fail "$file is not well-formed: $(head -1 xml.txt)"
done
grep -qE '(src|href)="(http|/)' new/r/report.html && fail "report.html needs other files"
[ "$(wc -l <new/r/report.csv)" = 9 ] || fail "report.csv has $(wc -l <new/r/report.csv) lines"
[ "$(awk -F, '{ print NF }' new/r/report.csv | uniq | wc -l)" = 1 ] || fail "columns of report.csv"
head -1 new/r/report.csv | grep -q ',drawing.rmse,.*,light.rmse,' || fail "heads of report.csv"
good measure tetra.obj --hairs 100 --views far --techniques distance --size 16 --spp 2 --repeat 1 -o new/r
grep -q '^wrote report.html, .* to new/r: 1 pictures, views: 1$' out.txt || fail "measure: $(cat out.txt)"
[ "$(ls new/r)" = $'plot.svg\nreport.csv\nreport.html\nreport.json' ] || fail "measure: $(ls new/r)"
json 'j.rows.map(r => r.layers).join() === "8,16,32,64"' 'j.rows.every(r => r.msShellPass > 0)' \
    'j.rows.every(r => r.hairsDrawn === 0 && r.textureBytes > 0)' \
    -- measure tetra.obj --hairs 100 --views far --techniques shells-plain --size 16 --spp 2 --repeat 1 \
    -o new/s --json
head -1 new/s/report.csv | grep -q ',layers,textureBytes,msShellPass,' || fail "heads of report.csv"
grep -q '<th>layers</th>' new/s/report.html || fail "heads of report.html"
bad 2 'measure .*--views: .*close.*middle.*far' measure tetra.obj --views near -o never
bad 2 'measure .*--techniques: .*hairs.*samples' measure tetra.obj --techniques hairs,magic -o never
bad 2 'measure .*--spp' measure tetra.obj --spp 1 -o never
bad 2 'measure .*--output is required' measure tetra.obj
bad 1 'never\.obj: ' measure never.obj -o never
[ ! -e never ] || fail "a refused measure made its folder"
bad 1 'tetra\.obj/x: Not a directory$' measure tetra.obj --size 16 --spp 2 -o tetra.obj/x
bad 1 'tetra\.obj: Not a directory$' measure tetra.obj --size 16 --spp 2 -o tetra.obj

# Shells from a photograph. 256 columns of as many greys: 2.55 of them are one percent.
convert -size 1x256 gradient:white-black -rotate 90 -scale 256x256! -depth 8 PNG32:ramp.png
json 'j.width === 256 && j.height === 256 && j.layers === 16' 'j.populations.length === 16' \
    'j.populations.reduce((a, b) => a + b) === 65536' 'j.populations.every(n => n > 0)' \
    'j.regions.length === 1 && j.regions[0].thresholds.length === 16' \
    'j.regions[0].thresholds[15] === j.regions[0].low' 'j.regions[0].extinctionTimesThickness > 0' \
    'j.textureBytes === 256 * 1024' 'j.textureBytesWithMips === 4 * 87381' \
    'j.storedLayersBytes === 4096 * 1024' 'j.entropy > 3 && j.entropyAtMost === 4' \
    'j.clamp.join() === "1,99" && j.warnings.length === 0' -- shells --photo ramp.png -o shells/p --json
[ "$(ls shells/p)" = "histogram.svg"$'\n'"$(seq -f 'layer-%02g.png' 16)" ] || fail "shells: $(ls shells/p)"
xmllint --noout shells/p/histogram.svg || fail "histogram.svg is not well-formed"
[ "$(png_size shells/p/layer-01.png)" = 256x256 ] || fail "layer-01.png"
convert shells/p/layer-*.png -background none -flatten all.png
[ "$(compare -metric AE ramp.png all.png null: 2>&1)" = 0 ] || fail "the layers are not the photograph"
good shells --photo ramp.png -o shells/p
grep -q '^texture 256 KiB, with its mips 341 KiB; 16 stored layers would take 4096 KiB$' out.txt ||
    fail "shells: $(cat out.txt)"
grep -q '^wrote 17 files to shells/p$' out.txt || fail "shells: $(tail -1 out.txt)"
json 'Math.max(...j.populations) - Math.min(...j.populations) <= 256' 'j.uniform' \
    -- shells --photo ramp.png --uniform --layers 4 -o shells/u --json
json 'j.cumulative' -- shells --photo ramp.png --cumulative --layers 3 --clamp 0,100 -o shells/c --json
[ "$(compare -metric AE ramp.png shells/c/layer-03.png null: 2>&1)" = 0 ] || fail "shells --cumulative"
json 'j.populations.join() === "65536"' 'j.entropy === 0' -- shells --photo ramp.png --layers 1 -o shells/1 --json
json 'j.populations.length === 256' 'j.warnings.length === 1' -- \
    shells --photo ramp.png --layers 256 -o shells/256 --json
[ -s shells/256/layer-256.png ] && [ -s shells/256/layer-001.png ] || fail "shells --layers 256"
convert \( ramp.png -colorspace gray \) \( ramp.png -fill orange -colorize 60 \) +append two.png
json 'j.regions.length === 2' 'j.regions[0].pixels + j.regions[1].pixels === 131072' \
    -- shells --photo two.png --two-colors -o shells/2 --json

# Hard photographs.
convert -size 9x7 xc:black PNG24:black.png
convert -size 9x7 xc:white PNG24:white.png
convert -size 9x7 xc:'#604020' PNG24:brown.png
convert -size 1x1 xc:gray PNG24:dot.png
convert -size 9x7 xc:none PNG32:none.png
convert -size 1x256 gradient:white-black -colorspace gray -depth 16 PNG48:deep.png
convert -size 1x256 gradient:white-black -colorspace gray -type grayscale -depth 8 grey.png
convert ramp.png \( -size 256x256 gradient:white-black \) -alpha off -compose CopyOpacity -composite alpha.png
convert ramp.png -background white -flatten -quality 90 ramp.jpg
for name in black white brown dot; do
    json 'j.populations[0] === j.width * j.height' 'j.entropy === 0' 'j.warnings.length === 1' \
        'j.regions[0].extinctionTimesThickness === 0' -- shells --photo $name.png -o shells/$name --json
done
for name in deep.png grey.png alpha.png ramp.jpg; do
    json 'j.entropy > 3' -- shells --photo $name -o shells/hard --json
done
json 'j.populations.reduce((a, b) => a + b) < 65536' -- shells --photo alpha.png -o shells/hard --json
head -c 200 ramp.png >cut.png
head -c 900 ramp.jpg >cut.jpg
printf 'No picture.\n' >text.png
convert -size 8193x2 xc:gray PNG24:wide.png
# refused ARGUMENTS...: each of them, where its name is the last argument.
refused() {
    bad 1 'cut\.png: ends after 200 bytes, in the middle of the picture$' "$@" cut.png
    bad 1 'cut\.jpg: ends after 900 bytes, in the middle of the picture$' "$@" cut.jpg
    bad 1 'text\.png: is no PNG or JPEG picture: its 12 bytes begin with 4e 6f 20 70$' "$@" text.png
    bad 1 'wide\.png: has 8193x2 pixels, of which a side may have 8192$' "$@" wide.png
    bad 1 'no\.png: No such file or directory$' "$@" no.png
}
refused shells -o never --photo
refused shells -o never --image
bad 1 'none\.png: all of 9x7 pixels are transparent' shells --photo none.png -o never
# 8k: cut into layers as it is, halved where it is drawn.
convert -size 8192x24 plasma:gray-white -depth 8 PNG24:long.png
json 'j.width === 8192 && j.height === 24' 'j.storedLayersBytes === 2 * 4 * 8192 * 24' \
    -- shells --photo long.png --layers 2 -o shells/long --json
[ "$(png_size shells/long/layer-02.png)" = 8192x24 ] || fail "layers of 8k"
# The same in the fur.
drawn() { json "$1" -- render tetra.obj --size 32x32 --samples 1 --repeat 1 -o s.png --json "${@:2}"; }
drawn 'j.layers === 16 && j.textureBytes === 4 * 87381 && j.storedLayersBytes === 4096 * 1024' \
    --technique shells --shell-photo ramp.png
drawn 'j.layers === 5 && j.textureBytes === 4 * 174763' --technique shells --layers 5 \
    --shell-photo two.png --shell-two-colors --shell-clamp 0,100 --shell-side 0.1 --shell-gap 0.5
drawn 'j.textureBytes > 4 * 87381' --technique shells-plain --shell-noise --shell-coat under
drawn 'j.textureBytes === 4 * 87381' --technique shells-instanced --shell-image ramp.jpg --shell-coverage 0.9
for name in black white brown dot deep grey alpha; do
    good render tetra.obj --size 32x32 --samples 1 -o s.png --technique shells --shell-photo $name.png
done
for kind in photo image; do
    refused render tetra.obj -o never.png --technique shells --shell-$kind
    good render tetra.obj --size 32x32 --samples 1 -o s.png --technique shells --shell-$kind long.png
    grep -q '^8192x24 pixels are drawn as 4096x12$' out.txt || fail "render --shell-$kind: $(cat out.txt)"
done
for layers in 1 256; do
    drawn "j.layers === $layers" --technique shells --layers $layers --shell-photo ramp.png
done
good render tetra.obj --size 32x32 --samples 1 -o s.png --technique shells --shell-photo ramp.png
grep -q '^texture 256 KiB, with its mips 341 KiB; 16 stored layers would take 4096 KiB$' out.txt ||
    fail "render --shell-photo: $(cat out.txt)"
drawn 'j.layers === 16' --technique shells --layers 0 --shell-photo ramp.png
bad 2 'render .*--layers' render tetra.obj -o never.png --technique shells --layers 257 --shell-photo ramp.png
bad 1 'none\.png: all of 9x7 pixels are transparent' \
    render tetra.obj -o never.png --technique shells --shell-photo none.png
bad 2 'render --shell-photo: needs a --technique of shells' render tetra.obj -o never.png --shell-photo ramp.png
bad 2 'render --shell-clamp: 60 is not below 40' \
    render tetra.obj -o never.png --technique shells --shell-photo ramp.png --shell-clamp 60,40
bad 2 'render .*--shell-photo excludes --shell-noise' \
    render tetra.obj -o never.png --technique shells --shell-noise --shell-photo ramp.png
bad 2 'render .*--shell-gap' render tetra.obj -o never.png --technique shells --shell-noise --shell-gap 0
[ ! -e never.png ] || fail "a refused render wrote its picture"
bad 2 'shells .*--layers: .*0' shells --photo ramp.png --layers 0 -o never
bad 2 'shells .*--layers: .*257' shells --photo ramp.png --layers 257 -o never
bad 2 'shells --clamp: 60 is not below 40' shells --photo ramp.png --clamp 60,40 -o never
bad 2 'shells .*--clamp' shells --photo ramp.png --clamp 5 -o never
bad 2 'shells .*--clamp: .*101' shells --photo ramp.png --clamp 5,101 -o never
bad 2 'shells .*--uniform requires --photo' shells --noise --uniform -o never
bad 2 'shells .*--output is required' shells --noise
bad 2 'shells .*' shells -o never
bad 2 'shells .*' shells --noise --photo ramp.png -o never
[ ! -e never ] || fail "refused shells made their folder"
bad 1 'ramp\.png: Not a directory$' shells --noise -o ramp.png

# Shells from noise, hairs and a picture.
json 'j.width === 256' 'j.layers.length === 16' 'j.textureBytes === 256 * 1024' \
    'Math.abs(j.layers[15].coverage - 0.5 * (31 / 32) ** 2) < 1e-4' \
    'j.layers.every((l, i) => i === 0 || l.coverage > j.layers[i - 1].coverage)' \
    -- shells --noise -o shells/n --json
[ "$(ls shells/n)" = $'heights.png\nids.png\n'"$(seq -f 'layer-%02g.png' 16)" ] || fail "shells: $(ls shells/n)"
for mask in 1 3 5 7 9; do
    good shells --noise --mask $mask --box --side 64 --layers 2 --taper 0.5 --coverage 0.8 -o shells/m
done
bad 2 'shells .*--mask' shells --noise --mask 4 -o never
bad 2 'shells .*--side' shells --noise --side 8193 -o never
json 'j.width === 1 && j.height === 1' -- shells --noise --side 1 -o shells/s --json
json 'Math.abs(j.layers[0].coverage - 3.14159 * 64 * 0.02 ** 2 * 0.25) < 0.001' \
    -- shells --hairs 64 --radius 0.02 --layers 1 --side 512 -o shells/h --json
json 'Math.abs(j.layers[0].coverage - 0.5) < 0.003' \
    -- shells --image ramp.png --raw --layers 1 -o shells/r --json
json 'Math.abs(j.layers[0].coverage - 0.9 * 0.25) < 1e-4' \
    -- shells --image ramp.jpg --coverage 0.9 --layers 1 -o shells/i --json

# Wrong use of the program itself.
bad 2 '.*--nonsense' --nonsense
bad 2 '"tetra\.obj" stands before the verb info' tetra.obj info animal.glb
bad 2 '.*not expected: animal\.glb' tetra.obj animal.glb

# Without a display: pictures and a groomed .glb in place of the editor.
json 'j.written.length === 5' 'j.written.includes("pelage-out/tetra-groomed.glb")' -- --json tetra.obj
for name in front side three-quarter close-up; do
    [ "$(png_size pelage-out/$name.png)" = 1200x900 ] || fail "pelage-out/$name.png"
done
json 'j.hasFur' -- info pelage-out/tetra-groomed.glb --json
bad 1 'none\.obj: ' none.obj

# A full disk is failed work.
if [ -e /dev/full ]; then
    "$program" presets >/dev/full 2>err.txt
    status=$?
    [ $status = 1 ] || fail "exit status $status, expected 1, of a full stdout"
    [ "$(wc -l <err.txt)" = 1 ] || fail "stderr of a full stdout: $(cat err.txt)"
fi

[ "$failures" = 0 ] && echo "the command line is right"
[ "$failures" = 0 ]
