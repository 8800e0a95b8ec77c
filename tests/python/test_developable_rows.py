# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of faces between two knuckles: exactly ruled, their warp, and made developable."""

import math

import hull_native as hn
import numpy as np
import pytest
from production_hulls import body_of

LIMIT = math.radians(1.0)


def rows_of(surface, low, high):
    """Faces of the planing boat's mesh between two of its eight rows of points along the ship, by
    the points' places in their station."""
    creases = {tuple(sorted(edge)) for edge in np.asarray(surface.mesh.creases).tolist()}
    border = {tuple(sorted(edge)) for edge in np.asarray(surface.mesh.border_edges).tolist()}
    faces = np.asarray(surface.mesh.face_vertices)
    starts = np.concatenate([[0], np.cumsum(surface.mesh.face_sizes)])
    found = []
    for face in range(len(starts) - 1):
        loop = faces[starts[face] : starts[face + 1]].tolist()
        edges = [tuple(sorted(pair)) for pair in zip(loop, loop[1:] + loop[:1])]
        tagged = [edge in creases or edge in border for edge in edges]
        if len(loop) == 4 and (tagged[0] and tagged[2] or tagged[1] and tagged[3]):
            found.append(face)
    return found[low:high]


def outer_bottom():
    """(surface, faces) of the planing boat between rail and chine."""
    _, body = body_of("planing_boat")
    surface = body.surface
    points = np.asarray(surface.mesh.points)
    candidates, best = rows_of(surface, None, None), []
    for face in candidates:
        try:
            row = hn.RuledRow(surface, [face])
        except ValueError as error:
            assert "has not four points" in str(error)  # beside a pointed face
            continue
        own = points[row.points]
        # Broad, and in the bottom: not the level strips of rail and chine, nor the side.
        ends = row.rulings(1)
        broad = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).min()
        if broad > 0.25 and own[:, 0].min() > 0.1:
            best.append(face)
    return surface, best


def test_the_surface_is_just_the_rulings():
    """Points of the surface by its own evaluation lie on the straight rulings."""
    surface, faces = outer_bottom()
    assert len(faces) >= 4
    row = hn.RuledRow(surface, faces)
    tree = hn.SurfaceTree(surface)
    ends = row.rulings(6)
    for v in (0.21, 0.5, 0.83):
        places = (1.0 - v) * ends[:, 0] + v * ends[:, 1]
        found = tree.closest_points(places)
        distances = np.linalg.norm(np.asarray(found.points) - places, axis=1)
        assert distances.max() < 1e-9


def off_rulings(surface, face, rulings):
    """How far the surface is from the rulings of a face, m, at the most of places between."""
    first = int(np.sum(surface.mesh.face_sizes[:face]))
    t = np.linspace(0.1, 0.9, 5)
    u, v = (one.ravel() for one in np.meshgrid(t, t))
    places = np.concatenate(
        [
            surface.evaluate(np.full(len(u), first + i), np.stack([u, v], axis=1))[0]
            for i in range(4)
        ]
    )
    begins, ways = rulings[:, 0], rulings[:, 1] - rulings[:, 0]
    return max(line_distance(p, begins, ways) for p in places)


def row_between(tip, corners=()):
    """Five quadrilaterals between two knuckles that rise, and may meet in a triangle."""
    x = np.arange(6.0)
    low = np.stack([x, 0.2 * x, 0.02 * x**2], axis=1)
    high = np.stack([x, 3.0 - 0.2 * x, 0.5 + 0.06 * x**2], axis=1)
    points = np.vstack([low, high, [[6.2, 1.5, 2.0]]])[: 13 if tip else 12]
    faces = [k for i in range(5) for k in (i, i + 1, i + 7, i + 6)] + [5, 12, 11] * tip
    return hn.LimitSurface(hn.ControlMesh(points, [4] * 5 + [3] * tip, faces, [], list(corners)))


def test_the_surface_beside_a_pointed_face_is_not_ruled():
    surface = row_between(True)
    row = hn.RuledRow(surface, range(4))
    for face, rulings in enumerate(np.split(row.rulings(1000), 4)):
        assert off_rulings(surface, face, rulings) < 1e-12
    with pytest.raises(ValueError, match="Face 4 is not of straight lines beside face 5, which"):
        hn.RuledRow(surface, [3, 4])


def test_the_surface_beside_a_corner_is_not_ruled():
    """But for those at the row's ends, where it has no other face."""
    surface = row_between(False, [2])
    for face in (0, 3, 4):
        rulings = hn.RuledRow(surface, [face]).rulings(1000)
        assert off_rulings(surface, face, rulings) < 1e-12
    for face in (1, 2):
        with pytest.raises(
            ValueError, match=f"Face {face} is not of straight lines at its point 2"
        ):
            hn.RuledRow(surface, [face])


def test_flat_faces_are_ruled_whatever_is_beside():
    mesh = row_between(True, [2]).mesh
    flat = hn.LimitSurface(mesh.with_points(np.asarray(mesh.points) * [1.0, 1.0, 0.0]))
    assert hn.RuledRow(flat, range(5)).warps().max() == pytest.approx(0.0, abs=1e-9)


