"""blender_coverage.py -- Cycles covers the same pixels with the same hairs as the reference does.

    blender -b --factory-startup --python-exit-code 1 --python blender_coverage.py -- PATCH.json

PATCH.json is what hair_patch writes. Curves are of the kind THICK, round and tapered.
"""
import json
import os
import sys
import tempfile

import bpy
from mathutils import Matrix

# Of coverage. The reference is within 0.0002 of theory (tests/core/reference_test.cpp), Cycles covers
# 0.0008 less; the round foot of a hair seen from 10 degrees, which Cycles leaves open, is 0.0004.
BOUND = 0.0015

(path,) = sys.argv[sys.argv.index("--") + 1:]
with open(path, encoding="utf-8") as stream:
    patch = json.load(stream)
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene

data = bpy.data.curves.new("hairs", "CURVE")
data.dimensions = "3D"
for hair in patch["hairs"]:
    spline = data.splines.new("POLY")
    spline.points.add(len(hair) - 1)
    for point, (x, y, z, radius) in zip(spline.points, hair):
        point.co = (x, y, z, 1)
        point.radius = radius
thing = bpy.data.objects.new("hairs", data)
scene.collection.objects.link(thing)
bpy.context.view_layer.objects.active = thing
thing.select_set(True)
bpy.ops.object.convert(target="CURVES")
thing = bpy.context.view_layer.objects.active
assert thing.type == "CURVES", thing.type
radii = [r.value for r in thing.data.attributes["radius"].data]
wanted = max(point[3] for hair in patch["hairs"] for point in hair)
assert abs(max(radii) / wanted - 1) < 1e-5, f"radius {max(radii)}, not {wanted}"



def shade(thing, brightness):
    material = bpy.data.materials.new(thing.name)
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    emission = nodes.new("ShaderNodeEmission")
    emission.inputs["Strength"].default_value = brightness
    output = nodes.new("ShaderNodeOutputMaterial")
    material.node_tree.links.new(emission.outputs[0], output.inputs["Surface"])
    thing.data.materials.append(material)


# Black hair on white skin: roots are round, and half of each is under the skin.
shade(thing, 0)
mesh = bpy.data.meshes.new("skin")
mesh.from_pydata([(-1, 0, -1), (-1, 0, 1), (1, 0, 1), (1, 0, -1)], [], [(0, 1, 2, 3)])
skin = bpy.data.objects.new("skin", mesh)
scene.collection.objects.link(skin)
shade(skin, 1)

scene.render.engine = "CYCLES"
scene.cycles.device = "CPU"
scene.cycles.samples = patch["samples"]
scene.cycles.use_adaptive_sampling = False
scene.cycles.use_denoising = False
scene.cycles.max_bounces = 0
scene.cycles.pixel_filter_type = "BOX"
scene.cycles.filter_width = 1.0
scene.cycles_curves.shape = "THICK"
scene.render.resolution_percentage = 100
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_mode = "RGBA"
scene.render.image_settings.color_depth = "32"
camera = bpy.data.cameras.new("eye")
camera.type = "ORTHO"
camera.clip_start, camera.clip_end = 0.01, 10
scene.camera = bpy.data.objects.new("eye", camera)
scene.collection.objects.link(scene.camera)


def coverage(view):
    scene.render.resolution_x, scene.render.resolution_y = view["size"]
    camera.ortho_scale = view["width"]
    back = [-x for x in view["forward"]]
    scene.camera.matrix_world = Matrix(
        [[view["right"][i], view["up"][i], back[i], view["eye"][i]] for i in range(3)]
        + [[0, 0, 0, 1]])
    with tempfile.TemporaryDirectory() as folder:
        scene.render.filepath = os.path.join(folder, "picture.exr")
        bpy.ops.render.render(write_still=True)
        picture = bpy.data.images.load(scene.render.filepath)
        red = list(picture.pixels)[::4]
    return 1 - sum(red) / len(red)


failures = []
for view in patch["views"]:
    cycles = coverage(view)
    difference = view["coverage"] - cycles
    print(f"from {view['degrees']:.0f} degrees: reference {view['coverage']:.4f}, Cycles "
          f"{cycles:.4f}, difference {difference:+.5f}")
    if abs(difference) > BOUND:
        failures.append(view["degrees"])
assert not failures, f"more than {BOUND} apart from {failures} degrees"
