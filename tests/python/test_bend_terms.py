# SPDX-License-Identifier: GPL-3.0-or-later
"""What bends count for in a fit: the second fundamental form, and nothing that moves along it."""

import hull_native as hn
import numpy as np
import pytest
from hull_native.networks.bend_terms import bend_terms
from test_curve_networks import sample_surface

FAIRNESS = 1e-3


def sheet(height, moved=0.0, side=8):
    """A LimitSurface over a square of points, those inside moved along it."""
    at = np.arange(side + 1.0)
    x, y = np.meshgrid(at, at, indexing="ij")
    inside = np.zeros_like(x)
    inside[2:-2, 2:-2] = moved * np.sin(3.0 * x + 5.0 * y)[2:-2, 2:-2]
    x, y = x + inside, y - inside
    points = np.stack([x, y, height(x, y)], axis=-1).reshape(-1, 3)
    first = (at[:-1, None] * (side + 1) + at[:-1]).astype(int).reshape(-1)
    corners = np.stack([first, first + side + 1, first + side + 2, first + 1], axis=1)
    return hn.LimitSurface(hn.ControlMesh(points, [4] * len(first), corners.reshape(-1), [], []))


def energy(terms, surface):
    points = np.asarray(surface.mesh.points)
    return sum(float(np.sum((row @ points[numbers] - rest) ** 2)) for numbers, row, rest in terms)


def of_the_second_form(surface, across):
    """The same by L, M, N of the surface at the same places (do Carmo 1976, 3-3)."""
    at = np.array([(u, v) for u in (0.25, 0.75) for v in (0.25, 0.75)])
    cells, uv = np.repeat(np.arange(surface.cell_count), 4), np.tile(at, (surface.cell_count, 1))
    _, xu, xv, xuu, xuv, xvv = surface.evaluate(cells, uv, 2)
    normals = np.cross(xu, xv)
    areas = np.linalg.norm(normals, axis=1)
    normals /= areas[:, None]
    total = 0.0
    for k in range(len(cells)):
        part = np.array([1.0, 0.0, 0.0]) - normals[k, 0] * normals[k]
        along = part / np.linalg.norm(part)
        ways = [(along, part @ part, 1.0), (np.cross(normals[k], along), 1.0, across)]
        metric = np.stack([xu[k], xv[k]], axis=1)
        form = np.array([[normals[k] @ xuu[k], normals[k] @ xuv[k]],
                         [normals[k] @ xuv[k], normals[k] @ xvv[k]]])  # fmt: skip
        for way, weight, share in ways:
            ab = np.linalg.lstsq(metric, way, rcond=None)[0]
            bend = ab @ form @ ab
            strong = bend * surface.mesh.size / 10.0
            total += (share * weight * bend) ** 2 / (1.0 + strong**2) * areas[k] / 4.0
    return (FAIRNESS * surface.mesh.size) ** 2 * total


def test_terms_are_the_bends_of_the_second_fundamental_form():
    surface = sheet(lambda x, y: 0.05 * x**2 - 0.03 * x * y + 0.3 * np.sin(0.5 * y))
    assert energy(bend_terms(surface, FAIRNESS), surface) == pytest.approx(
        of_the_second_form(surface, 0.05), rel=1e-9
    )


def test_what_moves_along_a_plane_costs_nothing():
    surface = sheet(lambda x, y: 0.4 * x + 0.2 * y, moved=0.1)
    terms = bend_terms(surface, FAIRNESS)
    assert len(terms) == 2 * 4 * surface.cell_count
    assert energy(terms, surface) < 1e-24


def test_places_beside_irregular_points_are_looked_at():
    surface = sample_surface("coaster")
    assert len(bend_terms(surface, FAIRNESS)) > 0.9 * 8 * surface.cell_count
    assert bend_terms(surface, 0.0) == []


def test_changes_are_those_of_the_second_fundamental_form():
    # Of a shallow surface, whose normals turn little from place to place: bends are second
    # derivatives in plan there.
    surface = sheet(lambda x, y: 1e-4 * (x**3 - 2.0 * x * y**2 + 30.0 * np.sin(0.5 * y)))
    at = np.array([(u, v) for u in (0.25, 0.75) for v in (0.25, 0.75)])
    cells, uv = np.repeat(np.arange(surface.cell_count), 4), np.tile(at, (surface.cell_count, 1))
    _, by_u, _, along, _, across = surface.evaluate(cells, uv, 2)
    side, total = np.linalg.norm(by_u[0, :2]), 0.0
    for bends in (along[:, 2] / side**2, across[:, 2] / side**2):
        (a, b), (c, d) = bends.reshape(-1, 2, 2).transpose(1, 2, 0)
        for change in (a - c, b - d, a - b, c - d):
            total += np.sum((change / (0.5 * side)) ** 2) * side**2 / 4.0
    wanted = (FAIRNESS * surface.mesh.size**2) ** 2 * total
    assert energy(bend_terms(surface, 0.0, FAIRNESS), surface) == pytest.approx(wanted, rel=1e-2)


def test_changes_keep_what_moves_along_a_plane():
    surface = sheet(lambda x, y: 0.4 * x + 0.2 * y, moved=0.1)
    terms = bend_terms(surface, 0.0, FAIRNESS)
    assert len(terms) == 2 * 4 * surface.cell_count
    assert energy(terms, surface) < 1e-20
