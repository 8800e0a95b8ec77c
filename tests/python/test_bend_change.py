# SPDX-License-Identifier: GPL-3.0-or-later
"""FairRegion compared with a surface before: its energy by a second way, and what it leaves alone.
"""

import hull_native as hn
import numpy as np
import pytest
from test_fairing import bulging_sheet

LEAST = 0.3
NODES = np.array([0.5 - np.sqrt(0.15), 0.5, 0.5 + np.sqrt(0.15)])
SHARES = np.array([5.0, 8.0, 5.0]) / 18.0


def with_points(surface, points):
    return hn.LimitSurface(surface.mesh.with_points(points), surface.scheme)


def two_sheets():
    before, _ = bulging_sheet(noise=0.0)
    points = before.mesh.points.copy()
    points += 0.05 * np.random.default_rng(5).normal(size=points.shape)
    return before, with_points(before, points)


def nodes(surface):
    """(cells, uv, weights of the rule) of three by three places in each cell."""
    u, v = np.meshgrid(NODES, NODES)
    uv = np.stack([u.ravel(), v.ravel()], axis=1)
    weights = np.outer(SHARES, SHARES).ravel()
    count = surface.cell_count
    return np.repeat(np.arange(count), 9), np.tile(uv, (count, 1)), np.tile(weights, count)


class Bends:
    """At places of a surface: its frame, and what something else that the same control points carry
    has for covariant second derivatives along it."""

    def __init__(self, surface, cells, uv):
        self.cells, self.uv = cells, uv
        _, self.u, self.v, *self.second = surface.evaluate(cells, uv, 2)
        normal = np.cross(self.u, self.v)
        self.area = np.linalg.norm(normal, axis=1)
        self.normal = normal / self.area[:, None]
        along = np.array([1.0, 0.0, 0.0]) - self.normal[:, :1] * self.normal
        self.along = along / np.linalg.norm(along, axis=1)[:, None]
        self.across = np.cross(self.normal, self.along)

    def parts(self, vector):
        """Along u and v of vectors along the surface, by least squares."""
        sides = np.stack([self.u, self.v], axis=2)
        return np.stack([np.linalg.lstsq(a, b, rcond=None)[0] for a, b in zip(sides, vector)])

    def of(self, carried):
        _, u, v, *second = carried.evaluate(self.cells, self.uv, 2)
        covariant = []
        for own, other in zip(self.second, second):
            symbols = self.parts(own)
            covariant.append(other - symbols[:, :1] * u - symbols[:, 1:] * v)
        uu, uv, vv = covariant
        p, q = self.parts(self.along), self.parts(self.across)

        def by(a, b):
            mixed = a[:, 0] * b[:, 1] + a[:, 1] * b[:, 0]
            return (
                (a[:, 0] * b[:, 0])[:, None] * uu
                + mixed[:, None] * uv
                + (a[:, 1] * b[:, 1])[:, None] * vv
            )

        return by(p, p), np.sqrt(2.0) * by(p, q), by(q, q)


def dot(a, b):
    return (a * b).sum(axis=1)


def energy(before, surface, moves, factors=1.0):
    cells, uv, weights = nodes(surface)
    was, now = Bends(before, cells, uv), Bends(surface, cells, uv)
    changes = [np.zeros_like(now.normal)] * 3
    if moves is not None:
        moved = hn.LimitSurface(surface.mesh)
        moved.set_points(moves)
        changes = now.of(moved)
    total = 0.0
    for b, h, change in zip(was.of(before), now.of(surface), changes):
        bend = dot(b, was.normal)
        share = LEAST**2 / (bend**2 + LEAST**2)
        differs = dot(h, now.normal) + dot(change, now.normal) - bend
        slides = dot(change, now.along) ** 2 + dot(change, now.across) ** 2
        total += (factors * weights * now.area * (share * differs**2 + 0.01 * slides)).sum()
    return total


def region(surface, before, **options):
    every = np.arange(len(surface.mesh.points))
    return hn.FairRegion(
        surface,
        every,
        before=before.mesh.points,
        least_bend=LEAST,
        keep_creases=False,
        along_normals=False,
        **options,
    )


def test_energy_is_that_of_a_second_way():
    before, surface = two_sheets()
    faired = region(surface, before).solve(0.02)
    assert faired.energy_before == pytest.approx(energy(before, surface, None), rel=1e-9)
    assert faired.energy_after == pytest.approx(energy(before, surface, faired.moves), rel=1e-9)
    assert faired.energy_after < faired.energy_before
    assert faired.rms == pytest.approx(0.02, rel=1e-6)


def test_it_is_the_least_of_its_deviation():
    before, surface = two_sheets()
    faired = region(surface, before).solve(0.02)
    rng = np.random.default_rng(8)
    for _ in range(5):
        other = rng.normal(size=faired.moves.shape)
        other[:, 0] = 0.0
        moves = faired.moves + 1e-3 * other
        cells, uv, weights = nodes(surface)
        shift = hn.LimitSurface(surface.mesh)
        shift.set_points(moves)
        moved = shift.evaluate(cells, uv, 0)[0]
        shares = weights * Bends(surface, cells, uv).area
        rms = np.sqrt((shares * dot(moved, moved)).sum() / shares.sum())
        scaled = moves * min(1.0, faired.rms / rms)
        assert energy(before, surface, scaled) > faired.energy_after * (1.0 - 1e-3)


def test_what_bends_as_before_stays():
    before, _ = two_sheets()
    faired = region(before, before).solve(0.1)
    assert faired.energy_before <= 1e-20
    assert np.abs(faired.moves).max() <= 1e-9


def test_emphasis_multiplies_what_is_near():
    """By the larger factor where two are near."""
    before, surface = two_sheets()
    cells, uv, _ = nodes(surface)
    places = before.evaluate(cells, uv, 0)[0]
    middles, reach = places[[20 * 9 + 4, 21 * 9 + 4]], 1.0
    near = np.linalg.norm(places[:, None] - middles, axis=2) <= reach
    factors = np.where(near, [50.0, 8.0], 1.0).max(axis=1)
    emphasis = {"emphasised": middles, "factors": [50.0, 8.0], "reach": reach}
    faired = region(surface, before, **emphasis).solve(0.1)
    for found, moves in ((faired.energy_before, None), (faired.energy_after, faired.moves)):
        assert found == pytest.approx(energy(before, surface, moves, factors), rel=1e-9)


@pytest.mark.parametrize(
    "options, words",
    [
        ({"before": np.zeros((3, 3))}, "must have"),
        ({"least_bend": 0.0}, "least bend"),
        ({"emphasised": np.zeros((1, 3))}, "a factor for each"),
        ({"emphasised": np.zeros((1, 3)), "factors": [-1.0]}, "above zero"),
    ],
)
def test_nonsense_is_refused(options, words):
    before, surface = two_sheets()
    arguments = {"before": before.mesh.points, "least_bend": LEAST, **options}
    with pytest.raises(ValueError, match=words):
        hn.FairRegion(surface, [30], **arguments)
