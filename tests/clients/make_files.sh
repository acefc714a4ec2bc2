#!/bin/sh
# make_files.sh -- writes the files under test with the shipped program, and what it says of them.
#
#   make_files.sh PELAGE FOLDER [NAME=SOURCE=PRESET[=OPTION]...]
# Leaves NAME.glb, NAME_uvs.glb (with the compatibility mirror) and NAME.json in FOLDER; the
# built-in animal is always among them.
set -e
pelage=$1
folder=$2
shift 2
rm -rf "$folder"
mkdir -p "$folder"

describe() {
    "$pelage" info --json "$folder/$1.glb" >"$folder/$1.json"
}

"$pelage" animal --triangles 5000 -o "$folder/animal.glb"
"$pelage" animal --triangles 5000 --compatibility-uvs -o "$folder/animal_uvs.glb"
describe animal
for case in "$@"; do
    name=${case%%=*}
    rest=${case#*=}
    source=${rest%%=*}
    rest=${rest#*=}
    preset=${rest%%=*}
    option=${rest#"$preset"}
    option=${option#=}
    set -- "$source" --preset "$preset" ${option:+"$option"}
    "$pelage" export "$@" -o "$folder/$name.glb"
    "$pelage" export "$@" --compatibility-uvs -o "$folder/${name}_uvs.glb"
    describe "$name"
done
