# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls transformed from Blender: what is asked for comes, what is kept stays, refusals say why."""

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, part, sample, values

# Points are kept in single precision.
SINGLE = 3e-6


def points_of(hull):
    return part("bridge.mesh.mesh_points").read(hull.data)


def test_displacement_and_lcb_as_asked_for():
    hull = sample("coaster")
    before = points_of(hull)
    assert bpy.ops.hull.shift_sections(
        measure="BLOCK", block=0.72, lcb_as="PERCENT", lcb_percent=-0.5
    ) == {"FINISHED"}
    found = values(hull)
    assert found.project_block == pytest.approx(0.72, rel=SINGLE)
    assert found.lcb_percent == pytest.approx(-0.5, abs=1e2 * SINGLE)
    after = points_of(hull)
    assert np.array_equal(after[:, 1:], before[:, 1:])
    bpy.ops.hull.shift_sections(
        measure="DISPLACEMENT", displacement=4400.0, lcb_as="LENGTH", lcb=42.5
    )
    assert values(hull).displacement_t == pytest.approx(4400.0, rel=SINGLE)
    assert values(hull).lcb == pytest.approx(42.5, abs=84.0 * SINGLE)


@pytest.mark.parametrize("part_name", ["APART", "FORE", "AFT"])
@pytest.mark.parametrize("parallel", ["FREE", "KEEP"])
def test_parts_and_parallel_body(part_name, parallel):
    hull = sample("coaster")
    bpy.ops.hull.shift_sections(
        measure="VOLUME", volume=4350.0, lcb_as="NONE", part=part_name, parallel=parallel
    )
    assert values(hull).displaced_volume == pytest.approx(4350.0, rel=SINGLE)


def prismatics(hull):
    return part("features.transformation.section_shifts").prismatics(hull, bpy.context.scene)


def test_prismatic_coefficients_of_both_halves():
    hull = sample("coaster")
    before, points = prismatics(hull), points_of(hull)
    # Halves share the station amidships.
    found = values(hull)
    assert 0.5 * (before.fore + before.aft) == pytest.approx(found.project_prismatic, rel=1e-12)
    bpy.ops.hull.shift_sections(
        measure="HALVES", prismatic_fore=before.fore + 0.01, prismatic_aft=before.aft - 0.015
    )
    after = prismatics(hull)
    assert after.fore == pytest.approx(before.fore + 0.01, abs=SINGLE)
    assert after.aft == pytest.approx(before.aft - 0.015, abs=SINGLE)
    assert np.array_equal(points_of(hull)[:, 1:], points[:, 1:])
    wanted = after.fore - 0.02
    points = points_of(hull)
    bpy.ops.hull.shift_sections(measure="HALVES", prismatic_fore=wanted, part="FORE")
    assert prismatics(hull).fore == pytest.approx(wanted, abs=SINGLE)
    moves = np.abs(points_of(hull) - points)[:, 0]
    assert moves[points[:, 0] < 30.0].max() < 0.05 * moves.max()
    with pytest.raises(RuntimeError, match=r"Cp aft can be 0\.\d+ to 0\.\d+ here"):
        bpy.ops.hull.shift_sections(measure="HALVES", prismatic_aft=0.97, part="AFT")


def test_what_is_out_of_reach_is_told_and_changes_nothing():
    hull = sample("coaster")
    before = points_of(hull)
    with pytest.raises(RuntimeError, match="Cb can be 0"):
        bpy.ops.hull.shift_sections(measure="BLOCK", block=0.95, lcb_as="NONE")
    with pytest.raises(RuntimeError, match="One half of the body alone"):
        bpy.ops.hull.shift_sections(
            measure="BLOCK", block=0.73, lcb_as="LENGTH", lcb=42.0, part="FORE"
        )
    hull.hull.heel = 0.1
    with pytest.raises(RuntimeError, match="set the heel to zero"):
        bpy.ops.hull.shift_sections(measure="BLOCK", block=0.73)
    hull.hull.heel = 0.0
    hull.hull.length_pp = 0.0
    with pytest.raises(RuntimeError, match="Give Lpp"):
        bpy.ops.hull.shift_sections(measure="BLOCK", block=0.73)
    assert np.array_equal(points_of(hull), before)


