# SPDX-License-Identifier: GPL-3.0-or-later
"""The control net over the 3D view, by its colour: in object mode, while it is edited, and gone
where it is switched off."""

import bmesh
import bpy
import numpy as np
from addon_under_test import part
from editing import bilge_point, editing_a_hull, select
from test_tag_overlay import mask

_FEW = 20  # pixels that may have its colour by chance


def net_alone(window):
    """A hull in edit mode of which nothing is shown but its net, in Blender's lines and ours."""
    hull = editing_a_hull(window)
    for switch in part("features.lines.lines").SWITCHES.values():
        setattr(hull.hull.lines, switch, False)
    hull.hull.tags.show = False
    part("bridge.objects.shown_objects").surface_of(hull).hide_viewport = True
    return hull


def net_mask(window):
    return mask(window, "net", "net", is_on_light=False)


def net_seen(window):
    return int(net_mask(window).sum())


def test_the_switch_takes_the_net_away_in_object_mode(window):
    hull = net_alone(window)
    window.press("TAB")
    yield
    hull.select_set(False)
    window.area.tag_redraw()
    yield
    assert hull.mode == "OBJECT" and net_seen(window) > 10 * _FEW
    hull.hull.show_net = False
    assert hull.display_type == "BOUNDS"
    yield
    assert net_seen(window) < _FEW
    hull.hull.show_net = True
    assert hull.display_type == "WIRE"
    yield
    assert net_seen(window) > 10 * _FEW
    hull.select_set(True)  # Blender's colour of what is selected
    window.area.tag_redraw()
    yield
    assert net_seen(window) < _FEW


def test_the_net_that_is_edited_has_its_colour_but_where_it_is_selected(window):
    hull = net_alone(window)
    yield
    most = net_seen(window)
    assert most > 10 * _FEW
    select(hull, bilge_point(hull)[0])
    window.area.tag_redraw()
    yield
    less = net_seen(window)
    assert 0.8 * most < less < most - _FEW
    window.press("A")
    yield
    assert net_seen(window) < _FEW
    bpy.ops.mesh.select_all(action="DESELECT")
    bpy.ops.mesh.select_mode(type="EDGE")
    window.area.tag_redraw()
    yield
    assert net_seen(window) > most + _FEW  # points are drawn over it where they can be selected
    window.press("A")
    window.press("H")
    yield
    assert net_seen(window) < _FEW


def test_the_net_follows_points_that_move(window):
    hull = net_alone(window)
    index, _ = bilge_point(hull)
    yield
    before = net_mask(window)
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    bm.verts[index].co.z += 1.0
    bmesh.update_edit_mesh(hull.data, loop_triangles=False, destructive=False)
    yield
    after = net_mask(window)
    assert (before & ~after).sum() > _FEW and (after & ~before).sum() > _FEW
    part("overlays.net")._batches.clear()
    window.area.tag_redraw()
    yield
    assert np.array_equal(net_mask(window), after)
