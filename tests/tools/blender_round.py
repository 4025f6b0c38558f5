"""Imports a GLB and exports it again, with the settings that Blender offers."""

from blender_script import answer, arguments, bpy

asked = arguments()
bpy.ops.import_scene.gltf(filepath=asked["file"])
bpy.ops.export_scene.gltf(filepath=asked["output"], export_format="GLB", export_extras=asked["extras"])
answer({})
