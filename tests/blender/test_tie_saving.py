# SPDX-License-Identifier: GPL-3.0-or-later
"""Tied points of all kinds survive copies, hull files, .blend files, undo and redo, and hold as
exactly as before each time."""

import dataclasses

import bpy
import numpy as np
import pytest
from addon_under_test import make_active, part
from edited_hulls import at, edit, grid_hull
from test_centre_keeping import points
from test_tie_keeping import select_points, stored
from tied_hulls import misses, tie, ties

ONE_SIDE = {"LINE", "ANCHOR", "LEVEL", "CAMBER"}


def tied_half():
    """(hull, points to be dragged, a point that follows): all kinds but mirror pairs."""
    hull = grid_hull()
    edit(hull)
    bpy.ops.object.mode_set(mode="OBJECT")
    tie(hull, "LINE", [at(2, 2), at(3, 2)], at(1, 2), at(4, 2))
    tie(hull, "ANCHOR", [at(5, 4)], at(5, 3))
    tie(hull, "LEVEL", [at(2, 4)], at(3, 4))
    tie(hull, "CAMBER", [at(0, 4)], at(1, 4), share=0.03)
    return hull, [at(4, 2), at(5, 3)], at(5, 4), 0.5


def tied_whole():
    """The same of a whole hull whose sides are mirror pairs."""
    hull = grid_hull()
    edit(hull)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert bpy.ops.hull.make_whole() == {"FINISHED"}
    edit(hull)
    bpy.ops.mesh.select_all(action="SELECT")
    assert bpy.ops.hull.tie_points(kind="MIRROR") == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    pairs = {to[0]: point for point, (_, to) in stored(hull).items()}
    assert len(pairs) == 30
    return hull, [at(2, 2)], pairs[at(2, 2)], -0.5


def holds(hull, kinds):
    """Whether ties of all kinds are there, and hold as they must."""
    found = misses(hull)
    return set(found) == kinds and max(found.values()) <= 1e-12


@pytest.mark.parametrize(
    "tied, kinds", [(tied_half, ONE_SIDE), (tied_whole, {"MIRROR"})], ids=["half", "whole"]
)
def test_ties_survive_copying_saving_and_undo(tied, kinds, tmp_path):
    hull, dragged, follower, moves_by = tied()
    before, name = ties().stored_ties(hull.data), hull.name
    assert holds(hull, kinds)
    bpy.ops.object.duplicate()
    copy = bpy.context.object
    bpy.context.view_layer.update()
    assert copy != hull and ties().stored_ties(copy.data) == before and holds(copy, kinds)
    path = str(tmp_path / "tied.hull.json")
    assert bpy.ops.hull.export_hull(filepath=path) == {"FINISHED"}
    assert bpy.ops.hull.import_hull(filepath=path) == {"FINISHED"}
    again = bpy.context.object
    for found, wanted in zip(sorted(ties().stored_ties(again.data)), sorted(before)):
        assert found[:3] == wanted[:3] and found[3] == pytest.approx(wanted[3], abs=1e-6)
    assert len(stored(again)) == len(before)
    assert np.array_equal(points(again), points(copy))
    assert holds(again, kinds)
    blend = str(tmp_path / "tied.blend")
    bpy.ops.wm.save_as_mainfile(filepath=blend)
    bpy.ops.wm.open_mainfile(filepath=blend)
    bpy.context.view_layer.update()
    hull = bpy.data.objects[name]
    assert ties().stored_ties(hull.data) == before
    make_active(hull)
    assert holds(hull, kinds)
    edit(hull)
    bpy.ops.ed.undo_push(message="before")
    there = points(hull)
    select_points(hull, dragged)
    bpy.ops.ed.undo_push(message="selected")
    bpy.ops.transform.translate(value=(0.0, 0.5, 0.25))
    bpy.context.view_layer.update()
    assert holds(hull, kinds)
    bpy.ops.ed.undo_push(message="moved")
    moved = points(hull)
    assert moved[follower, 1] == pytest.approx(there[follower, 1] + moves_by)
    bpy.ops.ed.undo()
    hull = bpy.data.objects[name]
    assert np.array_equal(points(hull), there) and ties().stored_ties(hull.data) == before
    bpy.context.view_layer.update()
    assert holds(hull, kinds)
    bpy.ops.ed.redo()
    hull = bpy.data.objects[name]
    bpy.context.view_layer.update()
    assert np.array_equal(points(hull), moved) and holds(hull, kinds)


def test_named_groups_of_points_come_back(tmp_path):
    """By a hull file, with their names and points, and to Blender's selection by name."""
    hull = grid_hull()
    edit(hull)
    bpy.ops.object.mode_set(mode="OBJECT")
    wanted = {"sheer": [at(i, 4) for i in range(6)], "Bilge „a“": [at(2, 1), at(3, 1)]}
    for name, indices in wanted.items():
        hull.vertex_groups.new(name=name).add(indices, 1.0, "REPLACE")
    path = str(tmp_path / "groups.hull.json")
    assert bpy.ops.hull.export_hull(filepath=path) == {"FINISHED"}
    bpy.ops.wm.read_homefile(use_empty=True)
    assert bpy.ops.hull.import_hull(filepath=path) == {"FINISHED"}
    again = bpy.context.object
    found = {group.name: [] for group in again.vertex_groups}
    for vertex in again.data.vertices:
        for entry in vertex.groups:
            found[again.vertex_groups[entry.group].name].append(vertex.index)
    assert found == {name: sorted(indices) for name, indices in wanted.items()}
    edit(again)
    again.vertex_groups.active_index = again.vertex_groups["sheer"].index
    bpy.ops.object.vertex_group_select()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert [v.index for v in again.data.vertices if v.select] == sorted(wanted["sheer"])


def test_what_is_tied_exactly_has_another_digest():
    """The surface is of more digits than Blender keeps of a point, which stays as it is."""
    hull = grid_hull()
    mesh_arrays = part("bridge.mesh.mesh_arrays")
    last = len(points(hull)) - 1
    tie(hull, "LINE", [last // 2], 0, last, share=1.0)
    tied = mesh_arrays.read_mesh(hull.data)
    assert not np.array_equal(tied.exact_points(), tied.points)
    assert tied.points_digest() != dataclasses.replace(tied, ties=None).points_digest()
