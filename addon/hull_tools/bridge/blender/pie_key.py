# SPDX-License-Identifier: GPL-3.0-or-later
"""The key of a pie menu while a mesh is edited. Blender's own preferences list it under 3D View,
Mesh, where it may be changed."""

import bpy

KEY = {"type": "Q", "value": "PRESS", "shift": True}

_MENU = "HULL_MT_pie"
_OPERATOR = "wm.call_menu_pie"


def follow(is_wanted):
    """Has the key in Blender's key map of add-ons, once, or not."""
    configuration = bpy.context.window_manager.keyconfigs.addon
    if configuration is None:  # in the background
        return
    keymap = configuration.keymaps.new("Mesh")
    items = [item for item in keymap.keymap_items if _is_ours(item)]
    if is_wanted and not items:
        keymap.keymap_items.new(_OPERATOR, **KEY).properties.name = _MENU
    for item in items[is_wanted:]:
        keymap.keymap_items.remove(item)


def _is_ours(item):
    return item.idname == _OPERATOR and item.properties.name == _MENU
