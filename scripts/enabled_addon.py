# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on that is enabled in this Blender, whatever Blender calls it."""

import importlib

import bpy

_NAMES = ("hull_tools", "bl_ext.user_default.hull_tools")


def part(path):
    """A module of the add-on's inner package, such as `features.exchange.exports`."""
    enabled = [name for name in _NAMES if name in bpy.context.preferences.addons]
    if not enabled:
        raise RuntimeError("Hull Tools is not enabled in this Blender")
    return importlib.import_module(f"{enabled[0]}.hull_tools.{path}")
