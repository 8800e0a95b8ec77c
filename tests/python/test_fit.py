# SPDX-License-Identifier: GPL-3.0-or-later
"""Fitting surfaces to points: samples shaken at random come back, and what is wrong is said."""

from pathlib import Path

import hull_native as hn
import numpy as np
import pytest
from vessels import surface_of_sample

ROOT = Path(__file__).resolve().parents[2]

SEED = 20261122
SHAKEN = 0.02  # of the beam
SAMPLES = sorted(path.name.split(".")[0] for path in (ROOT / "samples").glob("*.hull.json"))


def samples_of(surface, n):
    return surface.evaluate_grid(n, 0)[0].reshape(-1, 3)


def curves_of(surface):
    curves = []
    for chain, curve in enumerate(hn.crease_curves(surface)):
        t = np.linspace(0, curve.edge_count, 8 * curve.edge_count + 1)
        curves.append((curve.evaluate(t)[0], chain, True))
    return curves


def with_points(surface, points):
    return hn.LimitSurface(surface.mesh.with_points(points), surface.scheme)


def bodies_of(mesh):
    """(n,) a number for each point, the same for those of one body."""
    body = np.arange(mesh.vertex_count)
    ends = np.cumsum(mesh.face_sizes)
    while True:
        before = body.copy()
        for begin, end in zip(ends - mesh.face_sizes, ends):
            corners = mesh.face_vertices[begin:end]
            body[corners] = body[corners].min()
        if (body == before).all():
            return body


def shaken(surface, random, by):
    """by (n,) or a number: how far each point is moved, m."""
    points = surface.mesh.points
    moves = random.normal(size=points.shape)
    moves /= np.linalg.norm(moves, axis=1)[:, None]
    return with_points(surface, points + np.broadcast_to(by, len(points))[:, None] * moves)


def farthest(a, b):
    """Either surface's largest distance from the other, at places that no target was taken at."""
    return max(
        hn.SurfaceTree(one).closest_points(samples_of(other, 5)).distances.max()
        for one, other in ((a, b), (b, a))
    )


@pytest.mark.parametrize("name", SAMPLES)
def test_a_sample_comes_back(name):
    surface = surface_of_sample(name)
    length = np.ptp(surface.mesh.points[:, 0])
    # Keels and rudders by their own beam: they are thinner than a ship's beam's 2 %.
    bodies, breadths = bodies_of(surface.mesh), surface.mesh.points[:, 1]
    beams = np.array([2 * np.abs(breadths[bodies == body]).max() for body in bodies])
    start = shaken(surface, np.random.default_rng(SEED), SHAKEN * beams)
    assert farthest(start, surface) > 1e-3 * length
    fit = hn.fit_surface(
        start, samples_of(surface, 4), curves=curves_of(surface), fairness=0, most_steps=150
    )
    assert farthest(with_points(surface, fit.points), surface) < 1e-6 * length
    assert fit.rms < 1e-7 * length
    assert fit.curve_largest < 1e-6 * length


@pytest.mark.parametrize("name", ["coaster", "sailing_yacht"])
def test_rounding_of_the_target_decides_nothing(name):
    """Places on creases and borders belong to several cells, and targets on them have no direction:
    what of it counts must not depend on the last digits. The points answer as the target changes,
    over four decades. A quarter of a per cent of the beam is what the target is moved by."""
    surface = surface_of_sample(name)
    beam = 2 * np.abs(surface.mesh.points[:, 1]).max()
    targets = samples_of(surface, 2)
    targets[:, 1] += 0.0025 * beam * np.sin(targets[:, 0] / beam)
    noise = np.random.default_rng(SEED).normal(size=targets.shape)
    points = hn.fit_surface(surface, targets, most_steps=2).points
    for size in 1e-13, 1e-12, 1e-11, 1e-10:
        other = hn.fit_surface(surface, targets + size * noise, most_steps=2).points
        assert 0 < np.abs(other - points).max() < 100 * size


def test_the_report_is_of_the_surface_it_gives():
    surface = surface_of_sample("barge")
    start = shaken(surface, np.random.default_rng(SEED), 0.1)
    targets = samples_of(surface, 3)
    normals = np.tile([0.0, 0.0, -1.0], (len(targets), 1))
    fit = hn.fit_surface(start, targets, fairness=1e-3, reach=1.0)
    fitted = with_points(surface, fit.points)
    closest = hn.SurfaceTree(fitted).closest_points(targets)
    counted = ~np.isnan(fit.distances)
    assert counted.sum() == fit.counted
    # At the border only the part across the surface counts.
    far = np.abs(fit.distances)
    assert (far[counted] <= closest.distances[counted] + 1e-12).all()
    inner = counted & (closest.kinds == 0)
    np.testing.assert_allclose(far[inner], closest.distances[inner], atol=1e-9)
    assert fit.rms == pytest.approx(np.sqrt(np.mean(fit.distances[counted] ** 2)))
    assert fit.largest == pytest.approx(np.nanmax(np.abs(fit.distances)))
    assert abs(fit.distances[fit.largest_target]) == pytest.approx(fit.largest)
    np.testing.assert_allclose(fit.largest_place, closest.points[fit.largest_target], atol=1e-9)
    # Only the bottom looks down.
    down, all_ways = (
        hn.fit_surface(start, targets, normals=which, most_steps=0).counted
        for which in (normals, None)
    )
    assert 0 < down < 0.6 * all_ways


