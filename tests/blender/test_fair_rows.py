# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of control points: which they are, how they bend, and that they become smooth within a
deviation and what holds them."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import hull_io, mesh_points, part, state_of
from edited_hulls import at, edit, grid_hull, keys, select

pytestmark = pytest.mark.once

COLUMNS, ROWS = 9, 7
SEED = 20261123


def rows_of(hull, edges, are_whole=True):
    control = state_of(hull).ship.source.control
    rows = hull_io("control_rows")
    return rows.RowNet(control).rows_of(edges, are_whole)


def along(j, columns=COLUMNS):
    return [at(i, j, ROWS) for i in range(columns)]


def either_way(points):
    return min(list(points), list(points)[::-1])


def crease(hull, pairs):
    wanted = keys(pairs)
    edges = [e.index for e in hull.data.edges if tuple(sorted(e.vertices)) in wanted]
    part("bridge.blender.blender_versions").set_creases(hull.data, edges, [])
    part("features.hull.hull_state").follow_edit(hull, bpy.context.scene)


def test_rows_go_on_across_faces_and_along_borders():
    hull = grid_hull(COLUMNS, ROWS)
    for j in (0, 3, ROWS - 1):  # inside, and both borders
        (row,) = rows_of(hull, [(at(4, j, ROWS), at(5, j, ROWS))])
        assert either_way(row.points) == along(j)
        assert not row.is_closed and row.knuckles == () and len(row.parts()) == 1
    (short,) = rows_of(hull, list(zip(along(3)[2:], along(3)[3:6])), are_whole=False)
    assert either_way(short.points) == along(3)[2:6]


def test_rows_have_knuckles_where_they_cross_creases():
    hull = grid_hull(COLUMNS, ROWS)
    across = [at(3, j, ROWS) for j in range(ROWS)]
    crease(hull, zip(across, across[1:]))
    (row,) = rows_of(hull, [(at(6, 3, ROWS), at(7, 3, ROWS))])
    assert either_way(row.points) == along(3)
    assert row.points[list(row.knuckles)].tolist() == [at(3, 3, ROWS)]
    assert [len(part) for part, _ in row.parts()] in ([4, 6], [6, 4])
    (knuckle,) = rows_of(hull, [across[2:4]])
    assert either_way(knuckle.points) == across and knuckle.knuckles == ()
    (border,) = rows_of(hull, [along(0)[5:7]])
    assert border.points[list(border.knuckles)].tolist() == [at(3, 0, ROWS)]


def test_rows_may_be_closed():
    rows = hull_io("control_rows")
    arrays = part("bridge.mesh.mesh_arrays").ControlArrays
    # A tube of six faces around and two along.
    faces = [(6 * r + i, 6 * r + (i + 1) % 6, 6 * r + 6 + (i + 1) % 6, 6 * r + 6 + i)
             for r in range(2) for i in range(6)]  # fmt: skip
    none = np.empty((0, 2), dtype=np.int64)
    points = np.zeros((18, 3))
    numbers = np.arange(18), np.arange(12)
    control = arrays(
        points, np.full(12, 4), np.array(faces).ravel(), none, none[:, 0], *numbers, none
    )
    (ring,) = rows.RowNet(control).rows_of([(6, 7)])
    assert ring.is_closed and sorted(ring.points) == list(range(6, 12))
    assert keys(rows.edges_of(ring)) == keys((6 + i, 6 + (i + 1) % 6) for i in range(6))
    assert [closed for _, closed in ring.parts()] == [True]


def test_bends_are_those_of_circles():
    """In any plane: 1/R towards the centre."""
    combs = part("features.fairness.row_combs")
    random = np.random.default_rng(SEED)
    frame = np.linalg.qr(random.normal(size=(3, 3)))[0]
    angles = np.sort(random.uniform(0.0, 5.0, 12))
    out = np.column_stack([np.cos(angles), np.sin(angles), 0.0 * angles]) @ frame
    places, bends = combs.bends_of(4.0 * out)
    np.testing.assert_array_equal(places, 4.0 * out[1:-1])
    np.testing.assert_allclose(bends, -0.25 * out[1:-1], atol=1e-13)
    assert not combs.bends_of(np.outer(np.arange(5.0), (1.0, 2.0, 3.0)))[1].any()


def test_inflections_are_counted_in_plan_and_in_profile():
    combs = part("features.fairness.row_combs")
    row = hull_io("control_rows").Row(np.arange(41), False, ())
    x = np.linspace(0.1, 4.0 * np.pi + 1.0, 41)
    plan = np.column_stack([x, np.sin(x), 0.05 * x**2])
    both = np.column_stack([x, np.sin(x), np.sin(x)])
    assert len(combs.inflections(plan, row)) == 4
    found = combs.inflections(both, row)
    assert len(found) == 8
    # To a sample, of 16 between two points.
    assert np.abs(np.sin(found[:, 0])).max() < (x[1] - x[0]) / 16.0
    section = plan[:, [2, 0, 1]] * (1e-3, 1.0, 1.0)
    assert len(combs.inflections(section, row)) == 4
    # Waves are not seen that are less deep than 2 in 10 000 of the beam.
    assert not len(combs.inflections(np.vstack([both, (0.0, 1e4, 0.0)]), row))