def test_warp_is_that_between_normals_at_the_ends():
    """The bound is above what the surface's normals have, and near it."""
    surface, faces = outer_bottom()
    row = hn.RuledRow(surface, faces)
    seen = []
    for face in faces:
        lone = hn.RuledRow(surface, [face])
        ends = lone.rulings(400)
        # Normals from the rulings' derivative along the creases, by differences.
        da = np.gradient(ends[:, 0], axis=0)[2:-2]
        db = np.gradient(ends[:, 1], axis=0)[2:-2]
        q = (ends[:, 1] - ends[:, 0])[2:-2]
        one, other = np.cross(da, q), np.cross(db, q)
        cos = (one * other).sum(axis=1)
        sin = np.linalg.norm(np.cross(one, other), axis=1)
        seen.append((np.arctan2(sin, cos) / np.linalg.norm(q, axis=1)).max())
    warps = row.warps()
    assert np.all(np.array(seen) <= warps * (1 + 1e-3))
    assert max(seen) == pytest.approx(warps.max(), rel=0.02)


def feature_lines(surface, parts=40):
    """Polylines along all knuckles and borders, within 1e-6 m of them."""
    curves, lines = hn.HullCurves(surface), []
    for curve in curves.knuckles() + curves.borders():
        t = (np.arange(parts + 1) / parts)[:, None, None]
        uv = (1.0 - t) * curve.starts + t * curve.ends
        uv = uv.swapaxes(0, 1).reshape(-1, 2)
        lines.append(surface.evaluate(np.repeat(curve.cells, parts + 1), uv)[0])
    return lines


def line_distance(p, begins, ways):
    """Of a point from straight pieces, the least."""
    square = np.maximum((ways * ways).sum(axis=1), 1e-30)
    t = np.clip(((p - begins) * ways).sum(axis=1) / square, 0.0, 1.0)
    return np.linalg.norm(begins + t[:, None] * ways - p, axis=1).min()


def apart(surface, other):
    """The largest distance between the creases of two surfaces, each from the other."""
    largest = 0.0
    for own, target in ((surface, other), (other, surface)):
        lines = feature_lines(target)
        begins = np.concatenate([line[:-1] for line in lines])
        ways = np.concatenate([np.diff(line, axis=0) for line in lines])
        for line in feature_lines(own, 8):
            largest = max(largest, max(line_distance(p, begins, ways) for p in line))
    return largest


@pytest.mark.parametrize(
    "distance, warp, moved", [(0.005, 5.91, 4.9), (0.02, 2.93, 18.9), (0.1, 0.985, 42.0)]
)
def test_warp_of_a_planing_boat_s_bottom_in_numbers(distance, warp, moved):
    """From 7.68°/m; mm. The move is measured on the creases themselves, both ways."""
    surface, faces = outer_bottom()
    row = hn.RuledRow(surface, faces)
    made = row.develop(LIMIT, distance)
    assert math.degrees(made.before) == pytest.approx(7.68, abs=0.01)
    assert math.degrees(made.after) == pytest.approx(warp, rel=0.02)
    moved_surface = hn.LimitSurface(surface.mesh.with_points(made.points), surface.scheme)
    off = apart(surface, moved_surface)
    assert 1000.0 * off == pytest.approx(moved, rel=0.05)
    assert off <= distance


@pytest.mark.parametrize("distance", [0.005, 0.02, 0.1])
def test_a_planing_boat_s_bottom_is_made_developable(distance):
    surface, faces = outer_bottom()
    row = hn.RuledRow(surface, faces)
    made = row.develop(LIMIT, distance)
    assert made.before == pytest.approx(row.warps().max())
    assert made.after < made.before
    assert made.reached == (made.after <= LIMIT)
    # Again by a surface of the moved points.
    moved = hn.LimitSurface(surface.mesh.with_points(made.points), surface.scheme)
    again = hn.RuledRow(moved, faces)
    assert again.warps().max() == pytest.approx(made.after, rel=1e-9)
    # The creases stay within the distance, each from the other.
    off = apart(surface, moved)
    assert off <= distance
    # What is told is of the row's own edges, beyond whose ends the creases go on.
    assert off <= made.distance * (1.0 + 1e-2)
    assert made.distance <= distance
    # Only points of the knuckles move.
    changed = np.flatnonzero((np.asarray(made.points) != surface.mesh.points).any(axis=1))
    assert set(changed) <= set(row.points)


def test_more_distance_is_never_worse():
    surface, faces = outer_bottom()
    row = hn.RuledRow(surface, faces)
    after = [row.develop(math.radians(0.05), d).after for d in (0.002, 0.01, 0.05)]
    assert after[2] <= after[1] * 1.001 and after[1] <= after[0] * 1.001


def test_locked_and_held_points():
    surface, faces = outer_bottom()
    row = hn.RuledRow(surface, faces)
    points = np.asarray(surface.mesh.points)
    free = row.develop(LIMIT, 0.05)
    moved = np.flatnonzero((np.asarray(free.points) != points).any(axis=1))
    held = row.develop(
        LIMIT, 0.05, locked=moved[:2], held_points=moved, held_normals=[[0, 0, 1]] * len(moved)
    )
    np.testing.assert_array_equal(np.asarray(held.points)[moved[:2]], points[moved[:2]])
    np.testing.assert_allclose(np.asarray(held.points)[:, 2], points[:, 2], atol=1e-15)


def test_bad_rows_have_their_sentence():
    surface, faces = outer_bottom()
    _, coaster = body_of("coaster")
    with pytest.raises(ValueError, match="needs faces"):
        hn.RuledRow(surface, [])
    with pytest.raises(ValueError, match="is none of the mesh"):
        hn.RuledRow(surface, [100000])
    with pytest.raises(ValueError, match="does not lie between two knuckles: make"):
        hn.RuledRow(coaster.surface, [40])
    row = hn.RuledRow(surface, faces)
    for bad in (0.0, -1.0, math.nan, math.inf):
        with pytest.raises(ValueError, match="warp must be an angle"):
            row.develop(bad, 0.1)
        with pytest.raises(ValueError, match="must be a length above 0"):
            row.develop(LIMIT, bad)
