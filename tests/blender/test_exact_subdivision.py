# SPDX-License-Identifier: GPL-3.0-or-later
"""A control mesh subdivided exactly: the same surface, and all that the hull knows comes along."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import HALF_BREADTH, ROOT, add_hull, mesh_points, part, sample, state_of
from edited_hulls import at, edit, faces_in, grid_hull, keys, select, selected

pytestmark = [pytest.mark.once, pytest.mark.one_in(3)]

SAMPLES = sorted(path.name[: -len(".hull.json")] for path in (ROOT / "samples").glob("*.hull.json"))
SIDE = (0.0, 1.0, 0.0, HALF_BREADTH)

# Of the size: what single precision, in which Blender keeps points, leaves of a place.
ROUNDED = 2.0**-24
# Corners of the four quarters of a cell, each of which is a cell of the finer mesh, with its axes.
QUARTERS = (
    ((0, 0), (1, 0), (0, 1)),
    ((1, 0), (0, 1), (-1, 0)),
    ((1, 1), (-1, 0), (0, -1)),
    ((0, 1), (0, -1), (1, 0)),
)


def subdivide(hull):
    return part("features.modelling.exact_subdivision").subdivide(hull, bpy.context.scene)


def surface_of(hull):
    """One of its own, which edits leave as it is."""
    state = part("features.hull.hull_state").up_to_date(hull, bpy.context.scene)
    return state.ship.source.new_surface()


def furthest_apart(coarse, fine, count=7):
    """At places all over every cell, among them its corners and edges."""
    assert fine.cell_count == 4 * coarse.cell_count
    places = np.stack(np.meshgrid(*2 * [np.linspace(0.0, 1.0, count)]), axis=-1).reshape(-1, 2)
    worst = 0.0
    for quarter, (origin, u, v) in enumerate(QUARTERS):
        cells = np.repeat(np.arange(coarse.cell_count), len(places))
        own = np.tile(places, (coarse.cell_count, 1))
        there = np.array(origin) + 0.5 * (own[:, :1] * u + own[:, 1:] * v)
        apart = coarse.positions(cells, there) - fine.positions(4 * cells + quarter, own)
        worst = max(worst, np.abs(apart).max())
    return worst


@pytest.mark.parametrize("whole", [False, True])
@pytest.mark.parametrize("scheme", ["biermann", "catmull_clark"])
@pytest.mark.parametrize("name", SAMPLES)
def test_the_surface_is_the_same(name, scheme, whole):
    hull = sample(name)
    hull.hull.scheme = scheme
    if whole and hull.hull.half:
        assert bpy.ops.hull.make_whole() == {"FINISHED"}
    before, size = surface_of(hull), state_of(hull).ship.surface.mesh.size
    faces, sizes = len(hull.data.polygons), state_of(hull).ship.source.control.face_sizes
    found = subdivide(hull)
    assert found.faces == len(hull.data.polygons) == faces - len(sizes) + sizes.sum()
    assert furthest_apart(before, surface_of(hull)) < ROUNDED * size
    state = state_of(hull)
    assert not state.status and not state.keeping.held
    kinds, finer = before.mesh.vertex_kinds, state.ship.surface.mesh.vertex_kinds
    assert np.bincount(kinds[kinds != 2], minlength=5)[1:].tolist() == (
        np.bincount(finer[finer != 2], minlength=5)[1:].tolist()
    )
    assert len(state.ship.surface.mesh.creases) == 2 * len(before.mesh.creases)


@pytest.mark.parametrize("name", SAMPLES)
def test_the_border_on_the_centre_plane_stays_there(name):
    hull = sample(name)
    points = mesh_points(hull)
    on_plane = {edge.key for edge in hull.data.edges if not points[list(edge.vertices), 1].any()}
    mesh = state_of(hull).ship.surface.mesh
    count = sum(tuple(sorted(edge)) in on_plane for edge in mesh.border_edges.tolist())
    assert count or name in ("catamaran", "naval_vessel")
    subdivide(hull)
    mesh = state_of(hull).ship.surface.mesh
    finer = (mesh.points[mesh.border_edges, 1] == 0.0).all(axis=1)
    assert np.count_nonzero(finer) >= 2 * count - 2


FIRST, MIDDLE = at(2, 2), at(3, 2)


def dressed_hull():
    """A grid in edit mode whose edge between FIRST and MIDDLE, both locked, is all that an edge can
    be, with weights, texture places and two layers."""
    hull = grid_hull()
    for name in ("one", "two"):
        hull.data.materials.append(bpy.data.materials.new(name))
    group = hull.vertex_groups.new(name="weights")
    for index in range(len(hull.data.vertices)):
        group.add([index], index / 32.0, "REPLACE")
    for polygon in hull.data.polygons:
        polygon.material_index, polygon.use_smooth = polygon.index % 2, polygon.index % 3 == 0
    layer = hull.data.uv_layers.new(name="places")
    for loop, corner in zip(hull.data.loops, layer.data):
        corner.uv = hull.data.vertices[loop.vertex_index].co.xz
    bm = edit(hull)
    crease, _ = part("bridge.blender.blender_versions").ensure_crease_layers(bm)
    bm.edges.layers.int.new(part("bridge.mesh.deck_edge_marks").ATTRIBUTE)
    mark = bm.edges.layers.int[part("bridge.mesh.deck_edge_marks").ATTRIBUTE]
    bm.verts.ensure_lookup_table()
    edge = bm.edges.get((bm.verts[FIRST], bm.verts[MIDDLE]))
    edge.seam, edge.smooth, edge[crease], edge[mark] = True, False, 1.0, 1
    bmesh.update_edit_mesh(hull.data)
    select(hull, "vertex", [FIRST, MIDDLE])
    assert bpy.ops.hull.lock_points() == {"FINISHED"}
    return hull


def all_of(hull):
    """What is known of the edges, as sets of pairs, and of the points of a hull in edit mode."""
    data = part("bridge.mesh.mesh_arrays").read_mesh(hull.data)
    bm = bmesh.from_edit_mesh(hull.data)
    edges = {
        "creases": data.tagged_edges[data.edge_creases == 1.0].tolist(),
        "deck edge": data.deck_edge().tolist(),
        "seams": [[v.index for v in edge.verts] for edge in bm.edges if edge.seam],
        "sharp": [[v.index for v in edge.verts] for edge in bm.edges if not edge.smooth],
    }
    weights = bm.verts.layers.deform.active
    return {name: keys(found) for name, found in edges.items()}, [v[weights][0] for v in bm.verts]


def test_what_the_mesh_carries_comes_along():
    hull = dressed_hull()
    before, (edges, weights) = surface_of(hull), all_of(hull)
    faces = [(f.material_index, f.smooth) for f in bmesh.from_edit_mesh(hull.data).faces]
    assert set(map(len, edges.values())) == {1}
    assert bpy.ops.hull.subdivide_exactly() == {"FINISHED"}
    assert furthest_apart(before, surface_of(hull)) < ROUNDED * before.mesh.size
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    (new,) = {v.index for f in bm.verts[FIRST].link_faces for v in f.verts} & {
        edge.other_vert(bm.verts[MIDDLE]).index for edge in bm.verts[MIDDLE].link_edges
    }
    finer_edges, finer_weights = all_of(hull)
    assert all(found == keys([(FIRST, new), (new, MIDDLE)]) for found in finer_edges.values())
    locks = part("features.constraints.point_locks").locked_points(hull.data)
    assert locks.tolist() == sorted((FIRST, MIDDLE, new))
    assert finer_weights[: len(weights)] == weights
    assert finer_weights[new] == pytest.approx((FIRST + MIDDLE) / 64.0, abs=1e-6)
    # Those of a face come one after the other, as cells do.
    finer = [(f.material_index, f.smooth) for f in bm.faces]
    assert finer == [face for face in faces for _ in range(4)]
    uv = bm.loops.layers.uv.active
    for index, face in enumerate(bm.faces):
        column, row = divmod(index // 4, 4)
        assert np.array(face.loops[2][uv].uv) == pytest.approx((column + 0.5, row + 0.5)), index
    bpy.ops.object.mode_set(mode="OBJECT")
    assert not state_of(hull).status


@pytest.mark.parametrize("kind, count", [("vertex", 9), ("edge", 4), ("face", 4)])
def test_selected_and_hidden_parts_stay_so(kind, count):
    hull = grid_hull()
    edit(hull, tuple(kind == one for one in ("vertex", "edge", "face")))
    bm = bmesh.from_edit_mesh(hull.data)
    bm.faces.ensure_lookup_table()
    for piece in (bm.faces[-1], *bm.faces[-1].edges):
        piece.hide = piece is bm.faces[-1] or piece.is_boundary
    corner = [at(1, 1), at(2, 1), at(2, 2), at(1, 2)]
    chosen = {"vertex": corner, "edge": [corner[:2], corner[2:]], "face": [5]}[kind]
    select(hull, kind, chosen)
    assert bpy.ops.hull.subdivide_exactly() == {"FINISHED"}
    assert len(selected(hull, kind)) == count
    bm = bmesh.from_edit_mesh(hull.data)
    assert sum(face.hide for face in bm.faces) == 4
    assert sum(edge.hide for edge in bm.edges) == 8
    assert sum(vertex.hide for vertex in bm.verts) == 3
    bpy.ops.object.mode_set(mode="OBJECT")


def test_flats_between_knuckles_stay_whole():
    hull = add_hull()
    flats = part("features.constraints.flats")
    number = flats.mark(hull, faces_in(hull, SIDE), SIDE)
    for count in (4, 16):
        assert subdivide(hull).no_longer_flat == 0
        (region,) = flats.regions(hull)
        assert (region.number, len(region.faces)) == (number, count)
        assert not state_of(hull).keeping.held


@pytest.mark.parametrize("name", ["bulk_carrier", "container_ship", "roro"])
def test_smooth_rims_of_flats_are_let_go(name):
    hull = sample(name)
    flats = part("features.constraints.flats")
    before = {region.number: region for region in flats.regions(hull)}
    surface = surface_of(hull)
    sizes = np.array([len(polygon.vertices) for polygon in hull.data.polygons])
    found = subdivide(hull)
    points, after = mesh_points(hull).astype(np.float64), flats.regions(hull)
    assert found.no_longer_flat == (
        sum(sizes[region.faces].sum() for region in before.values())
        - sum(len(region.faces) for region in after)
    )
    assert 0 < found.no_longer_flat
    for region in after:
        assert np.array_equal(region.plane, before[region.number].plane)
        off = points[region.points] @ region.plane[:3] - region.plane[3]
        assert np.abs(off).max() <= 2.4e-7 * np.abs(points).max()
    # Keeping them moves nothing.
    bpy.context.view_layer.update()
    assert furthest_apart(surface, surface_of(hull)) < ROUNDED * surface.mesh.size


def test_what_is_not_of_the_shell_stays():
    hull = grid_hull()
    splitting = part("features.modelling.splitting")
    before = surface_of(hull)
    assert splitting.set_aside(hull, bpy.context.scene, [0, 1]) == 2
    shell = surface_of(hull)
    found = subdivide(hull)
    assert found.faces == 2 + 4 * (before.mesh.face_count - 2)
    sizes = [len(polygon.vertices) for polygon in hull.data.polygons if polygon.material_index]
    assert sorted(sizes) == [5, 6]
    assert furthest_apart(shell, surface_of(hull)) < ROUNDED * shell.mesh.size


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_it_is_one_step_of_undo(mode):
    hull = sample("coaster")
    bpy.ops.object.mode_set(mode=mode)
    bpy.ops.ed.undo_push(message="before")
    count = len(part("bridge.mesh.mesh_arrays").read_mesh(hull.data).points)
    assert bpy.ops.hull.subdivide_exactly() == {"FINISHED"}
    bpy.ops.ed.undo_push(message="subdivided")
    bpy.ops.ed.undo()
    hull = bpy.context.view_layer.objects.active
    assert len(part("bridge.mesh.mesh_arrays").read_mesh(hull.data).points) == count
    bpy.ops.ed.redo()
    hull = bpy.context.view_layer.objects.active
    assert len(part("bridge.mesh.mesh_arrays").read_mesh(hull.data).points) > 3 * count
    if mode == "EDIT":
        bpy.ops.object.mode_set(mode="OBJECT")


def test_why_not_is_said(monkeypatch):
    hull = grid_hull()
    monkeypatch.setattr(part("bridge.limits"), "MOST_CONTROL_FACES", 79)
    with pytest.raises(RuntimeError, match="80 faces, more than 79"):
        bpy.ops.hull.subdivide_exactly()
    monkeypatch.undo()
    other = hull.copy()
    with pytest.raises(RuntimeError, match="2 objects share the mesh"):
        bpy.ops.hull.subdivide_exactly()
    bpy.data.objects.remove(other)
    hull.data.polygons[3].flip()
    with pytest.raises(RuntimeError, match="same direction by both"):
        bpy.ops.hull.subdivide_exactly()
    assert len(hull.data.polygons) == 20


def test_what_could_not_follow_is_refused_before_anything_is_changed(monkeypatch):
    """Of many triangles the finer mesh is too fine, though its faces are few enough."""
    hull = grid_hull(8, 8)
    edit(hull)
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.quads_convert_to_tris()
    bpy.ops.object.mode_set(mode="OBJECT")
    state = part("features.hull.hull_state").up_to_date(hull, bpy.context.scene)
    work = part("bridge.mesh.mesh_check")
    control = state.ship.source.control
    now = work._work(control, True, work._irregular_cells(control))
    monkeypatch.setattr(part("bridge.limits"), "MOST_SHOWN_FACES", now + 1)
    before = mesh_points(hull)
    with pytest.raises(ValueError, match="of which too many have irregular corners"):
        subdivide(hull)
    assert np.array_equal(mesh_points(hull), before)
    assert not state_of(hull).status
