"""Imports an OBJ, applies a point cache with the defaults of the Mesh Cache modifier, and returns its vertices."""

from blender_script import answer, arguments, bpy

asked = arguments()
bpy.ops.wm.obj_import(filepath=asked["obj"])
shape = bpy.context.selected_objects[0]
cache = shape.modifiers.new("cache", "MESH_CACHE")
cache.cache_format = asked["format"]
cache.filepath = asked["cache"]
cache.frame_start = 0


def vertices(frame):
    bpy.context.scene.frame_set(frame)
    shown = shape.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = shown.to_mesh()
    out = [[number, *vertex.co] for number, vertex in enumerate(mesh.vertices)]
    shown.to_mesh_clear()
    return out


answer({
    "vertices": len(shape.data.vertices),
    "corners": [len(polygon.vertices) for polygon in shape.data.polygons],
    "materials": [material.name for material in shape.data.materials],
    "uvs": len(shape.data.uv_layers),
    "shown": [vertices(frame) for frame in range(asked["frames"])],
})
