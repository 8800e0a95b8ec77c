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
        row = hn.RuledRow(surface, [face])
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
    # The creases stay within the distance: finely sampled, both ways.
    old, new = row.rulings(100).reshape(-1, 3), again.rulings(33).reshape(-1, 3)
    off = np.array([np.linalg.norm(old - p, axis=1).min() for p in new])
    spacing = np.linalg.norm(np.diff(row.rulings(100)[:101, 0], axis=0), axis=1).max()
    assert off.max() <= math.hypot(distance, spacing)
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
    with pytest.raises(ValueError, match="warp must be an angle"):
        row.develop(0.0, 0.1)
    with pytest.raises(ValueError, match="must be a length above 0"):
        row.develop(LIMIT, 0.0)
