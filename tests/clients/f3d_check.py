#!/usr/bin/env python3
"""f3d_check.py -- f3d lists the fur fields with the ranges that the program says.

    f3d_check.py FILE.glb INFO.json
"""
import json
import re
import subprocess
import sys


def ranges(text, name):
    """(least, greatest) of each component of every array of that name."""
    found = []
    for line in text.splitlines():
        match = re.match(rf"\s*{name} : (\w+) : (.*)", line)
        if not match:
            continue
        assert match[1] == "float", f"{name} is of type {match[1]}"
        pairs = re.findall(r"\[([^,\]]+), ([^\]]+)\]", match[2])
        found.append([(float(a), float(b)) for a, b in pairs])
    return found


def near(a, b):
    return abs(a - b) <= 1e-4 * max(1e-3, abs(a), abs(b))  # f3d prints 6 digits


def total(text, name):
    return sum(int(n) for n in re.findall(rf"Number of {name}: (\d+)", text))


def main(path, info_path):
    with open(info_path, encoding="utf-8") as file:
        info = json.load(file)
    text = subprocess.run(["f3d", "--verbose", "--no-render", path], check=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout
    for name in ("length", "density"):
        found = ranges(text, f"_FUR_{name.upper()}")
        assert found, f"f3d shows no _FUR_{name.upper()}:\n{text}"
        least = min(pairs[0][0] for pairs in found)
        greatest = max(pairs[0][1] for pairs in found)
        wanted = info["fields"][name]
        assert near(least, wanted["min"]) and near(greatest, wanted["max"]), (
            f"{name} is {least} to {greatest}, the program says {wanted}")
        print(f"{name}: {least} to {greatest}")
    found = ranges(text, "_FUR_DIRECTION")
    assert found and all(len(pairs) == 3 for pairs in found), f"no vectors:\n{text}"
    longest = info["fields"]["direction"]["max"]
    ends = [end for pairs in found for pair in pairs for end in pair]
    largest = max(map(abs, ends))  # of one component, of three
    assert longest / 3**0.5 - 1e-4 <= largest <= longest + 1e-4, (
        f"components of directions are up to {largest}, the program says {longest} long")
    print(f"direction: {found}")
    for name, wanted in (("points", info["vertices"]), ("polygons", info["triangles"])):
        shown = total(text, name)
        assert shown == wanted, f"{shown} {name}, the program says {wanted}"


main(*sys.argv[1:])
