# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows and columns even along the girth: what they cost, and what costs nothing."""

import numpy as np
import pytest
from hull_native.networks.even_lines import even_lines

EVENNESS = 0.1


def sheet(along_girth, stations=5, bent=0.0):
    """Points (stations * n, 3) of a plane along the ship that is 3 across to 4 up, or bent along
    it; faces; and runs of four points along it and across it."""
    x, girth = np.meshgrid(np.arange(float(stations)), along_girth, indexing="ij")
    off = bent * x**3
    points = np.stack([x, 0.6 * girth - 0.8 * off, 0.8 * girth + 0.6 * off], axis=-1)
    numbers = np.arange(x.size).reshape(x.shape)
    corners = [numbers[:-1, :-1], numbers[1:, :-1], numbers[1:, 1:], numbers[:-1, 1:]]
    faces = np.stack(corners, axis=-1).reshape(-1, 4).tolist()
    runs = [line[k : k + 4] for lines in (numbers, numbers.T) for line in lines
            for k in range(len(line) - 3)]  # fmt: skip
    return points.reshape(-1, 3), faces, np.array(runs)


def cost(terms, points):
    return sum(float(np.sum((w @ points[run] - rest) ** 2)) for run, w, rest in terms)


def test_what_is_even_costs_nothing_nor_does_form_nor_the_rows_distance():
    points, faces, runs = sheet(np.linspace(0.0, 2.0, 9), bent=0.01)
    assert cost(even_lines(points, faces, runs, EVENNESS), points) < 1e-24
    points, faces, runs = sheet(np.linspace(0.0, 2.0, 9))
    points[:, 0] = points[:, 0] ** 2 + np.sin(points[:, 0])
    assert cost(even_lines(points, faces, runs, EVENNESS), points) < 1e-24


def test_uneven_points_cost_their_third_differences_along_the_girth():
    girth = np.linspace(0.0, 2.0, 9) + 0.05 * np.sin(7.0 * np.arange(9.0))
    points, faces, runs = sheet(girth)
    terms = even_lines(points, faces, runs, EVENNESS)
    wanted = EVENNESS**2 / len(runs) * 5 * np.sum(np.diff(girth, 3) ** 2)
    assert cost(terms, points) == pytest.approx(wanted, rel=1e-9)
    # What is across the surface is to stay, whatever it is: it costs what it moves by.
    for run, weights, rest in terms:
        assert weights @ (points[run] + [0.0, -0.8, 0.6]) == pytest.approx(weights @ points[run])
        across = np.array([0.0, -0.8, 0.6])
        assert (weights @ points[run] - rest) @ across == pytest.approx(0.0, abs=1e-12)


def test_nothing_is_asked_for_without_evenness_and_where_there_is_no_girth():
    points, faces, runs = sheet(np.linspace(0.0, 2.0, 9))
    assert even_lines(points, faces, runs, 0.0) == []
    assert even_lines(points, faces, runs[:0], EVENNESS) == []
    # A transom: its normal is along the ship.
    transom = points[:, [1, 0, 2]] * [0.0, 1.0, 1.0]
    assert even_lines(transom, faces, runs, EVENNESS) == []