def smooth(points, deviation, held=(), closed=False):
    count = len(points)
    conditions = np.array([np.eye(3 * count)[3 * i + axis] for i in held for axis in range(3)])
    smoothing = part("features.fairing.row_smoothing")
    parts = [(np.arange(count), closed)]
    return smoothing.smooth(points, parts, conditions.reshape(-1, 3 * count), deviation)


def noisy(count=15):
    random = np.random.default_rng(SEED)
    x = np.linspace(0.0, 30.0, count)
    points = np.column_stack([x, 5.0 - 0.005 * x**2, 0.1 * x])
    return points + random.normal(0.0, 0.01, points.shape)


def test_rows_are_as_smooth_as_can_be_within_the_deviation():
    """No other moves as far are smoother; Dierckx's curve with few knots is not, either."""
    native = part("bridge.native").require()
    points, random = noisy(), np.random.default_rng(SEED)
    length = np.linalg.norm(np.diff(points, axis=0), axis=1)
    t = np.concatenate([[0.0], np.cumsum(length)])

    def jumps(q):
        thirds = native.smooth_curve(q, 0.0, parameters=t).evaluate(0.5 * (t[1:] + t[:-1]), 3)
        return (np.diff(thirds, axis=0)[1:-1] ** 2).sum() * (t[-1] / (len(t) - 1)) ** 6

    for deviation in (1e-3, 5e-3):
        found = smooth(points, deviation, held=(0, 14))
        assert found.is_bound and found.rms == pytest.approx(deviation, rel=1e-12)
        assert not found.moves[[0, 14]].any()
        assert found.before == pytest.approx(jumps(points), rel=1e-9)
        assert found.after == pytest.approx(jumps(points + found.moves), rel=1e-6)
        for size in (1e-3, 0.1, 1.0):
            other = found.moves + size * deviation * random.normal(size=points.shape)
            other[[0, 14]] = 0.0
            other *= deviation * np.sqrt(13.0) / np.linalg.norm(other)
            assert jumps(points + other) > found.after
    free = smooth(points, 5e-3)
    curve = native.smooth_curve(points, 5e-3, parameters=t).evaluate(t)
    assert np.sqrt(((curve - points) ** 2).sum(axis=1).mean()) == pytest.approx(5e-3, rel=1e-6)
    assert free.after <= jumps(curve)
    # Cubics have no jumps: more is of no use, and none is taken.
    most = smooth(points, 1e3)
    assert not most.is_bound and most.rms < 0.1 and most.after < 1e-18 * most.before
    assert not smooth(points, 0.0).moves.any()


def test_closed_rows_are_smoothed_all_around():
    """Turned by a point they are smoothed alike: it counts nowhere that they begin."""
    angles = np.linspace(0.0, 2.0 * np.pi, 16, endpoint=False)
    points = 5.0 * np.column_stack([0.0 * angles, np.cos(angles), np.sin(angles)])
    points += np.random.default_rng(SEED).normal(0.0, 0.01, points.shape)
    found = smooth(points, 5e-3, closed=True)
    turned = smooth(np.roll(points, 5, axis=0), 5e-3, closed=True)
    np.testing.assert_allclose(np.roll(turned.moves, -5, axis=0), found.moves, atol=1e-5)


