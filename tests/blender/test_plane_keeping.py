# SPDX-License-Identifier: GPL-3.0-or-later
"""Points that are kept in their station, waterline or buttock stay there while they are moved."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import make_active, mesh_points, part, state_of
from edited_hulls import at, edit, grid_hull
from test_bilge import FLAT, SIDE, bilge_points, midbody, select_rows
from test_centre_keeping import move, points

X, Y, Z = range(3)


def marks():
    return part("features.constraints.kept_points")


def kept(hull):
    """{index: (axes, places)}"""
    found = marks().read(hull.data)
    return {
        index: ("".join("xyz"[c] for c in range(3) if axes[c]), tuple(place))
        for index, axes, place in zip(
            found.indices.tolist(), found.is_kept.tolist(), found.places.tolist()
        )
    }


def keep(hull, indices, *axes):
    marks().set_axes(hull.data, indices, axes, True)
    bpy.context.view_layer.update()


@pytest.fixture
def hull():
    hull = grid_hull()
    edit(hull)
    return hull


@pytest.mark.parametrize("axis", (X, Y, Z))
@pytest.mark.parametrize("mode", ("EDIT", "OBJECT"))
def test_a_kept_point_slides_in_its_plane(hull, axis, mode):
    index = at(2, 2)
    keep(hull, [index], axis)
    before, wanted = points(hull), np.array([0.25, 0.125, -0.5])
    if mode == "EDIT":
        move(hull, [index], wanted)
    else:
        bpy.ops.object.mode_set(mode=mode)
        hull.data.vertices[index].co = before[index] + wanted
        hull.data.update()
        bpy.context.view_layer.update()
    wanted[axis] = 0.0
    assert points(hull)[index].tolist() == (before[index] + wanted).astype(np.float32).tolist()
    assert np.array_equal(np.delete(points(hull), index, 0), np.delete(before, index, 0))
    assert "stay in their stations" in state_of(hull).keeping.held
    assert state_of(hull).ship.source.control.points[index] == pytest.approx(points(hull)[index])


def test_points_kept_along_two_axes_and_freed_again(hull):
    keep(hull, [at(2, 2), at(3, 2)], X, Z)
    before = points(hull)
    move(hull, [at(2, 2), at(3, 2)], (0.25, 0.5, 0.25))
    assert (points(hull)[[at(2, 2), at(3, 2)]] - before[[at(2, 2), at(3, 2)]]).tolist() == [
        [0.0, 0.5, 0.0]
    ] * 2
    assert marks().set_axes(hull.data, [at(2, 2)], (X,), False) == 1
    assert {axes for axes, _ in kept(hull).values()} == {"z", "xz"}
    marks().set_axes(hull.data, [at(2, 2), at(3, 2)], (X, Y, Z), False)
    assert kept(hull) == {}
    move(hull, [at(2, 2)], (0.25, 0.5, 0.25))
    assert points(hull)[at(2, 2), 0] == before[at(2, 2), 0] + 0.25


def test_numbers_take_the_plane_along(hull):
    index = at(2, 2)
    keep(hull, [index], X)
    scene = bpy.context.scene
    part("features.modelling.point_places").set_points(hull, scene, {index: (2.25, 1.0, 2.0)})
    assert points(hull)[index].tolist() == [2.25, 1.0, 2.0]
    assert kept(hull) == {index: ("x", (2.25, 0.0, 0.0))}
    move(hull, [index], (1.0, 0.0, 0.0))
    assert points(hull)[index, 0] == 2.25


@pytest.mark.parametrize("mode", ("EDIT", "OBJECT"))
def test_planes_go_along_with_the_whole_hull(hull, mode):
    indices = [at(i, 2) for i in range(1, 5)]
    keep(hull, indices, X, Z)
    before = points(hull)
    if mode == "EDIT":
        bpy.ops.mesh.select_all(action="SELECT")
        bpy.ops.transform.resize(value=(1.1, 1.0, 0.5))
        bpy.ops.transform.translate(value=(0.25, 0.0, 1.0))
    else:
        bpy.ops.object.mode_set(mode=mode)
        hull.scale = (1.1, 1.0, 0.5)
        bpy.context.view_layer.update()
        bpy.ops.object.transform_apply(location=False, rotation=False)
    bpy.context.view_layer.update()
    after = points(hull)
    assert np.ptp(after[:, 0]) == pytest.approx(1.1 * np.ptp(before[:, 0]))
    assert np.ptp(after[:, 2]) == pytest.approx(0.5 * np.ptp(before[:, 2]))
    found = kept(hull)
    assert list(found) == indices
    assert all(found[i][1] == (after[i, 0], 0.0, after[i, 2]) for i in indices)


def test_a_station_dragged_alone_stays(hull):
    station = [at(2, j) for j in range(5)]
    keep(hull, station, X)
    before = points(hull)
    move(hull, station, (0.5, 0.0, 0.0))
    assert np.array_equal(points(hull), before)


def chosen(hull, edges):
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    bpy.ops.mesh.select_all(action="DESELECT")
    for a, b in edges:
        bm.edges.get((bm.verts[a], bm.verts[b])).select_set(True)
    bm.select_flush_mode()
    bmesh.update_edit_mesh(hull.data)


def test_divided_edges_keep_what_both_their_ends_are_kept_in(hull):
    """The station at 2 is kept, and two points of the next, one in its waterline too."""
    keep(hull, [at(2, j) for j in range(5)], X)
    keep(hull, [at(2, 1), at(2, 2)], Z)
    keep(hull, [at(3, 1)], X)
    count = len(points(hull))
    edges = [(at(2, 1), at(2, 2)), (at(2, 3), at(2, 4)), (at(2, 3), at(3, 3)), (at(3, 1), at(4, 1))]
    chosen(hull, edges)
    bpy.ops.mesh.subdivide(number_cuts=2)
    bpy.context.view_layer.update()
    new = {index: entry for index, entry in kept(hull).items() if index >= count}
    assert set(new.values()) == {("x", (2.0, 0.0, 0.0))}
    at_2 = np.flatnonzero(points(hull)[:, 0] == 2.0)
    assert sorted(new) == [index for index in at_2.tolist() if index >= count]


def test_extruded_and_duplicated_points_are_free(hull):
    station = [at(5, j) for j in range(5)]
    keep(hull, station, X)
    before, count = points(hull), len(points(hull))
    chosen(hull, [(at(5, j), at(5, j + 1)) for j in range(4)])
    bpy.ops.mesh.extrude_edges_move(TRANSFORM_OT_translate={"value": (1.0, 0.0, 0.0)})
    bpy.context.view_layer.update()
    assert sorted(kept(hull)) == station
    assert points(hull)[count:, 0].tolist() == [6.0] * 5
    assert np.array_equal(points(hull)[:count], before)
    chosen(hull, [(at(5, j), at(5, j + 1)) for j in range(4)])
    bpy.ops.mesh.duplicate()
    bpy.context.view_layer.update()
    assert sorted(kept(hull)) == station
    bpy.ops.transform.translate(value=(2.0, 0.0, 0.0))
    bpy.context.view_layer.update()
    assert points(hull)[-5:, 0].tolist() == [7.0] * 5 and sorted(kept(hull)) == station


def test_undo_and_redo_know_the_planes(hull):
    bpy.ops.ed.undo_push(message="begin")
    index = at(2, 2)
    keep(hull, [index], X)
    bpy.ops.ed.undo_push(message="kept")
    part("features.modelling.point_places").set_points(
        hull, bpy.context.scene, {index: (2.25, 1.0, 2.0)}
    )
    bpy.ops.ed.undo_push(message="moved")
    places = [2.25, 2.0]
    for _ in range(2):
        bpy.ops.ed.undo()
        bpy.context.view_layer.update()
        hull = bpy.context.object
        found = kept(hull)
        assert (points(hull)[index, 0] == 2.0) and (not found or found[index][1][0] == 2.0)
    assert kept(hull) == {}
    for place in reversed(places):
        bpy.ops.ed.redo()
        bpy.context.view_layer.update()
        hull = bpy.context.object
        assert kept(hull)[index][1][0] == points(hull)[index, 0] == place
    move(hull, [index], (1.0, 0.0, 0.0))
    assert points(hull)[index, 0] == 2.25


def test_saved_and_opened(hull, tmp_path):
    keep(hull, [at(2, 2)], X, Y)
    bpy.ops.object.mode_set(mode="OBJECT")
    found = kept(hull)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "kept.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "kept.blend"))
    hull = bpy.data.objects["grid"]
    assert kept(hull) == found and len(found) == 1
    make_active(hull)
    before = points(hull)
    hull.data.vertices[at(2, 2)].co.x += 1.0
    hull.data.update()
    bpy.context.view_layer.update()
    assert np.array_equal(points(hull), before)


def test_what_was_done_without_the_add_on_was_meant(hull):
    keep(hull, [at(2, 2)], X)
    bpy.ops.object.mode_set(mode="OBJECT")
    part("features.hull.hull_state").forget_all()
    hull.data.vertices[at(2, 2)].co.x = 2.5
    hull.data.update()
    bpy.context.view_layer.update()
    assert kept(hull) == {at(2, 2): ("x", (2.5, 0.0, 0.0))}


def test_copies_and_joined_hulls_keep_both(hull):
    keep(hull, [at(2, 2)], X)
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.object.duplicate()
    copy = bpy.context.object
    bpy.context.view_layer.update()
    assert kept(copy) == kept(hull)
    copy.location.x = 10.0
    make_active(hull)
    copy.select_set(True)
    bpy.ops.object.join()
    bpy.context.view_layer.update()
    other = at(2, 2) + 30
    assert kept(hull) == {at(2, 2): ("x", (2.0, 0.0, 0.0)), other: ("x", (12.0, 0.0, 0.0))}


def test_halves_and_whole_hulls():
    bpy.ops.hull.add_hull(kind="ROUND_BILGE")
    hull = bpy.context.object
    index = int(np.argmax(mesh_points(hull)[:, 1]))
    keep(hull, [index], X, Y)
    half = kept(hull)
    assert bpy.ops.hull.make_whole() == {"FINISHED"}
    x, y, _ = half[index][1]
    assert sorted(kept(hull).values()) == [("xy", (x, -y, 0.0)), ("xy", (x, y, 0.0))]
    before = points(hull)
    for vertex in kept(hull):
        hull.data.vertices[vertex].co.y *= 1.5
    hull.data.update()
    bpy.context.view_layer.update()
    assert np.array_equal(points(hull), before)
    assert bpy.ops.hull.make_half(side="STARBOARD") == {"FINISHED"}
    assert list(kept(hull).values()) == list(half.values())


def test_tools_heed_them(hull):
    """What holds points goes to all tools through constraints.move_limits."""
    keep(hull, [at(2, 2)], X)
    keep(hull, [at(3, 2)], Y, Z)
    state = state_of(hull)
    ids = state.ship.source.control.vertex_ids
    limits = part("features.constraints.move_limits").of_hull(
        hull, ids, state.ship.surface.mesh.points
    )
    found = set(zip(ids[limits.held_points].tolist(), map(tuple, limits.held_normals.tolist())))
    assert found == {
        (at(2, 2), (1.0, 0.0, 0.0)),
        (at(3, 2), (0.0, 1.0, 0.0)),
        (at(3, 2), (0.0, 0.0, 1.0)),
    }
    pulling = part("features.modelling.pulling")
    pull = pulling.SurfacePull(hull, bpy.context.scene)
    grip = pull.nearest((2.2, 1.5, 2.0))
    before = points(hull)
    pull.pull(grip, grip.point + (0.1, 0.3, 0.1))
    moved = points(hull) - before
    assert np.abs(moved).max() > 0.1
    assert moved[at(2, 2), 0] == 0.0 and moved[at(2, 2), 1] != 0.0
    assert moved[at(3, 2), 1:].tolist() == [0.0, 0.0] and moved[at(3, 2), 0] != 0.0
    bpy.context.view_layer.update()
    assert state_of(hull).keeping.held == ""


def flat_of(hull, faces, plane):
    flats = part("features.constraints.flats")
    bpy.ops.object.mode_set(mode="OBJECT")
    flats.mark(hull, faces, plane)
    bpy.context.view_layer.update()
    bpy.ops.object.mode_set(mode="EDIT")


def test_with_a_raked_flat_points_go_where_both_hold_them(hull):
    """A plane that leans forward: along the station points slide down the flat."""
    normal = np.array([0.6, 0.8, 0.0])
    faces = [0, 1, 2, 3]
    flat_of(hull, faces, (*normal, 2.0))
    own = np.unique([v for face in faces for v in hull.data.polygons[face].vertices])
    plane = part("features.constraints.flats").regions(hull)[0].plane
    keep(hull, own, X)
    before, index = points(hull)[own], int(own[2])
    move(hull, [index], (0.5, 0.25, 0.125))
    after = points(hull)[own]
    assert np.array_equal(np.delete(after, 2, 0), np.delete(before, 2, 0))
    assert after[2, 0] == before[2, 0] and after[2, 2] == before[2, 2] + 0.125
    assert np.abs(after @ plane[:3] - plane[3]).max() < 1e-6


def test_planes_that_do_not_meet_are_told(hull):
    """A flat at one y, and a point of it that is kept in a buttock at another."""
    faces = [0, 1, 2, 3]
    flat_of(hull, faces, (0.0, 1.0, 0.0, 1.5))
    index = int(hull.data.polygons[0].vertices[0])
    marks().write(hull.data, [index], (False, True, False), [(0.0, 1.25, 0.0)])
    move(hull, [index], (0.0, 0.5, 0.0))
    assert points(hull)[index, 1] == 1.5
    assert "1 point is kept in a plane that does not meet" in state_of(hull).keeping.held


def test_the_centre_plane_holds_too(hull):
    """The keel of a half hull: a point that is kept in its station slides up and down alone."""
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.hull.add_hull(kind="ROUND_BILGE")
    hull = bpy.context.object
    edit(hull)
    index = int(np.argmax(points(hull)[:, 0]))
    keep(hull, [index], X)
    before = points(hull)[index]
    move(hull, [index], (0.5, 0.25, -0.125))
    assert points(hull)[index].tolist() == (before + (0.0, 0.0, -0.125)).tolist()


def test_exact_subdivision_keeps_points_between_kept_ones(hull):
    """Whole stations are kept: the points between those of one station are in it too."""
    for i in (2, 3):
        keep(hull, [at(i, j) for j in range(5)], X)
    assert bpy.ops.hull.subdivide_exactly() == {"FINISHED"}
    found = kept(hull)
    assert sorted({place[0] for _, place in found.values()}) == [2.0, 3.0]
    assert len(found) == 2 * 9
    assert all(points(hull)[index, 0] == place[0] for index, (_, place) in found.items())


def test_an_inserted_row_is_kept_in_the_stations_it_crosses(hull):
    for i in range(6):
        keep(hull, [at(i, j) for j in range(5)], X)
    before = points(hull)
    chosen(hull, [(at(2, 1), at(2, 2))])
    assert bpy.ops.hull.insert_row() == {"FINISHED"}
    assert len(points(hull)) == len(before) + 6
    assert np.array_equal(points(hull)[: len(before), 0], before[:, 0])
    assert sorted(points(hull)[len(before) :, 0]) == pytest.approx(range(6), abs=0)
    assert len(kept(hull)) == len(before) + 6


def test_a_bilge_of_kept_points_is_not_rounded():
    """Rounding moves points within their stations."""
    section = [*FLAT[::2], *bilge_points(4), *SIDE[::2]]
    hull = midbody(section, (1, 6))
    select_rows(hull, len(section), 1, 6)
    keep(hull, range(len(points(hull))), X)
    before = points(hull)
    assert bpy.ops.hull.round_bilge(radius=2.5) == {"FINISHED"}
    assert np.array_equal(points(hull)[:, 0], before[:, 0])
    assert np.abs(points(hull) - before).max() > 0.1
    keep(hull, [3], Z)
    before = points(hull)
    with pytest.raises(RuntimeError, match="1 point is kept in a buttock or waterline"):
        bpy.ops.hull.round_bilge(radius=2.25)
    assert np.array_equal(points(hull), before)


def select_points(hull, indices):
    part("bridge.mesh.selection").select(bpy.context, hull, "vertex", indices)


def test_points_are_kept_selected_and_freed_by_operators(hull):
    station = [at(2, j) for j in range(5)]
    select_points(hull, station)
    assert bpy.ops.hull.keep_points(plane="STATION") == {"FINISHED"}
    select_points(hull, [at(2, 1), at(3, 1)])
    bpy.ops.hull.keep_points(plane="WATERLINE")
    found = {index: axes for index, (axes, _) in kept(hull).items()}
    assert found == {**dict.fromkeys(station, "x"), at(2, 1): "xz", at(3, 1): "z"}
    selected = part("bridge.mesh.selection").selected
    bpy.ops.hull.select_kept(plane="WATERLINE")
    assert sorted(selected(hull, "vertex")) == [at(2, 1), at(3, 1)]
    bpy.ops.hull.free_points(plane="STATION")
    bpy.ops.hull.select_kept()
    assert sorted(selected(hull, "vertex")) == sorted([*station, at(3, 1)])
    assert kept(hull)[at(2, 1)][0] == "z"
    bpy.ops.mesh.select_all(action="DESELECT")
    for name in ("keep_points", "free_points"):
        with pytest.raises(RuntimeError, match="Select the points first"):
            getattr(bpy.ops.hull, name)()
    bpy.ops.hull.free_points(everything=True)
    assert kept(hull) == {}
    with pytest.raises(RuntimeError, match="No point is kept so"):
        bpy.ops.hull.select_kept(plane="BUTTOCK")


def test_all_points_are_kept_in_their_stations_in_both_modes(hull):
    bpy.ops.hull.keep_all_points(plane="WATERLINE")
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.hull.keep_all_points()
    assert [axes for axes, _ in kept(hull).values()] == ["xz"] * len(points(hull))


def test_hull_files_have_kept_and_locked_points(hull, tmp_path):
    keep(hull, [at(2, 2), at(3, 2)], X)
    keep(hull, [at(3, 2)], Y, Z)
    select_points(hull, [at(4, 1)])
    bpy.ops.hull.lock_points()
    bpy.ops.object.mode_set(mode="OBJECT")
    before, path = kept(hull), str(tmp_path / "kept.hull.json")
    assert bpy.ops.hull.export_hull(filepath=path) == {"FINISHED"}
    assert bpy.ops.hull.import_hull(filepath=path) == {"FINISHED"}
    again = bpy.context.object
    assert again != hull and kept(again) == before
    locks = part("features.constraints.point_locks").locked_points(again.data)
    assert locks.tolist() == [at(4, 1)]
    make_active(again)
    edit(again)
    there = points(again)
    move(again, [at(3, 2)], (0.5, 0.5, 0.5))
    assert np.array_equal(points(again), there)
