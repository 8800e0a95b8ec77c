# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's own tools by their keys: local view, duplicate, delete, hide, scale and apply, copy and
paste, join. What shows the hull keeps in step."""

import bpy
import numpy as np
import pytest
from addon_under_test import mesh_points, part, state_of
from editing import hull_at_hand
from expect import assert_follows


def a_hull(window):
    """A sample hull in object mode, whole in the view."""
    with window.in_view():
        bpy.ops.hull.load_sample(name="barge")
        bpy.ops.ed.undo_push(message="begin")
    hull = bpy.context.view_layer.objects.active
    window.look(hull)
    return hull


def surface(hull):
    return part("bridge.objects.shown_objects").surface_of(hull)


def hulls():
    return part("bridge.objects.hull_objects").hulls(bpy.context.scene.objects)


def assert_in_step():
    """Each hull has a surface of its own at its place, and nothing else is in the scene."""
    shown = [surface(hull) for hull in hulls()]
    wanted = {obj.name for obj in (*hulls(), *shown)}
    assert {obj.name for obj in bpy.context.scene.objects} == wanted
    assert len(wanted) == 2 * len(hulls())
    for hull in hulls():
        assert np.allclose(surface(hull).matrix_world, hull.matrix_world)
        assert_follows(hull)


def is_seen(window, obj):
    depsgraph = bpy.context.view_layer.depsgraph
    return obj.evaluated_get(depsgraph).visible_in_viewport_get(window.space)


def test_local_view_shows_surface_and_lines(window):
    hull = a_hull(window)
    with window.in_view():
        bpy.ops.mesh.primitive_cube_add()
        cube = bpy.context.object
        bpy.ops.object.select_all(action="DESELECT")
        hull.select_set(True)
        bpy.context.view_layer.objects.active = hull
    window.press("NUMPAD_SLASH")
    yield
    yield
    assert window.space.local_view is not None and not is_seen(window, cube)
    assert is_seen(window, hull) and is_seen(window, surface(hull))
    with window.in_view():
        (shown,) = part("overlays.view").hulls_in_view()
    assert shown.hull == hull
    window.press("NUMPAD_SLASH")
    yield
    assert window.space.local_view is None and is_seen(window, cube)


def test_duplicate_move_undo_redo_and_delete(window):
    a_hull(window)
    yield
    window.press("D", shift=True)
    window.move_by(80, 60)
    window.click()
    yield
    yield
    assert len(hulls()) == 2 and hull_at_hand().location.length > 1.0
    assert_in_step()
    window.undo()
    yield
    yield
    assert len(hulls()) == 1
    assert_in_step()
    window.redo()
    yield
    yield
    assert len(hulls()) == 2
    assert_in_step()
    window.press("DEL")
    yield
    yield
    assert len(hulls()) == 1
    assert_in_step()
    window.undo()
    yield
    yield
    assert len(hulls()) == 2
    assert_in_step()


def test_hide_and_reveal(window):
    hull = a_hull(window)
    yield
    window.press("H")
    yield
    yield
    assert not is_seen(window, hull) and not is_seen(window, surface(hull))
    window.press("H", alt=True)
    yield
    yield
    assert is_seen(window, hull) and is_seen(window, surface(hull))


def test_scale_is_refused_until_it_is_applied(window):
    hull = a_hull(window)
    length = hull.dimensions.x
    volume = state_of(hull).hydrostatics.values.displaced_volume
    yield
    window.press("S")
    window.write("2")
    window.press("RET")
    yield
    yield
    assert "Ctrl A" in state_of(hull).status
    window.press("A", ctrl=True)
    yield
    window.press("S")
    yield
    yield
    assert hull.scale == hull.scale.__class__((1.0, 1.0, 1.0)) and not state_of(hull).status
    assert np.ptp(mesh_points(surface(hull))[:, 0]) == pytest.approx(2.0 * length)
    assert_in_step()
    hull.hull.draft *= 2.0
    yield
    assert state_of(hull).hydrostatics.values.displaced_volume == pytest.approx(
        8.0 * volume, rel=1e-5
    )
    window.undo()
    window.undo()
    yield
    yield
    assert np.ptp(mesh_points(surface(hull_at_hand()))[:, 0]) == pytest.approx(length)


def test_copy_paste_and_join(window):
    a_hull(window)
    yield
    window.press("C", ctrl=True)
    yield
    window.press("V", ctrl=True)
    yield
    yield
    assert len(hulls()) == 2
    assert_in_step()
    first, second = hulls()
    second.location.x += 200.0
    for each in (first, second):
        each.select_set(True)
    yield
    window.press("J", ctrl=True)
    yield
    yield
    assert len(hulls()) == 1 and hulls()[0].dimensions.x > 200.0
    assert_in_step()
