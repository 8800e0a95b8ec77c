# SPDX-License-Identifier: GPL-3.0-or-later
"""The angle along knuckles: shown, written, drawn, and set in edit mode."""

import csv

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, compute, part, state_of
from edited_hulls import edit, select


def knuckles_of(hull):
    return part("features.fairness.knuckle_angles").of_surface(state_of(hull).ship.surface)


def planing_boat():
    bpy.ops.hull.load_sample(name="planing_boat")
    return bpy.context.view_layer.objects.active


def chine_edges(hull):
    """The edges, pairs of Blender's points, of the longest knuckle."""
    (longest, *_) = knuckles_of(hull)
    ids = state_of(hull).ship.source.control.vertex_ids
    points = ids[longest.vertices]
    return np.stack([points[:-1], points[1:]], axis=1).tolist()


def test_a_box_has_right_angles(tmp_path):
    hull = add_hull()
    found = knuckles_of(hull)
    assert len(found) == 5
    for one in found:
        np.testing.assert_allclose(np.degrees([one.least, one.mean, one.largest]), 90, atol=1e-9)
    path = tmp_path / "angles.csv"
    name = {"filepath": str(path), "analysis": "knuckle_angles"}
    assert bpy.ops.hull.export_table(**name) == {"FINISHED"}
    with open(path, newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert all(float(row["angle [deg]"]) == pytest.approx(90.0) for row in rows)
    assert {int(row["knuckle"]) for row in rows} == {1, 2, 3, 4, 5}
    compute([(hull.name, "knuckle_angles")])
    assert part("features.fairness.knuckle_angles").plot(found, "box") is not None


def plotted(hull, chosen=slice(None)):
    """Laid out: names of curves, texts, and how much of the diagram's width the widest takes."""
    angles, native = part("features.fairness.knuckle_angles"), part("bridge.native").require()
    plot = angles.plot(knuckles_of(hull)[chosen], hull.name)
    sheet = native.lay_out_plot(plot, width_mm=200, height_mm=150)
    left, _, right, _ = sheet.diagram
    widths = [np.ptp(points[:, 0]) for points, *_ in sheet.strokes if len(points) > 4]
    return plot.curve_names, [label["text"] for label in sheet.labels], max(widths) / (right - left)


def test_knuckles_across_the_ship_are_drawn_over_their_length():
    """Over x they would be upright lines: a box has three of them, and two along her."""
    hull = add_hull()
    found = knuckles_of(hull)
    assert [one.is_across for one in found] == [False] + 4 * [True]
    assert [one.reach[0] == one.reach[1] for one in found] == [False] + 4 * [True]
    names, said, width = plotted(hull, slice(1, None))
    assert names == ["1", "2", "3", "4"] and "Along the knuckle [m]" in said and width > 0.5
    names, said, _ = plotted(hull, slice(1))
    assert names == ["1"] and "x from the after perpendicular [m]" in said
    names, said, _ = plotted(hull)
    assert names == ["1 over x", "2 over s", "3 over s", "4 over s", "5 over s"]
    assert "x: from the after perpendicular, s: along the knuckle" in said


def test_a_chine_gets_one_angle_along_its_length():
    hull = planing_boat()
    chine = chine_edges(hull)
    edit(hull, (False, True, False))
    select(hull, "edge", chine[2:-2])
    before = part("bridge.mesh.mesh_points").read(hull.data)
    assert bpy.ops.hull.set_knuckle_angle(angle=np.radians(40.0)) == {"FINISHED"}
    after = part("bridge.mesh.mesh_points").read(hull.data)
    moved = np.abs(after - before).max(axis=1) > 0.0
    assert moved.any() and not moved[np.unique(chine)].any()
    surface, native = state_of(hull).ship.surface, part("bridge.native").require()
    (number,) = [
        i
        for i, curve in enumerate(native.crease_curves(surface))
        if set(state_of(hull).ship.source.control.vertex_ids[curve.vertices])
        == set(np.unique(chine))
    ]
    edges = list(range(2, len(chine) - 2))
    angles = native.knuckle_angles(surface, number, edges=edges, samples_per_edge=16).angles
    assert np.degrees(np.abs(angles - np.radians(40.0))).max() < 0.5
    bpy.ops.object.mode_set(mode="OBJECT")


def test_without_a_knuckle_it_says_so():
    hull = planing_boat()
    bm = edit(hull, (False, True, False))
    bmesh.update_edit_mesh(hull.data)
    assert bm.edges
    with pytest.raises(RuntimeError, match="Select edges of a knuckle first"):
        bpy.ops.hull.set_knuckle_angle(angle=0.5)
    bpy.ops.object.mode_set(mode="OBJECT")
