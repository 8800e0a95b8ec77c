# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of Blender's windows drawn anew."""

import bpy


def redraw(*kinds):
    """Has all areas of these kinds drawn anew, 3D views where none is named."""
    for manager in bpy.data.window_managers:
        for window in manager.windows:
            for area in window.screen.areas:
                if area.type in (kinds or ("VIEW_3D",)):
                    area.tag_redraw()
