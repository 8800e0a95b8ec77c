# SPDX-License-Identifier: GPL-3.0-or-later
"""Fair Region and Fair Curvature: a dent goes, what is to stay does, and both are told."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from addon_under_test import mesh_points, part, state_of
from edited_hulls import at, edit, find, grid_hull, select

DENT = 0.052  # 4 per mille of the coaster's beam
PLACE = (67.9, 6.1, 4.9)


def dented():
    """(the coaster in edit mode with a dent selected, the surface without it, the point)."""
    bpy.ops.hull.load_sample(name="coaster")
    hull = bpy.context.view_layer.objects.active
    hull = part("bridge.objects.hull_objects").hull_of(hull)
    before = state_of(hull).ship.source.new_surface()
    edit(hull)
    point = find(hull, *PLACE)
    places = part("bridge.mesh.mesh_points").read(hull.data, [point])
    places[0, 1] -= DENT
    part("bridge.mesh.mesh_points").write(hull.data, [point], places)
    part("features.hull.hull_state").follow_edit(hull, bpy.context.scene)
    select(hull, "vertex", [point])
    return hull, before, point


def distance(hull, surface):
    native = part("bridge.native").require()
    points = state_of(hull).ship.surface.tessellate(6).points
    return float(
        np.sqrt((native.SurfaceTree(surface).closest_points(points).distances ** 2).mean())
    )


def coordinates(hull):
    return part("bridge.mesh.mesh_points").read(hull.data)


@pytest.mark.parametrize(
    "operator, options",
    [("fair_region", {}), ("fair_region", {"energy": "BLEND"}), ("fair_curvature", {})],
)
def test_a_dent_is_faired_out(operator, options):
    hull, before, point = dented()
    start, dent = coordinates(hull), distance(hull, before)
    assert getattr(bpy.ops.hull, operator)(deviation_mm=7.5, **options) == {"FINISHED"}
    after = coordinates(hull)
    np.testing.assert_array_equal(after[:, 0], start[:, 0])
    assert (np.flatnonzero((after != start).any(axis=1)) == [point]).all()
    assert distance(hull, before) < dent / 3.0
    fairing = part("features.fairing.region_fairing")
    report, is_current = fairing.last_report(hull)
    # Blender's points are single precision: 4 µm there.
    assert is_current and report.rms == pytest.approx(7.5e-3, rel=1e-6)
    assert report.count == 1 and not report.has_more_marks
    assert dict(fairing.rows(report))["RMS shift"] == "7.5 mm"
    bpy.ops.object.mode_set(mode="OBJECT")


def test_another_deviation_needs_no_other_preparation(monkeypatch):
    """Nor are marks of the surface as it was counted again, or those of what has not moved."""
    hull, _, _ = dented()
    fairing, marks = part("features.fairing.region_fairing"), part("features.fairing.local_marks")
    scene, start = bpy.context.scene, coordinates(hull)
    counted, count = [], marks._count

    def counting(surface, *where):
        counted.append(surface)
        return count(surface, *where)

    monkeypatch.setattr(marks, "_count", counting)
    prepared, reports = [], []
    for deviation in (1e-3, 2e-3, 0.0):
        part("bridge.mesh.mesh_points").write(hull.data, np.arange(len(start)), start)
        reports.append(fairing.fair_selected(hull, scene, fairing.Asked(deviation)))
        assert reports[-1].rms == pytest.approx(deviation, rel=1e-6)
        prepared.append(state_of(hull).of(fairing.Prepared).last[1:])
    assert prepared[0] == prepared[1] == prepared[2] and len(prepared[0]) == 2
    assert len(counted) == 3  # as it was, and as it came to lie twice
    assert reports[2].before == reports[2].after == reports[0].before
    bpy.ops.object.mode_set(mode="OBJECT")


@pytest.mark.parametrize("operator", ["fair_region", "fair_curvature"])
def test_displacement_and_lcb_are_kept(operator):
    """To what single precision of Blender's points leaves; told is what is left before that."""
    hull, _, point = dented()
    points = coordinates(hull)
    near = np.linalg.norm(points - points[point], axis=1).argsort()[:12]
    select(hull, "vertex", near.tolist())
    before = state_of(hull).hydrostatics.values
    options = {"keep_volume": True, "keep_lcb": True}
    assert getattr(bpy.ops.hull, operator)(deviation_mm=4.0, **options) == {"FINISHED"}
    after = state_of(hull).hydrostatics.values
    assert after.displaced_volume == pytest.approx(before.displaced_volume, rel=1e-6)
    assert after.lcb == pytest.approx(before.lcb, abs=1e-5)
    report, _ = part("features.fairing.region_fairing").last_report(hull)
    assert report.rms == pytest.approx(4e-3, rel=1e-6)
    assert abs(report.missed["displaced_volume"]) < 1e-9 * before.displaced_volume
    assert abs(report.missed["lcb"]) < 1e-8
    hull.hull.heel = 0.1
    with pytest.raises(RuntimeError, match="set the heel to zero"):
        bpy.ops.hull.fair_region(**options)
    bpy.ops.object.mode_set(mode="OBJECT")


