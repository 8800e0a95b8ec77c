# SPDX-License-Identifier: GPL-3.0-or-later
"""The key of the pie menu while a mesh is edited, unless the user has switched it off in the
add-on's preferences. Blender's own preferences list it under 3D View, Mesh, where it may be
changed."""

import bpy

from ..bridge.blender import preferences

KEY = {"type": "Q", "value": "PRESS", "shift": True}

_items = []  # (keymap, its item)


def _follow_preferences():
    is_wanted = preferences.value("use_pie_key")
    if is_wanted and not _items:
        _add()
    elif not is_wanted:
        _remove()


def _add():
    configuration = bpy.context.window_manager.keyconfigs.addon
    if configuration is None:  # in the background
        return
    keymap = configuration.keymaps.new("Mesh")
    item = keymap.keymap_items.new("wm.call_menu_pie", **KEY)
    item.properties.name = "HULL_MT_pie"
    _items.append((keymap, item))


def _remove():
    while _items:
        keymap, item = _items.pop()
        keymap.keymap_items.remove(item)


def register():
    preferences.listeners.append(_follow_preferences)
    _follow_preferences()


def unregister():
    preferences.listeners.remove(_follow_preferences)
    _remove()
