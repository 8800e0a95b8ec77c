# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators do what the functions behind them do, are undone, and keep over saving."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import (
    DEPTH,
    HALF_BREADTH,
    LENGTH,
    add_box,
    add_hull,
    make_active,
    mesh_points,
    part,
    state_of,
)

VOLUME_AT_1 = LENGTH * 2.0 * HALF_BREADTH * 1.0


def edge_creases(obj):
    return part("bridge.blender.blender_versions").edge_creases(obj.data)


def vertex_creases(obj):
    return part("bridge.blender.blender_versions").vertex_creases(obj.data)


def select_in_edit_mode(obj, vertices):
    """Enters edit mode with exactly these vertices and the edges between them selected."""
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.context.tool_settings.mesh_select_mode = (True, False, False)
    bm = bmesh.from_edit_mesh(obj.data)
    for vertex in bm.verts:
        vertex.select_set(vertex.index in vertices)
    bm.select_flush_mode()
    bmesh.update_edit_mesh(obj.data)


def test_make_hull_fills_in_the_particulars_and_shows_surface_and_lines():
    hull = add_hull()
    settings = hull.hull
    assert (settings.length_pp, settings.beam, settings.depth) == (LENGTH, 4.0, DEPTH)
    assert settings.surface_object.parent == hull
    assert len(settings.surface_object.data.polygons) == 2 * 4 * 4 * settings.samples**2
    lines = state_of(hull).lines.groups
    assert {kind for kind, group in lines.items() if group.polylines} == {
        "station", "waterline", "buttock", "draft", "flat", "feature"
    }  # fmt: skip


def test_make_hull_gives_the_hydrostatics_of_a_box():
    hull = add_hull()
    hull.hull.draft = 1.0
    bpy.context.view_layer.update()
    found = state_of(hull).hydrostatics.values
    assert found.displaced_volume == pytest.approx(VOLUME_AT_1, rel=1e-12)
    assert found.displacement_t == pytest.approx(1.025 * VOLUME_AT_1, rel=1e-12)
    assert found.lcb == pytest.approx(LENGTH / 2, rel=1e-12)
    assert found.kb == pytest.approx(0.5, rel=1e-12)
    assert found.waterplane_area == pytest.approx(40.0, rel=1e-12)
    assert found.wetted_surface == pytest.approx(40.0 + 2.0 * (10.0 + 4.0), rel=1e-12)
    # KM = KB + B² / 12 T of a box.
    assert found.kmt == pytest.approx(0.5 + 16.0 / 12.0, rel=1e-12)


def test_operator_equals_function():
    by_operator = add_hull("by operator")
    by_function = add_box("by function")
    part("features.hull.hull_creation").make_hull(by_function, bpy.context.scene, True)
    assert state_of(by_operator).hydrostatics.values == state_of(by_function).hydrostatics.values
    first, second = (obj.hull.surface_object for obj in (by_operator, by_function))
    assert np.array_equal(mesh_points(first), mesh_points(second))


def test_make_hull_is_one_undo_step():
    add_box()
    bpy.ops.ed.undo_push(message="box")
    assert bpy.ops.hull.make_hull() == {"FINISHED"}
    bpy.ops.ed.undo_push(message="hull")
    bpy.ops.ed.undo()
    assert not bpy.data.objects["box"].hull.is_hull
    assert list(bpy.data.objects.keys()) == ["box"]
    bpy.ops.ed.redo()
    assert bpy.data.objects["box"].hull.is_hull


@pytest.mark.parametrize(
    "spoil, reason",
    [
        (lambda box: setattr(box, "scale", (1.0, 2.0, 1.0)), "apply"),
        (lambda box: setattr(box, "rotation_euler", (0.0, 0.1, 0.0)), "apply"),
    ],
)
def test_unapplied_scale_and_rotation_are_refused_with_the_reason(spoil, reason):
    box = add_box()
    spoil(box)
    bpy.context.view_layer.update()
    assert not bpy.ops.hull.make_hull.poll()
    with pytest.raises(ValueError, match=reason):
        part("features.hull.hull_creation").make_hull(box, bpy.context.scene, True)
    assert not box.hull.is_hull


def test_a_moved_hull_keeps_its_numbers():
    hull = add_hull()
    before = state_of(hull).hydrostatics.values
    hull.location = (100.0, 0.0, 5.0)
    bpy.context.view_layer.update()
    assert state_of(hull).hydrostatics.values == before and not state_of(hull).status


