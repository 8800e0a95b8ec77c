# SPDX-License-Identifier: GPL-3.0-or-later
"""Developable strips and warp: cones by their closed forms, bounds that no sample passes."""

import math

import hull_native as hn
import numpy as np
import pytest


def circle(radius, height, spans=64, first=0.0, last=2 * math.pi):
    """Bézier points (4 spans, 3) of an arc, off by 2e-11 of the radius at 64 spans a turn."""
    ends = np.linspace(first, last, spans + 1)
    handle = 4 / 3 * math.tan((last - first) / spans / 4)
    points = np.stack([np.cos(ends), np.sin(ends), 0 * ends], axis=1) * radius
    along = np.stack([-np.sin(ends), np.cos(ends), 0 * ends], axis=1) * radius * handle
    points[:, 2] = height
    quads = [points[:-1], points[:-1] + along[:-1], points[1:] - along[1:], points[1:]]
    return np.stack(quads, axis=1).reshape(-1, 3)


def split(span, t):
    """Two cubics of one (de Casteljau)."""
    rows = [np.asarray(span, dtype=float)]
    while len(rows[-1]) > 1:
        rows.append((1 - t) * rows[-1][:-1] + t * rows[-1][1:])
    return np.array([row[0] for row in rows]), np.array([row[-1] for row in rows[::-1]])


def lengths(points):
    return np.linalg.norm(np.diff(points, axis=0), axis=1)


def area(a, b):
    """Of the quadrilaterals between two rows of points in the plane or in space, by triangles."""
    if a.shape[1] == 2:
        a, b = (np.pad(p, ((0, 0), (0, 1))) for p in (a, b))
    one = np.cross(a[1:] - a[:-1], b[:-1] - a[:-1])
    other = np.cross(b[1:] - a[1:], b[:-1] - a[1:])
    return 0.5 * (np.linalg.norm(one, axis=1) + np.linalg.norm(other, axis=1)).sum()


def test_warp_bound_is_above_all_samples():
    """1,000 random strips, their curves rather straight as those of chines are."""
    random = np.random.default_rng(231)
    t = np.linspace(0.0, 1.0, 201)
    tight, gentle = 0, 0
    for k in range(1000):
        x = np.linspace(0.0, 3.0, 4)[:, None] * [1.0, 0.0, 0.0]
        bend = random.choice([0.05, 0.3, 1.0])
        a = x + bend * random.normal(size=(4, 3))
        b = x + [0.0, 1.5, 0.5] + bend * random.normal(size=(4, 3))
        worst = hn.largest_warp(a, b)
        sampled = max(hn.ruled_warp(a, b, one) for one in t)
        assert sampled <= worst.bound, f"seed 231, strip {k}"
        assert worst.found <= worst.bound
        assert hn.ruled_warp(a, b, worst.at) == worst.found
        gentle += bend == 0.05
        tight += bend == 0.05 and worst.bound <= 1.0011 * worst.found
    # Where normals at both ends of a ruling are more than 90° apart there is no sharp bound.
    assert tight == gentle > 250


def test_warp_of_a_hyperbolic_paraboloid():
    """z = x y over the unit square: at x = 0 and 1 along y the normals of the edges y = 0 and y = 1
    are (-y, -x, 1): the angle between (0, -x, 1) and (-1, -x, 1) is acos(√((x² + 1) / (x² + 2))).
    """
    x = np.linspace(0.0, 1.0, 4)
    a = np.stack([x, 0 * x, 0 * x], axis=1)
    b = np.stack([x, 0 * x + 1, x], axis=1)
    for t in (0.0, 0.3, 1.0):
        angle = math.acos(math.sqrt((t**2 + 1) / (t**2 + 2)))
        assert hn.ruled_warp(a, b, t) == pytest.approx(angle / math.sqrt(1 + t**2), rel=1e-12)
    worst = hn.largest_warp(a, b)
    assert worst.found == pytest.approx(math.pi / 4, rel=1e-3) and worst.at == 0.0


def test_warp_of_more_than_a_span_is_refused():
    spans = np.vstack([circle(1.0, 0.0)[:8], np.full((4, 3), math.nan)])
    for call in (lambda a: hn.largest_warp(a, a), lambda a: hn.ruled_warp(a, a, 0.5)):
        with pytest.raises(ValueError, match="[ab] must be one cubic span"):
            call(spans[:8])
        with pytest.raises(ValueError, match="finite"):
            call(spans[8:])


