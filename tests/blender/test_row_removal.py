# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of control points taken away: what was inserted goes again, tags and all, and what would
change the surface too much stays."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import ROOT, mesh_points, part, sample, state_of
from edited_hulls import at, edit, grid_hull, select, selected

SAMPLES = sorted(path.name[: -len(".hull.json")] for path in (ROOT / "samples").glob("*.hull.json"))


def surface_of(hull):
    state = part("features.hull.hull_state").up_to_date(hull, bpy.context.scene)
    return state.ship.source.new_surface()


def apart(old, new):
    points = new.tessellate(7).points
    native = part("bridge.native").require()
    return native.SurfaceTree(old).closest_points(points).distances.max()


def insert(hull, kind, elements):
    edit(hull, (False, kind == "edge", kind == "face"))
    select(hull, kind, elements)
    return part("features.modelling.row_insertion").insert_rows(hull, bpy.context.scene)


def remove(hull, tolerance):
    return part("features.modelling.row_removal").remove_row(hull, bpy.context.scene, tolerance)


def facts(hull):
    """Of points and edges what tools may not lose, without their places."""
    data = hull.data
    native = state_of(hull).ship.source.control
    return (
        len(data.vertices),
        len(data.edges),
        sorted(polygon.loop_total for polygon in data.polygons),
        len(native.creases),
        len(native.corners),
    )


