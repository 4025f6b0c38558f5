"""Common start of the scripts that blender.ts runs in Blender. Import this module first: it empties the scene."""

import json
import sys

import bpy

bpy.ops.wm.read_factory_settings(use_empty=True)


def arguments():
    """The arguments of the test."""
    with open(sys.argv[1], encoding="utf-8") as file:
        return json.load(file)


def answer(value):
    """Returns plain data to the test."""
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        json.dump(value, file)
