# SPDX-License-Identifier: GPL-3.0-or-later
"""Show a hull in Blender's window, ready to model.

blender --python open.py -- FILE
"""

import math
import sys

import bpy
from mathutils import Euler

# The farthest that the view shows, in lengths of the hull.
VIEW_LENGTHS = 1000.0
# The view from off the bow, as the angles of its turn.
VIEW_ANGLES_DEG = (68.0, 0.0, 48.0)


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
    space.clip_end = VIEW_LENGTHS * max(hull.dimensions)
    region = next(region for region in area.regions if region.type == "WINDOW")
    with bpy.context.temp_override(area=area, region=region):
        space.region_3d.view_rotation = Euler(map(math.radians, VIEW_ANGLES_DEG)).to_quaternion()
        bpy.ops.view3d.view_selected()


def show_when_the_window_is_there():
    show(sys.argv[sys.argv.index("--") + 1])


# The hull is the welcome.
bpy.context.preferences.view.show_splash = False
bpy.app.timers.register(show_when_the_window_is_there, first_interval=0.1)
