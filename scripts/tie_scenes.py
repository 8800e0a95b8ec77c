# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of docs/tags.md of tied points."""

import bpy
import numpy as np
from addon_under_test import part
from expect import edited_points
from screenshot_panels import load


def tied_points(window):
    """A coaster's fore body in edit mode: points of a row between two others on a line, one that
    is anchored, and points of a station as high as one of the next."""
    with window.in_view():
        bpy.ops.screen.screen_full_area()
    yield
    hull = load(window)
    window.space.show_region_toolbar = False
    window.open_sidebar()
    yield
    window.look(hull, (68.0, 0.0, 150.0), is_perspective=True)
    window.space.region_3d.view_location = (60.0, 6.0, 4.0)
    window.space.region_3d.view_distance = 46.0
    window.space.overlay.show_floor = False
    lines = hull.hull.lines
    lines.show_buttocks = lines.show_waterlines = lines.show_stations = False
    with window.in_view():
        bpy.ops.object.mode_set(mode="EDIT")
        _tie(hull)
        part("features.hull.hull_state").follow_edit(hull, bpy.context.scene)
        bpy.ops.mesh.select_all(action="DESELECT")
    yield


def _tie(hull):
    ties, kinds = part("features.constraints.ties"), part("bridge.mesh.point_ties").KINDS
    points = edited_points(hull)

    def nearest(*place):
        return int(np.abs(points - place).sum(axis=1).argmin())

    row = list(dict.fromkeys(nearest(x, 6.3, 6.5) for x in (48.0, 52.0, 56.0, 60.0, 64.0, 68.0)))
    ends = [(row[0], row[-1])] * (len(row) - 2)
    ties.tie_points(hull, kinds.index("LINE"), np.array(row[1:-1]), np.array(ends))
    foot, head = nearest(60.0, 5.0, 1.0), nearest(64.0, 5.0, 3.0)
    if foot != head:
        ties.tie_points(hull, kinds.index("ANCHOR"), np.array([foot]), np.array([(head, head)]))
