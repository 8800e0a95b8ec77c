# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape fields in the window: added and applied by the sidebar's buttons, seen in the 3D view, and
dragged by their handles."""

import bpy
import numpy as np
import sidebar
from addon_under_test import mesh_points, part
from editing import hull_at_hand

_FROM_PORT_BOW = (68.0, 0.0, 132.0)


def begin(window):
    """The coaster's fore body from its port bow, with the panel, and the 3D cursor at its side."""
    with window.in_view():
        bpy.ops.hull.load_sample(name="coaster")
    hull = hull_at_hand()
    bpy.context.scene.cursor.location = nearest(hull, 0.7, 1.0, 0.4)
    bpy.ops.ed.undo_push(message="begin")
    window.look(hull, _FROM_PORT_BOW)
    window.space.region_3d.view_distance *= 0.45
    window.space.region_3d.view_location = (50.0, 0.0, 3.0)
    sidebar.show_panels(window, "fields")
    window.open_sidebar()
    return hull


def nearest(hull, *parts):
    """The control point nearest to these parts of the hull's largest coordinates."""
    points = mesh_points(hull)
    return points[np.linalg.norm(points - parts * points.max(axis=0), axis=1).argmin()]


def fields():
    return hull_at_hand().hull.fields


def eye(window):
    lines, scale = part("features.modelling.pull_lines"), 1.0
    return lines.eye_of(hull_at_hand(), scale, window.space.region_3d, window.region())


def move_to_handle(window, kind):
    """Moves the mouse to a handle of the chosen field, as it is shown then."""
    handles, drags = part("features.fields.handles"), part("features.modelling.drags")

    def move():
        seen = eye(window)
        row, base = handles.at_hand(hull_at_hand(), bpy.context.scene)
        place = handles.places(row, base, seen, 1.0)[kind]
        x, y = drags.in_picture(seen.to_clip, seen.size, place[None])[0]
        window.cursor = round(window.region().x + x), round(window.region().y + y)
        window._simulate("MOUSEMOVE", "NOTHING")

    window.actions.append(move)


def values():
    field = fields().fields[fields().active_field]
    return np.array([*field.shift, field.extent])


def crease_points(hull):
    """Which points of the mesh are those of the crease of the chosen field."""
    parent = part("features.transformation.parents").of_hull(hull, bpy.context.scene)
    row = fields().fields[fields().active_field]
    _, crease = part("features.fields.base_curves").base_crease(row, parent.surface, parent.scale)
    return parent.control.vertex_ids[np.asarray(crease.vertices)]


def dragged_preview(window, before):
    """A field added by its button is previewed, and its shift dragged along y by so many dots."""
    yield from sidebar.press(window, "hull.add_field", across=sidebar.BESIDE_LIST)
    assert len(fields().fields) == 1 and fields().fields[0].extent > 1.0
    yield from sidebar.press(window, "hull.preview_fields")
    assert fields().is_previewed
    yield from sidebar.press(window, "hull.drag_field")
    move_to_handle(window, "shift")
    yield
    window.hold("LEFTMOUSE")
    window.move_by(10, 4)
    window.press("Y")
    window.move_by(10, 0)
    yield
    held = part("features.fields.handles").held(hull_at_hand())
    assert (held.is_on, held.kind, held.is_dragged) == (True, "shift", True)
    window.let_go("LEFTMOUSE")
    yield
    x, y, z, _ = values()
    assert x == z == 0.0 and 0.2 < abs(y) < 8.0
    assert not np.array_equal(mesh_points(hull_at_hand()), before)


def test_a_field_is_dragged_beside_a_protected_knuckle(window):
    hull = begin(window)
    before = mesh_points(hull)
    yield
    yield from dragged_preview(window, before)
    move_to_handle(window, "extent")
    window.drag(20, 0)
    yield
    shifted, extent = values()[1], values()[3]
    assert extent > 0.16 * np.ptp(before[:, 0])
    window.press("RET")
    yield
    assert not part("features.fields.handles").held(hull_at_hand()).is_on
    window.undo()  # the drags are one step
    yield
    assert values()[1] == 0.0 and values()[3] < extent
    window.redo()
    yield
    assert values()[1] == shifted and values()[3] == extent
    # The deck's edge is protected by a second one.
    bpy.context.scene.cursor.location = nearest(hull_at_hand(), 0.7, 1.0, 1.0)
    yield from sidebar.press(window, "hull.add_field", across=sidebar.BESIDE_LIST)
    yield from sidebar.press(window, "role", across=0.7)
    yield from sidebar.choose(window, "base", lambda: fields().fields[1].base == "CREASE")
    assert fields().fields[1].role == "PROTECT"
    kept = crease_points(hull_at_hand())
    shown = mesh_points(hull_at_hand())
    assert len(kept) > 3 and np.array_equal(shown[kept], before[kept])
    assert not np.array_equal(shown, before)
    yield from sidebar.press(window, "hull.apply_fields")
    assert not fields().is_previewed and np.array_equal(mesh_points(hull_at_hand()), shown)
    window.undo()
    yield
    assert fields().is_previewed and np.array_equal(mesh_points(hull_at_hand()), shown)
    yield from sidebar.press(window, "hull.cancel_fields", across=0.7)
    assert not fields().is_previewed and np.array_equal(mesh_points(hull_at_hand()), before)
    sidebar.show_all_panels()


def test_escape_leaves_the_field_as_it_was(window):
    begin(window)
    yield
    yield from sidebar.press(window, "hull.add_field", across=sidebar.BESIDE_LIST)
    was = values()
    yield from sidebar.press(window, "hull.drag_field")
    for kind in ("shift", "extent"):
        move_to_handle(window, kind)
        window.drag(12, 9)
        yield
    now = values()
    assert (now[:3] != was[:3]).any() and now[3] != was[3]
    window.undo()  # nothing is undone while handles are dragged
    yield
    assert np.array_equal(values(), now)
    window.press("ESC")
    yield
    assert np.array_equal(values(), was)
    assert not part("features.fields.handles").held(hull_at_hand()).is_on
    sidebar.show_all_panels()


def test_a_hull_that_is_scaled_to_nothing_has_no_handles(window):
    """No traceback while it is drawn: there is no way back from the picture to it."""
    begin(window)
    yield
    yield from sidebar.press(window, "hull.add_field", across=sidebar.BESIDE_LIST)
    parent = bpy.data.objects.new("Flat", None)
    bpy.context.collection.objects.link(parent)
    hull_at_hand().parent = parent
    parent.scale = (1.0, 0.0, 1.0)
    yield
    yield
    assert eye(window).from_clip is None
    with window.in_view():
        assert not bpy.ops.hull.drag_field.poll() and not bpy.ops.hull.pull_surface.poll()
    parent.scale = (1.0, 1.0, 1.0)
    yield
    yield from sidebar.press(window, "hull.drag_field")
    assert part("features.fields.handles").held(hull_at_hand()).is_on
    window.press("ESC")
    yield
    sidebar.show_all_panels()
