# SPDX-License-Identifier: GPL-3.0-or-later
"""New hulls after type ships: to their dimensions and to a wanted form, valid, flat and fair.

HULL_LONG_TYPES=1 tries 100 sets of dimensions of each type, not four.
"""

import os

import bpy
import numpy as np
import pytest
from addon_under_test import hull_io, mesh_points, part, state_of

pytestmark = pytest.mark.once

KINDS = ("COASTER", "CONTAINER_SHIP", "BULK_CARRIER", "RORO", "RESEARCH_VESSEL", "NAVAL_VESSEL")
COUNT = 100 if os.environ.get("HULL_LONG_TYPES") == "1" else 4
SEED = 24
# Points are kept in single precision.
SINGLE = 2e-6


def type_ships():
    return part("features.transformation.type_ships")


def add(kind, **asked):
    assert bpy.ops.hull.add_hull(kind=kind, **asked) == {"FINISHED"}
    return bpy.context.object


def numbers(hull):
    return part("features.transformation.form_parameters").of_hull(hull, bpy.context.scene)


def extent(hull):
    """Of the surface: low and high ends."""
    (points,) = state_of(hull).ship.surface.evaluate_grid(8)
    points = points.reshape(-1, 3)
    return points.min(axis=0), points.max(axis=0)


def furthest_off_flats(hull):
    """Of the hull's size, over all points of its flats."""
    points, size = mesh_points(hull), np.ptp(mesh_points(hull), axis=0).max()
    planes = part("features.constraints.flats").flat_planes(hull)
    off = [np.abs(points[index] @ plane[:3] - plane[3]).max() for index, plane in planes]
    return max(off, default=0.0) / size


@pytest.mark.parametrize("kind", KINDS)
def test_left_alone_it_is_the_type_ship(kind):
    hull = add(kind)
    wanted = hull_io().read_hull(part("features.hull.samples").sample_files()[kind.lower()])
    np.testing.assert_allclose(mesh_points(hull), wanted.points, rtol=SINGLE, atol=1e-5)
    assert hull.name.startswith(hull_io("new_hulls.type_ships").TYPE_SHIPS[kind].name)
    assert len(hull.hull.flats) == len(wanted.flats)
    ship, form = type_ships().usual(kind)
    found, parallel = numbers(hull)
    assert found.block == pytest.approx(form.block, abs=1e-5)
    assert parallel == pytest.approx(form.parallel, abs=1e-4 * ship.length_pp)


def cases(kind):
    ship, form = type_ships().usual(kind)
    random = np.random.default_rng(SEED)
    for _ in range(COUNT):
        length, beam, draft, depth = np.exp(random.uniform(-0.3, 0.3, 4))
        yield {
            "length": ship.length_pp * length,
            "beam": ship.beam * beam,
            "draft": min(ship.draft * draft, 0.9 * ship.depth * depth),
            "depth": ship.depth * depth,
        }


@pytest.mark.parametrize("kind", KINDS)
def test_each_has_its_dimensions_and_is_valid(kind):
    ship, _ = type_ships().usual(kind)
    usual = extent(add(kind))
    for asked in cases(kind):
        hull = add(kind, **asked)
        state = state_of(hull)
        assert not state.status and not state.ship.check.problems, asked
        factors = [asked["length"] / ship.length_pp, asked["beam"] / ship.beam]
        factors.append(asked["depth"] / ship.depth)
        for here, there in zip(extent(hull), usual):
            np.testing.assert_allclose(here, there * factors, rtol=1e-5, atol=1e-4)
        assert hull.hull.draft == pytest.approx(asked["draft"], rel=SINGLE)
        assert furthest_off_flats(hull) <= 1e-6, asked
        bpy.data.objects.remove(hull)


@pytest.mark.parametrize("kind", KINDS)
def test_the_form_that_is_wanted(kind):
    ship, form = type_ships().usual(kind)
    # The bulk carrier's sections can hardly be shifted further out.
    block, percent = form.block - 0.005, form.lcb_percent + 0.1
    hull = add(kind, use_block=True, block=block, use_lcb_percent=True, lcb_percent=percent)
    found, _ = numbers(hull)
    assert found.block == pytest.approx(block, abs=SINGLE)
    assert found.lcb_percent == pytest.approx(percent, abs=1e-3)
    assert furthest_off_flats(hull) <= 1e-6
    assert not state_of(hull).ship.check.problems


@pytest.mark.parametrize("kind, share", [("COASTER", 0.8), ("BULK_CARRIER", 1.1)])
def test_the_parallel_body_that_is_wanted(kind, share):
    ship, form = type_ships().usual(kind)
    assert form.parallel > 0.05 * ship.length_pp
    before, _ = numbers(add(kind))
    wanted = share * form.parallel
    found, parallel = numbers(add(kind, use_parallel=True, parallel=wanted))
    assert parallel == pytest.approx(wanted, abs=2e-3 * ship.length_pp)
    assert found.block == pytest.approx(before.block, abs=SINGLE)
    assert found.lcb_percent == pytest.approx(before.lcb_percent, abs=1e-3)


def test_what_cannot_be_leaves_nothing():
    before = [len(bpy.data.objects), len(bpy.data.meshes)]
    with pytest.raises(RuntimeError, match="Cb can be"):
        add("COASTER", use_block=True, block=0.95)
    with pytest.raises(RuntimeError, match="Cb can be"):
        add("BULK_CARRIER", use_parallel=True, parallel=58.0)
    with pytest.raises(RuntimeError, match="no freeboard"):
        add("COASTER", draft=9.0, depth=8.0)
    with pytest.raises(RuntimeError, match="parallel middle body wanted leaves too little"):
        add("NAVAL_VESSEL", use_parallel=True, parallel=20.0)
    assert [len(bpy.data.objects), len(bpy.data.meshes)] == before


def test_lengths_are_in_the_scenes_units():
    bpy.context.scene.unit_settings.scale_length = 0.01
    hull = add("RORO", length=15000.0)
    low, high = extent(hull)
    assert hull.hull.length_pp == pytest.approx(15000.0)
    assert 150.0 < high[0] - low[0] < 165.0