def test_modifiers_are_told_of():
    hull = add_hull()
    hull.modifiers.new("Mirror", "MIRROR")
    bpy.ops.hull.update()
    assert any("Mirror" in remark for remark in state_of(hull).remarks)


def test_the_scene_scale_makes_metres():
    bpy.context.scene.unit_settings.scale_length = 0.5
    hull = add_hull()
    hull.hull.draft = 2.0
    bpy.context.view_layer.update()
    found = state_of(hull).hydrostatics.values
    assert found.draft == 1.0
    assert found.displaced_volume == pytest.approx(5.0 * 2.0 * 1.0, rel=1e-12)
    surface = mesh_points(hull.hull.surface_object)
    assert surface[:, 0].max() == pytest.approx(LENGTH)


def test_tags_of_the_selection():
    box = add_box()
    part("bridge.blender.blender_versions")
    select_in_edit_mode(box, {0, 1, 2})
    assert bpy.ops.hull.tag_smooth() == {"FINISHED"}
    assert bpy.ops.hull.tag_corner() == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    ends = np.array([edge.vertices[:] for edge in box.data.edges])
    smoothed = np.isin(ends, (0, 1, 2)).all(axis=1)
    assert smoothed.any() and np.array_equal(edge_creases(box), np.where(smoothed, 0.0, 1.0))
    assert vertex_creases(box).tolist() == [1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0]

    select_in_edit_mode(box, {0, 1, 2})
    assert bpy.ops.hull.tag_crease() == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    assert (edge_creases(box) == 1.0).all()


def test_tagging_nothing_is_refused():
    box = add_box()
    select_in_edit_mode(box, set())
    with pytest.raises(RuntimeError, match="Select"):
        bpy.ops.hull.tag_crease()


def test_tags_and_settings_survive_saving(tmp_path):
    hull = add_hull()
    select_in_edit_mode(hull, {3})
    bpy.ops.hull.tag_corner()
    bpy.ops.object.mode_set(mode="OBJECT")
    hull.hull.draft = 1.25
    hull.hull.samples = 3
    volume = part("features.hull.hull_state").refresh(hull, bpy.context.scene).hydrostatics.values
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "hull.blend"))
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "hull.blend"))
    hull = bpy.data.objects["box"]
    assert (edge_creases(hull) == 1.0).all()
    assert np.flatnonzero(vertex_creases(hull)).tolist() == [3]
    assert (hull.hull.draft, hull.hull.samples, hull.hull.half) == (1.25, 3, True)
    assert state_of(hull).hydrostatics.values == volume


def three_faced_edge():
    """A hull whose edge 2-6 has a third face, to a new vertex 8."""
    hull = add_hull()
    bm = bmesh.new()
    bm.from_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    far = bm.verts.new((5.0, 4.0, 0.0))
    bm.verts.ensure_lookup_table()
    bm.faces.new((bm.verts[2], bm.verts[6], far))
    bm.to_mesh(hull.data)
    bm.free()
    make_active(hull)
    return hull


def test_a_problem_names_and_selects_its_elements():
    hull = three_faced_edge()
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    problems = state_of(hull).ship.check.problems
    index = next(i for i, problem in enumerate(problems) if problem.kind == "edge")
    assert problems[index].severity == "error"
    assert {frozenset(pair) for pair in problems[index].elements} == {frozenset((2, 6))}
    assert bpy.ops.hull.select_problem(index=index) == {"FINISHED"}
    bm = bmesh.from_edit_mesh(hull.data)
    selected = [{v.index for v in edge.verts} for edge in bm.edges if edge.select]
    assert selected == [{2, 6}]


def test_a_problem_that_is_gone_is_refused():
    add_hull()
    with pytest.raises(RuntimeError, match="no longer"):
        bpy.ops.hull.select_problem(index=0)


def test_a_problem_of_a_hull_that_cannot_be_seen_is_not_selected():
    """Its surface is at hand: the hull is hidden, or out of the view layer."""
    hull = three_faced_edge()
    hull_state = part("features.hull.hull_state")
    hull_state.refresh(hull, bpy.context.scene)
    make_active(part("bridge.objects.shown_objects").surface_of(hull))
    hull.hide_set(True)
    with pytest.raises(RuntimeError, match="cannot be edited here: it is hidden"):
        bpy.ops.hull.select_problem(index=0)
    hull.hide_set(False)
    for collection in hull.users_collection:
        collection.objects.unlink(hull)
    with pytest.raises(RuntimeError, match="or not in this view layer"):
        bpy.ops.hull.select_problem(index=0)


