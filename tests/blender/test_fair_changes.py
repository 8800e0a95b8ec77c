# SPDX-License-Identifier: GPL-3.0-or-later
"""Fair New Marks: what a transformation made new goes, and displacement and LCB stay."""

import bpy
import numpy as np
import pytest
from addon_under_test import part, sample, values

pytestmark = pytest.mark.once

# Points are kept in single precision.
SINGLE = 1e-6


def points_of(hull):
    return part("bridge.mesh.mesh_points").read(hull.data)


def new_marks(hull):
    assert bpy.ops.hull.count_marks(compare=True) == {"FINISHED"}
    report, _ = part("features.fairing.seen_marks").last_report(hull)
    return report.new_count


def shift_lcb(hull, percent):
    found = values(hull)
    bpy.ops.hull.shift_sections(
        measure="BLOCK",
        block=found.project_block,
        lcb_as="PERCENT",
        lcb_percent=found.lcb_percent + percent,
        part="FAIR",
    )
    return found


def test_new_marks_go_and_what_was_wanted_stays():
    hull = sample("catamaran")
    before = shift_lcb(hull, -1.0)
    shifted, wanted = points_of(hull), before.lcb - 0.01 * 30.5
    assert new_marks(hull) == 2
    assert bpy.ops.hull.fair_new_marks() == {"FINISHED"}
    assert new_marks(hull) == 0
    assert values(hull).project_block == pytest.approx(before.project_block, abs=SINGLE)
    assert values(hull).lcb == pytest.approx(wanted, abs=SINGLE * 30.5)
    moved = points_of(hull)
    assert np.array_equal(moved[:, 0], shifted[:, 0])
    assert 0.0 < np.abs(moved - shifted).max() < 5e-3 * 11.0
    # The form before is still that of before the shift.
    form = part("features.hull.form_before").of_hull(hull)
    assert np.abs(form.mesh.points[:, 0] - moved[:, 0]).max() > 0.1


def test_it_is_refused_where_nothing_is_known_of_the_form_before():
    hull = sample("roro")
    with pytest.raises(RuntimeError, match="Nothing is known of the hull's form before"):
        bpy.ops.hull.fair_new_marks()
    bpy.ops.hull.shift_sections(measure="NONE", lcb_as="PERCENT", lcb_percent=0.0, part="FAIR")
    hull.hull.heel = 0.1
    with pytest.raises(RuntimeError, match="heel"):
        bpy.ops.hull.fair_new_marks()


def test_a_hull_changed_meanwhile_stays_as_it_is():
    fair_changes = part("features.transformation.fair_changes")
    hull = sample("catamaran")
    shift_lcb(hull, -0.01)
    task = fair_changes.FairingChange(hull, bpy.context.scene, fair_changes.Asked(5e-3))
    points = points_of(hull)
    points[30, 1] += 0.1
    part("bridge.mesh.mesh_points").write(hull.data, np.arange(len(points)), points)
    points = points_of(hull)  # in single precision
    with pytest.raises(ValueError, match="changed meanwhile"):
        task.write(bpy.context.scene)
    assert np.array_equal(points_of(hull), points)
