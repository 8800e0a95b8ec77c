# SPDX-License-Identifier: GPL-3.0-or-later
"""The angle along knuckles, against closed forms and normals had by differences; and set."""

import hull_native as hn
import numpy as np
import pytest

SEED = 20261123
SIDE = 8


def folded(height, side=SIDE, creased=None, **tags):
    """Control points (x, y, height(x, y)) over a square about the origin, creased along x = 0."""
    at = np.arange(side + 1) - side / 2
    x, y = np.meshgrid(at, at)
    points = np.stack([x, y, height(x, y)], axis=-1).reshape(-1, 3)
    first = (np.arange(side)[:, None] * (side + 1) + np.arange(side)).reshape(-1)
    faces = np.stack([first, first + 1, first + side + 2, first + side + 1], axis=1)
    rows = range(side) if creased is None else creased
    middle = side // 2 + (side + 1) * np.arange(side + 1)
    creases = [(middle[i], middle[i + 1]) for i in rows]
    mesh = hn.ControlMesh(points, np.full(len(faces), 4), faces.ravel(), creases=creases, **tags)
    return hn.LimitSurface(mesh)


def inner_crease(surface):
    """The number of the one crease that is no border."""
    kinds = [curve.kind for curve in hn.crease_curves(surface)]
    return kinds.index("crease")


def wavy(x, y):
    return -np.abs(x) * (0.5 + 0.05 * y) + 0.02 * y**2 - 0.03 * x**2


def moved(surface, setting):
    points = surface.mesh.points.copy()
    points[setting.points] += setting.moves
    return hn.LimitSurface(surface.mesh.with_points(points), surface.scheme)


def angles_by_differences(surface, knuckle, t, step=1e-5):
    """Angles at places t from three positions on each side."""
    curve = hn.crease_curves(surface)[knuckle]
    along = curve.evaluate(t, 1)[1]
    normals = []
    for cells, uv in (curve.left(t), curve.right(t)):
        inwards = np.where(uv == 0.0, step, 0.0) * (uv == uv.min(axis=1)[:, None])
        across = surface.positions(cells, uv + inwards) - surface.positions(cells, uv)
        normals.append(np.cross(along, across))
    left, right = normals[0], -normals[1]
    left /= np.linalg.norm(left, axis=1)[:, None]
    right /= np.linalg.norm(right, axis=1)[:, None]
    along = along / np.linalg.norm(along, axis=1)[:, None]
    sine = np.einsum("ij,ij->i", np.cross(left, right), along)
    return np.arctan2(sine, np.einsum("ij,ij->i", left, right))


@pytest.mark.parametrize("slope", [-3.0, -0.4, 0.0, 0.1, 2.0])
def test_a_fold_has_its_angle_all_along(slope):
    """Planes at both sides: bent away from the normals' side where the fold is a ridge."""
    surface = folded(lambda x, y: -slope * np.abs(x))
    found = hn.knuckle_angles(surface, inner_crease(surface))
    wanted = 2 * np.arctan(slope)
    np.testing.assert_allclose(found.angles, wanted, atol=1e-13)
    assert (found.least, found.mean, found.largest) == pytest.approx([wanted] * 3, abs=1e-13)
    assert found.length == pytest.approx(SIDE, rel=1e-12)
    np.testing.assert_allclose(found.arc_lengths[[0, -1]], [0, SIDE], atol=1e-12)


def test_angles_are_those_of_the_surface():
    surface = folded(wavy)
    knuckle = inner_crease(surface)
    found = hn.knuckle_angles(surface, knuckle, samples_per_edge=5)
    assert found.largest - found.least > 0.2
    at = slice(1, -1)
    expected = angles_by_differences(surface, knuckle, found.t[at] + 1e-9)
    np.testing.assert_allclose(found.angles[at], expected, atol=1e-5)
    # By arc length, from as many samples again.
    fine = hn.knuckle_angles(surface, knuckle, samples_per_edge=200)
    assert fine.mean == pytest.approx(found.mean, abs=1e-3)
    steps = np.diff(fine.arc_lengths)
    assert fine.mean == pytest.approx(
        (steps * 0.5 * (fine.angles[1:] + fine.angles[:-1])).sum() / steps.sum()
    )


def test_a_dart_has_no_angle():
    surface = folded(wavy, creased=range(4))
    knuckle = inner_crease(surface)
    found = hn.knuckle_angles(surface, knuckle)
    assert min(abs(found.angles[0]), abs(found.angles[-1])) < 1e-12
    assert found.largest > 0.5


def test_some_edges_only():
    surface = folded(wavy)
    knuckle = inner_crease(surface)
    whole = hn.knuckle_angles(surface, knuckle)
    part = hn.knuckle_angles(surface, knuckle, edges=[1, 2, 5])
    assert part.t[[0, 16, 17]].tolist() == [1, 3, 5] and len(part.t) == 26
    np.testing.assert_array_equal(part.angles[:17], whole.angles[8:25])
    assert part.length == pytest.approx(3.0, abs=0.1)


