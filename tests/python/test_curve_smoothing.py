# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth curves through points: the deviation asked for is met, as FITPACK meets it; the least
squares spline is FITPACK's; the balance is that of a dense solution with NumPy."""

import hull_native as hn
import numpy as np
import pytest

interpolate = pytest.importorskip(
    "scipy.interpolate", reason="compared with SciPy, which is not there"
)

SEED = 20261123


def noisy(count=60, noise=0.02, dimensions=2):
    random = np.random.default_rng(SEED)
    t = np.sort(np.concatenate([[0.0, 10.0], random.uniform(0.0, 10.0, count - 2)]))
    curve = np.stack([t, 2.0 * np.sin(t), np.cos(0.5 * t)], axis=1)[:, :dimensions]
    return t, curve + random.normal(0.0, noise, curve.shape)


def design(knots, t, order=0):
    """(n, k - 4) by SciPy: the splines at parameters, or a derivative."""
    count = len(knots) - 4
    splines = [interpolate.BSpline(knots, unit, 3) for unit in np.eye(count)]
    return np.stack([spline.derivative(order)(t) if order else spline(t) for spline in splines], 1)


@pytest.mark.parametrize("deviation", [0.01, 0.02, 0.05, 0.3])
def test_the_deviation_is_met_as_fitpack_meets_it(deviation):
    t, points = noisy()
    weights = np.random.default_rng(SEED).uniform(0.5, 2.0, len(t))
    wanted = deviation**2 * weights.sum()
    curve = hn.smooth_curve(points, deviation, parameters=t, weights=weights)
    error = (weights[:, None] * (curve.evaluate(t) - points) ** 2).sum()
    assert curve.error == pytest.approx(error, rel=1e-9)
    assert error == pytest.approx(wanted, rel=2e-9)
    # FITPACK squares weights, and stops within a thousandth.
    spline, _ = interpolate.splprep(points.T, w=np.sqrt(weights), u=t, s=wanted)
    theirs = np.stack(interpolate.splev(t, spline), axis=1)
    assert (weights[:, None] * (theirs - points) ** 2).sum() == pytest.approx(error, rel=1e-3)


def test_the_balance_is_that_of_a_dense_solution():
    t, points = noisy()
    curve = hn.smooth_curve(points, 0.03, parameters=t)
    knots = np.array(curve.knots)
    inner = knots[4:-4]
    splines = interpolate.BSpline(knots, np.eye(len(knots) - 4), 3).derivative(3)
    middles = 0.5 * (np.unique(knots)[1:] + np.unique(knots)[:-1])
    jumps = np.diff(splines(middles), axis=0)
    assert len(jumps) == len(inner)
    rows = design(knots, t)
    left = jumps.T @ jumps + curve.p * rows.T @ rows
    wanted = np.linalg.solve(left, curve.p * rows.T @ points)
    np.testing.assert_allclose(curve.coefficients, wanted, atol=1e-7)


def test_without_need_of_a_balance_it_is_the_least_squares_cubic():
    t, points = noisy()
    curve = hn.smooth_curve(points, 100.0, parameters=t)
    assert len(curve.knots) == 8 and curve.error < 1e4 * len(t) and np.isinf(curve.p)
    cubic = np.stack([np.polyval(np.polyfit(t, column, 3), t) for column in points.T], axis=1)
    np.testing.assert_allclose(curve.evaluate(t), cubic, atol=1e-9)


def test_no_deviation_interpolates():
    t, points = noisy(dimensions=3)
    curve = hn.smooth_curve(points, 0.0, parameters=t)
    np.testing.assert_allclose(curve.evaluate(t), points, atol=1e-12)
    # The spline without knots at the second and last but one point is one alone.
    theirs = interpolate.make_interp_spline(t, points, 3)
    between = np.linspace(0.0, 10.0, 301)
    for order in range(3):
        mine = curve.evaluate(between, order)
        np.testing.assert_allclose(mine, theirs(between, order), rtol=1e-8, atol=1e-7)


@pytest.mark.parametrize(
    "degree, ends",
    [(degree, ()) for degree in (1, 2, 3, 4, 5)]
    + [(degree, (end,)) for degree in (2, 3, 4, 5) for end in ("start", "end")]
    + [(degree, ("start", "end")) for degree in (3, 4, 5)],
)
def test_interpolated_it_moves_along_with_its_points(degree, ends):
    t, points = noisy(20)
    given = {end: np.array([points[0 if end == "start" else -1], [1.0, 0.5]]) for end in ends}
    shift = np.array([300.0, -200.0])
    there = {end: rows + [shift, [0.0, 0.0]] for end, rows in given.items()}
    between = np.linspace(0.0, 10.0, 301)
    here, moved = (
        hn.smooth_curve(p, 0.0, parameters=t, degree=degree, **at)
        for p, at in ((points, given), (points + shift, there))
    )
    assert len(here.coefficients) == len(t) + len(ends)
    np.testing.assert_allclose(here.evaluate(t), points, atol=1e-9)
    np.testing.assert_allclose(moved.evaluate(between), here.evaluate(between) + shift, atol=1e-8)


