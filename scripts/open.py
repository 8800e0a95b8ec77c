# SPDX-License-Identifier: GPL-3.0-or-later
"""Show a hull in Blender's window, ready to model.

blender --python open.py -- FILE
"""

import sys

import bpy

VIEW_MARGIN_FACTOR = 1000.0


def show(path):
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    bpy.ops.hull.import_hull(filepath=path)
    hull = bpy.context.object
    for area in bpy.context.window.screen.areas:
        if area.type == "VIEW_3D":
            _frame(area, hull)


def _frame(area, hull):
    """Opens the sidebar, shows the materials' colours, and brings the hull into view."""
    space = area.spaces.active
    space.show_region_ui = True
    space.shading.color_type = "MATERIAL"
    space.clip_end = VIEW_MARGIN_FACTOR * max(hull.dimensions)
    region = next(region for region in area.regions if region.type == "WINDOW")
    with bpy.context.temp_override(area=area, region=region):
        bpy.ops.view3d.view_selected()


def show_when_the_window_is_there():
    show(sys.argv[sys.argv.index("--") + 1])


bpy.app.timers.register(show_when_the_window_is_there, first_interval=0.1)
