"""Imports a GLB and exports it again, with default settings except the given option for extras."""

from blender_script import answer, arguments, bpy

asked = arguments()
bpy.ops.import_scene.gltf(filepath=asked["file"])
bpy.ops.export_scene.gltf(filepath=asked["output"], export_format="GLB", export_extras=asked["extras"])
answer({})
