# SPDX-License-Identifier: GPL-3.0-or-later
"""Borders that lie on one another are joined, with their tags; where a hull has no volume its panel
has the buttons that help."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, hull_io, mesh_points, part, sample, state_of
from edited_hulls import edit
from test_hulls_of_others import hull_of, hulls_of_others, state_now
from test_panels import texts


def volume(hull):
    return state_now(hull).hydrostatics.values.displaced_volume


def yacht(torn=True):
    folder = part("features.hull.samples").sample_files()
    data = hull_io().read_hull(folder["sailing_yacht"])
    return hull_of(hulls_of_others.torn(data) if torn else data)


def doubled(hull):
    return [p for p in state_now(hull).ship.check.problems if p.remedy == "POINTS"]


def creases(hull):
    values = part("bridge.blender.blender_versions").edge_creases(hull.data)
    ends = [tuple(sorted(map(tuple, (hull.data.vertices[v].co for v in edge.vertices))))
            for edge in hull.data.edges]  # fmt: skip
    return {pair for pair, value in zip(ends, values) if value == 1.0}


def test_a_torn_sheet_becomes_the_one_that_it_was():
    whole, hull = yacht(torn=False), yacht()
    (problem,) = doubled(hull)
    more = len(hull.data.vertices) - len(whole.data.vertices)
    assert problem.message.startswith(f"{more} points of borders are there twice, within 0.0")
    assert len(problem.elements) == 2 * more and problem.severity == "warning"
    assert volume(hull) != pytest.approx(volume(whole), rel=1e-9)
    assert bpy.ops.hull.join_points(smooth=True) == {"FINISHED"}
    for kind in ("vertices", "edges", "polygons"):
        assert len(getattr(hull.data, kind)) == len(getattr(whole.data, kind))
    assert creases(hull) == creases(whole) and not doubled(hull)
    assert volume(hull) == pytest.approx(volume(whole), rel=1e-12)
    with pytest.raises(RuntimeError, match="No points of borders are there twice"):
        bpy.ops.hull.join_points()


def test_a_surface_is_the_same_where_joined_edges_become_creases():
    hull = yacht()
    before, points = volume(hull), len(hull.data.vertices)
    tagged = creases(hull)
    bpy.ops.ed.undo_push(message="torn")
    assert bpy.ops.hull.join_points() == {"FINISHED"}
    bpy.ops.ed.undo_push(message="joined")
    assert volume(hull) == pytest.approx(before, rel=1e-7)
    assert creases(hull) > tagged and not doubled(hull)
    bpy.ops.ed.undo()
    hull = bpy.context.view_layer.objects.active
    assert len(hull.data.vertices) == points and len(doubled(hull)) == 1


def is_low(edge):
    """Whether an edge of the box is where its bottom meets side and ends."""
    return all(vertex.co.z == 0.0 for vertex in edge.verts) and len(edge.link_faces) > 0


def cut_box():
    """The half box, whose bottom has borders of its own at side and ends; of the two at the side
    one is a crease, the other one marked as deck edge, and a point of one has what is a user's own.
    """
    hull = add_hull()
    bm = bmesh.new()
    bm.from_mesh(hull.data)
    creases, _ = part("bridge.blender.blender_versions").ensure_crease_layers(bm)
    mark = bm.edges.layers.int.new("hull_deck_edge")
    own = bm.verts.layers.int.new("own")
    cut = [edge for edge in bm.edges if is_low(edge) and len(edge.link_faces) == 2]
    assert len(cut) == 3
    for edge in cut:
        edge[creases] = 0.0
    bmesh.ops.split_edges(bm, edges=cut)
    at_side = [e for e in bm.edges if is_low(e) and all(v.co.y > 0.0 for v in e.verts)]
    assert len(at_side) == 2
    at_side[0][creases], at_side[1][mark] = 1.0, 1
    at_side[0].verts[0][own] = 7
    bm.to_mesh(hull.data)
    bm.free()
    hull.hull.draft = 1.5
    return hull


def test_tags_of_both_borders_and_points_stay():
    hull = cut_box()
    assert len(doubled(hull)) == 1
    assert bpy.ops.hull.join_points(smooth=True) == {"FINISHED"}
    points = mesh_points(hull)
    ends = [points[list(edge.vertices)] for edge in hull.data.edges]
    at_side = [(at[:, 2] == 0.0).all() and (at[:, 1] > 0.0).all() for at in ends]
    (edge,) = np.flatnonzero(at_side).tolist()
    assert part("bridge.blender.blender_versions").edge_creases(hull.data)[edge] == 1.0
    marks = [value.value for value in hull.data.attributes["hull_deck_edge"].data]
    assert [i for i, mark in enumerate(marks) if mark] == [edge]
    assert [value.value for value in hull.data.attributes["own"].data if value.value] == [7]


def test_points_are_joined_in_edit_mode():
    hull = cut_box()
    count = len(hull.data.vertices)
    edit(hull)
    assert bpy.ops.hull.join_points() == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    assert len(hull.data.vertices) < count and not doubled(hull)


def test_borders_that_do_not_make_one_surface_are_left():
    """Two in the same sense, as of a sheet turned over."""
    hull = cut_box()
    bm = bmesh.new()
    bm.from_mesh(hull.data)
    bottom = next(face for face in bm.faces if all(v.co.z == 0.0 for v in face.verts))
    bmesh.ops.reverse_faces(bm, faces=[bottom])
    bm.to_mesh(hull.data)
    bm.free()
    assert not doubled(hull)
    before = mesh_points(hull)
    with pytest.raises(RuntimeError, match="there twice"):
        bpy.ops.hull.join_points()
    assert np.array_equal(mesh_points(hull), before)


def test_samples_have_no_such_points():
    for name in part("features.hull.samples").sample_files():
        assert not doubled(sample(name)), name


def test_a_panel_has_the_buttons_of_what_it_says():
    hull = sample("coaster")
    hull.data.flip_normals()
    state_now(hull)
    said = texts()["HULL_PT_hydrostatics"]
    assert any("turned inwards" in text for text in said)
    assert "operator hull.turn_outwards" in said
    assert bpy.ops.hull.turn_outwards() == {"FINISHED"}
    assert state_of(hull).hydrostatics.values is not None
    assert "operator hull.turn_outwards" not in texts()["HULL_PT_hydrostatics"]


def test_a_hull_whose_sides_are_apart_is_closed_as_a_half():
    hull = add_hull()
    for vertex in hull.data.vertices:
        x, y, z = vertex.co
        vertex.co.y = y or 0.1 * (z == 0.0) * (10.0 - x)
    hull.data.update()
    hull.hull.draft = 1.5
    wanted = volume(hull)
    hull.hull.half = False
    bm = bmesh.new()
    bm.from_mesh(hull.data)
    made = bmesh.ops.duplicate(bm, geom=[*bm.verts, *bm.edges, *bm.faces])["geom"]
    for vertex in (v for v in made if isinstance(v, bmesh.types.BMVert)):
        vertex.co.y = -vertex.co.y
    faces = [face for face in made if isinstance(face, bmesh.types.BMFace)]
    bmesh.ops.reverse_faces(bm, faces=faces)
    bm.to_mesh(hull.data)
    bm.free()
    state, said = state_now(hull), texts()["HULL_PT_hydrostatics"]
    values = state.hydrostatics
    assert "Make Half" in (values.status or values.values.remark)
    assert {"operator hull.make_half", "operator hull.select_creases"} <= set(said)
    assert bpy.ops.hull.select_creases(kind="BORDER") == {"FINISHED"}
    assert hull.mode == "EDIT"
    bpy.ops.object.mode_set(mode="OBJECT")
    assert bpy.ops.hull.make_half() == {"FINISHED"}
    assert not state_now(hull).hydrostatics.values.remark
    assert volume(hull) == pytest.approx(wanted, rel=1e-9)
