# SPDX-License-Identifier: GPL-3.0-or-later
"""Levers of marks: how depths change with curvatures, and bends of lines with control points; sums
that are wished for. Against finite differences."""

import hull_native as hn
import numpy as np
import pytest
from hull_fairness import levers, lines
from hull_fairness.inflections import marks
from transformation_hulls import Sample

LENGTHS = np.linspace(0.0, 40.0, 1201)
# Bent to one side with a flat spot; to both sides.
CURVES = {
    "dip": 0.02 * np.sin(np.pi * LENGTHS / 40.0) - 0.012 * np.exp(-(((LENGTHS - 17.0) / 5.0) ** 2)),
    "inflection": 0.02 * np.cos(LENGTHS / 9.0) + 0.004,
}


def only(kind, curvatures):
    found = [mark for mark in marks(LENGTHS, curvatures, 1e-3) if mark.kind == kind]
    assert len(found) == 1
    return found[0]


@pytest.mark.parametrize("kind", CURVES)
def test_a_lever_tells_how_the_depth_changes(kind):
    curvatures = CURVES[kind]
    mark = only(kind, curvatures)
    own = slice(mark.lever.first, mark.lever.first + len(mark.lever.factors))
    assert mark.lever.unseen == pytest.approx(max(1e-3, np.ptp(LENGTHS[own]) / 2000.0))
    assert mark.lever.factors @ curvatures[own] == pytest.approx(mark.lever.depth, rel=1e-3)
    change = np.sin(LENGTHS / 5.0 + 0.3) * np.abs(curvatures)
    step = 1e-4
    more, less = (only(kind, curvatures + sign * step * change).lever.depth for sign in (1, -1))
    found = (more - less) / (2.0 * step)
    assert mark.lever.factors @ change[own] == pytest.approx(found, rel=2e-2)


@pytest.fixture(scope="module")
def coaster():
    return Sample("coaster")


def bends(surface, cells, uv, parts, is_cut, out):
    """out · second derivatives (n, 3) along fixed parts (n, 2) of both parameters, without what
    slides along the surface or, where the line goes with it, along the line."""
    _, xu, xv, xuu, xuv, xvv = surface.evaluate(cells, uv, 2)
    a, b = parts.T[:, :, None]
    first, second = a * xu + b * xv, a * a * xuu + 2.0 * a * b * xuv + b * b * xvv
    if is_cut:
        out = np.cross(xu, xv)
        out /= np.linalg.norm(out, axis=1)[:, None]
        return np.sum(out * second, axis=1)
    slides = np.sum(second * first, axis=1) / np.sum(first * first, axis=1)
    return np.sum(out * (second - slides[:, None] * first), axis=1)


@pytest.mark.parametrize("is_cut", [True, False])
def test_bend_sums_agree_with_differences(coaster, is_cut):
    surface, points = coaster.surface, coaster.surface.mesh.points
    rng = np.random.default_rng(5)
    cells = rng.integers(0, surface.cell_count, 60)
    uv = rng.uniform(0.2, 0.8, (60, 2))
    _, xu, xv = surface.evaluate(cells, uv, 1)
    parts = rng.normal(size=(60, 2))
    first = parts[:, :1] * xu + parts[:, 1:] * xv
    sizes = np.linalg.norm(first, axis=1)[:, None]
    parts, along = parts / sizes, first / sizes
    normals = np.cross(xu, xv)
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    out = normals if is_cut else np.cross(along, rng.normal(size=(60, 3)))
    factors = rng.normal(size=60)
    at, slopes = hn.BendSums(surface).sum(
        points, cells, uv, along, factors[:, None] * out, is_cut=is_cut
    )
    moves, step = rng.normal(size=points.shape), 1e-5
    more, less = (
        factors
        @ bends(
            hn.LimitSurface(surface.mesh.with_points(points + sign * step * moves)),
            cells,
            uv,
            parts,
            is_cut,
            out,
        )
        for sign in (1, -1)
    )
    found = (more - less) / (2.0 * step)
    assert np.sum(slopes * moves[at]) == pytest.approx(found, rel=1e-6)


def test_a_dent_goes_by_its_lever(coaster):
    """A dent makes an inflection of a waterline; moves by the lever make it as deep as wished."""
    points = coaster.mesh.points.copy()
    points[62, 1] -= 8e-3 * coaster.ship.beam
    surface = hn.LimitSurface(coaster.mesh.with_points(points))
    place = np.array([coaster.mesh.points[62]])
    beam = coaster.ship.beam

    def deepest(changed):
        parts = next(lines.found_through(changed, beam, "waterline", place))
        near = [
            one for part in parts for one in part if np.linalg.norm(one.point - place[0]) < 10.0
        ]
        return max((one.lever for one in near), key=lambda lever: lever.depth / lever.unseen)

    lever = deepest(surface)
    tree, sums = hn.SurfaceTree(surface), hn.BendSums(surface)
    at, slopes = levers.slopes(sums, surface, tree, lever)
    wanted = 0.9 * lever.depth
    region = hn.FairRegion(
        surface,
        np.arange(len(points)),
        before=points,
        least_bend=1e-3,
        wished=[(at, slopes)],
        wished_values=[wanted - lever.depth],
        wished_weights=[1e6],
    )
    moves = region.solve(1.0).moves
    assert np.sum(slopes * moves[at]) == pytest.approx(wanted - lever.depth, rel=1e-6)
    found = deepest(hn.LimitSurface(coaster.mesh.with_points(points + moves)))
    # To first order, and the line goes through another place of the surface then.
    assert found.depth == pytest.approx(wanted, abs=0.02 * lever.depth)


@pytest.mark.parametrize(
    "how, message",
    [
        ({"energy": "curvature"}, "quadratic energies alone"),
        ({"wished_values": []}, "a value and a weight"),
        ({"wished_weights": [-1.0]}, "not below zero"),
        ({"wished_values": [np.inf]}, "must be finite"),
        ({"wished": [([62, 63], [(0.0, 1.0, 0.0)])]}, "2 points, but 1 slopes"),
    ],
)
def test_wishes_are_checked(coaster, how, message):
    given = {
        "wished": [([62], [(0.0, 1.0, 0.0)])],
        "wished_values": [0.1],
        "wished_weights": [1.0],
        **how,
    }
    with pytest.raises(ValueError, match=message):
        hn.FairRegion(coaster.surface, [62], **given)


@pytest.mark.parametrize(
    "how, message",
    [
        ({"points": [(0.0, 0.0, 0.0)]}, "control points"),
        ({"cells": [10**6]}, "no cell"),
        ({"along": np.zeros((2, 3))}, "equal length"),
    ],
)
def test_places_of_bends_are_checked(coaster, how, message):
    given = {
        "points": coaster.mesh.points,
        "cells": [0],
        "uv": [(0.5, 0.5)],
        "along": [(1.0, 0.0, 0.0)],
        "out": [(0.0, 1.0, 0.0)],
        **how,
    }
    with pytest.raises(ValueError, match=message):
        hn.BendSums(coaster.surface).sum(**given)
