"""blender_example.py -- what a groomed .glb is in Blender.

    blender --background --python blender_example.py -- animal.glb

From 3.5 on the fields are point attributes under their own names. Blender 3.4 drops them: export
with the compatibility mirror, which arrives as UV maps there. The coats are custom properties.
"""
import sys

import bpy
from mathutils import Vector


def import_glb(path):
    """Imports a file and returns its mesh objects. FLAT avoids a bug of the importer of 3.4."""
    before = set(bpy.data.objects)
    bpy.ops.import_scene.gltf(filepath=path, import_shading="FLAT")
    return [o for o in bpy.data.objects if o not in before and o.type == "MESH"]


def coats_of(obj):
    """The fur block (schema: assets/fur.schema.json) as a dictionary, or None."""
    block = obj.data.get("fur") or obj.get("fur")
    return block.to_dict() if block else None


def to_blender(v):
    """glTF has Y up, Blender Z. The importer turns positions, but no attributes and no UVs."""
    return Vector((v[0], -v[2], v[1]))


def fur_of(obj):
    """Length, density and direction of each vertex, in Blender's axes; None when there are none."""
    mesh = obj.data
    count = len(mesh.vertices)
    if "_FUR_LENGTH" in mesh.attributes:  # 3.5 and later
        fields = [mesh.attributes["_FUR_" + name].data for name in
                  ("LENGTH", "DENSITY", "DIRECTION")]
        return [(fields[0][v].value, fields[1][v].value, to_blender(fields[2][v].vector))
                for v in range(count)]
    block = coats_of(obj)
    if not block or "uvSet" not in block:
        return None
    maps = [mesh.uv_layers[int(block["uvSet"]) + k].data for k in range(3)]
    fur = [None] * count
    for corner in mesh.loops:
        a, b, c = (uv[corner.index].uv for uv in maps)
        # The importer turns each v into 1 - v.
        fur[corner.vertex_index] = (a.x, 1 - a.y, to_blender((b.x, 1 - b.y, c.x)))
    return fur


if __name__ == "__main__":
    for thing in import_glb(sys.argv[sys.argv.index("--") + 1]):
        fur = [f for f in fur_of(thing) or [] if f]
        print(thing.name, len(fur), "vertices with fur")
        if fur:
            print("  longest hair", max(f[0] for f in fur), "coats", sorted(coats_of(thing)))
