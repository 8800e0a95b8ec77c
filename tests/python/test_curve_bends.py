# SPDX-License-Identifier: GPL-3.0-or-later
"""Bends of a network's curves as sums that a fit meets, and rows put where columns meet lines."""

import hull_native as hn
import numpy as np
import pytest
from hull_native.networks.best_rows import _Lines, best_rows
from hull_native.networks.curve_bends import curve_bend_terms, network_bends
from hull_native.networks.sampling import on_spline, spline_slopes
from test_curve_networks import lines_of, sample_surface


def missed(terms, points):
    return sum(np.sum((weights @ points[at] - rest) ** 2) for at, weights, rest in terms)


@pytest.mark.parametrize("degree", [1, 2, 3, 5])
def test_slopes_of_a_rational_spline_are_those_of_differences(degree):
    values = np.random.default_rng(degree)
    knots = np.r_[[0.0] * (degree + 1), 0.2, 0.5, 0.7, [1.0] * (degree + 1)]
    count = len(knots) - degree - 1
    points, weights = values.random((count, 3)), 1.0 + values.random(count)
    at, step = np.array([0.05, 0.3, 0.41, 0.6, 0.93]), 1e-5

    def place(t):
        return on_spline(degree, knots, points, weights, t)

    first, second = spline_slopes(degree, knots, points, weights, at)
    forward, back = place(at + step), place(at - step)
    assert np.abs(first - (forward - back) / (2.0 * step)).max() < 1e-7
    assert np.abs(second - (forward - 2.0 * place(at) + back) / step**2).max() < 1e-4


def test_curves_of_a_cylinder_bend_as_circles_and_lines_do():
    """A quarter of a cylinder of radius 2 m along x: three arcs, five lines; border left out."""
    curves = []
    for name, x in zip("abc", (0.0, 3.0, 6.0)):
        start = hn.CurveEnd("tangent", direction=(0, 1, 0))
        points = [(x, 0.0, 0.0), (x, 2.0, 2.0)]
        curves.append(hn.NetworkCurve(name, points, kind="station", shape="arc", start=start))
    for turn in np.linspace(0.0, 0.5 * np.pi, 5):
        y, z = 2.0 * np.sin(turn), 2.0 - 2.0 * np.cos(turn)
        ends = [(0.0, y, z), (3.0, y, z), (6.0, y, z)]
        curves.append(hn.NetworkCurve(f"at {turn:.2f}", ends, kind="waterline"))
    bends = network_bends(hn.CurveNetwork(curves, 1e-6))
    is_across = np.abs(bends.tangents[:, 0]) < 0.5
    sizes = np.linalg.norm(bends.bends, axis=1)
    assert np.abs(sizes[is_across] - 0.5).max() < 1e-12 and sizes[~is_across].max() < 1e-12
    # The arc amidships, and three lines of 6 m.
    assert bends.lengths[~is_across].sum() == pytest.approx(18.0, abs=1e-9)
    assert bends.lengths[is_across].sum() == pytest.approx(np.pi, rel=5e-3)
    # Towards the axis.
    axis = np.array([0.0, 0.0, 2.0]) - bends.points[is_across] * [0.0, 1.0, 1.0]
    assert np.abs(bends.bends[is_across] - 0.25 * axis).max() < 1e-9


def test_a_hull_bends_as_its_own_lines_do():
    surface = sample_surface("coaster")
    network, _ = lines_of(surface, 9, 4, curves=1e-6)
    bends, points = network_bends(network), np.array(surface.mesh.points)
    terms = curve_bend_terms(surface, bends, 1e-4)
    own = missed(terms, points)
    # It is no more than the curves' own part, which are not exact, and far from all that is bent.
    assert own < 1e-2 * missed([(at, w, 0.0 * rest) for at, w, rest in terms], points)
    # A wave of a centimetre in one row is seen.
    points[:, 1] += np.where(points[:, 1] > 1.0, 0.02 * (-1.0) ** np.arange(len(points)), 0.0)
    assert missed(terms, points) > 3.0 * own


def test_what_bends_cost_is_by_the_square_of_their_factor():
    surface = sample_surface("coaster")
    bends, points = network_bends(lines_of(surface, 9, 4)[0]), np.array(surface.mesh.points)
    points[:, 1] *= 1.0 + 0.01 * np.sin(points[:, 0])
    single, double = (missed(curve_bend_terms(surface, bends, f), points) for f in (1e-4, 2e-4))
    assert double == pytest.approx(4.0 * single, rel=1e-9)
    assert curve_bend_terms(surface, bends, 0.0) == []


class SplineHull:
    """Sections of lines that are uniform cubic B-splines along the ship over rows at known x."""

    def __init__(self, rows):
        count = len(rows)
        t = np.linspace(0.0, count - 1.0, 20001)
        extended = np.zeros((count + 2, count))
        extended[1:-1] = np.eye(count)
        extended[0, :2] = extended[-1, :-3:-1] = 2.0, -1.0
        span = np.minimum(t.astype(int), count - 2)
        s = (t - span)[:, None]
        parts = (
            (1 - s) ** 3,
            3 * s**3 - 6 * s**2 + 4,
            1 + 3 * s + 3 * s**2 - 3 * s**3,
            s**3,
        )
        basis = sum(part / 6.0 * extended[span + k] for k, part in enumerate(parts))
        self._x = basis @ rows
        self._breadth = basis @ (6.0 + 3.0 * np.sin(np.arange(count) * 1.7))

    def at(self, x):
        breadth = np.interp(x, self._x, self._breadth)
        return np.array([[x, 0.0, 0.0], [x, breadth, 4.0]])


def test_rows_are_put_where_columns_meet_a_hull_of_splines():
    rows = np.array([0.0, 5.0, 14.0, 22.0, 47.0, 55.0, 76.0, 88.0, 95.0, 100.0])
    girths = SplineHull(rows)
    inner = rows[1:-1]
    start = inner + np.array([0.0, 1.5, -1.2, 2.0, 1.0, -2.0, 1.0, 0.0])
    found = best_rows(girths, start, rows[0], rows[-1])
    lines = _Lines(girths, start[0], start[-1])

    def missed(tried):
        return np.sqrt(lines.missed(np.concatenate([rows[:1], tried, rows[-1:]])))

    assert missed(inner) < 2e-3
    assert missed(found) < 0.2 * missed(start)
    # Ends stay, and no two rows come to lie on one another.
    assert (found[[0, -1]] == start[[0, -1]]).all() and np.diff(found).min() > 2.5
