# SPDX-License-Identifier: GPL-3.0-or-later
"""Weights with which a member of a family has wanted numbers: boxes, which have closed forms."""

import bpy
import numpy as np
import pytest
from addon_under_test import DEPTH, HALF_BREADTH, LENGTH, mesh_points, part, state_of
from expect_morph import assert_is_member, boxes, morph_of, set_weight
from test_targets import SINGLE, add, report_of

pytestmark = pytest.mark.once


@pytest.fixture(autouse=True)
def nothing_left():
    yield
    part("features.conversion.conversions").stop()


def family():
    made = morph_of(*boxes((1.0, 1.0, 1.0), (2.0, 1.5, 1.0)))
    made.hull.draft = 1.25
    bpy.context.view_layer.update()
    return made


def test_a_wanted_displacement():
    made = family()
    t = 0.8  # of the second: L (1 + t) · B (1 + t / 2)
    volume = LENGTH * (1 + t) * 2.0 * HALF_BREADTH * (1 + 0.5 * t) * 1.25
    add(made, "VOLUME", volume)
    assert bpy.ops.hull.find_weights() == {"FINISHED"}
    assert made.hull.morph.parents[1].weight == pytest.approx(t, abs=1e-6)
    assert made.hull.draft == 1.25 and not made.hull.morph.follows_particulars
    values = state_of(made).hydrostatics.values
    assert values.displaced_volume == pytest.approx(volume, rel=SINGLE)
    report = report_of(made)
    assert report.is_met and report.rows[0].reached == pytest.approx(volume, rel=1e-7)
    assert_is_member(made)


def test_the_member_is_known_after_it_was_renamed_meanwhile():
    made = family()
    add(made, "VOLUME", LENGTH * 1.8 * 2.0 * HALF_BREADTH * 1.4 * 1.25)
    task = part("features.morphing.wanted").Finding(made, bpy.context.scene)
    made.name = "renamed"
    task.write(bpy.context.scene)
    assert made.hull.morph.parents[1].weight == pytest.approx(0.8, abs=1e-6)


def test_beyond_the_parents_and_further_than_that():
    made = family()
    row = add(made, "VOLUME", LENGTH * 2.2 * 2.0 * HALF_BREADTH * 1.6 * 1.25)
    assert bpy.ops.hull.find_weights() == {"FINISHED"}
    assert made.hull.morph.parents[1].weight == pytest.approx(1.2, abs=1e-6)
    before, points = made.hull.draft, mesh_points(made).tobytes()
    row.value = LENGTH * 4.5 * 2.0 * HALF_BREADTH * 2.75 * 1.25
    with pytest.raises(RuntimeError, match="would be needed"):
        bpy.ops.hull.find_weights()
    assert mesh_points(made).tobytes() == points and made.hull.draft == before
    assert made.hull.morph.parents[1].weight == pytest.approx(1.2, abs=1e-6)
    assert_is_member(made)


def test_with_a_free_dimension_both_numbers_are_met():
    """What one weight cannot have, a factor of the beam gives."""
    made = family()
    volume = LENGTH * 1.5 * 2.0 * HALF_BREADTH * 1.3 * 1.25
    add(made, "VOLUME", volume)
    add(made, "BWL", 2.0 * HALF_BREADTH * 1.3)
    made.hull.targets.free_beam, made.hull.targets.beam_change = True, 10.0
    assert bpy.ops.hull.find_weights() == {"FINISHED"}
    morph = made.hull.morph
    weight, factors = morph.parents[1].weight, np.array(morph.factors)
    assert report_of(made).is_met
    assert weight == pytest.approx(0.5, abs=1e-5)
    assert factors == pytest.approx([1.0, 1.3 / 1.25, 1.0], abs=1e-5)
    size = np.ptp(mesh_points(made), axis=0)
    assert size == pytest.approx([LENGTH * 1.5, HALF_BREADTH * 1.3, DEPTH], rel=1e-5)
    values = state_of(made).hydrostatics.values
    assert values.displaced_volume == pytest.approx(volume, rel=2e-6)
    assert part("features.morphing.members").is_of_family(made)
    set_weight(made, 0, 0.2)  # the factor stays
    assert np.ptp(mesh_points(made)[:, 1]) == pytest.approx(HALF_BREADTH * 1.4 * factors[1])
    add(made, "LWL", LENGTH * 1.9)
    made.hull.targets.rows[0].use = made.hull.targets.rows[1].use = False
    made.hull.targets.free_beam = False
    assert bpy.ops.hull.find_weights() == {"FINISHED"}  # of the family as it is scaled
    assert morph.parents[1].weight == pytest.approx(0.9, abs=1e-5)
    assert np.array(morph.factors) == pytest.approx(factors)


def test_what_cannot_be_met_is_told():
    made = family()
    add(made, "KB", 0.5)  # of a box at this draft 0.625, whatever its weights
    assert bpy.ops.hull.find_weights() == {"FINISHED"}
    report = report_of(made)
    assert not report.is_met
    assert "Not all can be met" in part("features.targets.reports").warning(
        report, bpy.context.scene
    )
    made.hull.heel = 0.1
    with pytest.raises(RuntimeError, match="upright"):
        bpy.ops.hull.find_weights()
    made.hull.heel = 0.0
    made.data.vertices[0].co.z -= 0.5
    made.data.update()
    with pytest.raises(RuntimeError, match="no longer the family's"):
        bpy.ops.hull.find_weights()
