# SPDX-License-Identifier: GPL-3.0-or-later
"""The deck edge that a designer marks: stored with the mesh, counted in the righting levers."""

from math import atan

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import DEPTH, HALF_BREADTH, LENGTH, make_active, part, state_of

RAIL = 2.0  # of the box with bulwarks: the deck's edge, a knuckle in her sides
DRAFT = 1.0


def add_bulwark_box(name="bulwarks"):
    """The port half of a box whose deck meets the sides below their upper border."""
    levels = (0.0, RAIL, DEPTH)
    points = [(x, y, z) for x in (0.0, LENGTH) for y in (0.0, HALF_BREADTH) for z in levels]
    faces = [(0, 3, 9, 6)]  # bottom
    for low in (0, 1):
        faces += [
            (3 + low, 4 + low, 10 + low, 9 + low),  # side
            (low, low + 1, low + 4, low + 3),  # aft
            (6 + low, 9 + low, 10 + low, 7 + low),  # forward
        ]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, [], faces)
    part("bridge.blender.blender_versions").set_creases(mesh, range(len(mesh.edges)), [])
    box = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(box)
    make_active(box)
    assert bpy.ops.hull.make_hull(half=True) == {"FINISHED"}
    assert not state_of(box).ship.check.problems
    box.hull.draft, box.hull.loading.kg = DRAFT, 1.2
    bpy.context.view_layer.update()
    return box


def select_edges(hull, *pairs):
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.context.tool_settings.mesh_select_mode = (False, True, False)
    bm = bmesh.from_edit_mesh(hull.data)
    wanted = [set(pair) for pair in pairs]
    for edge in bm.edges:
        edge.select_set({vertex.index for vertex in edge.verts} in wanted)
    bm.select_flush_mode()
    bmesh.update_edit_mesh(hull.data)


def mark(hull, *pairs):
    select_edges(hull, *pairs)
    assert bpy.ops.hull.mark_deck_edge() == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.context.view_layer.update()


def marked(hull):
    marks = part("bridge.mesh.deck_edge_marks").stored_marks(hull.data)
    return {tuple(sorted(hull.data.edges[i].vertices)) for i in np.flatnonzero(marks)}


def deck_edge_heel(hull):
    result = part("features.analyses").result_of(hull, bpy.context.scene, "righting_levers")
    return result.levers.deck_edge_heel


SIDE = (4, 10)  # the knuckle along the side, at RAIL


def test_without_a_mark_it_is_the_border():
    hull = add_bulwark_box()
    # The water turns about the centre line until the bilge comes out: at 26.6°, when the rail
    # of a box this deep is far above it.
    assert deck_edge_heel(hull) > atan((RAIL - DRAFT) / HALF_BREADTH)
    assert state_of(hull).ship.source.deck_edge == ()


def test_the_marked_crease_counts():
    hull = add_bulwark_box()
    mark(hull, SIDE)
    assert marked(hull) == {SIDE}
    # At this heel the bilge just comes out, and the water still turns about the centre line.
    assert deck_edge_heel(hull) == pytest.approx(atan((RAIL - DRAFT) / HALF_BREADTH), rel=1e-9)


def remarks(hull):
    """What levers and criteria say of what they rest on."""
    scene, analyses = bpy.context.scene, part("features.analyses")
    levers = analyses.result_of(hull, scene, "righting_levers")
    criteria = analyses.result_of(hull, scene, "criteria")
    assert criteria.report.deck_edge_heel == pytest.approx(levers.levers.deck_edge_heel, abs=1e-9)
    return [list(levers.remarks()), list(criteria.remarks)]


def test_an_open_transom_is_a_deck_edge_at_0_until_another_is_marked():
    hull = add_bulwark_box()
    for vertex in hull.data.vertices:  # a transom swept forward at its sides: longer than high
        vertex.co.x += 0.5 * (vertex.co.x == 0.0 < vertex.co.y)
    bpy.context.view_layer.update()
    said = part("features.stability.loads").DECK_EDGE_UNDER_WATER
    assert not any(said in of_one for of_one in remarks(hull))
    bm = bmesh.new()
    bm.from_mesh(hull.data)
    transom = [face for face in bm.faces if all(vertex.co.x < 1.0 for vertex in face.verts)]
    bmesh.ops.delete(bm, geom=transom, context="FACES_ONLY")
    bm.to_mesh(hull.data)
    bm.free()
    bpy.context.view_layer.update()
    assert len(transom) == 2 and not state_of(hull).hydrostatics.status
    assert deck_edge_heel(hull) == 0.0
    assert all(said in of_one for of_one in remarks(hull))
    mark(hull, SIDE)
    assert deck_edge_heel(hull) == pytest.approx(atan((RAIL - DRAFT) / HALF_BREADTH), rel=1e-9)
    assert not any(said in of_one for of_one in remarks(hull))


