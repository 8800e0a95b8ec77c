# SPDX-License-Identifier: GPL-3.0-or-later
"""Where words have room on flat plates: within them, away from their borders and holes."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from hull_native.production.plate_room import reach_within, roomy_place

N = 40


def closed(*corners):
    return np.array([*corners, corners[0]], dtype=float)


def grid(shape):
    """A flat plate of triangles over the unit square, its points at shape(u, v)."""
    u, v = np.meshgrid(*[np.linspace(0.0, 1.0, N + 1)] * 2, indexing="ij")
    points = np.stack(shape(u.ravel(), v.ravel()), axis=-1)
    at = np.arange((N + 1) ** 2).reshape(N + 1, N + 1)
    a, b, c, d = at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]
    triangles = np.concatenate([np.stack(one, -1).reshape(-1, 3) for one in ((a, b, c), (a, c, d))])
    return SimpleNamespace(points=points, triangles=triangles)


def room_at(place, lines):
    """By points along the lines."""
    share = np.linspace(0.0, 1.0, 2001)[:, None]
    return min(
        np.linalg.norm(a + share * (b - a) - place, axis=1).min()
        for line in lines
        for a, b in zip(line[:-1], line[1:])
    )


def test_a_rectangle_has_it_in_its_middle():
    place, room = roomy_place(
        grid(lambda u, v: (8.0 * u, 2.0 * v)), [closed((0, 0), (8, 0), (8, 2), (0, 2))]
    )
    assert place.tolist() == [4.0, 1.0] and room == 1.0


def test_a_pointed_plate_has_it_at_its_broad_end():
    """The middle of the rectangle around is on the border; the largest circle is of radius
    (a + b - c) / 2."""
    border = [closed((0, 0), (10, 0), (0, 2))]
    place, room = roomy_place(grid(lambda u, v: (10.0 * u * (1.0 - v), 2.0 * v)), border)
    radius = 0.5 * (10.0 + 2.0 - math.hypot(10.0, 2.0))
    assert 0.8 * radius < room <= radius
    assert room == pytest.approx(room_at(place, border), rel=1e-6)
    assert (place > 0.0).all() and place[1] < 2.0 - 0.2 * place[0]


def test_it_is_in_no_hole():
    plate = grid(lambda u, v: (8.0 * u, 2.0 * v))
    middles = plate.points[plate.triangles].mean(axis=1)
    plate.triangles = plate.triangles[np.abs(middles - [4.0, 1.0]).max(axis=1) > 0.6]
    lines = [
        closed((0, 0), (8, 0), (8, 2), (0, 2)),
        closed((3.4, 0.4), (4.6, 0.4), (4.6, 1.6), (3.4, 1.6)),
    ]
    place, room = roomy_place(plate, lines)
    assert room > 0.8 and abs(place[0] - 4.0) < 2.0


def test_how_far_a_line_goes_within():
    border = [closed((0, 0), (8, 0), (8, 2), (0, 2))]
    for angle, reach in ((0.0, 3.0), (math.pi / 2, 0.5), (math.pi / 4, 0.5 * math.sqrt(2.0))):
        way = np.array([math.cos(angle), math.sin(angle)])
        found = reach_within(border, np.array([3.0, 0.5]), way)
        assert found == pytest.approx(reach, rel=1e-12)
    assert reach_within([], np.zeros(2), np.array([1.0, 0.0])) == math.inf
