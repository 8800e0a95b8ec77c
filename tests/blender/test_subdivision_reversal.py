# SPDX-License-Identifier: GPL-3.0-or-later
"""A subdivided control mesh taken back: all that the hull knew before is there again."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, mesh_points, part, state_of
from edited_hulls import edit, faces_in, grid_hull, select, selected
from test_exact_subdivision import (
    FIRST,
    MIDDLE,
    SAMPLES,
    SIDE,
    all_of,
    dressed_hull,
    sample,
    subdivide,
)

# Of the size: single precision of the finer points, and of those that come of them.
ROUNDED = 2.0**-22


def mesh_of(hull):
    return part("bridge.mesh.mesh_arrays").read_mesh(hull.data)


def faces_of(hull):
    """Each from its lowest point on, in order."""
    data = mesh_of(hull)
    faces = np.split(data.face_vertices, np.cumsum(data.face_sizes)[:-1])
    return [tuple(np.roll(face, -int(face.argmin())).tolist()) for face in faces]


def tags_of(hull):
    mesh = state_of(hull).ship.surface.mesh
    return sorted(map(tuple, np.sort(mesh.creases, axis=1).tolist())), mesh.vertex_kinds.tolist()


@pytest.mark.parametrize("scheme", ["biermann", "catmull_clark"])
@pytest.mark.parametrize("name", SAMPLES)
def test_samples_are_what_they_were(name, scheme):
    hull = sample(name)
    hull.hull.scheme = scheme
    before, faces, tags = mesh_points(hull), faces_of(hull), tags_of(hull)
    flats = {r.number: r.faces.tolist() for r in part("features.constraints.flats").regions(hull)}
    deck, size = mesh_of(hull).deck_edges.sum(), state_of(hull).ship.surface.mesh.size
    subdivide(hull)
    assert bpy.ops.hull.unsubdivide(tolerance=1e-6 * size) == {"FINISHED"}
    assert np.abs(mesh_points(hull) - before).max() < ROUNDED * size
    assert not mesh_points(hull)[before[:, 1] == 0.0, 1].any()
    assert faces_of(hull) == faces and tags_of(hull) == tags
    assert mesh_of(hull).deck_edges.sum() == deck and not state_of(hull).status
    # A face at a rim all of whose parts had left the plane is let go.
    now = {r.number: r.faces.tolist() for r in part("features.constraints.flats").regions(hull)}
    assert now.keys() == flats.keys()
    assert all(set(now[number]) <= set(flats[number]) for number in flats)
    assert sum(map(len, flats.values())) - sum(map(len, now.values())) <= 1


def test_what_the_mesh_carries_comes_back():
    hull = dressed_hull()
    before, (edges, weights) = mesh_points(hull), all_of(hull)
    faces = [(f.material_index, f.smooth) for f in bmesh.from_edit_mesh(hull.data).faces]
    loops = uv_of(hull)
    assert bpy.ops.hull.subdivide_exactly() == {"FINISHED"}
    assert bpy.ops.hull.unsubdivide() == {"FINISHED"}
    assert all_of(hull) == (edges, weights)
    bm = bmesh.from_edit_mesh(hull.data)
    assert [(f.material_index, f.smooth) for f in bm.faces] == faces
    assert uv_of(hull) == loops
    assert selected(hull, "vertex") == sorted((FIRST, MIDDLE))
    locks = part("features.constraints.point_locks").locked_points(hull.data)
    assert locks.tolist() == sorted((FIRST, MIDDLE))
    bpy.ops.object.mode_set(mode="OBJECT")
    assert np.abs(mesh_points(hull) - before).max() < 1e-6 * max(hull.dimensions)


def uv_of(hull):
    """Places of texture by face and point, in edit mode."""
    bm = bmesh.from_edit_mesh(hull.data)
    layer = bm.loops.layers.uv.active
    return [{loop.vert.index: tuple(loop[layer].uv) for loop in face.loops} for face in bm.faces]


def test_flats_between_knuckles_stay_whole():
    hull = add_hull()
    flats = part("features.constraints.flats")
    number = flats.mark(hull, faces_in(hull, SIDE), SIDE)
    subdivide(hull)
    assert bpy.ops.hull.unsubdivide() == {"FINISHED"}
    (region,) = flats.regions(hull)
    assert (region.number, len(region.faces)) == (number, 1)


@pytest.mark.parametrize("kind, chosen", [("edge", [[FIRST, MIDDLE]]), ("face", [5, 6])])
def test_what_is_selected_stays_so(kind, chosen):
    hull = grid_hull()
    edit(hull, tuple(kind == one for one in ("vertex", "edge", "face")))
    select(hull, kind, chosen)
    before = selected(hull, kind)
    assert bpy.ops.hull.subdivide_exactly() == {"FINISHED"}
    assert bpy.ops.hull.unsubdivide() == {"FINISHED"}
    assert selected(hull, kind) == before
    bpy.ops.object.mode_set(mode="OBJECT")


def test_moved_points_within_a_tolerance():
    hull = sample("coaster")
    count = len(mesh_points(hull))
    subdivide(hull)
    index = int(np.argmax(mesh_points(hull)[count:, 1])) + count
    hull.data.vertices[index].co.y += 0.2
    finer = mesh_points(hull)
    with pytest.raises(RuntimeError, match=rf"more than the tolerance .* is number {index}\b"):
        bpy.ops.hull.unsubdivide(tolerance=0.001)
    assert np.array_equal(mesh_points(hull), finer)
    reports = part("features.modelling.subdivision_reversal")
    made = reports.take_back(hull, bpy.context.scene, 0.5)
    assert made.points == len(mesh_points(hull)) == count
    # The surface goes back by less than the point had gone out.
    assert 0.02 < made.change < 0.1 and 0.1 < made.moved < 0.2


def test_undo_brings_the_finer_mesh_back():
    hull = sample("barge")
    bpy.ops.ed.undo_push(message="begin")
    bpy.ops.hull.subdivide_exactly()
    bpy.ops.ed.undo_push(message="subdivided")
    finer = mesh_points(hull)
    bpy.ops.hull.unsubdivide()
    bpy.ops.ed.undo_push(message="taken back")
    bpy.ops.ed.undo()
    hull = bpy.context.view_layer.objects.active
    assert np.array_equal(mesh_points(hull), finer) and not state_of(hull).status


def test_faces_outside_the_shell_lose_the_points_that_go():
    hull = grid_hull()
    assert part("features.modelling.splitting").set_aside(hull, bpy.context.scene, [0, 1]) == 2
    before, faces = mesh_points(hull), sorted(faces_of(hull))
    subdivide(hull)
    assert bpy.ops.hull.unsubdivide() == {"FINISHED"}
    assert sorted(faces_of(hull)) == faces
    assert np.abs(mesh_points(hull) - before).max() < 1e-6 * max(hull.dimensions)


def test_why_not_is_said():
    hull = grid_hull(columns=4)
    with pytest.raises(RuntimeError, match="no subdivided one: .* at point"):
        bpy.ops.hull.unsubdivide()
    hull = grid_hull()
    subdivide(hull)
    bm = edit(hull)
    bm.verts.ensure_lookup_table()
    middle = next(v for v in bm.verts if v.index >= 30 and len(v.link_faces) == 4)
    bm.edges.new((middle, bm.verts.new(middle.co * 1.5)))
    bmesh.update_edit_mesh(hull.data)
    bpy.ops.object.mode_set(mode="OBJECT")
    before = mesh_points(hull)
    with pytest.raises(RuntimeError, match="outside the shell hang on point"):
        bpy.ops.hull.unsubdivide()
    assert np.array_equal(mesh_points(hull), before)