def ring_edge(hull):
    """An edge of a longest ring of smooth quads: the row across it is away from knuckles."""
    insertion = part("features.modelling.row_insertion")
    bm = bmesh.new()
    bm.from_mesh(hull.data)
    shell = set(state_of(hull).ship.source.control.face_ids.tolist())
    best = max(
        (insertion._ring(edge, None) for edge in bm.edges if edge.link_faces),
        key=lambda ring: (
            all(face.index in shell for face in ring.quads) and len(set(ring.edges)) > 3,
            -ring.ends(),
            len(ring.edges),
        ),
    )
    found = [vertex.index for vertex in best.edges[len(best.edges) // 2].verts]
    bm.free()
    return found


@pytest.mark.parametrize("name", SAMPLES)
def test_what_is_inserted_can_be_removed(name):
    hull = sample(name)
    old, before, size = surface_of(hull), facts(hull), max(hull.dimensions)
    inserted = insert(hull, "edge", [ring_edge(hull)])
    points = selected(hull, "vertex")
    assert len(points) == inserted.count
    found = remove(hull, size)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert found.count == inserted.count and facts(hull) == before
    assert found.change <= found.bare_change + 1e-6 * size
    # From the surface between; that is as far from the first as it was told to be.
    assert apart(old, surface_of(hull)) < 1.05 * (found.change + inserted.change) + 1e-6 * size
    assert not state_of(hull).status


def test_the_surface_comes_back():
    """By the operator with its own tolerance."""
    bpy.ops.hull.add_hull(kind="ROUND_BILGE", length=80.0, beam=13.0, draft=5.0, depth=7.0)
    hull = bpy.context.view_layer.objects.active
    old = surface_of(hull)
    inserted = insert(hull, "edge", [ring_edge(hull)])
    assert bpy.ops.hull.remove_row() == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    assert apart(old, surface_of(hull)) < 0.01 + inserted.change


def middle_row(hull):
    """The edges of the row j = 2 of a grid, which runs along x."""
    return [(at(i, 2), at(i + 1, 2)) for i in range(5)]


def test_too_large_a_change_is_refused_and_nothing_changes():
    hull = grid_hull()
    hull.data.vertices[at(2, 2)].co.y += 0.5
    edit(hull, (False, True, False))
    select(hull, "edge", middle_row(hull))
    bpy.ops.object.mode_set(mode="OBJECT")
    points, before = mesh_points(hull), facts(hull)
    meshes, objects = len(bpy.data.meshes), len(bpy.data.objects)
    bpy.ops.object.mode_set(mode="EDIT")
    chosen = selected(hull, "edge")
    with pytest.raises(RuntimeError, match=r"Without the row the surface would be [\d.]+ .*m from"):
        bpy.ops.hull.remove_row(tolerance=1e-3)
    assert np.array_equal(chosen, selected(hull, "edge"))
    bpy.ops.object.mode_set(mode="OBJECT")
    assert np.array_equal(points, mesh_points(hull)) and facts(hull) == before
    assert (meshes, objects) == (len(bpy.data.meshes), len(bpy.data.objects))


def test_one_edge_stands_for_its_row():
    hull = grid_hull()
    edit(hull, (False, True, False))
    select(hull, "edge", [middle_row(hull)[2]])
    assert remove(hull, 10.0).count == 6
    bpy.ops.object.mode_set(mode="OBJECT")
    assert len(hull.data.vertices) == 24 and len(hull.data.polygons) == 15


def test_tags_across_the_row_stay():
    hull = grid_hull()
    edit(hull, (False, True, False))
    across = [(at(3, j), at(3, j + 1)) for j in range(4)]
    select(hull, "edge", across)
    assert bpy.ops.hull.tag_crease() == {"FINISHED"}
    select(hull, "edge", middle_row(hull))
    remove(hull, 10.0)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert len(state_of(hull).ship.source.control.creases) == 3


@pytest.mark.parametrize(
    "tag, edges, text",
    [
        ("crease", "row", "The row is a knuckle"),
        ("crease", "half across", "A knuckle ends at the row"),
        ("lock", "row", "Points of the row are locked"),
        ("none", "border", "runs along a border"),
        ("none", "cross", "Rows meet"),
        ("none", "nothing", "Select the row"),
    ],
)
def test_what_cannot_be_removed_is_said(tag, edges, text):
    hull = grid_hull()
    edit(hull, (False, True, False))
    row = middle_row(hull)
    across = [(at(3, j), at(3, j + 1)) for j in range(4)]
    tagged = {"half across": across[:2]}.get(edges, row)
    select(hull, "edge", tagged)
    if tag == "crease":
        bpy.ops.hull.tag_crease()
    elif tag == "lock":
        bpy.ops.hull.lock_points()
    border = [(at(i, 0), at(i + 1, 0)) for i in range(5)]
    chosen = {"border": border, "cross": row + across, "nothing": []}.get(edges, row)
    select(hull, "edge", chosen)
    with pytest.raises(RuntimeError, match=text):
        bpy.ops.hull.remove_row(tolerance=10.0)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert len(hull.data.vertices) == 30


@pytest.mark.parametrize("tolerance", [-1.0, 1e30, float("nan")])
def test_tolerances_without_sense_are_refused(tolerance):
    hull = grid_hull()
    edit(hull, (False, True, False))
    select(hull, "edge", middle_row(hull))
    with pytest.raises(ValueError, match="Tolerance"):
        remove(hull, tolerance)
    bpy.ops.object.mode_set(mode="OBJECT")


def test_a_row_runs_across_chosen_faces_alone_and_back():
    hull = grid_hull()
    old, before = surface_of(hull), facts(hull)
    points = mesh_points(hull)
    strip = [face.index for face in hull.data.polygons if set(face.vertices) <= strip_points()]
    assert len(strip) == 3
    found = insert(hull, "face", strip)
    assert found.count == 4 and found.ends == 2
    bpy.ops.object.mode_set(mode="OBJECT")
    assert facts(hull)[0] == before[0] + 4
    assert sorted(polygon.loop_total for polygon in hull.data.polygons).count(5) == 2
    assert found.change < found.cut_change
    bpy.ops.object.mode_set(mode="EDIT")
    back = remove(hull, 10.0)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert back.count == 4 and facts(hull) == before
    assert apart(old, surface_of(hull)) < found.change + back.change + 1e-5
    assert len(points) == len(mesh_points(hull))


def strip_points():
    return {at(i, j) for i in (1, 2, 3, 4) for j in (1, 2)}


def test_faces_that_do_not_tell_the_way_are_refused():
    hull = grid_hull()
    edit(hull, (False, False, True))
    select(hull, "face", [0])
    with pytest.raises(RuntimeError, match="as many one way as the other"):
        bpy.ops.hull.insert_row()
    bpy.ops.object.mode_set(mode="OBJECT")


def test_removal_is_one_step_of_undo():
    hull = grid_hull()
    points = mesh_points(hull)
    edit(hull, (False, True, False))
    select(hull, "edge", middle_row(hull))
    bpy.ops.ed.undo_push(message="before")
    assert bpy.ops.hull.remove_row(tolerance=10.0) == {"FINISHED"}
    bpy.ops.ed.undo_push(message="removed")
    bpy.ops.ed.undo()
    hull = bpy.context.view_layer.objects.active
    bpy.ops.object.mode_set(mode="OBJECT")
    assert np.array_equal(points, mesh_points(hull))


def test_faces_that_meet_twice_go_as_a_whole():
    bm = bmesh.new()
    places = ((-1, -1), (0, -1), (-1, 1), (0, 1), (1, 1))
    points = [bm.verts.new((x, y, 0.0)) for x, y in places]
    for face in ((0, 1, 3, 2), (1, 0, 4, 3)):
        bm.faces.new([points[i] for i in face])
    row = [bm.edges.get((points[a], points[b])) for a, b in ((1, 3), (0, 4))]
    count, beside, _ = part("features.modelling.row_removal")._dissolve(bm, row)
    assert count == 3 and len(beside) == len(bm.verts) == 2
    bm.free()
