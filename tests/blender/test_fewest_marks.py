# SPDX-License-Identifier: GPL-3.0-or-later
"""Displacement and LCB in the way with the fewest new marks: met, told, one step of undo, and the
marks of the form before need not be looked for again."""

import bpy
import numpy as np
import pytest
from addon_under_test import part, sample, values

pytestmark = pytest.mark.once

# Points are kept in single precision.
SINGLE = 1e-6


def points_of(hull):
    return part("bridge.mesh.mesh_points").read(hull.data)


def change(hull, **more):
    """Asks for Cb and LCB besides, and returns the task's words and whether they warn."""
    found = values(hull)
    fewest_marks = part("features.transformation.fewest_marks")
    block = found.project_block + more.get("block", 0.0)
    lcb = found.lcb + more.get("lcb", 0.0)
    asked = fewest_marks.Asked({"block": block}, lcb, 5e-3)
    task = fewest_marks.FewestMarks(hull, bpy.context.scene, asked)
    return fewest_marks.summary(task.write(bpy.context.scene), bpy.context.scene)


def test_shifts_are_taken_where_they_make_no_mark():
    hull = sample("catamaran")
    before, start = values(hull), points_of(hull)
    lcb = before.lcb_percent + 1.0
    assert bpy.ops.hull.fewest_marks(
        measure="BLOCK", block=before.project_block, lcb_as="PERCENT", lcb_percent=lcb
    ) == {"FINISHED"}
    assert values(hull).project_block == pytest.approx(before.project_block, abs=SINGLE)
    assert values(hull).lcb_percent == pytest.approx(lcb, abs=100.0 * SINGLE)
    moved = points_of(hull)
    assert np.array_equal(moved[:, 1:], start[:, 1:]) and not np.array_equal(moved, start)
    # What was found of the form before is known by then.
    form_before = part("features.hull.form_before")
    marks = form_before.MarksBefore(hull, hull.hull.beam)

    def refuse(share):
        raise AssertionError("it is looked for again")

    known, surface = marks.known(refuse).surface, form_before.of_hull(hull)
    assert np.array_equal(known.mesh.points, surface.mesh.points)


def test_the_least_change_is_taken_where_shifts_lead_nowhere():
    hull = sample("planing_boat")
    before, start = values(hull), points_of(hull)
    text, warns = change(hull, block=0.02)
    assert "by least change: " in text and text.endswith("by shifts of sections: out of reach")
    assert not warns
    assert values(hull).project_block == pytest.approx(before.project_block + 0.02, abs=SINGLE)
    assert not np.array_equal(points_of(hull)[:, 1], start[:, 1])


def test_what_no_way_reaches_is_refused_before_marks_are_counted(monkeypatch):
    sample("barge")
    fairness = part("features.transformation.fewest_marks").changes
    monkeypatch.setattr(fairness, "Known", None)
    with pytest.raises(RuntimeError, match="By shifts of sections: LCB can .* By least change: "):
        bpy.ops.hull.fewest_marks(measure="NONE", lcb_as="LENGTH", lcb=-1e6)


def test_what_no_way_reaches_is_refused_with_what_each_can():
    hull = sample("planing_boat")
    start = points_of(hull)
    with pytest.raises(RuntimeError, match="By shifts of sections: Cb can .* By least change: Not"):
        bpy.ops.hull.fewest_marks(measure="BLOCK", block=5.0, lcb_as="NONE")
    with pytest.raises(RuntimeError, match="Ask for a displacement"):
        bpy.ops.hull.fewest_marks(measure="NONE", lcb_as="NONE")
    assert np.array_equal(points_of(hull), start)
