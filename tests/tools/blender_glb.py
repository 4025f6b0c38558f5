"""Imports a GLB with the default settings, and returns its names, frames and the vertices at given times."""

from blender_script import answer, arguments, bpy

asked = arguments()
bpy.context.scene.render.fps = asked["fps"]
bpy.ops.import_scene.gltf(filepath=asked["file"])
shape = next(each for each in bpy.data.objects if each.type == "MESH")
keys = shape.data.shape_keys
if asked.get("script"):
    bpy.context.view_layer.objects.active = shape
    with open(asked["script"], encoding="utf-8") as file:
        exec(compile(file.read(), asked["script"], "exec"))

curves = keys.animation_data.action.fcurves if keys.animation_data and keys.animation_data.action else []
frames = sorted({point.co.x for curve in curves for point in curve.keyframe_points})


def vertices(time):
    """For each shown vertex: its number in the exported mesh, and its position with y up, as in the file."""
    if asked.get("script"):
        shape["slider"] = time
        shape.update_tag()
    else:
        frame = time * asked["fps"]
        bpy.context.scene.frame_set(int(frame), subframe=frame % 1)
    bpy.context.view_layer.update()
    shown = shape.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = shown.to_mesh()
    numbers = shape.data.attributes["_SHAPESPLINE_VERTEX"].data
    out = []
    for vertex, number in zip(mesh.vertices, numbers):
        x, y, z = shown.matrix_world @ vertex.co
        out.append([number.value, x, z, -y])
    shown.to_mesh_clear()
    return out


answer({
    "object": shape.name,
    "mesh": shape.data.name,
    "materials": [material.name for material in shape.data.materials],
    "keys": [block.name for block in keys.key_blocks],
    "frames": frames,
    "shown": [vertices(time) for time in asked["times"]],
})
