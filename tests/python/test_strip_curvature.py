# SPDX-License-Identifier: GPL-3.0-or-later
"""Strips between two curves, cones and cylinders have no Gaussian curvature as they are made: one
normal along each ruling, and nothing left within their borders by the theorem of Gauss and Bonnet
(do Carmo 1976)."""

import math

import hull_native as hn
import numpy as np
import pytest

CHINE = np.array([[0, 1.2, 0.1], [3, 2.3, 0.15], [6, 2.4, 0.4], [9, 1.0, 1.3]], dtype=float)
KEEL = np.array([[0, 0, 0], [3, 0.02, -0.1], [6.3, 0.05, 0.0], [9.4, 0.0, 0.8]], dtype=float)
EDGE = np.array([[0, 0, 0], [1, 0.6, 0.1], [2, 0.8, -0.1], [3, 0.1, 0.0]], dtype=float)
TIP, WAY = np.array([0.7, 0.9, 4.0]), np.array([0.2, 0.3, 1.0])


def at(chain, s, derivative=0):
    """Of a chain of cubics (4 n, 3) at parameters (k,): points or derivatives by de Casteljau."""
    spans = chain.reshape(-1, 4, 3)
    k = np.clip(np.floor(s).astype(int), 0, len(spans) - 1)
    rows, factor = spans[k], 1.0
    for order in range(derivative):
        factor *= 3 - order
        rows = np.diff(rows, axis=1)
    t = (s - k)[:, None, None]
    while rows.shape[1] > 1:
        rows = (1.0 - t) * rows[:, :-1] + t * rows[:, 1:]
    return factor * rows[:, 0]


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def strip_between(count):
    return KEEL, CHINE, hn.DevelopableStrip(KEEL, CHINE, count)


def cone(count):
    image = TIP + 0.5 * (EDGE - TIP)
    return EDGE, image, hn.DevelopableStrip.cone(EDGE, TIP, count=count)


def cylinder(count):
    shifted = EDGE + 2.5 * unit(WAY)
    return EDGE, shifted, hn.DevelopableStrip.cylinder(EDGE, direction=WAY, length=2.5, count=count)


def core_of(made):
    """(s, t, ends at a, ends at b, normals at a, normals at b) of the rulings that touch both
    curves; normals are unit. Of a cone all, and b is the image of a."""
    a, b, strip = made
    is_cone = strip.rulings[:, 1].max() == 0.0
    first, last = (0, len(strip.rulings) - 1) if is_cone else strip.core
    s, t = strip.rulings[first : last + 1].T
    on_a, on_b = (ends[first : last + 1] for ends in strip.ends)
    t = s if is_cone else t
    normals = [unit(np.cross(at(c, k, 1), on_b - on_a)) for c, k in ((a, s), (b, t))]
    return s, t, on_a, on_b, *normals


def turned(one, other):
    """The sine of the largest angle between unit vectors (k, 3) of the same sense."""
    assert (np.sum(one * other, axis=1) > 0.0).all()
    return np.linalg.norm(np.cross(one, other), axis=1).max()


@pytest.mark.parametrize("make", [strip_between, cone, cylinder])
def test_one_normal_along_each_ruling(make):
    """At both ends to rounding, by the tangents of the curves that were given. In the middle by the
    way from the ruling before to the one behind, at second order in their distance."""
    off = []
    for count in (100, 200):
        _, _, on_a, on_b, at_a, at_b = core_of(make(count))
        assert turned(at_a, at_b) < 1e-12
        middle = 0.5 * (on_a + on_b)
        by_way = unit(np.cross(middle[2:] - middle[:-2], (on_b - on_a)[1:-1]))
        off.append(turned(by_way, at_a[1:-1]))
    assert off[1] < 2e-3 and (off[1] < 0.3 * off[0] or off[0] < 1e-12)


def test_a_strip_of_equal_parameters_is_none():
    """What would be found of one that has warp."""
    s = np.linspace(0.0, 1.0, 50)
    q = at(CHINE, s) - at(KEEL, s)
    normals = [unit(np.cross(at(curve, s, 1), q)) for curve in (KEEL, CHINE)]
    assert turned(*normals) > 0.01


