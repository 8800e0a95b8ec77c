# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape fields in plain Python, alone and brought into hulls."""

from pathlib import Path

import hull_native as hn
import numpy as np
import pytest
from vessels import surface_of_sample

ROOT = Path(__file__).resolve().parents[2]
SEED = 20261124


def fields_on(surface):
    """A bulge in the side, and all creases protected."""
    low, high = surface.mesh.points.min(axis=0), surface.mesh.points.max(axis=0)
    size = high - low
    centre = low + size * [0.6, 1.0, 0.5]
    fields = [hn.ShapeField.at_point(centre, (0, 0.05 * size[1], 0), extent=0.3 * size[0])]
    for crease in hn.crease_curves(surface):
        if crease.kind == "crease":
            curve = hn.FieldCurve.of_crease(crease)
            fields.append(
                hn.ShapeField.along(curve, extent=0.1 * size[0], falloff=0.7, protects=True)
            )
    return fields


@pytest.mark.parametrize("name", ["coaster", "naval_vessel", "sailing_yacht"])
def test_gradients_are_those_of_differences(name):
    surface = surface_of_sample(name)
    fields = hn.ShapeFields(fields_on(surface), mirrored=True)
    random = np.random.default_rng([SEED, len(name)])
    points = hn.Reshape(surface).positions
    points = points[random.choice(len(points), 400, replace=False)]
    size = np.ptp(surface.mesh.points, axis=0).max()
    shifts, gradients = fields.at(points)
    assert np.abs(shifts).max() > 1e-3 * size * 0.05
    step = 1e-6 * size
    away = np.ones(len(points), dtype=bool)
    found = np.empty_like(gradients)
    for axis, unit in enumerate(np.eye(3)):
        near, far = (
            (fields.at(points + k * step * unit)[0] - fields.at(points - k * step * unit)[0])
            / (2 * k * step)
            for k in (1, 2)
        )
        found[:, :, axis] = near
        # Where the closest point jumps, between two creases, there is no gradient.
        away &= np.abs(near - far).max(axis=1) < 1e-8
    assert away.mean() > 0.9
    np.testing.assert_allclose(gradients[away], found[away], atol=1e-7)


@pytest.mark.parametrize("name", ["coaster", "naval_vessel", "sailing_yacht"])
def test_protected_creases_stay_and_what_is_far_does(name):
    surface = surface_of_sample(name)
    fields = hn.ShapeFields(fields_on(surface), mirrored=True)
    size = np.ptp(surface.mesh.points, axis=0).max()
    for crease in hn.crease_curves(surface):
        if crease.kind != "crease":
            continue
        (points,) = crease.evaluate(np.linspace(0, crease.edge_count, 40))
        # The distance from the base is rounded, and the intensity left there goes by its square.
        assert np.abs(fields.at(points)[0]).max() < 1e-20 * size
    places = hn.Reshape(surface).positions
    far = fields.deltas(0, places) >= 1
    assert far.any()
    assert not fields.at(places)[0][far].any()


def test_the_hull_follows_the_field():
    surface = surface_of_sample("coaster")
    fields = hn.ShapeFields(fields_on(surface)[:1], mirrored=True)
    largest = []
    for _ in range(2):
        reshape = hn.Reshape(surface)
        shifts, gradients = fields.at(reshape.positions)
        assert (np.linalg.det(np.eye(3) + gradients) > 0).all()
        result = reshape.solve(shifts)
        assert result.folded_place is None
        largest.append(result.rms)
        surface = hn.LimitSurface(surface.refined_mesh(), surface.scheme)
    assert largest[1] < largest[0] / 3  # the same field on the mesh subdivided once


def test_a_curve_becomes_another():
    stem = [(10, 0, z) for z in (8.0, 6.0, 4.0, 2.0, 0.0)]
    bulb = [(10 + 2 * np.sin(np.pi * (6 - z) / 6) ** 2 * (z < 6), 0, z) for _, _, z in stem]
    curve, other = hn.FieldCurve(stem), hn.FieldCurve(bulb)
    fields = hn.ShapeFields([hn.ShapeField.to_curve(curve, other, extent=5)], mirrored=True)
    points = curve.points_at(np.linspace(0, curve.length, 50))
    shifts, _ = fields.at(points)
    assert other.distances(points + shifts).max() < 1e-12


