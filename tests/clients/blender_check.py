"""blender_check.py -- Blender shows the counts, coats, joints and animations that it should.

    blender -b --factory-startup --python-exit-code 1 --python blender_check.py -- FILE.glb INFO.json
"""
import json
import os
import struct
import sys

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import blender_example  # noqa: E402


def read_glb(path):
    with open(path, "rb") as file:
        head = file.read(20)
        gltf = json.loads(file.read(struct.unpack("<I", head[12:16])[0]))
        file.read(8)
        return gltf, file.read()


def corners_of(gltf, data, primitive):
    """Vertex numbers of the corners of its triangles, read by hand."""
    if "indices" not in primitive:
        return list(range(gltf["accessors"][primitive["attributes"]["POSITION"]]["count"]))
    accessor = gltf["accessors"][primitive["indices"]]
    view = gltf["bufferViews"][accessor["bufferView"]]
    start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    code = {5121: "B", 5123: "H", 5125: "I"}[accessor["componentType"]]
    return list(struct.unpack_from(f"<{accessor['count']}{code}", data, start))


def triangles_of(gltf, data):
    """Corners of each triangle of the file, apart for each primitive."""
    for m, mesh in enumerate(gltf["meshes"]):
        for p, primitive in enumerate(mesh["primitives"]):
            c = corners_of(gltf, data, primitive)
            for t in range(0, len(c), 3):
                yield [(m, p, v) for v in c[t:t + 3]]


def counts_of(gltf, data):
    """(vertices, edges, polygons) as Blender counts them: no vertex that no triangle uses, each
    pair of neighbours once, no triangle with a corner twice, and each of those left once."""
    vertices, edges, polygons = set(), set(), set()
    for triangle in triangles_of(gltf, data):
        vertices.update(triangle)
        a, b, c = sorted(triangle)
        edges.update(pair for pair in ((a, b), (b, c), (a, c)) if pair[0] != pair[1])
        if a != b and b != c:
            polygons.add((a, b, c))
    return len(vertices), len(edges), len(polygons)


def near(a, b):
    return abs(a - b) <= 1e-5 * max(1.0, abs(a), abs(b))


path, info_path = sys.argv[sys.argv.index("--") + 1:]
gltf, data = read_glb(path)
with open(info_path, encoding="utf-8") as stream:
    info = json.load(stream)
bpy.ops.wm.read_factory_settings(use_empty=True)
things = [o for o in blender_example.import_glb(path) if o.data.get("fur") or o.get("fur")]
assert things, "no mesh object has the fur block"
vertices = sum(len(o.data.vertices) for o in things)
polygons = sum(len(o.data.polygons) for o in things)
edges = sum(len(o.data.edges) for o in things)
print(f"{path}: {vertices} vertices, {edges} edges, {polygons} polygons")
wanted = counts_of(gltf, data)
assert (vertices, edges, polygons) == wanted, f"the file has {wanted}"
used = info["vertices"] - info["unusedVertices"]
assert vertices == used, f"the program says {used} vertices"

for thing in things:
    block = blender_example.coats_of(thing)
    source = gltf["meshes"][0]["extras"]["fur"]
    for name in ("version", "seed", "hairs"):
        assert int(block[name]) == source[name], f"{name} is {block[name]}, not {source[name]}"
    for coat in ("over", "under"):
        names = set(block[coat]) ^ set(source[coat])
        assert not names, f"{coat} differs in {names}"
        stiffness = block[coat]["stiffness"]
        assert near(stiffness, source[coat]["stiffness"]), f"{coat}.stiffness is {stiffness}"
    assert thing.get("fur"), "the block is not on the object"
    assert thing.data.get("fur"), "the block is not on the mesh"

fields = [f for o in things for f in blender_example.fur_of(o) or [] if f]
if fields:
    for name, values in (("length", [f[0] for f in fields]), ("density", [f[1] for f in fields]),
                         ("direction", [f[2].length for f in fields])):
        wanted = info["fields"][name]
        assert near(max(values), wanted["max"]) and near(min(values), wanted["min"]), (
            f"{name} is {min(values)} to {max(values)}, the program says {wanted}")
    print(f"{len(fields)} vertices with fur")
mirrored = "uvSet" in gltf["meshes"][0]["extras"]["fur"]
assert mirrored == path.endswith("_uvs.glb"), f"mirror in UV sets: {mirrored}"
assert bool(fields) == (mirrored or bpy.app.version >= (3, 5, 0)), f"{len(fields)} with fur"

armatures = [o for o in bpy.data.objects if o.type == "ARMATURE"]
bones = sum(len(o.data.bones) for o in armatures)
joints = sum(len(s["joints"]) for s in gltf.get("skins", []))
assert bones == joints, f"{bones} bones for {joints} joints"
animations = len(gltf.get("animations", []))
assert len(bpy.data.actions) == animations, f"{list(bpy.data.actions)} for {animations} animations"
print(f"{bones} bones, {len(bpy.data.actions)} animations")
