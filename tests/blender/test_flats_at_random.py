# SPDX-License-Identifier: GPL-3.0-or-later
"""Drags, moves of whole regions, divisions, undo and redo in random order: flats stay flat."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import LENGTH, add_hull, part

STEPS = 80


def update():
    bpy.context.view_layer.update()


def edit_mesh():
    hull = bpy.data.objects["box"]
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    bm.faces.ensure_lookup_table()
    return hull, bm


def drag(random):
    hull, bm = edit_mesh()
    for index in random.choice(len(bm.verts), size=random.integers(1, 4), replace=False):
        bm.verts[index].co += bm.verts[index].co.__class__(random.normal(scale=0.3, size=3))
    bmesh.update_edit_mesh(hull.data)


def move_a_region(random):
    hull, bm = edit_mesh()
    regions = part("features.constraints.flats").regions(hull)
    if regions:
        region = regions[random.integers(len(regions))]
        by = random.normal(scale=0.2) * region.plane[:3]
        for index in region.points.tolist():
            bm.verts[index].co += bm.verts[index].co.__class__(by)
        bmesh.update_edit_mesh(hull.data)


def make_flat(random):
    hull, bm = edit_mesh()
    start = bm.faces[random.integers(len(bm.faces))]
    chosen = {start} | {face for edge in start.edges for face in edge.link_faces}
    bpy.ops.mesh.select_all(action="DESELECT")
    for face in chosen:
        face.select_set(True)
    bmesh.update_edit_mesh(hull.data)
    kind = ("SIDE", "BOTTOM", "TRANSOM", "RAKED", "BEST")[random.integers(5)]
    try:
        bpy.ops.hull.make_flat(kind=kind)
    except RuntimeError as error:
        assert "another plane" in str(error) or "in a line" in str(error)


def release(random):
    hull, bm = edit_mesh()
    bpy.ops.mesh.select_all(action="DESELECT")
    bm.faces[random.integers(len(bm.faces))].select_set(True)
    bmesh.update_edit_mesh(hull.data)
    try:
        bpy.ops.hull.release_flat()
    except RuntimeError as error:
        assert "None of the selected" in str(error)


def divide(random):
    hull, bm = edit_mesh()
    if len(bm.faces) > 400:
        return
    bpy.ops.mesh.select_all(action="DESELECT")
    for index in random.choice(len(bm.faces), size=2, replace=False):
        bm.faces[index].select_set(True)
    bmesh.update_edit_mesh(hull.data)
    bpy.ops.mesh.subdivide(number_cuts=1)


def undo(random):
    for _ in range(random.integers(1, 4)):
        if bpy.ops.ed.undo.poll() and undo.depth > 1:
            bpy.ops.ed.undo()
            undo.depth -= 1
            undo.ahead += 1


def redo(random):
    for _ in range(random.integers(1, 4)):
        if undo.ahead:
            bpy.ops.ed.redo()
            undo.depth += 1
            undo.ahead -= 1


def assert_flat():
    hull, _ = edit_mesh()
    flats, planes = part("features.constraints.flats"), part("features.constraints.planes")
    points = part("bridge.mesh.mesh_points").read(hull.data)
    for region in flats.regions(hull):
        heights = planes.heights(points[region.points], region.plane)
        assert np.abs(heights).max() <= 2e-6 * np.abs(points).max(), region
        if region.kind in ("SIDE", "BOTTOM", "TRANSOM"):
            own = flats.planes_of_points(
                part("features.constraints.flat_marks").read(hull.data),
                {region.number: region.plane},
            )
            axis = int(np.flatnonzero(region.plane[:3])[0])
            alone = [i for i in own if _is_only_of(hull, i, region)]
            assert (points[alone, axis] == region.plane[3] * region.plane[axis]).all()
    marks = part("features.constraints.flat_marks").read(hull.data)
    if marks is not None:
        assert set(marks.regions.tolist()) <= {entry.region for entry in hull.hull.flats}


def _is_only_of(hull, index, region):
    return (
        sum(index in other.points for other in part("features.constraints.flats").regions(hull))
        == 1
    )


@pytest.mark.parametrize("seed", [1, 2])
def test_flats_stay_flat(seed):
    print("seed", seed)
    random = np.random.default_rng(seed)
    add_hull()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide(number_cuts=3)
    bpy.context.tool_settings.mesh_select_mode = (False, False, True)
    bpy.ops.ed.undo_push(message="begin")
    undo.depth, undo.ahead = 1, 0
    actions = [drag, move_a_region, make_flat, release, divide, undo, redo]
    for _ in range(STEPS):
        action = actions[random.choice(7, p=[0.35, 0.15, 0.15, 0.05, 0.05, 0.15, 0.1])]
        action(random)
        update()
        update()
        assert_flat()
        if action not in (undo, redo):
            bpy.ops.ed.undo_push(message=action.__name__)
            undo.depth, undo.ahead = undo.depth + 1, 0
    hull, _ = edit_mesh()
    assert np.abs(part("bridge.mesh.mesh_points").read(hull.data)).max() < 10.0 * LENGTH
