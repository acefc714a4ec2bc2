# blender_compare.py -- what hair costs in Blender; run by blender_compare.sh inside Blender.
#
# Measured: generation (the evaluation that makes the particle hairs), re-evaluation after an edit of
# 200 vertices, and a Workbench render of 900x900 pixels. Left out: import and the first render,
# which compiles shaders. Arguments after --: mesh.glb, hairs, segments, result.json.
import json
import statistics
import sys
import time

import bpy
from mathutils import Vector

mesh_file, hairs, segments, result_file = sys.argv[sys.argv.index("--") + 1 :]
hairs, segments = int(hairs), int(segments)
REPEATS = 5


def timed(action):
    start = time.perf_counter()
    action()
    return 1000 * (time.perf_counter() - start)


bpy.ops.wm.read_factory_settings(use_empty=True)
# With its default shading the importer of 3.4.1 stops at numpy.bool.
bpy.ops.import_scene.gltf(filepath=mesh_file, import_shading="SMOOTH")
skin = max(
    (o for o in bpy.context.scene.objects if o.type == "MESH"), key=lambda o: len(o.data.polygons)
)
bpy.context.view_layer.objects.active = skin
skin.data.calc_loop_triangles()
triangles = len(skin.data.loop_triangles)
size = max(skin.dimensions)

particles = skin.modifiers.new("Hair", "PARTICLE_SYSTEM").particle_system.settings
particles.type = "HAIR"
particles.render_type = "PATH"
particles.hair_length = 0.04 * size
particles.hair_step = segments
particles.display_step = particles.render_step = (segments - 1).bit_length()
particles.display_percentage = 100


def generate():
    particles.count = hairs
    bpy.context.view_layer.update()


def edit():
    for vertex in skin.data.vertices[:200]:
        vertex.co += Vector((0, 0, 1e-5 * size))
    skin.data.update()
    bpy.context.view_layer.update()


bpy.context.view_layer.update()
generation = timed(generate)
edits = [timed(edit) for _ in range(REPEATS)]
evaluated = skin.evaluated_get(bpy.context.evaluated_depsgraph_get())
made = len(evaluated.particle_systems[0].particles)

scene = bpy.context.scene
camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
scene.collection.objects.link(camera)
scene.camera = camera
corners = [skin.matrix_world @ Vector(corner) for corner in skin.bound_box]
middle = sum(corners, Vector()) / 8
camera.location = middle + Vector((1.4, -1.4, 0.6)).normalized() * 1.9 * size
camera.rotation_euler = (middle - camera.location).to_track_quat("-Z", "Y").to_euler()
scene.render.engine = "BLENDER_WORKBENCH"
scene.render.resolution_x = scene.render.resolution_y = 900
scene.render.resolution_percentage = 100
bpy.ops.render.render()
renders = [timed(bpy.ops.render.render) for _ in range(REPEATS)]

with open(result_file, "w") as file:
    json.dump(
        {
            "version": bpy.app.version_string,
            "triangles": triangles,
            "hairs": made,
            "segments": segments,
            "msGenerate": generation,
            "msEdit": statistics.median(edits),
            "msRender": statistics.median(renders),
        },
        file,
    )
