"""Writes poses of one mesh in each way that Blender supports: python blender-poses.py FOLDER.

Needs the module bpy (pip install bpy). Also writes truth.json: for each set, the vertices of its poses in Blender,
converted to the axes of glTF.
"""

import json
import math
import os
import struct
import sys

import bpy

OUT = sys.argv[1]
ANGLES = [0.0, 60.0, 120.0]
truth = {}


def y_up(co):
    return [co[0], co[2], -co[1]]


def fresh():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def path(name):
    return os.path.join(OUT, name)


def bar():
    """A bar of quads along z, closed by n-gons, with a marked seam."""
    bpy.ops.mesh.primitive_cylinder_add(vertices=12, radius=0.3, depth=4, location=(0, 0, 2), end_fill_type="NGON")
    obj = bpy.context.object
    obj.name = "Bar"
    bpy.ops.object.transform_apply(location=True)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    for z in range(1, 16):
        bpy.ops.mesh.select_all(action="SELECT")
        bpy.ops.mesh.bisect(plane_co=(0, 0, z / 4), plane_no=(0, 0, 1))
    bpy.ops.object.mode_set(mode="OBJECT")
    return obj


def head():
    bpy.ops.mesh.primitive_monkey_add()
    bpy.context.object.name = "Head"
    return bpy.context.object


def deform(obj, angle, method="BEND", axis="X"):
    """Deforms the object by a modifier, which replaces earlier ones."""
    obj.modifiers.clear()
    modifier = obj.modifiers.new("Bend", "SIMPLE_DEFORM")
    modifier.deform_method = method
    modifier.deform_axis = axis
    modifier.angle = math.radians(angle)


def evaluated(obj):
    return obj.evaluated_get(bpy.context.evaluated_depsgraph_get())


def note(name, obj):
    shape = evaluated(obj)
    vertices = [y_up(shape.matrix_world @ v.co) for v in shape.data.vertices]
    truth.setdefault(name, []).append(vertices)


def glb(name, **options):
    bpy.ops.export_scene.gltf(filepath=path(name), export_format="GLB", **options)


def shaded(obj, flat):
    for polygon in obj.data.polygons:
        polygon.use_smooth = not flat


def applied(name, make, flat, method="BEND", axis="X"):
    """Poses whose modifiers are applied on export."""
    fresh()
    obj = make()
    shaded(obj, flat)
    for index, angle in enumerate(ANGLES):
        deform(obj, angle, method, axis)
        glb(f"{name}-{index}.glb", export_apply=True)
        note(name, obj)


def sharp(name):
    """Poses with smooth shading, except at edges that are sharp in the pose."""
    fresh()
    obj = bar()
    for index, angle in enumerate(ANGLES):
        deform(obj, angle)
        shape = bpy.data.meshes.new_from_object(evaluated(obj))
        shape.set_sharp_from_angle(angle=math.radians(20))
        copy = bpy.data.objects.new("Posed", shape)
        bpy.context.collection.objects.link(copy)
        bpy.ops.object.select_all(action="DESELECT")
        copy.select_set(True)
        glb(f"{name}-{index}.glb", use_selection=True)
        note(name, copy)
        bpy.data.objects.remove(copy)


def rig(name, animated):
    """A posed armature that is not applied. If `animated`, each file contains the whole animation."""
    fresh()
    obj = bar()
    bpy.ops.object.armature_add(location=(0, 0, 0))
    armature = bpy.context.object
    armature.show_in_front = True
    bpy.ops.object.mode_set(mode="EDIT")
    bone = armature.data.edit_bones[0]
    bone.tail = (0, 0, 2)
    upper = armature.data.edit_bones.new("Upper")
    upper.head, upper.tail, upper.parent = (0, 0, 2), (0, 0, 4), bone
    bpy.ops.object.mode_set(mode="OBJECT")
    obj.select_set(True)
    bpy.context.view_layer.objects.active = armature
    bpy.ops.object.parent_set(type="ARMATURE_AUTO")
    posed = armature.pose.bones["Upper"]
    posed.rotation_mode = "XYZ"
    for index, angle in enumerate(ANGLES):
        posed.rotation_euler = (math.radians(angle), 0, 0)
        if animated:
            posed.keyframe_insert("rotation_euler", frame=1 + 12 * index)
    for index, angle in enumerate(ANGLES):
        bpy.context.scene.frame_set(1 + 12 * index)
        posed.rotation_euler = (math.radians(angle), 0, 0)
        bpy.context.view_layer.update()
        glb(f"{name}-{index}.glb")
        note(name, obj)


def text_formats():
    fresh()
    obj = bar()
    for index, angle in enumerate(ANGLES):
        deform(obj, angle)
        bpy.ops.wm.ply_export(filepath=path(f"zup-{index}.ply"), apply_modifiers=True)
        bpy.ops.wm.obj_export(filepath=path(f"quads-{index}.obj"), apply_modifiers=True)
        bpy.ops.wm.obj_export(
            filepath=path(f"cut-{index}.obj"), apply_modifiers=True, export_triangulated_mesh=True
        )
        for name in ("zup", "quads", "cut"):
            note(name, obj)


def with_floor():
    fresh()
    bpy.ops.mesh.primitive_plane_add(size=10)
    bpy.context.object.name = "Floor"
    obj = bar()
    for index, angle in enumerate(ANGLES):
        deform(obj, angle)
        bpy.ops.wm.obj_export(filepath=path(f"objects-{index}.obj"), apply_modifiers=True)
        bpy.ops.wm.obj_export(
            filepath=path(f"groups-{index}.obj"), apply_modifiers=True, export_object_groups=True
        )
        glb(f"objects-{index}.glb", export_apply=True)
        for name in ("objects", "groups", "objects-glb"):
            note(name, obj)


def caches():
    """PC2 and MDD files as Blender's former add-ons wrote them. Blender reads them, but no longer exports them."""
    fresh()
    obj = bar()
    deform(obj, 0)
    bpy.ops.wm.obj_export(filepath=path("cache.obj"), apply_modifiers=False)
    frames = []
    for frame in range(25):
        deform(obj, 5 * frame)
        frames.append([tuple(v.co) for v in evaluated(obj).data.vertices])
        note("cache", obj)
    count = len(frames[0])
    with open(path("cache.pc2"), "wb") as file:
        file.write(struct.pack("<12siiffi", b"POINTCACHE2\0", 1, count, 0, 1, len(frames)))
        for frame in frames:
            for co in frame:
                file.write(struct.pack("<3f", *co))
    with open(path("cache.mdd"), "wb") as file:
        file.write(struct.pack(">2i", len(frames), count))
        file.write(struct.pack(f">{len(frames)}f", *[frame / 24 for frame in range(len(frames))]))
        for frame in frames:
            for co in frame:
                file.write(struct.pack(">3f", co[0], co[2], -co[1]))


os.makedirs(OUT, exist_ok=True)
applied("smooth", bar, flat=False)
applied("flat", bar, flat=True)
applied("head", head, flat=False, method="TWIST", axis="Z")
applied("flat-head", head, flat=True, method="TWIST", axis="Z")
sharp("sharp")
rig("still", animated=False)
rig("animated", animated=True)
text_formats()
with_floor()
caches()
with open(path("truth.json"), "w", encoding="utf-8") as file:
    json.dump(truth, file)
print("written")