def test_quantities_vary_along_a_curve():
    curve = hn.FieldCurve([(0, 5, 0), (10, 5, 0)])
    field = hn.ShapeField.along(
        curve,
        ([0, 5, 10], [(0, 1, 0), (0, 2, 0), (0, 1, 0)]),
        extent=([0, 10], [4, 2]),
        falloff=0.6,
    )
    shifts, _ = hn.ShapeFields([field]).at([(0, 5, 0), (5, 5, 0), (10, 5, 0), (10, 5, 2.5)])
    np.testing.assert_allclose(shifts[:, 1], [1, 2, 1, 0], atol=1e-14)


def test_remembered_places_get_the_same_shifts():
    surface = surface_of_sample("coaster")
    points = hn.Reshape(surface).positions
    places = hn.FieldPlaces(points)
    for falloff in (0.3, 0.8):
        curve = hn.FieldCurve([(60, 6, 7), (70, 6, 7), (80, 2, 7)])  # another object, the same base
        field = hn.ShapeField.along(curve, (0, 0.3, 0.1), extent=9, falloff=falloff)
        fields = hn.ShapeFields([field], mirrored=True)
        for found, wanted in zip(fields.at(places), fields.at(points)):
            np.testing.assert_array_equal(found, wanted)
        assert np.abs(fields.at(places)[0]).max() > 0.1


def test_what_is_wrong_is_said():
    at = hn.ShapeField.at_point
    with pytest.raises(ValueError, match="Field 0: the extent must be positive"):
        hn.ShapeFields([at((0, 0, 0), extent=-1)])
    with pytest.raises(ValueError, match="falloff must be from 0 to 1"):
        hn.ShapeFields([at((0, 0, 0), extent=1, falloff=2)])
    with pytest.raises(ValueError, match="letters x, y and z"):
        at((0, 0, 0), extent=1, axes="xw")
    with pytest.raises(ValueError, match="blend is"):
        hn.ShapeFields([], blend="both")
    with pytest.raises(ValueError, match="two points"):
        hn.FieldCurve([(0, 0, 0)])
    with pytest.raises(ValueError, match="There is no field 1"):
        hn.ShapeFields([at((0, 0, 0), extent=1)]).deltas(1, [(0, 0, 0)])
    with pytest.raises(ValueError, match="constant, or a tuple"):
        at((0, 0, 0), extent=(1, 2, 3))
    for numbers in ({"extent": []}, {"extent": 1, "falloff": []}, {"extent": np.zeros((0, 2))}):
        with pytest.raises(ValueError, match="(extent|falloff) must be one number"):
            at((0, 0, 0), **numbers)


def near_side(surface, random, count=300, off=0.5):
    """Points about the surface."""
    cells = random.integers(0, surface.cell_count, count)
    return surface.evaluate(cells, random.random((count, 2)))[0] + off * random.normal(
        size=(count, 3)
    )


def test_all_of_a_region_is_base():
    surface = surface_of_sample("coaster")
    cells = np.arange(5, 9)
    shift, extent = (0.1, 0.3, -0.2), 6.0
    field = hn.ShapeField.of_region(surface, cells, shift, extent=extent, falloff=0.6)
    random = np.random.default_rng(SEED)
    uv = random.random((len(cells), 2))
    own = surface.evaluate(cells, uv)[0]
    fields = hn.ShapeFields([field])
    shifts, gradients = fields.at(own)
    np.testing.assert_array_equal(shifts, np.tile(shift, (len(cells), 1)))
    assert not gradients.any()
    # By distances from very many points of the region, which are never smaller.
    u = np.linspace(0.0, 1.0, 41)
    grid = np.stack(np.meshgrid(u, u), axis=-1).reshape(-1, 2)
    every = surface.evaluate(np.repeat(cells, len(grid)), np.tile(grid, (len(cells), 1)))[0]
    points = near_side(surface, random)
    deltas = fields.deltas(0, points)
    least = np.linalg.norm(points[:, None] - every, axis=2).min(axis=1) / extent
    assert (deltas <= least * (1.0 + 1e-12)).all() and (least - deltas).max() < 0.02
    # delta² (2 - delta) in place of delta, by a point at that distance.
    point = hn.ShapeFields([hn.ShapeField.at_point((0, 0, 0), shift, extent=1.0, falloff=0.6)])
    flat = np.where(deltas < 1.0, deltas**2 * (2.0 - deltas), 1.0)
    of_point = point.at(np.column_stack([flat, 0 * flat, 0 * flat]))[0]
    np.testing.assert_allclose(fields.at(points)[0], of_point, atol=1e-15)
    assert (deltas < 1.0).sum() > 10 and (deltas > 1.0).sum() > 10


