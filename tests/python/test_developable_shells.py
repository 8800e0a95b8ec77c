# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves along edges of a control mesh, and strips, cones and cylinders from them."""

import hull_native as hn
import numpy as np
import pytest
from plate_hulls import cylinder
from test_developable import circle


def border(surface):
    """Control points of the border x = 0, in order of y."""
    points = np.asarray(surface.mesh.points)
    own = np.flatnonzero(np.abs(points[:, 0]) < 1e-9)
    return own[np.argsort(points[own, 1])]


def bezier_at(spans, t):
    p = spans.reshape(-1, 4, 3).transpose(1, 0, 2)
    return (
        (1 - t) ** 3 * p[0]
        + 3 * t * (1 - t) ** 2 * p[1]
        + 3 * t * t * (1 - t) * p[2]
        + (t**3) * p[3]
    )


def test_the_curve_of_a_border_is_exact():
    surface = cylinder()
    chain = border(surface)
    curve = hn.edge_curve(surface, chain)
    assert curve.shape == (8 * (len(chain) - 1), 3)
    (own,) = (
        one for one in hn.HullCurves(surface, 1e-5).borders()
        if np.abs(one.points[:, 0]).max() < 1e-9
    )  # fmt: skip
    tree = hn.SurfaceTree(surface)
    for t in (0.0, 0.17, 0.5, 0.81):
        points = bezier_at(curve, t)
        np.testing.assert_allclose(tree.closest_points(points).distances, 0.0, atol=1e-11)
        np.testing.assert_allclose(points[:, 0], 0.0, atol=1e-11)
    ends = {tuple(np.round(own.points[k], 9)) for k in (0, -1)}
    assert ends == {tuple(np.round(curve[k], 9)) for k in (0, -1)}
    # The other way round it is the same curve.
    np.testing.assert_allclose(hn.edge_curve(surface, chain[::-1])[::-1], curve, atol=1e-12)
    with pytest.raises(ValueError, match="no edge between the control points"):
        hn.edge_curve(surface, [chain[0], chain[2]])
    with pytest.raises(ValueError, match="two control points or more"):
        hn.edge_curve(surface, chain[:1])


def test_a_strip_between_circles_is_their_cone():
    a, b = circle(2.0, 0.0, last=1.5), circle(1.0, 3.0, last=1.5)
    for other in (b, b[::-1]):
        shell = hn.strip_between(a, other, 80)
        ways = shell.second - shell.first
        # All rulings go to the apex (0, 0, 6).
        off = np.cross(ways, np.array([0.0, 0.0, 6.0]) - shell.first)
        assert np.abs(off).max() < 1e-8
    # 1.5 rad of the lateral area π (r + R) s, s² = 3² + 1².
    assert shell.area == pytest.approx(0.75 * 3.0 * np.sqrt(10.0), rel=1e-4)


def test_a_cone_to_a_point():
    shell = hn.cone_to(circle(2.0, 0.0, last=1.5), (0.0, 0.0, 6.0), 80)
    assert (shell.second == [0.0, 0.0, 6.0]).all() and len(shell.first) > 80
    np.testing.assert_allclose(np.linalg.norm(shell.first, axis=1), 2.0, atol=1e-9)
    assert shell.area == pytest.approx(0.75 * 2.0 * np.sqrt(40.0), rel=1e-4)
    for apex in ((2.0, 0.0, 0.0), (2.0, 1.0, 0.0)):
        with pytest.raises(ValueError, match="runs along the straight line"):
            hn.cone_to(circle(2.0, 0.0, last=1.5), apex, 80)
    straight = np.linspace([0.0, 0, 0], [3.0, 0, 0], 4)
    with pytest.raises(ValueError, match="runs along the straight line"):
        hn.cone_to(straight, (5.0, 0.0, 0.0))


def test_a_cylinder_along_a_direction():
    shell = hn.cylinder_along(circle(2.0, 0.0, last=1.5), (0.0, 0.5, 3.0), 80)
    rulings = shell.second - shell.first
    np.testing.assert_allclose(rulings, [[0.0, 0.5, 3.0]] * len(rulings), atol=1e-12)
    upright = hn.cylinder_along(circle(2.0, 0.0, last=1.5), (0.0, 0.0, 3.0), 80)
    assert upright.area == pytest.approx(2.0 * 1.5 * 3.0, rel=1e-4)
    with pytest.raises(ValueError, match="runs along the straight line"):
        hn.cylinder_along(np.linspace([0.0, 0, 0], [3.0, 0, 0], 4), (1.0, 0.0, 0.0))
    with pytest.raises(ValueError, match="a direction and a length above 0 m"):
        hn.cylinder_along(circle(2.0, 0.0), (0.0, 0.0, 0.0))