@pytest.mark.parametrize("degree", [1, 2])
def test_tangents_at_both_ends_need_coefficients_of_their_own(degree):
    t, points = noisy(20)
    ends = {"start": [points[0], [1.0, 2.0]], "end": [points[-1], [1.0, -1.0]]}
    with pytest.raises(ValueError, match="places and tangents of both ends without knots"):
        hn.smooth_curve(points, 100.0, parameters=t, degree=degree, **ends)
    # With knots between, and as a straight line, there is no contradiction.
    curve = hn.smooth_curve(points, 0.1, parameters=t, degree=2, **ends)
    for at, (place, tangent) in ((0.0, ends["start"]), (10.0, ends["end"])):
        np.testing.assert_allclose(curve.evaluate([at])[0], place, atol=1e-12)
        np.testing.assert_allclose(curve.evaluate([at], 1)[0], tangent, atol=1e-9)
    line = np.outer(t, [1.0, 2.0])
    ends = {"start": [line[0], [1.0, 2.0]], "end": [line[-1], [1.0, 2.0]]}
    straight = hn.smooth_curve(line, 0.1, parameters=t, degree=degree, **ends)
    np.testing.assert_allclose(straight.evaluate(t), line, atol=1e-12)


def test_ends_are_met():
    t, points = noisy()
    start, end = [[0.0, 0.1], [1.0, 2.5]], [[10.0, -1.0], [1.0, -1.5]]
    curve = hn.smooth_curve(points, 0.05, parameters=t, start=start, end=end)
    for given, at in ((start, 0.0), (end, 10.0)):
        for order, value in enumerate(given):
            np.testing.assert_allclose(curve.evaluate([at], order)[0], value, atol=1e-9)
    assert curve.error == pytest.approx(0.05**2 * len(t), rel=2e-9)


def test_chords_are_the_parameters_unless_given():
    _, points = noisy()
    t = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    mine = hn.smooth_curve(points, 0.02)
    np.testing.assert_array_equal(mine.knots, hn.smooth_curve(points, 0.02, parameters=t).knots)


def jumps(degree, knots, coefficients):
    """Sum of the squared jumps of the highest derivative at knots."""
    spans = np.unique(knots)
    highest = interpolate.BSpline(knots, coefficients, degree).derivative(degree)
    return (np.diff(highest(0.5 * (spans[1:] + spans[:-1])), axis=0) ** 2).sum()


def random_set(seed):
    random = np.random.default_rng(seed)
    count, noise = int(random.integers(8, 80)), 10 ** random.uniform(-4.0, -1.0)
    t = np.cumsum(random.uniform(0.02, 1.0, count))
    turns = random.uniform(0.3, 1.5, 2)
    points = np.stack([t, 2.0 * np.sin(t * turns[0]), np.cos(t * turns[1])], axis=1)
    deviation = noise * 10 ** random.uniform(-0.5, 0.5)
    return t, points + random.normal(0.0, noise, points.shape), deviation


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("first", range(0, 200, 50))
def test_no_curve_of_fitpack_s_is_fairer(first):
    """Both have their knots at points; FITPACK takes few, and stops within a thousandth of S."""
    for seed in range(first, first + 50):
        t, points, deviation = random_set(seed)
        weights = np.random.default_rng(seed).uniform(0.5, 2.0, len(t))
        wanted = deviation**2 * weights.sum()
        found = interpolate.splprep(
            points.T, w=np.sqrt(weights), u=t, s=wanted, full_output=True, quiet=True
        )
        (knots, theirs, _), _ = found[0]
        options = {"parameters": t, "weights": weights, "knots_at_points": True}
        curve = hn.smooth_curve(points, deviation, **options)
        assert curve.error == pytest.approx(wanted, rel=2e-9) or np.isinf(curve.p)
        assert curve.error <= wanted * (1.0 + 2e-9)
        # At the deviation that FITPACK came to.
        at_theirs = hn.smooth_curve(points, np.sqrt(found[1] / weights.sum()), **options)
        mine = jumps(3, np.array(at_theirs.knots), np.array(at_theirs.coefficients))
        assert mine <= jumps(3, knots, np.stack(theirs, axis=1)) * (1.0 + 1e-6)


