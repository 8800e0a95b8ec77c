# SPDX-License-Identifier: GPL-3.0-or-later
"""Tied points are where others say: while these are dragged, after renumbering, copying, saving,
undo; circles, and what flats and planes contradict, are refused by name."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import part, sample, state_of
from edited_hulls import at, edit, grid_hull
from test_centre_keeping import move, points
from tied_hulls import SINGLE, misses, stored_misses, tie, ties


@pytest.fixture
def hull():
    hull = grid_hull()
    edit(hull)
    return hull


def select_points(hull, indices, active=None):
    bpy.ops.mesh.select_all(action="DESELECT")
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    for index in indices:
        bm.verts[index].select_set(True)
    bm.select_flush_mode()
    if active is not None:
        bm.select_history.clear()
        bm.select_history.add(bm.verts[active])
    bmesh.update_edit_mesh(hull.data)


def stored(hull):
    return {point: (kind, to) for kind, point, to, _ in ties().stored_ties(hull.data)}


def test_a_point_stays_on_its_line(hull):
    row = [at(1, 2), at(2, 2), at(4, 2)]
    select_points(hull, row)
    assert bpy.ops.hull.tie_points(kind="LINE") == {"FINISHED"}
    assert stored(hull) == {at(2, 2): ("LINE", (at(1, 2), at(4, 2)))}
    assert misses(hull)["LINE"] <= 1e-12
    ((_, _, _, (share, _, _)),) = ties().stored_ties(hull.data)
    move(hull, [at(4, 2)], (0.5, 0.25, 0.75))
    ends = points(hull)[[at(1, 2), at(4, 2)]].astype(float)
    wanted = (1 - share) * ends[0] + share * ends[1]
    assert points(hull)[at(2, 2)] == pytest.approx(wanted, abs=1e-6)
    assert misses(hull)["LINE"] <= 1e-12
    # Dragged itself it slides along, and not beyond its ends.
    before = points(hull)[at(2, 2)]
    move(hull, [at(2, 2)], (0.5, 0.0, 0.0))
    assert points(hull)[at(2, 2)][0] > before[0] + 0.25
    assert "stay where they are tied" in state_of(hull).keeping.held
    move(hull, [at(2, 2)], (9.0, 0.0, 0.0))
    assert points(hull)[at(2, 2)] == pytest.approx(points(hull)[at(4, 2)], abs=1e-6)
    assert misses(hull)["LINE"] <= 1e-12


def test_an_anchored_point_goes_along(hull):
    select_points(hull, [at(2, 2), at(3, 2), at(3, 3)], active=at(3, 3))
    bpy.ops.hull.tie_points(kind="ANCHOR")
    before = points(hull)
    move(hull, [at(3, 3)], (0.5, 0.25, -0.25))
    moved = points(hull) - before
    assert moved[[at(2, 2), at(3, 2)]] == pytest.approx(np.tile((0.5, 0.25, -0.25), (2, 1)))
    assert np.abs(np.delete(moved, [at(2, 2), at(3, 2), at(3, 3)], 0)).max() == 0.0
    before = points(hull)
    move(hull, [at(2, 2)], (1.0, 1.0, 1.0))
    assert points(hull) == pytest.approx(before, abs=1e-6)
    assert misses(hull)["ANCHOR"] <= 1e-12


def test_level_points_go_together_by_any(hull):
    pair = [at(2, 4), at(3, 4)]
    select_points(hull, pair, active=at(3, 4))
    bpy.ops.hull.tie_points(kind="LEVEL")
    move(hull, [at(3, 4)], (0.0, 0.0, 0.5))
    assert points(hull)[pair, 2].tolist() == [4.5, 4.5]
    move(hull, [at(2, 4)], (0.25, 0.0, -0.25))
    assert points(hull)[pair, 2].tolist() == [4.25, 4.25]
    assert misses(hull)["LEVEL"] == 0.0


def test_mirror_pairs_of_a_whole_hull_go_together_both_ways(hull):
    bpy.ops.object.mode_set(mode="OBJECT")
    assert bpy.ops.hull.make_whole() == {"FINISHED"}
    edit(hull)
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.hull.tie_points(kind="MIRROR")
    pairs = {point: to[0] for point, (kind, to) in stored(hull).items()}
    assert len(pairs) == 30
    starboard, port = next((s, p) for s, p in pairs.items() if p == at(2, 2))
    for index in (port, starboard):
        move(hull, [index], (0.25, 0.125, 0.5))
        there = points(hull)
        assert there[starboard].tolist() == (there[port] * (1, -1, 1)).tolist()
    assert misses(hull)["MIRROR"] == 0.0


def test_deck_at_side_is_below_the_centre_by_a_share_of_the_breadth(hull):
    """1/50 of the local breadth, whatever becomes of it."""
    select_points(hull, [at(2, 4), at(3, 4)], active=at(3, 4))
    bpy.ops.hull.tie_points(kind="CAMBER")
    y = abs(float(points(hull)[at(2, 4), 1]))
    assert points(hull)[at(2, 4), 2] == pytest.approx(4.0 - 2.0 * y / 50.0)
    move(hull, [at(2, 4)], (0.0, 1.0, 0.0))
    assert points(hull)[at(2, 4), 2] == pytest.approx(4.0 - 2.0 * (y + 1.0) / 50.0)
    move(hull, [at(3, 4)], (0.0, 0.0, 0.5))
    assert points(hull)[at(2, 4), 2] == pytest.approx(4.5 - 2.0 * (y + 1.0) / 50.0)
    assert misses(hull)["CAMBER"] <= 1e-12


def test_points_follow_in_a_chain(hull):
    tie(hull, "ANCHOR", [at(2, 2)], at(3, 2))
    tie(hull, "ANCHOR", [at(3, 2)], at(4, 2))
    tie(hull, "LINE", [at(1, 2)], at(0, 2), at(2, 2))
    before = points(hull)
    move(hull, [at(4, 2)], (0.0, 0.5, 0.0))
    moved = points(hull) - before
    assert moved[[at(2, 2), at(3, 2)], 1] == pytest.approx([0.5, 0.5])
    assert 0.0 < moved[at(1, 2), 1] < 0.5
    assert max(misses(hull).values()) <= 1e-12


def test_circles_are_refused_by_name(hull):
    tie(hull, "ANCHOR", [at(2, 2)], at(3, 2))
    tie(hull, "ANCHOR", [at(3, 2)], at(4, 2))
    before = points(hull)
    with pytest.raises(
        ValueError,
        match=f"Point {at(4, 2)} would follow itself, by points {at(2, 2)} and {at(3, 2)}",
    ):
        tie(hull, "ANCHOR", [at(4, 2)], at(2, 2))
    select_points(hull, [at(4, 2), at(2, 2)], active=at(2, 2))
    with pytest.raises(RuntimeError, match="would follow itself"):
        bpy.ops.hull.tie_points(kind="ANCHOR")
    assert np.array_equal(points(hull), before) and len(stored(hull)) == 2


def test_what_is_held_elsewhere_is_refused(hull):
    part("features.constraints.kept_points").set_axes(hull.data, [at(2, 4)], (2,), True)
    select_points(hull, [at(2, 4), at(3, 3)], active=at(3, 3))
    with pytest.raises(RuntimeError, match="1 point is kept in a flat, a plane"):
        bpy.ops.hull.tie_points(kind="LEVEL")
    select_points(hull, [at(1, 1)])
    bpy.ops.hull.lock_points()
    select_points(hull, [at(1, 1), at(3, 3)], active=at(3, 3))
    with pytest.raises(RuntimeError, match="1 point is locked"):
        bpy.ops.hull.tie_points(kind="LEVEL")
    assert stored(hull) == {}
    # In a plane that goes with it a point may be tied.
    select_points(hull, [at(2, 4), at(3, 4)], active=at(3, 4))
    assert bpy.ops.hull.tie_points(kind="LEVEL") == {"FINISHED"}
    # What comes into contradiction later is told, and the plane counts.
    move(hull, [at(3, 4)], (0.0, 0.0, 0.5))
    assert points(hull)[at(2, 4), 2] == 4.0
    assert "which their ties would have them leave" in state_of(hull).keeping.held


def test_too_little_selected_is_told(hull):
    for kind, message in (
        ("LINE", "at least three points"),
        ("ANCHOR", "last of all the one"),
        ("MIRROR", "half hull has no other side"),
    ):
        select_points(hull, [at(2, 2)])
        with pytest.raises(RuntimeError, match=message):
            bpy.ops.hull.tie_points(kind=kind)
    with pytest.raises(RuntimeError, match="No point is tied"):
        bpy.ops.hull.select_tied()


def test_points_are_selected_and_untied(hull):
    select_points(hull, [at(2, 2), at(3, 2), at(3, 3)], active=at(3, 3))
    bpy.ops.hull.tie_points(kind="ANCHOR")
    bpy.ops.hull.select_tied()
    assert sorted(part("bridge.mesh.mesh_points").selected(hull.data)) == [at(2, 2), at(3, 2)]
    select_points(hull, [at(2, 2)])
    bpy.ops.hull.untie_points()
    assert list(stored(hull)) == [at(3, 2)]
    before = points(hull)
    move(hull, [at(3, 3)], (0.5, 0.0, 0.0))
    assert points(hull)[at(2, 2)].tolist() == before[at(2, 2)].tolist()


def test_renumbered_points_keep_their_ties(hull):
    tie(hull, "LINE", [at(2, 3)], at(1, 3), at(4, 3))
    tie(hull, "ANCHOR", [at(5, 4)], at(5, 3))
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    bmesh.ops.delete(bm, geom=[bm.verts[at(0, 0)], bm.verts[at(1, 0)]], context="VERTS")
    bmesh.update_edit_mesh(hull.data)
    bpy.context.view_layer.update()
    assert {point + 2: kind for point, (kind, _) in stored(hull).items()} == {
        at(2, 3): "LINE",
        at(5, 4): "ANCHOR",
    }
    before = points(hull)
    move(hull, [at(4, 3) - 2], (0.0, 0.5, 0.0))
    assert points(hull)[at(2, 3) - 2, 1] > before[at(2, 3) - 2, 1] + 0.1
    assert max(stored_misses(hull)) <= SINGLE


def test_a_point_whose_leader_goes_is_free_and_that_is_told(hull):
    tie(hull, "ANCHOR", [at(2, 2)], at(5, 4))
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    bmesh.ops.delete(bm, geom=[bm.verts[at(5, 4)]], context="VERTS")
    bmesh.update_edit_mesh(hull.data)
    bpy.context.view_layer.update()
    assert "1 point is no longer tied: a point that they followed is gone" in (
        state_of(hull).keeping.held
    )
    move(hull, [at(2, 2)], (0.5, 0.0, 0.0))
    assert points(hull)[at(2, 2), 0] == 2.5


def test_extruded_and_divided_points_are_free(hull):
    tie(hull, "ANCHOR", [at(5, 4), at(5, 3)], at(4, 2))
    select_points(hull, [at(5, 4), at(5, 3)])
    bpy.ops.mesh.extrude_region_move(TRANSFORM_OT_translate={"value": (1.0, 0.0, 0.0)})
    bpy.context.view_layer.update()
    assert sorted(stored(hull)) == [at(5, 3), at(5, 4)]
    assert points(hull)[[at(5, 3), at(5, 4)], 0].tolist() == [5.0, 5.0]
    assert np.flatnonzero(points(hull)[:, 0] == 6.0).tolist() == [30, 31]
    select_points(hull, [at(5, 4), at(5, 3)])
    bpy.ops.mesh.subdivide()
    bpy.context.view_layer.update()
    assert sorted(stored(hull)) == [at(5, 3), at(5, 4)]
    assert max(misses(hull).values()) <= 1e-12


def test_ties_of_both_sides(hull):
    bpy.ops.object.mode_set(mode="OBJECT")
    tie(hull, "ANCHOR", [at(2, 2)], at(3, 3))
    tie(hull, "LINE", [at(2, 1)], at(1, 1), at(4, 1))
    bpy.ops.hull.make_whole()
    found = stored(hull)
    assert len(found) == 4 and not state_of(hull).keeping.held
    port, other = points(hull)[sorted(found)[:2]], points(hull)[sorted(found)[2:]]
    assert np.abs(port - other * (1, -1, 1)).max() < 1e-6
    assert max(misses(hull).values()) <= 1e-12
    bpy.ops.hull.make_half(side="PORT")
    assert stored(hull) == {
        at(2, 2): ("ANCHOR", (at(3, 3),)),
        at(2, 1): ("LINE", (at(1, 1), at(4, 1))),
    }


def test_distances_go_along_with_the_whole_hull(hull):
    tie(hull, "ANCHOR", [at(2, 2)], at(3, 3))
    tie(hull, "CAMBER", [at(2, 4)], at(3, 4))
    bpy.ops.object.mode_set(mode="OBJECT")
    before = points(hull)
    part("features.dimensions.dimensions").scale_hull(hull, bpy.context.scene, (2.0, 1.5, 0.5))
    after = points(hull)
    assert after[at(2, 2)] == pytest.approx(before[at(2, 2)] * (2.0, 1.5, 0.5))
    assert after[at(2, 4), 2] == pytest.approx(after[at(3, 4), 2] - 2.0 * after[at(2, 4), 1] / 50)
    assert max(misses(hull).values()) <= 1e-12


def test_exact_subdivision_unties_what_no_longer_holds(hull):
    bpy.ops.object.mode_set(mode="OBJECT")
    tie(hull, "ANCHOR", [at(0, 2)], at(3, 3))
    assert bpy.ops.hull.subdivide_exactly() == {"FINISHED"}
    assert stored(hull) == {}
    assert "1 point is no longer tied: the mesh is another one" in state_of(hull).keeping.held


def test_tools_heed_them():
    """The volume asked for is reached with the tied points where they belong: nothing moves after
    the solution was found."""
    hull = sample("coaster")
    there = part("bridge.mesh.mesh_points").read(hull.data)
    held = part("features.constraints.tie_keeping").held_planes(hull)
    free = [i for i in range(len(there)) if i not in held and there[i, 1] > 0.5]
    wet = sorted(free, key=lambda i: there[i, 2])[:24]
    for place in range(0, 24, 4):
        tie(hull, "ANCHOR", [wet[place]], wet[place + 1])
        tie(hull, "LINE", [wet[place + 2]], wet[place + 1], wet[place + 3])
    before = {point: numbers for _, point, _, numbers in ties().stored_ties(hull.data)}
    state = part("features.hull.hull_state").up_to_date(hull, bpy.context.scene)
    ids, control = state.ship.source.control.vertex_ids, state.ship.source.control.points
    limits = part("features.constraints.move_limits").of_hull(hull, ids, control)
    assert len(limits.tied) == 3 * 12
    bpy.ops.hull.add_target()
    row = hull.hull.targets.rows[-1]
    row.quantity, row.value = "VOLUME", 1.02 * state.hydrostatics.values.displaced_volume
    assert bpy.ops.hull.solve_targets() == {"FINISHED"}
    assert not state_of(hull).keeping.held
    moves = part("bridge.mesh.mesh_points").read(hull.data) - there
    assert np.abs(moves[wet]).max() > 0.01
    assert state_of(hull).hydrostatics.values.displaced_volume == pytest.approx(row.value, rel=2e-6)
    assert max(misses(hull).values()) <= 1e-12
    after = {point: numbers for _, point, _, numbers in ties().stored_ties(hull.data)}
    assert all(after[point] == pytest.approx(before[point], abs=1e-4) for point in before)