@pytest.mark.parametrize("degrees", [-40.0, 0.0, 15.0, 60.0, 120.0])
def test_the_angle_is_set_along_the_knuckle(degrees):
    surface = folded(wavy)
    knuckle = inner_crease(surface)
    angle = np.radians(degrees)
    before = surface.mesh.points.copy()
    setting = hn.set_knuckle_angle(surface, knuckle, angle)
    assert setting.met and setting.deviation < np.radians(0.1) and setting.steps < 40
    after = moved(surface, setting)
    found = hn.knuckle_angles(after, knuckle, samples_per_edge=16)
    assert np.abs(found.angles - angle).max() == pytest.approx(setting.deviation, abs=1e-9)
    t = np.linspace(0.01, SIDE - 0.01, 50)
    assert np.abs(angles_by_differences(after, knuckle, t) - angle).max() < np.radians(0.11)
    # The curve stays, and so does what is farther away than the row beside it.
    curves = [hn.crease_curves(s)[knuckle].evaluate(t)[0] for s in (surface, after)]
    np.testing.assert_allclose(*curves, atol=1e-13)
    assert (np.abs(before[setting.points, 0]) == 1).all()
    np.testing.assert_array_equal(surface.mesh.points, before)


def test_moves_are_the_least():
    """At the solution moves are sums of the angles' derivatives: conditions of a least norm."""
    surface = folded(wavy)
    knuckle = inner_crease(surface)
    setting = hn.set_knuckle_angle(surface, knuckle, np.radians(50.0))
    after = moved(surface, setting)
    t = (np.arange(4 * SIDE) + 0.5) / 4
    points = after.mesh.points

    def angles(places):
        curve = hn.crease_curves(after)[knuckle]
        there = hn.LimitSurface(after.mesh.with_points(places))
        left, right = (there.normals(*side) for side in (curve.left(t), curve.right(t)))
        along = curve.evaluate(t, 1)[1]
        along = along / np.linalg.norm(along, axis=1)[:, None]
        sine = np.einsum("ij,ij->i", np.cross(left, right), along)
        return np.arctan2(sine, np.einsum("ij,ij->i", left, right))

    columns = []
    for point in setting.points:
        for axis in range(3):
            step = np.zeros_like(points)
            step[point, axis] = 1e-6
            columns.append((angles(points + step) - angles(points - step)) / 2e-6)
    x = setting.moves.ravel()
    rows = np.array(columns)  # (unknowns, samples)
    multipliers, *_ = np.linalg.lstsq(rows, x, rcond=1e-9)
    assert np.linalg.norm(rows @ multipliers - x) < 1e-3 * np.linalg.norm(x)


def test_locked_points_and_flats_stay():
    surface = folded(wavy)
    knuckle = inner_crease(surface)
    points = surface.mesh.points
    left = np.flatnonzero(points[:, 0] == -1)
    flat = np.flatnonzero(points[:, 0] == 1)
    setting = hn.set_knuckle_angle(surface, knuckle, 0.9, locked=left)
    assert setting.met and not np.isin(setting.points, left).any()
    setting = hn.set_knuckle_angle(
        surface, knuckle, 0.9, held_points=flat, held_normals=np.tile([0.0, 0.0, 1.0], (9, 1))
    )
    held = np.isin(setting.points, flat)
    assert np.abs(setting.moves[held, 2]).max(initial=0.0) < 1e-15 and setting.met


def test_what_it_cannot_do_it_tells():
    surface = folded(wavy)
    knuckle = inner_crease(surface)
    rows = np.flatnonzero(np.abs(surface.mesh.points[:, 0]) == 1)
    with pytest.raises(ValueError, match="beside the knuckle may"):
        hn.set_knuckle_angle(surface, knuckle, 0.9, locked=rows)
    with pytest.raises(ValueError, match="170°"):
        hn.set_knuckle_angle(surface, knuckle, 3.1)
    with pytest.raises(ValueError, match="170°"):
        hn.set_knuckle_angle(surface, knuckle, np.nan)
    with pytest.raises(ValueError, match="border"):
        hn.knuckle_angles(surface, 1 - knuckle if knuckle < 2 else 0)
    with pytest.raises(ValueError, match="no knuckle 99"):
        hn.knuckle_angles(surface, 99)
    with pytest.raises(ValueError, match="Edge 8 of the knuckle"):
        hn.knuckle_angles(surface, knuckle, edges=[8])
    with pytest.raises(ValueError, match="Edge 1 of the knuckle"):
        hn.set_knuckle_angle(surface, knuckle, 0.5, edges=[2, 1])
    with pytest.raises(ValueError, match="1 to 1000 samples"):
        hn.knuckle_angles(surface, knuckle, samples_per_edge=0)
    short = folded(wavy, creased=[3])
    with pytest.raises(ValueError, match="darts"):
        hn.set_knuckle_angle(short, inner_crease(short), 0.5)
