# SPDX-License-Identifier: GPL-3.0-or-later
"""The context in which operators are called."""

from contextlib import nullcontext

import bpy


def in_view():
    """That of a 3D view where there is a window, to be used by `with`: a timer has none of its own.
    A file that is loaded brings another window, which has to be entered anew."""
    if bpy.app.background:
        return nullcontext()
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
    region = next(region for region in area.regions if region.type == "WINDOW")
    return bpy.context.temp_override(window=window, area=area, region=region)
