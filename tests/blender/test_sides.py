# SPDX-License-Identifier: GPL-3.0-or-later
"""A half hull made whole, and a whole one half: the same ship."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import (
    HALF_BREADTH,
    LENGTH,
    add_hull,
    make_active,
    mesh_points,
    part,
    sample,
    state_of,
)
from edited_hulls import faces_in

NUMBERS = ("displaced_volume", "wetted_surface", "waterplane_area", "lcb", "kb", "kmt", "lcf")
ALIKE = 1e-7  # live numbers are integrated to 1e-8


def numbers(hull):
    found = part("features.hull.hull_state").refresh(hull, bpy.context.scene).hydrostatics.values
    return {name: getattr(found, name) for name in NUMBERS}


def surface_points(hull):
    """Points of the surface object, both sides, sorted to be compared."""
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    return mesh_points(hull.hull.surface_object)


def furthest_apart(first, second):
    from mathutils import kdtree

    tree = kdtree.KDTree(len(second))
    for index, point in enumerate(second):
        tree.insert(point, index)
    tree.balance()
    return max(tree.find(point)[2] for point in first)


@pytest.mark.parametrize("name", ["barge", "coaster"])
def test_a_whole_hull_is_the_same_ship(name):
    hull = sample(name)
    before, surface = numbers(hull), surface_points(hull)
    faces = len(hull.data.polygons)
    assert bpy.ops.hull.make_whole() == {"FINISHED"}
    assert not hull.hull.half and len(hull.data.polygons) == 2 * faces
    assert numbers(hull) == pytest.approx(before, rel=ALIKE)
    assert not state_of(hull).ship.check.errors
    whole = surface_points(hull)
    assert furthest_apart(whole, surface) < 1e-6 * LENGTH * 10
    assert furthest_apart(surface, whole) < 1e-6 * LENGTH * 10
    assert bpy.ops.hull.make_half() == {"FINISHED"}
    assert hull.hull.half and len(hull.data.polygons) == faces
    assert numbers(hull) == pytest.approx(before, rel=ALIKE)
    assert np.array_equal(surface_points(hull), surface)


def test_sides_that_would_not_join_are_put_on_the_centre_plane_first():
    hull = sample("coaster")
    before = numbers(hull)
    mesh = state_of(hull).ship.surface.mesh
    line = np.flatnonzero(mesh.points[:, 1] == 0.0)
    hull.data.vertices[int(line[len(line) // 2])].co.y = 2e-6 * mesh.size
    with pytest.raises(RuntimeError, match="Put on Centre Plane"):
        bpy.ops.hull.make_whole()
    assert hull.hull.half
    assert bpy.ops.hull.put_on_centre_plane() == {"FINISHED"}
    assert bpy.ops.hull.make_whole() == {"FINISHED"}
    assert numbers(hull) == pytest.approx(before, rel=ALIKE)


def test_the_mesh_comes_back_with_its_tags():
    hull = sample("coaster")
    arrays = part("bridge.mesh.mesh_arrays")
    before = arrays.read_mesh(hull.data)
    bpy.ops.hull.make_whole()
    whole = arrays.read_mesh(hull.data)
    assert np.count_nonzero(whole.points[:, 1] < 0) == np.count_nonzero(before.points[:, 1] > 0)
    assert np.array_equal(whole.points[: len(before.points)], before.points)
    assert np.array_equal(whole.face_slots, np.tile(before.face_slots, 2))
    bpy.ops.hull.make_half()
    after = arrays.read_mesh(hull.data)
    for name in ("points", "face_sizes", "face_vertices", "face_slots", "vertex_creases"):
        assert np.array_equal(getattr(after, name), getattr(before, name)), name
    inner = ~(before.points[before.tagged_edges][:, :, 1] == 0.0).all(axis=1)
    pairs = {
        tuple(sorted(e)) for e in before.tagged_edges[inner & (before.edge_creases > 0)].tolist()
    }
    again = ~(after.points[after.tagged_edges][:, :, 1] == 0.0).all(axis=1)
    assert pairs == {
        tuple(sorted(e)) for e in after.tagged_edges[again & (after.edge_creases > 0)].tolist()
    }


def test_starboard_may_be_kept():
    hull = sample("coaster")
    before = numbers(hull)
    bpy.ops.hull.make_whole()
    assert bpy.ops.hull.make_half(side="STARBOARD") == {"FINISHED"}
    assert mesh_points(hull)[:, 1].min() == 0.0
    assert numbers(hull) == pytest.approx(before, rel=ALIKE)
    assert not state_of(hull).ship.check.problems


@pytest.mark.parametrize("side", ["PORT", "STARBOARD"])
def test_flat_regions_come_along(side):
    hull, flats = add_hull(), part("features.constraints.flats")
    planes = [(0.0, 1.0, 0.0, HALF_BREADTH), (0.0, 0.0, 1.0, 0.0)]
    for plane in planes:
        flats.mark(hull, faces_in(hull, plane), plane)
    bpy.ops.hull.make_whole()
    found = {(region.kind, len(region.faces)): region.plane for region in flats.regions(hull)}
    kinds = [region.kind for region in flats.regions(hull)]
    assert sorted(kinds) == ["BOTTOM", "SIDE", "SIDE"] and found[("BOTTOM", 2)][3] == 0.0
    sides = [r.plane[3] * r.plane[1] for r in flats.regions(hull) if r.kind == "SIDE"]
    assert sorted(sides) == [-HALF_BREADTH, HALF_BREADTH]
    bpy.ops.hull.make_half(side=side)
    assert len(hull.hull.flats) == 2
    kept = {region.kind: region.plane * region.plane[:3].sum() for region in flats.regions(hull)}
    assert kept["SIDE"].tolist() == list(planes[0]) and kept["BOTTOM"].tolist() == list(planes[1])


def test_the_deck_edge_comes_along():
    hull = add_hull()
    marks = part("bridge.mesh.deck_edge_marks")
    marked = np.arange(len(hull.data.edges)) == 2
    marks.store_marks(hull.data, marked)
    bpy.ops.hull.make_whole()
    assert np.count_nonzero(marks.stored_marks(hull.data)) == 2


def edit(hull, change):
    bm = bmesh.new()
    bm.from_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    change(bm)
    bm.to_mesh(hull.data)
    bm.free()
    bpy.context.view_layer.update()


def test_points_on_the_other_side_are_refused():
    hull = add_hull()
    edit(hull, lambda bm: setattr(bm.verts[0].co, "y", -0.5))
    before = mesh_points(hull)
    with pytest.raises(RuntimeError, match="1 point of the half hull to starboard"):
        bpy.ops.hull.make_whole()
    assert np.array_equal(mesh_points(hull), before) and hull.hull.half


def whole_box_with_faces_across():
    hull = add_hull()
    bpy.ops.hull.make_whole()

    def dissolve(bm):
        keel = [e for e in bm.edges if all(v.co.y == 0.0 and v.co.z == 0.0 for v in e.verts)]
        bmesh.ops.dissolve_edges(bm, edges=keel)

    edit(hull, dissolve)
    return hull


def test_faces_across_are_refused_or_cut():
    hull = whole_box_with_faces_across()
    before = numbers(hull)
    with pytest.raises(RuntimeError, match="1 faces reach across"):
        bpy.ops.hull.make_half()
    assert not hull.hull.half
    assert bpy.ops.hull.make_half(cut=True) == {"FINISHED"}
    assert numbers(hull) == pytest.approx(before, rel=ALIKE)
    assert len(hull.data.polygons) == 4


def whole_of_two_sides(over=0.0):
    """A box of two sides that are no one mesh; each reaches over the centre plane so far."""
    hull = add_hull()

    def add_starboard(bm):
        for vertex in bm.verts:
            vertex.co.y = vertex.co.y or -over
        made = bmesh.ops.duplicate(bm, geom=[*bm.verts, *bm.edges, *bm.faces])["geom"]
        faces = [part for part in made if isinstance(part, bmesh.types.BMFace)]
        for vertex in {vertex for face in faces for vertex in face.verts}:
            vertex.co.y = -vertex.co.y
        bmesh.ops.reverse_faces(bm, faces=faces)

    hull.hull.half = False
    edit(hull, add_starboard)
    return hull


@pytest.mark.parametrize("side", ["PORT", "STARBOARD"])
def test_sides_that_overlap_leave_no_slivers(side):
    over = 0.01
    hull = whole_of_two_sides(over)
    assert len(hull.data.polygons) == 8
    with pytest.raises(RuntimeError, match="3 faces reach across"):
        bpy.ops.hull.make_half(side=side)
    made = part("features.modelling.mirroring").to_half(hull, bpy.context.scene, side, cut=True)
    assert made.overlap == pytest.approx(over)
    assert len(hull.data.polygons) == 4 and len(hull.data.vertices) == 8
    y = mesh_points(hull)[:, 1]
    assert y.min() == 0.0 and y.max() == HALF_BREADTH
    assert state_of(hull).status == "" and state_of(hull).ship.check.problems == ()


def test_the_centre_line_of_two_sides_is_joined():
    joined, hull = add_hull("joined"), whole_of_two_sides()
    make_active(joined)
    assert bpy.ops.hull.make_whole() == {"FINISHED"}
    (problem,) = state_of(hull).ship.check.problems
    assert (problem.severity, problem.remedy, problem.kind) == ("warning", "JOIN", "vertex")
    assert problem.message.startswith("4 points of the centre line are there twice")
    assert len(problem.elements) == 8
    make_active(hull)
    assert bpy.ops.hull.join_centre_line() == {"FINISHED"}
    assert state_of(hull).ship.check.problems == ()
    assert len(hull.data.vertices) == 12
    for attribute in ("vertices", "edges", "polygons"):
        assert len(getattr(hull.data, attribute)) == len(getattr(joined.data, attribute))
    assert numbers(hull) == pytest.approx(numbers(joined), rel=ALIKE)
    creases = part("bridge.blender.blender_versions").edge_creases
    assert np.array_equal(np.sort(creases(hull.data)), np.sort(creases(joined.data)))
    with pytest.raises(RuntimeError, match="there twice"):
        bpy.ops.hull.join_centre_line()


def test_a_half_of_two_sides_leaves_nothing_of_the_other():
    hull = whole_of_two_sides()
    assert bpy.ops.hull.make_half() == {"FINISHED"}
    assert (len(hull.data.polygons), len(hull.data.vertices), len(hull.data.edges)) == (4, 8, 11)


def without_tags(hull):
    """The hull, with a mesh that never had a crease or a corner."""
    mesh = bpy.data.meshes.new(hull.name)
    faces = [tuple(polygon.vertices) for polygon in hull.data.polygons]
    mesh.from_pydata([tuple(vertex.co) for vertex in hull.data.vertices], [], faces)
    hull.data = mesh
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    return hull


@pytest.mark.parametrize("side", ["PORT", "STARBOARD"])
def test_a_half_of_two_sides_without_a_tag(side):
    hull = without_tags(whole_of_two_sides())
    assert bpy.ops.hull.make_half(side=side) == {"FINISHED"}
    assert (len(hull.data.polygons), len(hull.data.vertices)) == (4, 8)


def test_a_centre_line_without_a_tag_is_joined():
    hull = without_tags(whole_of_two_sides())
    assert bpy.ops.hull.join_centre_line() == {"FINISHED"}
    assert len(hull.data.vertices) == 12
    # What was a border is a crease: bottom of two faces, transom and front of one.
    creases = part("bridge.blender.blender_versions").edge_creases(hull.data)
    assert np.count_nonzero(np.asarray(creases)) == 3


def test_borders_that_meet_no_other_are_no_slit():
    """Neither an open deck and the ends of a whole hull are named, nor a side without the other."""
    hull = add_hull()
    bpy.ops.hull.make_whole()
    assert state_of(hull).ship.check.problems == ()
    other = whole_of_two_sides()
    edit(other, lambda bm: bmesh.ops.delete(bm, geom=list(bm.faces)[4:], context="FACES"))
    remedies = [problem.remedy for problem in state_of(other).ship.check.problems]
    assert "JOIN" not in remedies


def test_what_differs_is_told():
    hull = add_hull()
    bpy.ops.hull.make_whole()
    starboard = int(np.argmin(mesh_points(hull)[:, 1]))
    edit(hull, lambda bm: setattr(bm.verts[starboard].co, "y", -2.5))
    made = part("features.modelling.mirroring").to_half(hull, bpy.context.scene)
    assert made.difference == pytest.approx(0.5) and made.smooth_edges == 0


def test_a_smooth_keel_is_told():
    hull = add_hull()
    bpy.ops.hull.make_whole()
    blender_versions = part("bridge.blender.blender_versions")

    def smooth(bm):
        layer, _ = blender_versions.ensure_crease_layers(bm)
        for edge in bm.edges:
            if all(v.co.y == 0.0 for v in edge.verts):
                edge[layer] = 0.0

    edit(hull, smooth)
    assert part("features.modelling.mirroring").to_half(hull, bpy.context.scene).smooth_edges == 3


def test_twice_is_refused_and_shared_meshes_are():
    hull = add_hull()
    with pytest.raises(RuntimeError, match="a half already"):
        bpy.ops.hull.make_half()
    other = hull.copy()
    with pytest.raises(RuntimeError, match="2 objects share the mesh"):
        bpy.ops.hull.make_whole()
    bpy.data.objects.remove(other)
    bpy.ops.hull.make_whole()
    with pytest.raises(RuntimeError, match="whole already"):
        bpy.ops.hull.make_whole()


def test_one_undo_step():
    hull = add_hull()
    bpy.ops.ed.undo_push(message="half")
    bpy.ops.hull.make_whole()
    bpy.ops.ed.undo_push(message="whole")
    bpy.ops.ed.undo()
    hull = bpy.data.objects["box"]
    assert hull.hull.half and len(hull.data.polygons) == 4
    bpy.ops.ed.redo()
    hull = bpy.data.objects["box"]
    assert not hull.hull.half and len(hull.data.polygons) == 8


@pytest.mark.parametrize("in_edit_mode", [False, True])
def test_faces_are_turned_outwards_each_part_by_itself(in_edit_mode):
    hull = sample("coaster")
    before = numbers(hull)
    random = np.random.default_rng(5)

    def flip_some(bm):
        faces = [face for face in bm.faces if random.random() < 0.4]
        bmesh.ops.reverse_faces(bm, faces=faces)

    good = [tuple(polygon.vertices) for polygon in hull.data.polygons]
    edit(hull, flip_some)
    if in_edit_mode:
        bpy.ops.object.mode_set(mode="EDIT")
    turned = part("features.modelling.face_turning").turn_outwards(hull)
    assert turned
    bpy.ops.object.mode_set(mode="OBJECT")
    again = [tuple(polygon.vertices) for polygon in hull.data.polygons]
    assert all(b in {a[k:] + a[:k] for k in range(len(a))} for a, b in zip(good, again))
    assert numbers(hull) == pytest.approx(before, rel=1e-12)
    assert part("features.modelling.face_turning").turn_outwards(hull) == 0