def test_flats_stay_and_raked_ones_go_along():
    hull = sample("planing_boat")
    before = points_of(hull)
    (transom,) = part("features.constraints.flats").regions(hull)
    bpy.ops.hull.shift_sections(measure="NONE", lcb_as="PERCENT", lcb_percent=-9.5)
    moves = points_of(hull) - before
    assert np.ptp(moves[transom.points], axis=0).max() < 1e-5
    (now,) = part("features.constraints.flats").regions(hull)
    heights = points_of(hull)[now.points] @ now.plane[:3] - now.plane[3]
    assert np.abs(heights).max() < 1e-5


def test_what_is_kept_stays():
    hull = sample("container_ship")
    before = points_of(hull)
    ahead = np.flatnonzero(before[:, 0] > 340.0)
    group = hull.vertex_groups.new(name="bulb")
    group.add(ahead.tolist(), 1.0, "REPLACE")
    hull.hull.transform.kept_group = "bulb"
    hull.hull.transform.kept_fore = 10.0
    bpy.ops.hull.shift_sections(measure="BLOCK", block=0.655, lcb_as="NONE")
    after = points_of(hull)
    assert np.array_equal(after[ahead], before[ahead])
    assert np.abs(after - before).max() > 0.1
    # In edit mode groups are kept elsewhere.
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.hull.inflate_section(place=170.0, area_as="PERCENT", percent=0.5, extent=60.0)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert np.array_equal(points_of(hull)[ahead], before[ahead])
    hull.hull.transform.kept_group = "gone"
    with pytest.raises(RuntimeError, match="gone"):
        bpy.ops.hull.shift_sections(measure="BLOCK", block=0.66)


def test_lengthening():
    hull = sample("coaster")
    volume = values(hull).displaced_volume
    before = points_of(hull)
    with pytest.raises(RuntimeError, match="not parallel"):
        bpy.ops.hull.lengthen(length=5.0, place=8.0)
    assert hull.hull.length_pp == 84.0
    bpy.ops.hull.lengthen(length=5.0, place=42.0, use_range=True, range_aft=10.0, range_fore=70.0)
    assert hull.hull.length_pp == 89.0
    assert np.ptp(points_of(hull)[:, 0]) == pytest.approx(np.ptp(before[:, 0]) + 5.0, rel=SINGLE)
    assert values(hull).displaced_volume > volume


def test_inflating():
    hull = sample("coaster")
    area = part("features.transformation.inflating").section_area
    before = area(hull, bpy.context.scene, 20.0)
    bpy.ops.hull.inflate_section(place=20.0, area_as="PERCENT", percent=4.0, extent=25.0)
    assert area(hull, bpy.context.scene, 20.0) == pytest.approx(1.04 * before, rel=SINGLE)
    bpy.ops.hull.inflate_section(place=20.0, area_as="AREA", area=50.0, extent=25.0)
    assert area(hull, bpy.context.scene, 20.0) == pytest.approx(50.0, rel=SINGLE)


def test_nonsense_is_refused():
    hull = add_hull()
    hull.hull.length_pp, hull.hull.beam, hull.hull.draft = 10.0, 4.0, 1.0
    before = points_of(hull)
    for call in (
        lambda: bpy.ops.hull.shift_sections(measure="BLOCK", block=0.5),
        lambda: bpy.ops.hull.shift_sections(measure="VOLUME", volume=1e30),
        lambda: bpy.ops.hull.lengthen(length=0.0),
        lambda: bpy.ops.hull.lengthen(length=1e30),
        lambda: bpy.ops.hull.inflate_section(place=1e6, area_as="PERCENT"),
        lambda: bpy.ops.hull.inflate_section(place=5.0, area_as="AREA", area=0.0),
    ):
        with pytest.raises(RuntimeError, match="Error: "):
            call()
    assert np.array_equal(points_of(hull), before)


def test_where_nothing_is_wanted_nothing_is_done():
    hull = sample()
    with pytest.raises(RuntimeError, match="Ask for a displacement"):
        bpy.ops.hull.shift_sections(measure="NONE", lcb_as="NONE")
    assert not part("features.hull.form_before").is_known(hull)


def test_one_undo_step():
    hull = sample("coaster")
    bpy.ops.ed.undo_push(message="loaded")
    before = points_of(hull)
    bpy.ops.hull.shift_sections(measure="BLOCK", block=0.73, lcb_as="NONE")
    bpy.ops.ed.undo_push(message="shifted")
    bpy.ops.ed.undo()
    hull = bpy.context.view_layer.objects.active
    assert np.array_equal(points_of(hull), before)
