from blender_script import answer, arguments, bpy

answer({"version": bpy.app.version_string, "objects": len(bpy.data.objects), "asked": arguments()})