def coaster_row():
    """(the coaster in edit mode with a row along the bilge, of which the middle point is 60 mm
    inwards and its two edges are selected)."""
    bpy.ops.hull.load_sample(name="coaster")
    hull = part("bridge.objects.hull_objects").hull_of(bpy.context.view_layer.objects.active)
    edit(hull, (False, True, False))
    points = mesh_points_now(hull)
    control = state_of(hull).ship.source.control
    near = np.linalg.norm(points - (45.0, 6.6, 0.8), axis=1).argsort()
    net = hull_io("control_rows").RowNet(control)
    edges = [e for e in net.edges_at(near[0]) if np.ptp(points[list(e), 0]) > 1.0]
    row = net.row_through(edges[0])
    dented = points[row.points[[len(row.points) // 2]]] - (0.0, 0.06, 0.0)
    write = part("bridge.mesh.mesh_points").write
    write(hull.data, row.points[[len(row.points) // 2]], dented)
    part("features.hull.hull_state").follow_edit(hull, bpy.context.scene)
    select(hull, "edge", hull_io("control_rows").edges_of(row)[6:8])
    return hull, row


def mesh_points_now(hull):
    return part("bridge.mesh.mesh_points").read(hull.data)


def test_a_row_is_shown_and_faired():
    hull, row = coaster_row()
    assert bpy.ops.hull.show_rows() == {"FINISHED"}
    group = state_of(hull).fairness.combs["row"]
    assert either_way(group.rows[0].points) == either_way(row.points)
    before = group.mark_counts["inflection"]
    assert before == 2 and len(group.comb(1.0)[0]) == len(row.points) - 2
    start = mesh_points_now(hull)
    assert bpy.ops.hull.fair_row(deviation_mm=60.0) == {"FINISHED"}
    after = mesh_points_now(hull)
    np.testing.assert_array_equal(after[:, 0], start[:, 0])
    moved = np.flatnonzero((after != start).any(axis=1))
    assert set(moved) <= {int(row.points[7])}
    fairing = part("features.fairing.row_fairing")
    report, is_current = fairing.last_report(hull)
    assert is_current and report.rms == pytest.approx(60e-3, rel=1e-9)
    assert report.before == before and report.after == 0
    assert report.largest == pytest.approx(np.linalg.norm(after - start, axis=1).max(), abs=1e-5)
    # What is shown has followed.
    group = state_of(hull).fairness.combs["row"]
    assert group.mark_counts["inflection"] == report.after
    bpy.ops.object.mode_set(mode="OBJECT")
    assert len(state_of(hull).fairness.combs["row"].rows) == 1
    hull.hull.fairness.comb_rows = False
    bpy.context.view_layer.update()
    assert "row" not in state_of(hull).fairness.combs


def test_rows_that_cannot_be_shown_for_another_reason_say_it():
    hull, _ = coaster_row()
    hull.hull.fairness.comb_stations = True
    hull.hull.lines.show_stations, hull.hull.lines.stations = True, "abc"
    with pytest.raises(RuntimeError, match='"abc" should be numbers'):
        bpy.ops.hull.show_rows()
    bpy.ops.object.mode_set(mode="OBJECT")


def test_what_holds_points_holds_in_rows():
    hull, row = coaster_row()
    locked = row.points[len(row.points) // 2 - 1]
    select(hull, "vertex", [locked])
    bpy.ops.hull.lock_points()
    select(hull, "edge", hull_io("control_rows").edges_of(row))
    points, scene = mesh_points_now(hull), bpy.context.scene
    fairing = part("features.fairing.row_fairing")
    fairing.fair_rows(hull, scene, fairing.Asked(5e-3, keep_ends=False, keep_stations=False))
    after = mesh_points_now(hull)
    np.testing.assert_array_equal(after[locked], points[locked])
    held = np.flatnonzero(np.abs(points[:, 1]) < 1e-6)
    assert not after[held, 1].any()
    assert (after != points).any()
    bpy.ops.object.mode_set(mode="OBJECT")


def test_what_is_no_row_is_refused():
    hull = grid_hull(COLUMNS, ROWS)
    edit(hull, (False, True, False))
    fairing = part("features.fairing.row_fairing")
    start = mesh_points_now(hull)

    def refused(words, edges, deviation=0.01):
        select(hull, "edge", edges)
        with pytest.raises(ValueError, match=words):
            fairing.fair_rows(hull, bpy.context.scene, fairing.Asked(deviation))
        np.testing.assert_array_equal(mesh_points_now(hull), start)

    line = list(zip(along(3), along(3)[1:]))
    refused("Select the row", [])
    refused("Deviation", line, float("nan"))
    refused("Deviation", line, -1.0)
    across = [(at(4, j, ROWS), at(4, j + 1, ROWS)) for j in range(ROWS - 1)]
    refused("Rows meet", line + across)
    with pytest.raises(RuntimeError, match="Select edges or points"):
        bpy.ops.mesh.select_all(action="DESELECT")
        bpy.ops.hull.show_rows()
    select(hull, "vertex", [at(4, 3, ROWS)])
    assert bpy.ops.hull.show_rows() == {"FINISHED"}
    assert len(state_of(hull).fairness.combs["row"].rows) == 2
    bm = bmesh.from_edit_mesh(hull.data)
    assert len(bm.verts) == len(start)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert len(mesh_points(hull)) == len(start)


def test_a_row_needs_points_enough():
    hull = grid_hull(4, 3)
    edit(hull, (False, True, False))
    fairing = part("features.fairing.row_fairing")
    select(hull, "edge", [(1, 4)])
    with pytest.raises(ValueError, match="5 points or more"):
        fairing.fair_rows(hull, bpy.context.scene, fairing.Asked(0.01))
    bpy.ops.object.mode_set(mode="OBJECT")


def test_a_row_that_would_turn_the_surface_over_is_refused():
    hull = grid_hull(COLUMNS, ROWS)
    bm = edit(hull, (False, True, False))
    for vertex in bm.verts:
        vertex.co.z += 6.0 * (-1.0) ** (vertex.index // ROWS)  # rows zigzag one beside the other
    bmesh.update_edit_mesh(hull.data)
    bpy.context.view_layer.update()
    fairing = part("features.fairing.row_fairing")
    select(hull, "edge", zip(along(3), along(3)[1:]))
    start = mesh_points_now(hull)
    with pytest.raises(ValueError, match=r"turned over at \(\d.*give a smaller deviation"):
        fairing.fair_rows(hull, bpy.context.scene, fairing.Asked(10.0))
    np.testing.assert_array_equal(mesh_points_now(hull), start)
    report = fairing.fair_rows(hull, bpy.context.scene, fairing.Asked(0.1))
    assert report.rms == pytest.approx(0.1, rel=1e-9)
    bpy.ops.object.mode_set(mode="OBJECT")
