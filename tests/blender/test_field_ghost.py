# SPDX-License-Identifier: GPL-3.0-or-later
"""While shape fields are previewed the hull as it was is seen behind it, and told beside it."""

import bpy
import numpy as np
import pytest
from addon_under_test import part, state_of
from test_field_preview import changed, shown
from test_fields import add, points_of, sample, side_point


def before_of(hull):
    return part("features.fields.before").of_hull(hull)


def polylines(groups):
    return {kind: [line.tolist() for line in groups[kind].polylines] for kind in groups}


def previewed():
    hull = sample()
    own = polylines(state_of(hull).lines.groups)
    own.pop("flat", None)
    field = add(hull, side_point(hull), extent=20.0, shift=(0.0, 0.3, 0.0))
    changed()
    assert before_of(hull).lines.groups == {}
    bpy.ops.hull.preview_fields()
    changed()
    return hull, field, own


def test_the_ghost_has_the_lines_of_before():
    hull, field, own = previewed()
    assert own["station"]
    assert polylines(before_of(hull).lines.groups) == own
    assert polylines(state_of(hull).lines.groups)["station"] != own["station"]
    groups = before_of(hull).lines.groups
    field.shift = (0.0, 0.4, 0.0)
    changed()
    assert before_of(hull).lines.groups is groups  # nothing is computed anew
    hull.hull.lines.show_stations = False
    changed()
    assert "station" not in before_of(hull).lines.groups
    hull.hull.fields.show_before = False
    changed()
    assert before_of(hull).lines.groups == {}


@pytest.mark.parametrize("end", ["apply_fields", "cancel_fields"])
def test_it_goes_with_the_preview(end):
    hull, field, _ = previewed()
    assert before_of(hull).lines.groups
    getattr(bpy.ops.hull, end)()
    changed()
    assert before_of(hull).lines.groups == {} and before_of(hull).values is None


def test_numbers_and_sectional_areas_are_compared():
    hull = sample()
    was = state_of(hull).hydrostatics.values
    hull.hull.plots.sectional_areas = True
    field = add(hull, side_point(hull), extent=20.0, shift=(0.0, 0.3, 0.0))
    bpy.ops.hull.preview_fields()
    changed()
    known, now = before_of(hull), state_of(hull).hydrostatics.values
    assert known.values.displacement_t == pytest.approx(was.displacement_t, rel=1e-7)
    (name, change), (_, moved) = part("features.fields.before").changes(hull)
    gain = 100.0 * (now.displacement_t / was.displacement_t - 1.0)
    assert gain > 0.05 and name == "Displacement by" and change == f"{gain:+.2f} %"
    assert moved == f"{1e3 * (now.lcb - was.lcb):+.0f} mm"
    beside = part("features.curves_of_form.beside").Beside
    (curve,) = state_of(hull).of(beside).of("sectional_areas")
    volume = np.trapz(curve.y, curve.x)
    assert curve.colour == part("bridge.blender.preferences").colour("ghost", "ghost")
    assert curve.name == "Before" and volume == pytest.approx(was.displaced_volume, rel=2e-3)
    hull.hull.draft *= 0.9
    changed()
    assert before_of(hull).values.displacement_t < 0.95 * was.displacement_t
    field.use = False
    bpy.ops.hull.cancel_fields()
    changed()
    assert state_of(hull).of(beside).of("sectional_areas") == ()
    assert part("features.fields.before").changes(hull) == []


def test_it_has_the_appendages_and_openings_of_the_hull():
    """So that what is told to change is the fields' alone."""
    hull = sample()
    bpy.ops.hull.add_appendage(kind="FIN_KEEL")
    changed()
    bpy.context.view_layer.objects.active = hull
    bare = state_of(hull).ship.source.alone
    was = state_of(hull).hydrostatics.values
    without = bare.new_ship().hydrostatics(part("features.flotation.afloat").afloat(hull.hull, 1.0))
    assert abs(was.displaced_volume - without.displaced_volume) > 1e-4 * was.displaced_volume
    add(hull, side_point(hull), extent=20.0, shift=(0.0, 0.3, 0.0))
    bpy.ops.hull.preview_fields()
    changed()
    known = before_of(hull)
    assert known.values.displaced_volume == pytest.approx(was.displaced_volume, rel=1e-7)
    hull.hull.deck_closed = not hull.hull.deck_closed
    changed()
    assert known._ship.body.openings == state_of(hull).ship.body.openings
    bpy.ops.hull.cancel_fields()


def test_of_a_finer_start_it_is_the_same_hull():
    hull, field, own = previewed()
    bpy.ops.hull.subdivide_for_fields()
    changed()
    groups = before_of(hull).lines.groups
    for now, was in zip(polylines(groups)["station"], own["station"]):
        assert np.allclose(np.max(now, axis=0), np.max(was, axis=0), atol=2e-3)
    assert points_of(hull).shape[0] > 0 and shown(hull).problem == ""


def test_a_row_is_inserted_where_it_is_too_coarse():
    hull = sample()
    before, place = points_of(hull), side_point(hull)
    add(hull, place, extent=8.0, shift=(0.0, 0.5, 0.0))
    bpy.ops.hull.preview_fields()
    coarse = shown(hull).applied.result
    assert not shown(hull).applied.is_followed
    assert bpy.ops.hull.insert_row_for_fields() == {"FINISHED"}
    assert hull.hull.fields.is_previewed and shown(hull).problem == ""
    added = len(points_of(hull)) - len(before)
    assert 3 < added < 0.5 * len(before)
    assert shown(hull).applied.result.largest < coarse.largest
    bpy.ops.hull.cancel_fields()
    # The surface of before is nearly the same.
    assert len(points_of(hull)) == len(before) + added
    assert not bpy.ops.hull.insert_row_for_fields.poll()
