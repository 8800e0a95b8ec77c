# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of docs/production.md from Blender's window: seams over a hull, and rulings."""

import bmesh
import bpy
import numpy as np
from addon_under_test import part
from close_views import coaster_in_window
from screenshot_panels import load, with_plates

_LINES = ("show_buttocks", "show_waterlines", "show_stations", "show_diagonals")


def _without_lines(window, hull, view, closer):
    window.space.overlay.show_floor = False
    for name in _LINES:
        setattr(hull.hull.lines, name, False)
    window.look(hull, view, is_perspective=True)
    window.space.region_3d.view_distance /= closer


def seams(window):
    """The coaster's shell in plates, from ahead and above to port."""
    hull = yield from coaster_in_window(window)
    with_plates(hull)
    _without_lines(window, hull, (68.0, 0.0, 140.0), 1.5)
    yield


def rulings(window):
    """The planing boat's bottom between spray rail and chine, developable, from below."""
    with window.in_view():
        bpy.ops.screen.screen_full_area()
    yield
    hull = load(window, "planing_boat")
    window.space.show_region_toolbar = False
    yield
    _without_lines(window, hull, (112.0, 0.0, 140.0), 1.5)
    with window.in_view():
        bpy.ops.object.mode_set(mode="EDIT")
        _select_bottom(hull)
        bpy.ops.hull.make_developable(warp=1.5, distance=0.1)
        bpy.ops.mesh.select_all(action="DESELECT")
    window.space.show_region_ui = False
    yield


def _select_bottom(hull):
    """Faces that are ruled and broad: those of the bottom."""
    state = part("features.hull.hull_state").up_to_date(hull, bpy.context.scene)
    control, native = state.ship.source.control, part("bridge.native").require()
    points = np.asarray(state.ship.surface.mesh.points)
    bm = bmesh.from_edit_mesh(hull.data)
    bpy.ops.mesh.select_all(action="DESELECT")
    bpy.context.tool_settings.mesh_select_mode = (False, False, True)
    bm.faces.ensure_lookup_table()
    for face, number in enumerate(control.face_ids):
        try:
            row = native.RuledRow(state.ship.surface, [face])
        except ValueError:
            continue
        ends = row.rulings(1)
        broad = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).min()
        if broad > 0.25 and points[row.points][:, 0].min() > 0.1:
            bm.faces[int(number)].select_set(True)
    bmesh.update_edit_mesh(hull.data)
