# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of docs/export.md."""

import bpy
from addon_under_test import part
from screenshot_panels import load

_FROM_THE_BOW = (78.0, 0.0, 118.0)
_TURNS_OF_THE_WHEEL = 12  # until the panels' end is there


def worst_spot(window):
    """A container ship's patches are made: their report, and where they are farthest from the
    surface."""
    with window.in_view():
        bpy.ops.screen.screen_full_area()
    yield
    hull = load(window, "container_ship")
    space = window.space
    space.show_region_toolbar = space.overlay.show_floor = False
    hull.hull.lines.show_buttocks = hull.hull.show_net = False
    window.open_sidebar()
    yield
    window.look(hull, _FROM_THE_BOW, is_perspective=True)
    conversions = part("features.conversion.conversions")
    with window.in_view():
        bpy.ops.hull.convert("INVOKE_DEFAULT")
    yield lambda: conversions.last_outcome(hull)[0] is not None
    with window.in_view():
        bpy.ops.hull.show_worst_spot(kind="DISTANCE")
    hull.select_set(False)
    region = window.region("UI")
    window.move_to(region.x + 0.5 * region.width, region.y + 0.5 * region.height)
    for _ in range(_TURNS_OF_THE_WHEEL):
        window.hold("WHEELDOWNMOUSE")
    yield
