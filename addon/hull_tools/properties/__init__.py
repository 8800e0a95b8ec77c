# SPDX-License-Identifier: GPL-3.0-or-later
"""What is saved with the file, and what is saved with the user's preferences."""

import bpy

from . import addon_preferences, hull_settings


def register():
    for cls in addon_preferences.CLASSES:
        bpy.utils.register_class(cls)
    hull_settings.register()


def unregister():
    hull_settings.unregister()
    for cls in reversed(addon_preferences.CLASSES):
        bpy.utils.unregister_class(cls)
