# SPDX-License-Identifier: GPL-3.0-or-later
"""What is expected of a hull at any moment: all that is shown is of the mesh as it is now."""

import bpy
import numpy as np
from addon_under_test import mesh_points, part, shown_points, state_of
from mathutils import Vector


def edited_points(hull):
    """Control points (n, 3) as they are now, in edit mode or not, in Blender's units."""
    return part("bridge.mesh.mesh_arrays").read_mesh(hull.data).points.copy()


def assert_follows(hull):
    """Surface object, lines and hydrostatics are those of the control mesh as it is now."""
    settings, state = hull.hull, state_of(hull)
    assert not state.status and not state.lines.status and not state.hydrostatics.status
    source, surface = _fresh(hull)
    size = max(hull.dimensions)

    wanted = shown_points(surface, hull)
    shown = mesh_points(settings.surface_object)
    assert shown.shape == wanted.shape
    # Blender keeps points in single precision.
    assert np.abs(shown - wanted).max() <= 1e-6 * size

    where = part("features.flotation.afloat").afloat(settings, 1.0)
    body = source.live_body(surface)
    bodies = part("bridge.objects.appendages").read(hull)
    if bodies and not state.ship.waits:
        points = source.control.points
        body.join(part("features.flotation.appendages").native_bodies(bodies, 1.0, points))
    fresh = part("features.flotation.hydrostatics").computed(body, where)
    volume = state.hydrostatics.values.displaced_volume
    assert abs(volume - fresh.displaced_volume) <= 1e-7 * fresh.displaced_volume

    lines = part("features.lines.lines")
    cuts = lines.wanted_cuts(settings, surface.mesh.points, 1.0)
    nothing_known = part("bridge.mesh.moves").Moves(None, None)
    groups = lines.groups({}, surface, cuts, settings.half, nothing_known)
    assert groups.keys() == state.lines.groups.keys()
    for kind, group in groups.items():
        _assert_same_lines(state.lines.groups[kind].polylines, group.polylines, 1e-9 * size)


def _fresh(hull):
    """(ship.ShipSource, LimitSurface) of the mesh as it is now; the scene is in metres."""
    arrays, native = part("bridge.mesh.mesh_arrays"), part("bridge.native").require()
    data, settings = arrays.read_mesh(hull.data), hull.hull
    excluded = part("bridge.objects.hull_objects").excluded_slots(hull)
    control = arrays.control_arrays(data, 1.0, excluded)
    openings = "closed" if settings.deck_closed else "open"
    deck_edge = tuple(map(tuple, control.deck_edge.tolist()))
    source = part("features.flotation.ship").ShipSource(
        control, settings.scheme, settings.half, openings, deck_edge
    )
    mesh = native.ControlMesh(*control.arguments())
    return source, native.LimitSurface(mesh, settings.scheme)


def _assert_same_lines(shown, wanted, tolerance):
    assert len(shown) == len(wanted)
    for line, other in zip(shown, wanted):
        assert line.shape == other.shape
        assert np.abs(line - other).max() <= tolerance


def snapshot(hull):
    """What is shown of a hull, as numbers to compare."""
    state = state_of(hull)
    polylines = [
        np.asarray(one) for group in state.lines.groups.values() for one in group.polylines
    ]
    return {
        "points": edited_points(hull),
        "surface": mesh_points(hull.hull.surface_object),
        "volume": np.array([state.hydrostatics.values.displaced_volume]),
        "lines": np.concatenate([line.reshape(-1, 3) for line in polylines]),
    }


def are_equal(one, other):
    """Whether two snapshots show the same."""
    return all(
        one[name].shape == other[name].shape and np.allclose(one[name], other[name], 0.0, 1e-6)
        for name in one
    )


def assert_framed(hull):
    """That the 3D view shows all of a hull, large, and that the eye is not in it."""
    screen = bpy.context.window_manager.windows[0].screen
    area = next(area for area in screen.areas if area.type == "VIEW_3D")
    view = area.spaces.active.region_3d
    eye = view.view_matrix.inverted().translation
    corners = [hull.matrix_world @ Vector(corner) for corner in hull.bound_box]
    low, high = (Vector(f(c[i] for c in corners) for i in range(3)) for f in (min, max))
    assert not all(low[i] < eye[i] < high[i] for i in range(3))
    places = []
    for corner in corners:
        x, y, z, w = view.perspective_matrix @ Vector((*corner, 1.0))
        assert w > 0.0 and abs(x) <= 1.05 * w and abs(y) <= 1.05 * w
        places.append((x / w, y / w))
    assert max(np.ptp(places, axis=0)) > 0.5