def test_warp_of_developable_ones_is_none():
    a = np.array([[0, 0, 0], [1, 0.4, 0.1], [2, 0.5, 0.3], [3, 0.2, 0.2]], dtype=float)
    for b in (a + [0.2, 1.0, 2.0], 0.4 * a + [1.0, 0.5, 2.0]):
        worst = hn.largest_warp(a, b)
        assert worst.found < 1e-10 and worst.bound < 1e-9


def test_rulings_of_an_oblique_cone_pass_its_tip():
    tip = np.array([0.7, 0.9, 4.0])
    a = np.array([[0, 0, 0], [1, 0.6, 0.1], [2, 0.8, -0.1], [3, 0.1, 0.0]], dtype=float)
    nearer = tip + 0.4 * (a - tip)
    # In other spans, so that equal parameters are not what belongs together.
    first, rest = split(nearer, 0.3)
    second, third = split(rest, 0.55)
    strip = hn.DevelopableStrip(a, np.vstack([first, second, third]), 60)
    assert strip.core == (0, len(strip.rulings) - 1)
    on_a, on_b = strip.ends
    along = (on_b - on_a) / np.linalg.norm(on_b - on_a, axis=1)[:, None]
    off = np.linalg.norm(np.cross(tip - on_a, along), axis=1)
    assert off.max() < 1e-11
    assert (np.diff(strip.rulings, axis=0) > 0.0).all()


def test_a_right_cone_develops_to_its_sector():
    """r = 1, h = 2: 360° r / √(r² + h²) = 160.997°; the edges are circles about the tip."""
    strip = hn.DevelopableStrip(circle(1.0, 0.0), circle(0.5, 1.0), 512)
    a, b = strip.developed()
    slant = math.sqrt(5.0)
    on_a, on_b = strip.ends
    assert np.linalg.norm(b - a, axis=1) == pytest.approx(np.linalg.norm(on_b - on_a, axis=1))
    # The tip, where all rulings meet: twice as far as the upper edge.
    tips = a + 2.0 * (b - a)
    assert np.ptp(tips, axis=0).max() < 1e-8
    tip = tips.mean(axis=0)
    assert np.linalg.norm(a - tip, axis=1) == pytest.approx(np.full(len(a), slant), abs=1e-8)
    assert np.linalg.norm(b - tip, axis=1) == pytest.approx(np.full(len(a), slant / 2), abs=1e-8)
    angles = np.unwrap(np.arctan2(*(a - tip).T[::-1]))
    assert math.degrees(abs(angles[-1] - angles[0])) == pytest.approx(160.997, abs=5e-4)
    assert abs(angles[-1] - angles[0]) == pytest.approx(2 * math.pi / slant, abs=1e-8)


def tangent_surface(distance):
    """Bézier points of c + d c', c = (u, u², u³ / 5), u = 1 + t: lines between two of these are
    tangents of c, their surface is developable, and no cone or cylinder."""
    t = np.linspace(0.0, 1.0, 4)
    u = 1.0 + t
    values = np.stack([u, u**2, 0.2 * u**3], axis=1)
    values += distance * np.stack([0 * u + 1, 2 * u, 0.6 * u**2], axis=1)
    rows = np.array([[1, 0, 0, 0], [1, 1 / 3, 0, 0], [1, 2 / 3, 1 / 3, 0], [1, 1, 1, 1]])
    return rows @ np.linalg.solve(t[:, None] ** np.arange(4), values)


def exact_edge(distance, t):
    """Of that edge at parameters (n,): derivatives, second derivatives, and the rulings c'."""
    u = 1.0 + t
    c1 = np.stack([0 * u + 1, 2 * u, 0.6 * u**2], axis=1)
    c2 = np.stack([0 * u, 0 * u + 2, 1.2 * u], axis=1)
    c3 = np.tile([0.0, 0.0, 1.2], (len(u), 1))
    return c1 + distance * c2, c2 + distance * c3, c1