def test_gradients_of_regions_are_those_of_differences():
    surface = surface_of_sample("coaster")
    field = hn.ShapeField.of_region(surface, np.arange(5, 9), (0, 0.3, 0.1), extent=6)
    fields = hn.ShapeFields([field], mirrored=True)
    points = near_side(surface, np.random.default_rng(SEED))
    gradients, step = fields.at(points)[1], 1e-6
    ways = [(fields.at(points + step * e)[0] - fields.at(points - step * e)[0]) for e in np.eye(3)]
    np.testing.assert_allclose(gradients, np.stack(ways, axis=2) / (2.0 * step), atol=1e-8)
    assert (np.abs(gradients).max(axis=(1, 2)) > 0.0).sum() > 10


def test_no_curvature_jumps_at_the_rim_of_a_region():
    """Second differences on a line that leaves a flat region: they shrink with the step there."""
    mesh = hn.ControlMesh(
        [(x, y, 0.0) for x in range(7) for y in range(4)],
        [4] * 18,
        [k for x in range(6) for y in range(3) for k in
         (4 * x + y, 4 * x + 4 + y, 4 * x + 5 + y, 4 * x + 1 + y)],
        [], [],
    )  # fmt: skip
    surface = hn.LimitSurface(mesh)
    middles = surface.evaluate(np.arange(surface.cell_count), np.full((surface.cell_count, 2), 0.5))
    cells = np.flatnonzero(middles[0][:, 0] < 3.0)
    fields = hn.ShapeFields([hn.ShapeField.of_region(surface, cells, (0, 0, 1), extent=2)])
    for step in (1e-2, 1e-3):
        line = np.column_stack([3.0 + step * np.arange(-1, 2), [1.5] * 3, [0.0] * 3])
        z = fields.at(line)[0][:, 2]
        assert abs(z[0] - 2.0 * z[1] + z[2]) / step**2 < 20.0 * step**2


def test_remembered_regions_are_known_again():
    surface = surface_of_sample("coaster")
    places = hn.FieldPlaces(hn.SurfacePlaces(surface).positions)
    for points in (surface.mesh.points, surface.mesh.points * [1.0, 1.01, 1.0]):
        moved = hn.LimitSurface(surface.mesh.with_points(points))
        for cells in ([3, 4], [3]):
            field = hn.ShapeField.of_region(moved, cells, (0, 0.3, 0), extent=8)
            fields = hn.ShapeFields([field])
            at = fields.at(places)
            for one, other in zip(at, fields.at(hn.SurfacePlaces(surface).positions)):
                np.testing.assert_array_equal(one, other)
            assert at[0].any()


def test_a_region_does_nothing_beyond_its_extent_whatever_it_is_for():
    surface = surface_of_sample("coaster")
    points = hn.SurfacePlaces(surface).positions
    mover = hn.ShapeField.at_point((60, 5, 3), (0, 0.3, 0), extent=25)
    alone = hn.ShapeFields([mover], mirrored=True).at(points)
    for extent in (0.5, 2.0):
        kept = hn.ShapeField.of_region(surface, [5], extent=extent, protects=True)
        fields = hn.ShapeFields([mover, kept], mirrored=True)
        image = points * [1.0, -1.0, 1.0]
        beyond = np.minimum(fields.deltas(1, points), fields.deltas(1, image)) > 1.0
        assert 0.5 < beyond.mean() < 1.0
        shifts, gradients = fields.at(points)
        np.testing.assert_array_equal(shifts[beyond], alone[0][beyond])
        np.testing.assert_array_equal(gradients[beyond], alone[1][beyond])
        assert np.isfinite(gradients).all()


def test_remembered_regions_grow_and_shrink():
    surface = surface_of_sample("coaster")
    points = hn.SurfacePlaces(surface).positions
    places = hn.FieldPlaces(points)
    for extent in (2.0, 2.5, 8.0, 1.0, 30.0):
        field = hn.ShapeField.of_region(surface, [3, 4], (0, 0.3, 0), extent=extent)
        fields = hn.ShapeFields([field], mirrored=True)
        for one, other in zip(fields.at(places), fields.at(points)):
            np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize(
    "cells, message", [([], "one cell at least"), ([9999], "cell 9999 is none"), ([-1], "cell -1")]
)
def test_regions_that_are_none_are_refused(cells, message):
    with pytest.raises(ValueError, match=message):
        hn.ShapeField.of_region(surface_of_sample("coaster"), cells, extent=1)
    with pytest.raises(ValueError, match=message):
        hn.SurfaceTree(surface_of_sample("coaster"), cells=cells)