@pytest.mark.parametrize("deviation", [0.0, 0.05])
@pytest.mark.parametrize("degree", [3, 5])
@pytest.mark.parametrize("given", [0, 1])
def test_straight_ends_have_no_curvature(deviation, degree, given):
    t, points = noisy()
    start, end = points[:1] if given else (), points[-1:] if given else ()
    curve = hn.smooth_curve(
        points,
        deviation,
        parameters=t,
        start=start,
        end=end,
        straight_start=True,
        straight_end=True,
        degree=degree,
    )
    scale = np.abs(curve.evaluate(np.linspace(0.0, 10.0, 301), 2)).max()
    np.testing.assert_allclose(curve.evaluate([0.0, 10.0], 2), 0.0, atol=1e-11 * scale)
    if deviation == 0.0:
        np.testing.assert_allclose(curve.evaluate(t), points, atol=1e-10)
    else:
        assert curve.error == pytest.approx(deviation**2 * len(t), rel=2e-9)


def test_interpolated_with_straight_ends_it_is_the_natural_spline():
    t, points = noisy()
    mine = hn.smooth_curve(points, 0.0, parameters=t, straight_start=True, straight_end=True)
    natural = interpolate.CubicSpline(t, points, bc_type="natural")
    between = np.linspace(0.0, 10.0, 301)
    np.testing.assert_allclose(mine.evaluate(between), natural(between), atol=1e-8)


@pytest.mark.parametrize("deviation", [0.0, 0.05])
def test_tangents_and_curvatures_are_met_by_quintics(deviation):
    t, points = noisy()
    start = [points[0], [1.0, 2.5], [0.3, -0.2]]
    end = [points[-1], [1.0, -1.5], [-0.1, 0.4]]
    curve = hn.smooth_curve(points, deviation, parameters=t, start=start, end=end, degree=5)
    for given, at in ((start, 0.0), (end, 10.0)):
        for order, value in enumerate(given):
            np.testing.assert_allclose(curve.evaluate([at], order)[0], value, atol=1e-8)
    if deviation == 0.0:
        np.testing.assert_allclose(curve.evaluate(t), points, atol=1e-8)


@pytest.mark.parametrize("degree", [1, 2, 3, 4, 5])
def test_a_polynomial_of_the_degree_is_itself(degree):
    t = np.linspace(0.0, 3.0, degree + 1)
    factors = np.random.default_rng(degree).normal(size=(degree + 1, 3))
    points = np.stack([np.polyval(column, t) for column in factors.T], axis=1)
    curve = hn.smooth_curve(points, 0.0, parameters=t, degree=degree)
    assert len(curve.coefficients) == degree + 1
    between = np.linspace(0.0, 3.0, 20)
    wanted = np.stack([np.polyval(column, between) for column in factors.T], axis=1)
    np.testing.assert_allclose(curve.evaluate(between), wanted, atol=1e-11 * np.abs(wanted).max())


def test_two_points_with_tangents_are_a_hermite_cubic():
    start, end = [[0.0, 0.0], [1.0, 0.0]], [[2.0, 1.0], [1.0, 0.0]]
    curve = hn.smooth_curve(
        np.array([start[0], end[0]]), 0.0, parameters=[0, 2], start=start, end=end
    )
    theirs = interpolate.CubicHermiteSpline([0, 2], [start[0], end[0]], [start[1], end[1]])
    between = np.linspace(0.0, 2.0, 9)
    np.testing.assert_allclose(curve.evaluate(between), theirs(between), atol=1e-14)


@pytest.mark.parametrize(
    "points, options, words",
    [
        (np.zeros((3, 2)), {}, "needs 4 points"),
        (np.zeros((5, 2)), {}, "same place"),
        (np.full((5, 2), np.nan), {}, "no place"),
        (np.eye(5), {"deviation": -1.0}, "must not be negative"),
        (np.eye(5), {"deviation": np.nan}, "must not be negative"),
        (np.eye(5), {"parameters": [0, 1, 2, 2, 3]}, "out of order"),
        (np.eye(5), {"parameters": [0, 1]}, "as many parameters"),
        (np.eye(5), {"weights": [1, 1, 0, 1, 1]}, "above zero"),
        (np.eye(5), {"start": [[1.0]]}, "coordinates"),
        (np.eye(5), {"start": np.eye(5)[:3]}, "degree 5"),
        (np.eye(5), {"start": np.eye(5)[:2], "straight_start": True}, "degree 5"),
        (np.eye(5), {"degree": 2, "straight_end": True}, "degree of 3"),
        (np.eye(5), {"degree": 6}, "from 1 to 5"),
        (np.eye(5), {"degree": 5}, "needs 6 points"),
    ],
)
def test_nonsense_is_refused(points, options, words):
    options = {"deviation": 0.1, **options}
    with pytest.raises(ValueError, match=words):
        hn.smooth_curve(points, **options)