def test_fairness_takes_away_a_dent_and_stiffness_keeps_it():
    surface = surface_of_sample("coaster")
    points = surface.mesh.points.copy()
    inner = int(np.argmin(np.linalg.norm(points - [44.0, 6.0, 2.5], axis=1)))
    points[inner, 1] += 0.2
    dented = with_points(surface, points)
    few = samples_of(surface, 1)
    loose = hn.fit_surface(dented, few, fairness=0)
    assert hn.fit_surface(dented, few, fairness=1e-3).energy < loose.energy
    stiff = hn.fit_surface(dented, few, fairness=0, stiffness=1.0)
    assert np.abs(stiff.points - points).max() < np.abs(loose.points - points).max()


def test_sums_of_control_points_come_to_rest():
    # Against targets in the surface itself, which no sum moves as long as it has its rest: a sum
    # that counts for much brings its points to another one.
    surface = surface_of_sample("barge")
    points = np.asarray(surface.mesh.points)
    there = samples_of(surface, 3)
    weights = np.array([1.0, -2.0, 1.0])
    rest = weights @ points[:3]
    options = {"fairness": 0.0, "most_steps": 20}
    still = hn.fit_surface(surface, there, sums=[([0, 1, 2], weights, rest)], **options)
    assert np.abs(still.points - points).max() < 1e-6
    moved = hn.fit_surface(
        surface, there, sums=[([0, 1, 2], 1e6 * weights, 1e6 * (rest + [0.0, 0.0, 0.1]))], **options
    )
    assert weights @ moved.points[:3] == pytest.approx(rest + [0.0, 0.0, 0.1], abs=1e-6)
    with pytest.raises(ValueError, match="as many weights as points, 2, not 1"):
        hn.fit_surface(surface, there, sums=[([0, 1], [1.0], rest)])
    with pytest.raises(ValueError, match="Sum 0's point"):
        hn.fit_surface(surface, there, sums=[([10**6], [1.0], rest)])


def test_it_can_be_watched_and_cancelled():
    surface = surface_of_sample("barge")
    start = shaken(surface, np.random.default_rng(SEED), 0.1)
    shares = []

    class Enough(Exception):
        pass

    def watch(share):
        shares.append(share)
        if len(shares) == 3:
            raise Enough

    with pytest.raises(Enough):
        hn.fit_surface(start, samples_of(surface, 2), progress=watch)
    assert len(shares) == 3 and shares[0] == 0 and shares == sorted(shares)


@pytest.mark.parametrize(
    "options, message",
    [
        ({"targets": np.zeros((3, 2))}, r"targets must have shape \(n, 3\)"),
        ({"targets": [[np.nan, 0, 0]]}, "Target 0"),
        ({"targets": [[2e9, 0, 0]]}, "Target 0 is no place within 1e9 m"),
        ({"normals": np.zeros((2, 3))}, "as many normals as targets"),
        ({"normals": [[0.0, np.nan, 1.0]]}, "Normal 0 is no number"),
        ({"weights": [-1.0]}, "weight"),
        ({"curves": [3]}, r"curves\[0\]"),
        ({"curves": [(np.zeros((1, 3)), 0, True)]}, "Curve 0 needs two points"),
        ({"curves": [(np.eye(3), 999, True)]}, "crease curve 999"),
        ({"fairness": -1}, "fairness"),
        ({"stiffness": np.inf}, "stiffness"),
        ({"reach": 0}, "reach"),
        ({"most_steps": -1}, "most_steps is -1: it must be from 0 to 1000"),
        ({"most_steps": 1_000_000}, "most_steps is 1000000: it must be from 0 to 1000"),
        ({"reach": 1e-9}, "No target counts"),
        ({"locked": [9999]}, "locked point is 9999"),
        ({"held_points": [1]}, "held_normals"),
    ],
)
def test_what_is_wrong_is_said(options, message):
    surface = surface_of_sample("barge")
    with pytest.raises(ValueError, match=message):
        hn.fit_surface(surface, **{"targets": [[30.0, 9.0, 2.0]], **options})
