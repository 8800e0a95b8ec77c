# SPDX-License-Identifier: GPL-3.0-or-later
"""What edges, points and faces are to the surface: found, tagged, selected and drawn."""

from math import radians

import bmesh
import bpy
import pytest
from addon_under_test import add_box, add_hull, part, state_of
from edited_hulls import (
    BORDERS,
    KNUCKLES,
    at,
    edit,
    find,
    grid_hull,
    keys,
    select,
    selected,
    tags_of,
)


def test_edges_of_a_box_by_kind():
    found = tags_of(add_hull())
    assert {kind: len(edges) for kind, edges in found.edges.items()} == {
        "knuckle": KNUCKLES,
        "border": BORDERS,
        "deck_edge": 0,
    }
    # All points are corners by their creases, none by a tag; only two have three faces around.
    assert len(found.points["automatic_corner"]) == 8 and not len(found.points["corner"])
    assert not len(found.points["dart"]) and not len(found.odd_faces)


def test_the_deck_edge_is_of_no_other_kind():
    hull = add_hull()
    edit(hull)
    a, b = find(hull, 0, 2, 3), find(hull, 10, 2, 3)
    select(hull, "edge", [(a, b)])
    assert bpy.ops.hull.mark_deck_edge() == {"FINISHED"}
    found = tags_of(hull)
    assert keys(found.edges["deck_edge"]) == {tuple(sorted((a, b)))}
    assert len(found.edges["border"]) == BORDERS - 1
    assert bpy.ops.hull.select_creases(kind="DECK_EDGE") == {"FINISHED"}
    assert keys(selected(hull, "edge")) == {tuple(sorted((a, b)))}


def test_darts_corners_and_valences():
    hull = grid_hull()
    edit(hull)
    select(hull, "edge", [(at(2, 2), at(3, 2))])
    assert bpy.ops.hull.tag_crease() == {"FINISHED"}
    select(hull, "vertex", [at(1, 1)])
    assert bpy.ops.hull.tag_corner() == {"FINISHED"}
    found = tags_of(hull)
    assert sorted(found.points["dart"]) == [at(2, 2), at(3, 2)]
    assert sorted(found.points["corner"]) == [at(1, 1)]
    assert sorted(found.points["automatic_corner"]) == [at(i, j) for i in (0, 5) for j in (0, 4)]
    irregular = dict(zip(found.points["irregular"].tolist(), found.valences.tolist()))
    assert irregular == {at(1, 1): 4, at(2, 2): 4, at(3, 2): 4}


def test_valences_count_edges_on_borders_too():
    hull = grid_hull()
    bm = edit(hull)
    bm.faces.ensure_lookup_table()
    corner_face = next(f for f in bm.faces if {v.index for v in f.verts} >= {at(0, 0), at(1, 1)})
    bmesh.ops.poke(bm, faces=[corner_face])
    bmesh.update_edit_mesh(hull.data)
    found = tags_of(hull)
    irregular = dict(zip(found.points["irregular"].tolist(), found.valences.tolist()))
    # One face more for each of the four; with two the corner of the sheet is a regular border.
    assert irregular == {at(0, 1): 4, at(1, 0): 4, at(1, 1): 5}
    assert len(found.odd_faces) == 4
    assert all(len(vertices) == 3 for vertices in found.odd_face_vertices)


def test_known_tags_change_with_the_mesh_and_only_then():
    hull = grid_hull()
    of_state = part("features.hull.tags").of_state
    first = of_state(state_of(hull))
    hull.data.vertices[7].co.y += 0.1
    hull.data.update()
    bpy.context.view_layer.update()
    assert of_state(state_of(hull)) is first
    edit(hull)
    select(hull, "vertex", [at(1, 1)])
    bpy.ops.hull.tag_corner()
    bpy.context.view_layer.update()
    assert len(of_state(state_of(hull)).points["corner"]) == 1


def test_automatic_takes_back_a_corner_and_leaves_creases():
    hull = grid_hull()
    edit(hull)
    select(hull, "edge", [(at(2, 2), at(3, 2))])
    bpy.ops.hull.tag_crease()
    select(hull, "vertex", [at(2, 2), at(3, 2)])
    bpy.ops.hull.tag_corner()
    assert len(tags_of(hull).points["corner"]) == 2
    assert bpy.ops.hull.tag_automatic() == {"FINISHED"}
    found = tags_of(hull)
    assert not len(found.points["corner"]) and len(found.points["dart"]) == 2
    assert bpy.ops.hull.tag_smooth() == {"FINISHED"}
    assert not len(tags_of(hull).points["dart"])


def test_automatic_needs_a_selection():
    hull = grid_hull()
    edit(hull)
    with pytest.raises(RuntimeError, match="Select the points"):
        bpy.ops.hull.tag_automatic()


@pytest.mark.parametrize("angle, count", [(89.0, KNUCKLES), (91.0, 0)])
def test_creases_by_angle(angle, count):
    hull = add_hull()
    edit(hull)
    bpy.ops.mesh.select_all(action="SELECT")
    assert bpy.ops.hull.tag_by_angle(angle=radians(angle)) == {"FINISHED"}
    assert len(tags_of(hull).edges["knuckle"]) == count


def test_tags_work_on_a_mesh_that_is_no_hull():
    box = add_box()
    edit(box)
    bpy.ops.mesh.select_all(action="SELECT")
    for operator in ("tag_smooth", "tag_crease", "tag_corner", "tag_automatic", "tag_by_angle"):
        assert getattr(bpy.ops.hull, operator)() == {"FINISHED"}
    assert not bpy.ops.hull.select_creases.poll()


