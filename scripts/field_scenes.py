# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of docs/first-fields.md, by their files' names: STEPS of a field that is added, dragged,
and held back by another one."""

import bpy
import numpy as np
from addon_under_test import mesh_points


def _alone(window, name):
    """A sample in a window that is nothing but the 3D view."""
    with window.in_view():
        bpy.ops.screen.screen_full_area()
    yield
    space = window.space
    space.show_region_toolbar, space.lens, space.overlay.show_floor = False, 90.0, False
    space.overlay.show_axis_x = space.overlay.show_axis_y = False
    with window.in_view():
        bpy.ops.hull.load_sample(name=name)
    yield
    return bpy.context.view_layer.objects.active


def _look(window, hull, angles, place, closer):
    """place: parts of the hull's largest coordinates that are in the middle."""
    window.look(hull, angles, is_perspective=True)
    view = window.space.region_3d
    view.view_location = mesh_points(hull).max(axis=0) * place
    view.view_distance /= closer


def _nearest(hull, *parts):
    points = mesh_points(hull)
    return points[np.linalg.norm(points - parts * points.max(axis=0), axis=1).argmin()]


def _coaster(window):
    hull = yield from _alone(window, "coaster")
    window.open_sidebar()
    yield
    _look(window, hull, (66.0, 0.0, 138.0), (0.8, 0.3, 0.4), 2.6)
    lines = hull.hull.lines
    lines.show_buttocks = lines.show_waterlines = False
    yield
    return hull


def _added(window, shift=(0.0, 0.0, 0.0)):
    hull = yield from _coaster(window)
    bpy.context.scene.cursor.location = _nearest(hull, 0.7, 1.0, 0.4)
    with window.in_view():
        bpy.ops.hull.add_field()
    field = hull.hull.fields.fields[0]
    field.name, field.shift = "Fuller shoulder", shift
    bpy.context.view_layer.update()
    yield
    return hull


def _dragged(window):
    hull = yield from _added(window, (0.0, 0.7, 0.0))
    with window.in_view():
        bpy.ops.hull.preview_fields()
        bpy.ops.hull.drag_field("INVOKE_DEFAULT")
    bpy.context.view_layer.update()
    yield
    return hull


def _protected(window):
    hull = yield from _added(window, (0.0, 0.7, 0.0))
    with window.in_view():
        bpy.ops.hull.preview_fields()
        bpy.context.scene.cursor.location = _nearest(hull, 0.7, 1.0, 1.0)
        bpy.ops.hull.add_field(role="PROTECT", base="CREASE")
    deck = hull.hull.fields.fields[1]
    deck.name, deck.extent = "Deck edge kept", 5.0
    bpy.context.view_layer.update()
    yield


STEPS = {"fields/added": _added, "fields/dragged": _dragged, "fields/protected": _protected}