def test_a_development_keeps_lengths_areas_and_geodesic_curvatures():
    interpolate = pytest.importorskip(
        "scipy.interpolate", reason="compared with SciPy, which is not there"
    )
    strip = hn.DevelopableStrip(tangent_surface(1.0), tangent_surface(2.5), 800)
    assert strip.core == (0, 800)
    # Rulings join equal parameters.
    assert strip.rulings[:, 0] == pytest.approx(strip.rulings[:, 1], abs=1e-9)
    nodes, weights = np.polynomial.legendre.leggauss(40)
    at, weights = 0.5 * (nodes + 1.0), 0.5 * weights
    t, rounds = strip.rulings[:, 0], 0.0
    for flat, distance, way in zip(strip.developed(), (1.0, 2.5), (1.0, -1.0)):
        curve = interpolate.make_interp_spline(t, flat, k=7)
        d1, d2, ruling = exact_edge(distance, at)
        speed = np.linalg.norm(d1, axis=1)
        p, v, w = curve(at), curve(at, 1), curve(at, 2)
        assert np.linalg.norm(v, axis=1) == pytest.approx(speed, rel=1e-8)
        normal = np.cross(d1, ruling)
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        curvature = np.sum(normal * np.cross(d1, d2), axis=1) / speed**3
        flat_curvature = (v[:, 0] * w[:, 1] - v[:, 1] * w[:, 0]) / speed**3
        assert flat_curvature == pytest.approx(curvature, rel=1e-8, abs=1e-8)
        rounds += way * np.sum(weights * (p[:, 0] * v[:, 1] - p[:, 1] * v[:, 0])) / 2
    a, b = strip.developed()
    for one, other, way in ((a[-1], b[-1], 1.0), (a[0], b[0], -1.0)):
        rounds += way * (one[0] * other[1] - one[1] * other[0]) / 2
    # |∂x/∂t x ∂x/∂d| = d |c'' x c'|.
    c1, c2, _ = exact_edge(0.0, at)
    area_in_space = (
        (2.5**2 - 1.0) / 2 * np.sum(weights * np.linalg.norm(np.cross(c2, c1), axis=1))
    )
    assert rounds == pytest.approx(area_in_space, rel=1e-8)


def test_strips_have_no_gaussian_curvature():
    """K of c + d c' by the normals' turn along a ruling: none."""
    for pair in (
        (tangent_surface(1.0), tangent_surface(2.5)),
        (circle(1.0, 0.0), circle(0.5, 1.0)),
    ):
        for k in range(0, len(pair[0]), 4):
            spans = [edge[k : k + 4] for edge in pair]
            assert hn.largest_warp(*spans).bound < 1e-9


def test_ends_are_closed_by_cones():
    """A cylinder whose edges are cut off askew: rulings are parallel, and what they leave is cones
    of straight lines from the edges' ends, in the plane here."""
    a = circle(1.0, 0.0, 16, 0.0, math.pi / 2)
    b = circle(1.0, 2.0, 16, 0.3, math.pi / 2 + 0.2)
    strip = hn.DevelopableStrip(a, b, 320)
    first, last = strip.core
    assert 0 < first < last < len(strip.rulings) - 1
    on_a, on_b = strip.ends
    core = (on_b - on_a)[first : last + 1]
    assert core[5:-5] == pytest.approx(np.tile([0.0, 0.0, 2.0], (len(core) - 10, 1)), abs=1e-6)
    assert (np.diff(strip.rulings, axis=0) >= 0.0).all()
    assert tuple(strip.rulings[0]) == (0.0, 0.0) and tuple(strip.rulings[-1]) == (16.0, 16.0)
    flat_a, flat_b = strip.developed()
    for plane, solid in ((flat_a, on_a), (flat_b, on_b)):
        assert lengths(plane).sum() == pytest.approx(lengths(solid).sum(), rel=1e-5)
    # Rulings keep their lengths, and nothing is laid upon anything else.
    assert np.linalg.norm(flat_b - flat_a, axis=1) == pytest.approx(
        np.linalg.norm(on_b - on_a, axis=1), rel=1e-9
    )
    assert area(flat_a, flat_b) == pytest.approx(area(on_a, on_b), rel=1e-4)


@pytest.mark.parametrize(
    "a, b, count, words",
    [
        (np.zeros((3, 3)), np.zeros((4, 3)), 10, "four rows for each"),
        (circle(1.0, 0.0), circle(1.0, 1.0), 0, "1 to 5000"),
        (np.full((4, 3), math.nan), circle(1.0, 1.0), 10, "finite"),
        (
            np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]], dtype=float),
            np.array([[0, 1, 0], [0, 1, 1], [0, 1, 2], [0, 1, 3]], dtype=float),
            10,
            "No straight line",
        ),
    ],
)
def test_refused(a, b, count, words):
    with pytest.raises(ValueError, match=words):
        hn.DevelopableStrip(a, b, count)