@pytest.mark.parametrize("operator", ["tag_crease", "tag_corner", "tag_by_angle"])
def test_tags_of_a_mesh_that_is_hidden_while_edited(operator):
    hull = add_hull()
    edit(hull)
    bpy.ops.mesh.select_all(action="SELECT")
    hull.hide_set(True)
    with pytest.raises(RuntimeError, match="What is edited is hidden here: show it"):
        getattr(bpy.ops.hull, operator)()


def test_tags_are_given_in_all_meshes_that_are_edited():
    boxes = [add_hull("one"), add_hull("other")]
    for box in boxes:
        box.select_set(True)
    bpy.ops.object.mode_set(mode="EDIT")
    assert {box.mode for box in boxes} == {"EDIT"}
    bpy.ops.mesh.select_all(action="SELECT")
    assert bpy.ops.hull.tag_by_angle(angle=radians(120.0)) == {"FINISHED"}
    assert [len(tags_of(box).edges["knuckle"]) for box in boxes] == [0, 0]
    bpy.ops.hull.tag_corner()
    bpy.ops.hull.tag_automatic()
    bpy.ops.hull.tag_crease()
    assert [len(tags_of(box).edges["knuckle"]) for box in boxes] == [KNUCKLES, KNUCKLES]


@pytest.mark.parametrize(
    "kind, count", [("ALL", KNUCKLES + BORDERS), ("KNUCKLE", KNUCKLES), ("BORDER", BORDERS)]
)
def test_select_creases(kind, count):
    hull = add_hull()
    edit(hull)
    assert bpy.ops.hull.select_creases(kind=kind) == {"FINISHED"}
    assert len(selected(hull, "edge")) == count
    assert tuple(bpy.context.tool_settings.mesh_select_mode) == (False, True, False)


def test_select_creases_says_when_there_are_none():
    hull = grid_hull()
    edit(hull)
    with pytest.raises(RuntimeError, match="has none"):
        bpy.ops.hull.select_creases(kind="KNUCKLE")


def test_extending_keeps_what_is_selected():
    hull = grid_hull()
    edit(hull)
    inner = (at(2, 2), at(3, 2))
    select(hull, "edge", [inner])
    bpy.ops.hull.select_creases(kind="BORDER", extend=True)
    borders = 2 * (5 + 4)
    assert len(selected(hull, "edge")) == borders + 1
    bpy.ops.hull.select_creases(kind="BORDER")
    assert len(selected(hull, "edge")) == borders


def test_select_chains():
    hull = grid_hull()
    edit(hull)
    # One of the border's edges along the keel, which goes from corner to corner.
    select(hull, "edge", [(at(2, 0), at(3, 0))])
    assert bpy.ops.hull.select_chains() == {"FINISHED"}
    assert keys(selected(hull, "edge")) == keys([(at(i, 0), at(i + 1, 0)) for i in range(5)])
    select(hull, "edge", [(at(2, 2), at(3, 2))])
    with pytest.raises(RuntimeError, match="crease or border"):
        bpy.ops.hull.select_chains()


def test_select_points():
    hull = grid_hull()
    bm = edit(hull)
    bm.faces.ensure_lookup_table()
    bmesh.ops.poke(bm, faces=[f for f in bm.faces if {v.index for v in f.verts} >= {at(2, 2)}])
    bmesh.update_edit_mesh(hull.data)
    middle = at(2, 2)
    assert bpy.ops.hull.select_points(kind="IRREGULAR", least_edges=7) == {"FINISHED"}
    assert selected(hull, "vertex") == [middle]
    bpy.ops.hull.select_points(kind="AUTOMATIC_CORNER")
    assert selected(hull, "vertex") == [at(i, j) for i in (0, 5) for j in (0, 4)]
    bpy.ops.hull.select_odd_faces()
    assert len(selected(hull, "face")) == 16
    with pytest.raises(RuntimeError, match="has none"):
        bpy.ops.hull.select_points(kind="DART")


def test_hidden_elements_stay_hidden():
    hull = grid_hull()
    edit(hull)
    select(hull, "vertex", [at(0, 0)])
    bpy.ops.mesh.hide()
    bpy.ops.hull.select_points(kind="AUTOMATIC_CORNER")
    assert selected(hull, "vertex") == [at(0, 4), at(5, 0), at(5, 4)]


def test_select_problems_selects_what_makes_the_mesh_bad():
    hull = grid_hull()
    bm = edit(hull)
    extra = bm.verts.new((2.5, 9.0, 2.0))
    bm.verts.ensure_lookup_table()
    bm.faces.new((bm.verts[at(2, 2)], bm.verts[at(3, 2)], extra))
    bmesh.update_edit_mesh(hull.data)
    bpy.context.view_layer.update()
    assert state_of(hull).status
    assert bpy.ops.hull.select_problems() == {"FINISHED"}
    assert set(selected(hull, "vertex")) >= {at(2, 2), at(3, 2)}
    with pytest.raises(RuntimeError):
        bpy.ops.hull.select_creases()


def test_selecting_and_tagging_are_one_undo_step_each():
    hull = grid_hull()
    edit(hull)
    name = hull.name
    for operator in (
        lambda: bpy.ops.hull.select_creases("EXEC_DEFAULT", True, kind="BORDER"),
        lambda: bpy.ops.hull.tag_corner("EXEC_DEFAULT", True),
    ):
        bpy.ops.ed.undo_push(message="before")
        assert operator() == {"FINISHED"}
    assert len(tags_of(bpy.data.objects[name]).points["corner"]) == 2 * (5 + 4)
    bpy.ops.ed.undo()
    assert not len(tags_of(bpy.data.objects[name]).points["corner"])
    assert len(selected(bpy.data.objects[name], "edge")) == 2 * (5 + 4)
