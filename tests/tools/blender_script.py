"""What every script in Blender starts with (blender.ts runs them): import this module first, it empties the scene."""

import json
import sys

import bpy

bpy.ops.wm.read_factory_settings(use_empty=True)


def arguments():
    """What the test asks for."""
    with open(sys.argv[1], encoding="utf-8") as file:
        return json.load(file)


def answer(value):
    """Hands plain data back to the test."""
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        json.dump(value, file)