def spline_over(parameters, values):
    """The spline of degree 7 through them."""
    interpolate = pytest.importorskip("scipy.interpolate", reason="SciPy is not there")
    return interpolate.make_interp_spline(parameters, values, k=7)


def inner_curvature(a, b, s, t, normals):
    """∫ K dA between the first of the rulings at s and t and the last by the theorem of Gauss and
    Bonnet: what the border's geodesic curvature and the angles at its corners leave of a full
    turn. normals: at a and at b."""
    bends, angles = 0.0, -2.0 * math.pi
    q = unit(at(b, t) - at(a, s))
    for curve, k, own, sense in ((a, s, normals[0], 1.0), (b, t, normals[1], -1.0)):
        d1, d2 = at(curve, k, 1), at(curve, k, 2)
        turn = np.sum(own * np.cross(d1, d2), axis=1) / np.sum(d1**2, axis=1)
        bends += sense * spline_over(k, turn).integrate(k[0], k[-1])
        across = sense * np.sum(q * unit(d1), axis=1)
        angles += math.acos(across[0]) + math.acos(-across[-1])
    return angles - bends


@pytest.mark.parametrize("make", [strip_between, cone, cylinder])
def test_no_curvature_within_the_border(make):
    """Found: 2e-13 of 200 rulings, by a spline of degree 7 over them."""
    made = make(200)
    s, t, _, _, *normals = core_of(made)
    assert abs(inner_curvature(*made[:2], s, t, normals)) < 1e-11


def test_curvature_within_a_warped_border():
    """Of straight lines between equal parameters: what the theorem finds is the integral of their
    K = -(a' × q · (b' - a'))² / |x_s × q|⁴ over the surface x = a + v q."""
    s = np.linspace(0.0, 1.0, 201)
    q = at(CHINE, s) - at(KEEL, s)
    normals = [unit(np.cross(at(curve, s, 1), q)) for curve in (KEEL, CHINE)]
    nodes, weights = np.polynomial.legendre.leggauss(24)
    u, v = (grid.ravel() for grid in np.meshgrid(0.5 * (nodes + 1.0), 0.5 * (nodes + 1.0)))
    da, db = at(KEEL, u, 1), at(CHINE, u, 1)
    q = at(CHINE, u) - at(KEEL, u)
    area = np.linalg.norm(np.cross(da + v[:, None] * (db - da), q), axis=1)
    twist = np.sum(np.cross(da, q) * (db - da), axis=1)
    exact = -np.sum(0.25 * np.outer(weights, weights).ravel() * twist**2 / area**3)
    assert exact < -1e-3
    assert inner_curvature(KEEL, CHINE, s, s, normals) == pytest.approx(exact, rel=1e-8)


@pytest.mark.parametrize("make", [strip_between, cone, cylinder])
def test_developments_keep_the_angles_of_rulings(make):
    """Between them and both edges, which are curves of no known kind here, at the fourth power of
    the rulings' distance."""
    off = []
    for count in (100, 200):
        a, b, strip = made = make(count)
        s, t, on_a, on_b, *_ = core_of(made)
        first = strip.core[0] if len(s) < len(strip.rulings) else 0
        flat_a, flat_b = (flat[first : first + len(s)] for flat in strip.developed())
        # Of a cone the second edge is its tip: the angle is held along the image half-way.
        flat_b = 0.5 * (flat_a + flat_b) if make is cone else flat_b
        in_plane, in_space = unit(flat_b - flat_a), unit(on_b - on_a)
        worst = 0.0
        for curve, k, flat in ((a, s, flat_a), (b, t, flat_b)):
            slopes, way = spline_over(k, flat)(k, 1), at(curve, k, 1)
            assert np.linalg.norm(slopes, axis=1) == pytest.approx(
                np.linalg.norm(way, axis=1), rel=1e-9
            )
            angles = (
                np.arccos(np.sum(unit(one) * ruling, axis=1))
                for one, ruling in ((slopes, in_plane), (way, in_space))
            )
            worst = max(worst, np.abs(next(angles) - next(angles)).max())
        off.append(worst)
    assert off[1] < 2e-11 and (off[1] < off[0] / 10.0 or off[0] < 1e-11)