def test_the_deviation_is_found_by_marks(monkeypatch):
    """The middle of the deviations with the fewest marks, told by a count that is made up; and of a
    sheet with a dent by those that are seen."""
    marks_out = part("features.fairing.marks_out")

    def solution(deviation):
        return SimpleNamespace(moves=deviation, rms=deviation, bound="deviation")

    def count(deviation):
        return 3 if 2.0 < deviation < 5.0 else 9

    told = []
    found = marks_out.best(solution, count, 20.0, told.append)
    assert found.moves == pytest.approx(3.5, rel=0.1) and sorted(told) == told
    with pytest.raises(ValueError, match="9 marks seen around the points none goes"):
        marks_out.best(solution, count, 1e-3, told.append)
    with pytest.raises(ValueError, match="No mark is seen"):
        marks_out.best(solution, lambda deviation: 0, 1.0, told.append)

    # Each count of the sheet takes some tenths of a second: few are made here.
    monkeypatch.setattr(marks_out, "_STEPS", 2)
    monkeypatch.setattr(marks_out, "_HALVINGS", 0)
    hull = grid_hull(9, 7)
    start = coordinates(hull)
    dent = at(4, 3, 7)
    edit(hull)
    write = part("bridge.mesh.mesh_points").write
    write(hull.data, [dent], [start[dent] - (0.0, 0.2, 0.0)])
    part("features.hull.hull_state").follow_edit(hull, bpy.context.scene)
    select(hull, "vertex", [dent])
    options = {"energy": "LENGTHWISE", "by_marks": True}
    assert bpy.ops.hull.fair_curvature(deviation_mm=100.0, **options) == {"FINISHED"}
    assert np.abs(coordinates(hull) - start).max() < 0.2 / 3.0
    bpy.ops.object.mode_set(mode="OBJECT")


def test_what_cannot_be_is_refused_and_moves_nothing():
    hull, _, point = dented()
    start = coordinates(hull)
    fairing = part("features.fairing.region_fairing")

    def refused(words, **options):
        with pytest.raises(ValueError, match=words):
            asked = fairing.Asked(**{"deviation": 0.01, **options})
            fairing.fair_selected(hull, bpy.context.scene, asked)
        np.testing.assert_array_equal(coordinates(hull), start)

    refused("Deviation", deviation=float("nan"))
    refused("Deviation", deviation=-1.0)
    refused("Largest", largest=-1.0)
    bpy.ops.hull.lock_points()
    refused("None of the chosen points may move")
    bpy.ops.hull.unlock_points()
    bpy.ops.mesh.select_all(action="DESELECT")
    refused("Select the control points")
    bpy.ops.object.mode_set(mode="OBJECT")
    assert not bpy.ops.hull.fair_region.poll()
    assert len(mesh_points(hull)) == len(start) and point < len(start)
