# SPDX-License-Identifier: GPL-3.0-or-later
"""Cones through a point, cylinders along a direction, and lines projected onto strips."""

import math

import hull_native as hn
import numpy as np
import pytest
from test_developable import circle, lengths, split


def off_tip(strip, tip):
    """How far rulings, as lines, pass a point."""
    on_a, on_b = strip.ends
    along = (on_b - on_a) / np.linalg.norm(on_b - on_a, axis=1)[:, None]
    return np.linalg.norm(np.cross(tip - on_a, along), axis=1).max()


def test_a_cone_through_a_point():
    """Rulings end in the tip to 1e-11; of the right cone the tip is one point of the plane, and the
    edge a circle of the slant about it, over 160.997°."""
    tip = np.array([0.7, 0.9, 4.0])
    edge = np.array([[0, 0, 0], [1, 0.6, 0.1], [2, 0.8, -0.1], [3, 0.1, 0.0]], dtype=float)
    oblique = hn.DevelopableStrip.cone(np.vstack(split(edge, 0.3)), tip, count=60)
    assert off_tip(oblique, tip) < 1e-11
    assert np.abs(oblique.ends[1] - tip).max() < 1e-11
    assert len(oblique.rulings) == 61 and (oblique.rulings[:, 1] == 0.0).all()
    # As the strip to the edge's image half-way to the tip has it.
    a, b = oblique.developed()
    image = tip + 0.5 * (edge - tip)
    half = hn.DevelopableStrip(np.vstack(split(edge, 0.3)), np.vstack(split(image, 0.3)), 60)
    other, _ = half.developed()
    assert lengths(a).sum() == pytest.approx(lengths(other).sum(), rel=1e-6)
    assert np.linalg.norm(a[-1] - a[0]) == pytest.approx(np.linalg.norm(other[-1] - other[0]))

    right = hn.DevelopableStrip.cone(circle(1.0, 0.0), (0.0, 0.0, 2.0), count=512)
    a, b = right.developed()
    assert np.ptp(b, axis=0).max() < 1e-11
    slant = math.sqrt(5.0)
    assert np.linalg.norm(a - b, axis=1) == pytest.approx(np.full(len(a), slant), abs=1e-9)
    angles = np.unwrap(np.arctan2(*(a - b).T[::-1]))
    assert abs(angles[-1] - angles[0]) == pytest.approx(2 * math.pi / slant, abs=1e-9)
    assert math.degrees(abs(angles[-1] - angles[0])) == pytest.approx(160.997, abs=5e-4)


def test_a_cylinder_along_a_direction():
    """Rulings are parallel to 1e-11, equal parameters are joined; a right cylinder is a rectangle,
    one cut off askew has the cosine of its edge's height in the plane: z = tan(lean) x."""
    edge = np.array([[0, 0, 0], [1, 0.6, 0.1], [2, 0.8, -0.1], [3, 0.1, 0.0]], dtype=float)
    way = np.array([0.2, 0.3, 1.0])
    strip = hn.DevelopableStrip.cylinder(edge, direction=way, length=2.5, count=40)
    on_a, on_b = strip.ends
    assert on_b - on_a == pytest.approx(
        np.tile(2.5 * way / np.linalg.norm(way), (41, 1)), abs=1e-11
    )
    assert (strip.rulings[:, 0] == strip.rulings[:, 1]).all() and strip.core == (0, 40)

    lean, count = 0.4, 512
    leaning = circle(1.0, 0.0)
    leaning[:, 2] = math.tan(lean) * leaning[:, 0]
    for edge, height in ((circle(1.0, 0.0), 0.0), (leaning, math.tan(lean))):
        strip = hn.DevelopableStrip.cylinder(edge, direction=(0, 0, 1), length=2.0, count=count)
        a, b = strip.developed()
        up = (b[0] - a[0]) / 2.0
        assert b - a == pytest.approx(np.tile(2.0 * up, (len(a), 1)), abs=1e-8)
        on_a, _ = strip.ends
        turn = np.unwrap(np.arctan2(on_a[:, 1], on_a[:, 0]))
        along = (a - a[0]) @ np.array([up[1], -up[0]])
        assert along == pytest.approx(turn, abs=1e-8)
        risen = (a - a[0]) @ up
        assert risen == pytest.approx(height * (np.cos(turn) - 1.0), abs=1e-8)


def test_a_straight_edge_gives_a_flat_panel():
    """Where every line between straight edges would fit."""
    edge = np.linspace([0.0, 0.0, 0.0], [3.0, 0.0, 0.0], 4)
    strip = hn.DevelopableStrip.cylinder(edge, direction=(1, 2, 0), length=math.sqrt(5.0), count=8)
    a, b = strip.developed()
    assert a == pytest.approx(np.stack([np.linspace(0, 3, 9), np.zeros(9)], axis=1), abs=1e-12)
    assert b == pytest.approx(a + [1.0, 2.0], abs=1e-12)