def test_a_hull_whose_mesh_another_object_left_in_edit_mode_is_not_edited():
    """As a script leaves them that exchanges the mesh of an object in edit mode."""
    hull = add_hull()
    bpy.ops.mesh.primitive_plane_add()
    bpy.ops.object.mode_set(mode="EDIT")
    other = bpy.context.object
    hull.data, other.data = other.data, hull.data
    make_active(hull)
    try:
        bpy.ops.object.mode_set(mode="EDIT")
    except RuntimeError:
        with pytest.raises(RuntimeError, match="cannot be edited here: .*open it again"):
            bpy.ops.hull.select_creases()
    else:
        pytest.skip("this Blender edits such a mesh")


def test_what_is_not_there_to_be_selected_leaves_the_mode():
    hull = add_hull()
    make_active(hull)
    with pytest.raises(RuntimeError, match="The hull has none"):
        bpy.ops.hull.select_creases(kind="DECK_EDGE")
    assert hull.mode == "OBJECT"
    assert bpy.ops.hull.select_creases(kind="BORDER") == {"FINISHED"}
    assert hull.mode == "EDIT"


def test_a_fractional_crease_is_a_warning():
    hull = add_hull()
    bm = bmesh.new()
    bm.from_mesh(hull.data)
    layer, _ = part("bridge.blender.blender_versions").ensure_crease_layers(bm)
    bm.edges.ensure_lookup_table()
    bm.edges[0][layer] = 0.5
    pair = tuple(vertex.index for vertex in bm.edges[0].verts)
    bm.to_mesh(hull.data)
    bm.free()
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    problems = [p for p in state_of(hull).ship.check.problems if "between 0 and 1" in p.message]
    assert [(p.severity, p.elements) for p in problems] == [("warning", (pair,))]


def test_faces_turned_inwards_are_reported_and_turned_on_request():
    hull = add_hull()
    hull.data.flip_normals()
    assert bpy.ops.hull.check_mesh() == {"FINISHED"}
    assert any("inwards" in problem.message for problem in state_of(hull).ship.check.problems)
    assert bpy.ops.hull.turn_outwards() == {"FINISHED"}
    assert not state_of(hull).ship.check.problems
    assert state_of(hull).hydrostatics.values.displaced_volume > 0.0


def test_a_layer_outside_the_shell_does_not_count():
    hull = add_hull()
    material = bpy.data.materials.new("bulkhead")
    hull.data.materials.append(None)
    hull.data.materials.append(material)
    layer = hull.hull.layers.add()
    layer.material, layer.in_hydrostatics = material, False
    bm = bmesh.new()
    bm.from_mesh(hull.data)
    corners = [bm.verts.new((5.0, y, z)) for y, z in ((0, 0), (2, 0), (2, 3), (0, 3))]
    bm.faces.new(corners).material_index = 1
    bm.to_mesh(hull.data)
    bm.free()
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    assert state_of(hull).ship.check.face_count == 4
    assert not state_of(hull).ship.check.problems
    layer.in_hydrostatics = True
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    assert state_of(hull).ship.check.face_count == 5
    layer.in_hydrostatics = False
    bpy.context.view_layer.update()
    assert state_of(hull).ship.check.face_count == 4
    layer.material = bpy.data.materials.new("another")
    bpy.context.view_layer.update()
    assert state_of(hull).ship.check.face_count == 5


def test_a_copy_of_a_hull_gets_objects_of_its_own():
    hull = add_hull()
    copy = hull.copy()
    copy.data = hull.data.copy()
    bpy.context.collection.objects.link(copy)
    make_active(copy)
    assert part("bridge.objects.shown_objects").surface_of(copy) is None
    assert bpy.ops.hull.update() == {"FINISHED"}
    assert copy.hull.surface_object.parent == copy
    assert hull.hull.surface_object.parent == hull


@pytest.mark.parametrize("call", ["make_studio", "lines_as_curves"])
def test_a_hull_that_is_not_in_the_view_layer_is_told_of(call):
    """Its surface is at hand."""
    hull = add_hull()
    hull_state = part("features.hull.hull_state")
    hull_state.refresh(hull, bpy.context.scene)
    make_active(part("bridge.objects.shown_objects").surface_of(hull))
    for collection in hull.users_collection:
        collection.objects.unlink(hull)
    with pytest.raises(RuntimeError, match="is not in this view layer: tick the box"):
        getattr(bpy.ops.hull, call)()