def test_a_crease_is_marked_from_end_to_end():
    hull = add_bulwark_box()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide()
    bpy.ops.object.mode_set(mode="OBJECT")
    points = np.array([vertex.co for vertex in hull.data.vertices])
    rail = np.flatnonzero((points[:, 2] == RAIL) & (points[:, 1] == HALF_BREADTH))
    edges = {tuple(sorted(e.vertices)) for e in hull.data.edges if set(e.vertices) <= set(rail)}
    assert len(edges) == 2
    mark(hull, next(iter(edges)))
    assert marked(hull) == edges
    assert deck_edge_heel(hull) == pytest.approx(atan(0.5), rel=1e-9)


def test_a_division_divides_the_mark():
    hull = add_bulwark_box()
    mark(hull, SIDE)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide()
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.context.view_layer.update()
    assert len(marked(hull)) == 2
    assert deck_edge_heel(hull) == pytest.approx(atan(0.5), rel=1e-9)


def test_a_mark_changes_no_surface_but_the_levers():
    hull = add_bulwark_box()
    before = deck_edge_heel(hull)
    surface, body = state_of(hull).ship.surface, state_of(hull).ship.body
    mark(hull, SIDE)
    assert state_of(hull).ship.surface is surface and state_of(hull).ship.body is body
    after = deck_edge_heel(hull)
    assert after < before
    select_edges(hull)
    assert bpy.ops.hull.clear_deck_edge() == {"FINISHED"}
    assert deck_edge_heel(hull) == before
    assert bpy.ops.object.mode_set(mode="OBJECT") == {"FINISHED"} and not marked(hull)


def test_a_mark_replaces_the_one_before_and_can_be_selected():
    hull = add_bulwark_box()
    border = (5, 11)
    mark(hull, border)
    mark(hull, SIDE)
    assert marked(hull) == {SIDE}
    select_edges(hull, border)
    assert bpy.ops.hull.select_deck_edge() == {"FINISHED"}
    bm = bmesh.from_edit_mesh(hull.data)
    selected = [{vertex.index for vertex in edge.verts} for edge in bm.edges if edge.select]
    assert selected == [set(SIDE)]


def test_what_cannot_be_marked_says_why():
    hull = add_bulwark_box()
    select_edges(hull)
    with pytest.raises(RuntimeError, match="Select edges"):
        bpy.ops.hull.mark_deck_edge()
    with pytest.raises(RuntimeError, match="No edge is marked"):
        bpy.ops.hull.select_deck_edge()
    select_edges(hull, SIDE)
    bpy.ops.hull.tag_smooth()
    select_edges(hull, SIDE)
    with pytest.raises(RuntimeError, match="neither crease nor border of the shell: 1 of 1"):
        bpy.ops.hull.mark_deck_edge()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert not bpy.ops.hull.mark_deck_edge.poll()


def test_a_mark_on_a_crease_that_was_smoothed_is_told():
    hull = add_bulwark_box()
    mark(hull, SIDE)
    select_edges(hull, SIDE)
    bpy.ops.hull.tag_smooth()
    bpy.ops.object.mode_set(mode="OBJECT")
    with pytest.raises(ValueError, match="marked as deck edge 1 of 1 belong"):
        deck_edge_heel(hull)


def test_marks_survive_saving_copying_and_undo(tmp_path):
    hull = add_bulwark_box()
    bpy.ops.ed.undo_push(message="no mark")
    mark(hull, SIDE)
    bpy.ops.ed.undo_push(message="marked")
    bpy.ops.ed.undo()
    hull = bpy.data.objects["bulwarks"]
    assert not marked(hull) and state_of(hull).ship.source.deck_edge == ()
    bpy.ops.ed.redo()
    hull = bpy.data.objects["bulwarks"]
    assert marked(hull) == {SIDE} and len(state_of(hull).ship.source.deck_edge) == 1
    make_active(hull)
    bpy.ops.object.duplicate()
    copy = bpy.context.object
    assert copy != hull and marked(copy) == {SIDE}
    path = str(tmp_path / "marks.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.wm.open_mainfile(filepath=path)
    assert marked(bpy.data.objects["bulwarks"]) == {SIDE}
    assert deck_edge_heel(bpy.data.objects["bulwarks"]) == pytest.approx(atan(0.5), rel=1e-9)


def test_a_deck_edge_under_water_upright_is_said():
    hull = add_bulwark_box()
    analyses = part("features.analyses")

    def remarks():
        levers = analyses.result_of(hull, bpy.context.scene, "righting_levers")
        criteria = analyses.result_of(hull, bpy.context.scene, "criteria")
        return " ".join(levers.remarks()), " ".join(criteria.notes())

    assert not any("deck edge" in text for text in remarks())
    mark(hull, (3, 9))  # the chine
    assert all("deck edge is under water upright" in text for text in remarks())
