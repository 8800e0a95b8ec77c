# SPDX-License-Identifier: GPL-3.0-or-later
"""Recipes of shape fields do on hulls of all kinds what their names say."""

import bpy
import numpy as np
import pytest
from addon_under_test import part, state_of
from test_fields import points_of, sample

pytestmark = [pytest.mark.once, pytest.mark.one_in(2)]

HULLS = ("coaster", "naval_vessel", "container_ship", "sailing_yacht", "bulk_carrier")


def surface_of(hull):
    return state_of(hull).ship.source.new_surface()


def ends_of(surface):
    points = surface.evaluate_grid(4)[0].reshape(-1, 3)
    return points.min(axis=0), points.max(axis=0)


def breadth_at(surface, x, z):
    """Where a ray from the side meets it."""
    tree = part("bridge.native").hull_native.SurfaceTree(surface)
    hits = tree.ray_hits([(x, 1e3, z)], [(0.0, -1.0, 0.0)])
    return float(hits.points[0, 1])


def applied(name, recipe):
    """(surface before, surface after, the shaping.Applied) of a sample."""
    hull = sample(name)
    before = surface_of(hull)
    assert bpy.ops.hull.add_field_recipe(recipe=recipe) == {"FINISHED"}
    outcome = part("features.fields.shaping").apply(hull, bpy.context.scene)
    assert hull.hull.fields.active_field == 0
    return before, surface_of(hull), outcome


@pytest.mark.parametrize("name", HULLS)
@pytest.mark.parametrize("recipe, sign", [("SHARPEN", -1.0), ("FATTEN", 1.0)])
def test_the_fore_ship_becomes_finer_or_fuller(name, recipe, sign):
    before, after, outcome = applied(name, recipe)
    low, high = ends_of(before)
    x, z = low[0] + 0.85 * (high[0] - low[0]), state_draft()
    change = breadth_at(after, x, z) - breadth_at(before, x, z)
    assert sign * change > 0.01 * high[1]
    # Amidships and aft all stays.
    aft = low[0] + 0.3 * (high[0] - low[0])
    assert breadth_at(after, aft, z) == pytest.approx(breadth_at(before, aft, z), abs=1e-3)


def state_draft():
    return bpy.context.view_layer.objects.active.hull.draft


@pytest.mark.parametrize("name", HULLS)
def test_the_sheer_rises(name):
    before, after, outcome = applied(name, "SHEER")
    (_, high), (_, now) = ends_of(before), ends_of(after)
    assert 0.02 < (now[2] - high[2]) / high[2] < 0.12
    low, _ = ends_of(before)
    assert ends_of(after)[0][2] == pytest.approx(low[2], abs=1e-4)


@pytest.mark.parametrize("name", HULLS)
def test_the_bilge_moves(name):
    hull = sample(name)
    volume = state_of(hull).hydrostatics.values.displaced_volume
    bpy.ops.hull.add_field_recipe(recipe="BILGE")
    bpy.ops.hull.apply_fields()
    assert 1.0005 < state_of(hull).hydrostatics.values.displaced_volume / volume < 1.05


@pytest.mark.parametrize("name", HULLS)
def test_the_bow_flares_above_the_waterline(name):
    before, after, outcome = applied(name, "FLARE")
    low, high = ends_of(before)
    x = low[0] + 0.85 * (high[0] - low[0])
    heights = np.linspace(state_draft(), high[2], 11)
    widened = [breadth_at(after, x, z) - breadth_at(before, x, z) for z in heights]
    assert np.nanmax(widened) > 0.01 * high[1]
    assert abs(widened[0]) < 0.6 * np.nanmax(widened)


@pytest.mark.parametrize("name", ("naval_vessel", "NEW"))
def test_a_bulb_is_drawn_out(name):
    if name == "NEW":
        bpy.ops.hull.add_hull(kind="ROUND_BILGE")
        hull = bpy.context.view_layer.objects.active
    else:
        hull = sample(name)
    for _ in range(2):
        bpy.ops.hull.subdivide_exactly()
    before = surface_of(hull)
    bpy.ops.hull.add_field_recipe(recipe="BULB")
    outcome = part("features.fields.shaping").apply(hull, bpy.context.scene)
    low = ends_of(before)[0][2]
    draft = state_draft() - low
    height = low + 0.37 * draft

    def stem(surface):
        tree = part("bridge.native").hull_native.SurfaceTree(surface)
        return tree.ray_hits([(1e4, 1e-3, height)], [(-1.0, 0.0, 0.0)]).points[0, 0]

    grown = stem(surface_of(hull)) - stem(before)
    assert outcome.is_followed
    assert 0.15 * draft < grown < 0.35 * draft


@pytest.mark.parametrize("name", HULLS)
def test_a_tunnel_is_made_or_refused(name):
    hull = sample(name)
    start = points_of(hull)
    try:
        bpy.ops.hull.add_field_recipe(recipe="TUNNEL")
    except RuntimeError as error:
        assert "no bottom over the propellers" in str(error)
        assert not hull.hull.fields.fields
        return
    bpy.ops.hull.apply_fields()
    raised = (points_of(hull) - start)[:, 2]
    assert raised.max() > 0.0 and np.argmax(raised) in np.flatnonzero(
        start[:, 0] < np.median(start[:, 0])
    )
