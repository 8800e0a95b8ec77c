# SPDX-License-Identifier: GPL-3.0-or-later
"""Views of a part of a hull in edit mode, as pictures of the documentation have them."""

import bpy
from screenshot_panels import load


def coaster_in_window(window):
    """A coaster alone in the whole window, with the sidebar; returns it."""
    with window.in_view():
        bpy.ops.screen.screen_full_area()
    yield
    hull = load(window)
    window.space.show_region_toolbar = False
    window.open_sidebar()
    yield
    return hull


def coaster_close_by(window, view, location, distance):
    """The same without lines, in edit mode; returns it. view: the turns
    of the view, degrees; location, distance: where it looks, and from how far, m."""
    hull = yield from coaster_in_window(window)
    window.look(hull, view, is_perspective=True)
    window.space.region_3d.view_location = location
    window.space.region_3d.view_distance = distance
    window.space.overlay.show_floor = False
    lines = hull.hull.lines
    lines.show_buttocks = lines.show_waterlines = lines.show_stations = False
    with window.in_view():
        bpy.ops.object.mode_set(mode="EDIT")
    return hull