def test_lines_projected_onto_strips():
    """A level line around a cylinder is straight on its development; a plane across a cone meets it
    in an ellipse."""
    strip = hn.DevelopableStrip.cylinder(
        circle(1.0, 0.0), direction=(0, 0, 1), length=2.0, count=256
    )
    square = [[-2, -3, 0.7], [2, -3, 0.7]]
    ((on_strip, flat),) = strip.projected(square, direction=(0, 1, 0))
    assert np.hypot(*on_strip.T[:2]) == pytest.approx(np.ones(len(on_strip)), abs=1e-9)
    assert on_strip[:, 2] == pytest.approx(np.full(len(on_strip), 0.7), abs=1e-12)
    assert len(on_strip) == 257
    assert lengths(flat).sum() == pytest.approx(2.0 * math.pi, abs=1e-8)
    assert np.linalg.norm(flat[-1] - flat[0]) == pytest.approx(2.0 * math.pi, abs=1e-8)
    # Rays begin on the line: from amidst the cylinder only one side is met.
    ((on_strip, _),) = strip.projected([[-2, 0.3, 0.7], [2, 0.3, 0.7]], direction=(0, 1, 0))
    assert (on_strip[:, 1] >= 0.3).all() and 60 < len(on_strip) < 257

    cone = hn.DevelopableStrip.cone(circle(1.0, 0.0), (0.0, 0.0, 2.0), count=256)
    ((on_strip, flat),) = cone.projected([[-3, -5, 0.5], [3, -5, 1.5]], direction=(0, 1, 0))
    # In the line's plane, on the cone.
    assert on_strip[:, 2] == pytest.approx(1.0 + on_strip[:, 0] / 6.0, abs=1e-11)
    radius = 1.0 - on_strip[:, 2] / 2.0
    assert np.hypot(*on_strip.T[:2]) == pytest.approx(radius, abs=1e-9)
    _, tip = cone.developed()
    slant = math.sqrt(5.0) / 2.0 * (2.0 - on_strip[:, 2])
    assert np.linalg.norm(flat - tip[0], axis=1) == pytest.approx(slant, abs=1e-9)


@pytest.mark.parametrize("aside", [0.0, 1e-13, -1e-13])
def test_a_line_on_a_strip_is_met_all_along(aside):
    """Rounding puts half of its points behind the strip; what is behind by more is not met."""
    strip = hn.DevelopableStrip.cylinder(
        circle(1.0, 0.0), direction=(0, 0, 1), length=2.0, count=256
    )
    ((on_strip, _),) = strip.projected([[-2, -3, 0.3], [2, -3, 1.7]], direction=(0, 1, 0))
    on_strip = on_strip[on_strip[:, 1] < -0.1]
    line = on_strip + np.array([0.0, aside, 0.0])
    found = [one for one, _ in strip.projected(line, direction=(0, 1, 0)) if one[0, 1] < 0.0]
    assert [len(one) for one in found] == [len(on_strip)]
    behind = strip.projected(line + np.array([0.0, 1e-9, 0.0]), direction=(0, 1, 0))
    assert all((one[:, 1] > 0.0).all() for one, _ in behind)


@pytest.mark.parametrize(
    "make, words",
    [
        (lambda a: hn.DevelopableStrip.cone(a, (1.0, 0.0, 0.0)), "tip off the curve"),
        (lambda a: hn.DevelopableStrip.cone(a, (math.nan, 0, 0)), "finite"),
        (lambda a: hn.DevelopableStrip.cone(a, (0, 0, 1), count=0), "1 to 5000"),
        (lambda a: hn.DevelopableStrip.cylinder(a, direction=(0, 0, 0), length=1), "direction"),
        (lambda a: hn.DevelopableStrip.cylinder(a, direction=(0, 1, 0), length=1), "another dir"),
        (lambda a: hn.DevelopableStrip.cylinder(a, direction=(0, 0, 1), length=0), "above 0 m"),
        (lambda a: hn.DevelopableStrip.cylinder(a, direction=(0, 0, 1), length=math.nan), "above"),
        (lambda a: whole(a).projected([[0, 0, 1]], direction=(0, 1, 0)), "two points"),
        (
            lambda a: whole(a).projected([[0, 0, 1], [0, math.nan, 1]], direction=(0, 1, 0)),
            "finite",
        ),
        (lambda a: whole(a).projected([[9, 0, 1], [9, 1, 1]], direction=(0, 1, 0)), "misses"),
        (lambda a: whole(a).projected([[0, 0, 0], [0, 0, 1]], direction=(1, 0, 0)), "along its"),
        (lambda a: whole(a).projected([[0, 0, 0], [0, 0, 1]], direction=(0, 0, 0)), "direction"),
    ],
)
def test_cones_and_cylinders_refused(make, words):
    with pytest.raises(ValueError, match=words):
        make(circle(1.0, 0.0))


def whole(edge):
    return hn.DevelopableStrip.cylinder(edge, direction=(0, 0, 1), length=2.0)
