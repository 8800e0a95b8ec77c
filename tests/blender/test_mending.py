# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls of others: what is wrong is said with what helps, and each button does what it says."""

import math

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import LENGTH, add_box, add_hull, mesh_points, part, sample, state_of
from edited_hulls import edit

ATTRIBUTE = "kept"


def refreshed(hull):
    return part("features.hull.hull_state").refresh(hull, bpy.context.scene)


def volume(hull):
    return refreshed(hull).hydrostatics.values.displaced_volume


def problems(hull):
    return [(problem.severity, problem.remedy) for problem in refreshed(hull).ship.check.problems]


def box_with_bulkhead():
    """The box parted at x = 5 by a wall up to half its depth, whose faces come last."""
    points = [(x, y, z) for x in (0.0, 5.0, 10.0) for y in (0.0, 2.0) for z in (0.0, 3.0)]
    faces = []
    for a in (0, 4):  # aft and forward
        faces += [(a + 2, a + 3, a + 7, a + 6), (a, a + 2, a + 6, a + 4)]
    faces += [(0, 1, 3, 2), (8, 10, 11, 9), (4, 6, 7, 5)]
    mesh = bpy.data.meshes.new("bulkhead")
    mesh.from_pydata(points, [], faces)
    part("bridge.blender.blender_versions").set_creases(mesh, range(len(mesh.edges)), [])
    values = mesh.attributes.new(ATTRIBUTE, "INT", "FACE").data
    for index in range(len(faces)):
        values[index].value = 10 + index
    obj = bpy.data.objects.new("bulkhead", mesh)
    bpy.context.collection.objects.link(obj)
    bpy.context.view_layer.objects.active = obj
    assert bpy.ops.hull.make_hull(half=True) == {"FINISHED"}
    obj.hull.length_pp, obj.hull.beam, obj.hull.draft = LENGTH, 4.0, 1.5
    return obj


def test_what_makes_a_surface_is_shown_until_the_mesh_is_split():
    hull = box_with_bulkhead()
    state = state_of(hull)
    assert "more than two faces" in state.status and state.ship.is_part
    assert ("error", "SPLIT") in problems(hull)
    surface = mesh_points(hull.hull.surface_object)
    assert surface.max(axis=0) == pytest.approx([10.0, 2.0, 3.0], abs=1e-5)
    assert part("overlays.status").status_line(hull).startswith("Only what makes a surface")
    with pytest.raises(RuntimeError, match="more than two faces"):
        bpy.ops.hull.export_table(analysis="hydrostatic_table", filepath="/tmp/none.csv")
    # It follows points that move, and errors stay errors.
    for vertex in hull.data.vertices:
        vertex.co.z *= 2.0
    hull.data.update()
    assert refreshed(hull).status and state_of(hull).ship.is_part
    assert mesh_points(hull.hull.surface_object)[:, 2].max() == pytest.approx(6.0)


def test_split_parts_the_mesh_and_keeps_what_is_known_of_it():
    hull = box_with_bulkhead()
    before = mesh_points(hull)
    assert bpy.ops.hull.split() == {"FINISHED"}
    state = refreshed(hull)
    assert not state.status and not state.ship.check.errors and not state.ship.is_part
    after = mesh_points(hull)
    assert np.array_equal(after[: len(before)], before) and len(after) == len(before) + 3
    kept = sorted(value.value for value in hull.data.attributes[ATTRIBUTE].data)
    assert kept == list(range(10, 17))
    creases = part("bridge.blender.blender_versions").edge_creases(hull.data)
    assert (creases == 1.0).all() and len(creases) == len(hull.data.edges)
    with pytest.raises(RuntimeError, match="nothing to split"):
        bpy.ops.hull.split()


@pytest.mark.parametrize("is_split", [True, False])
def test_what_stands_on_the_shell_is_set_aside(is_split):
    hull = box_with_bulkhead()
    if is_split:
        bpy.ops.hull.split()
    assert bpy.ops.hull.set_aside() == {"FINISHED"}
    assert not refreshed(hull).status
    assert volume(hull) == pytest.approx(LENGTH * 4.0 * 1.5, rel=1e-7)
    layers = {layer.name: layer.in_hydrostatics for layer in hull.hull.layers}
    assert layers == {"Shell": True, "Set aside": False}
    slots = [polygon.material_index for polygon in hull.data.polygons]
    assert sorted(slots) == [0] * 6 + [1]
    with pytest.raises(RuntimeError, match="select the faces"):
        bpy.ops.hull.set_aside()


def test_selected_faces_are_set_aside():
    hull = add_hull()
    bm = edit(hull, (False, False, True))
    bm.faces.ensure_lookup_table()
    bm.faces[2].select_set(True)
    assert bpy.ops.hull.set_aside() == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    assert [polygon.material_index for polygon in hull.data.polygons] == [0, 0, 1, 0]
    assert refreshed(hull).ship.surface.mesh.face_count == 3


def test_split_in_edit_mode_and_undone():
    hull = box_with_bulkhead()
    bpy.ops.ed.undo_push(message="made")
    bpy.ops.object.mode_set(mode="EDIT")
    assert bpy.ops.hull.split() == {"FINISHED"}
    assert len(bmesh.from_edit_mesh(hull.data).verts) == 15
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.ed.undo_push(message="split")
    bpy.ops.ed.undo()
    hull = bpy.context.view_layer.objects.active
    assert len(hull.data.vertices) == 12 and refreshed(hull).status


def starboard_box(across=0.0):
    """across: how far the centre line lies over the centre plane, of the half-breadth 2 m."""
    box = add_box()
    for vertex in box.data.vertices:
        vertex.co.y = -vertex.co.y or 2.0 * across
    box.data.flip_normals()
    bpy.ops.hull.make_hull(half=True)
    box.hull.length_pp, box.hull.beam, box.hull.draft = LENGTH, 4.0, 1.5
    return box


@pytest.mark.parametrize("across", [0.0, 0.002, 0.02, 0.3])
def test_a_half_hull_to_starboard_is_refused_and_mirrored(tmp_path, across):
    hull = starboard_box(across)
    state = refreshed(hull)
    assert "starboard" in state.status and state.hydrostatics.values is None
    assert ("error", "PORT") in problems(hull)
    path = tmp_path / "table.csv"
    for call in (
        lambda: bpy.ops.hull.export_table(analysis="hydrostatic_table", filepath=str(path)),
        lambda: bpy.ops.hull.export_table(analysis="offset_table", filepath=str(path)),
        lambda: bpy.ops.hull.export_lines(filepath=str(tmp_path / "lines.svg")),
        lambda: bpy.ops.hull.export_step(filepath=str(tmp_path / "hull.step")),
    ):
        with pytest.raises(RuntimeError, match="starboard"):
            call()
    assert not list(tmp_path.iterdir())
    assert bpy.ops.hull.mirror_to_port() == {"FINISHED"}
    assert not refreshed(hull).status and not state_of(hull).ship.check.errors
    assert not across or "to starboard (y < 0)" in state_of(hull).ship.check.problems[0].message
    assert state_of(hull).hydrostatics.values.immersed_beam == pytest.approx(4.0)
    if not across:
        assert not state_of(hull).ship.check.problems
        assert volume(hull) == pytest.approx(LENGTH * 4.0 * 1.5, rel=1e-7)
    with pytest.raises(RuntimeError, match="no half that lies to starboard"):
        bpy.ops.hull.mirror_to_port()


def doubts(hull):
    return [(doubt.remedy, doubt.takes) for doubt in refreshed(hull).plausible.doubts]


def test_particulars_that_are_none_of_the_surface_are_taken_from_it():
    hull = add_hull()
    settings = hull.hull
    settings.length_pp, settings.beam, settings.draft = 1.0, 1.0, 1.0
    assert doubts(hull)[0] == ("TAKE", ("length_pp", "beam"))
    assert "all 1 m" in state_of(hull).plausible.doubts[0].message
    assert bpy.ops.hull.take_from_surface(names={"length_pp", "beam"}) == {"FINISHED"}
    assert (settings.length_pp, settings.beam) == pytest.approx((10.0, 4.0))
    assert settings.draft == 1.0 and doubts(hull) == []
    settings.beam = 2.0
    assert [remedy for remedy, _ in doubts(hull)] == ["TAKE", "TAKE"]
    assert any("Cb is 2.000" in doubt.message for doubt in state_of(hull).plausible.doubts)


def test_in_edit_mode_the_particulars_are_those_of_the_surface_now():
    hull = add_hull()
    hull.hull.length_pp = 1.0
    doubts(hull)
    bpy.ops.object.mode_set(mode="EDIT")
    net = bmesh.from_edit_mesh(hull.data)
    for vertex in net.verts:
        vertex.co.x *= 1.5
    bmesh.update_edit_mesh(hull.data)
    bpy.context.view_layer.update()
    assert bpy.ops.hull.take_from_surface(names={"length_pp"}) == {"FINISHED"}
    assert hull.hull.length_pp == pytest.approx(15.0)
    bpy.ops.object.mode_set(mode="OBJECT")


def test_a_coordinate_that_is_no_number_does_not_end_what_follows():
    """Of a hull with ties, too: the scale that is looked for is of finite places only."""
    hull = sample("coaster")
    anchor = part("bridge.mesh.point_ties").ANCHOR
    part("features.constraints.ties").tie_points(hull, anchor, [3], [(5, 5)])
    hull.data.update_tag()
    bpy.context.view_layer.update()
    place = hull.data.vertices[8].co.x
    for x in (math.nan, place, place + 0.01):
        hull.data.vertices[8].co.x = x
        hull.data.update_tag()
        bpy.context.view_layer.update()
        assert math.isnan(x) == bool(refreshed(hull).ship.check.errors)
    ties = state_of(hull).keeping.ties
    assert ties.points[8, 0] == np.float32(place + 0.01)


def test_both_sides_that_count_as_half_are_counted_as_whole():
    hull = add_hull()
    hull.hull.length_pp, hull.hull.beam, hull.hull.draft = LENGTH, 4.0, 1.5
    once = volume(hull)
    bpy.ops.hull.make_whole()
    hull.hull.half = True
    assert doubts(hull) == [("WHOLE", ())]
    assert bpy.ops.hull.count_sides(sides="WHOLE") == {"FINISHED"}
    assert doubts(hull) == [] and volume(hull) == pytest.approx(once, rel=1e-7)


BUTTONS = {
    "TAKE": lambda doubt: bpy.ops.hull.take_from_surface(names=set(doubt.takes)),
    "WHOLE": lambda doubt: bpy.ops.hull.count_sides(sides="WHOLE"),
    "HALF": lambda doubt: bpy.ops.hull.count_sides(sides="HALF"),
    "KEEL": lambda doubt: bpy.ops.hull.put_keel_on_base_line(),
}


def lowered(hull, depth):
    for vertex in hull.data.vertices:
        vertex.co.z -= depth
    hull.data.update()
    return refreshed(hull)


@pytest.mark.parametrize("depth", [2.0, -1.5])
def test_each_button_clears_its_doubt_about_a_lowered_hull(depth):
    hull = sample("coaster")
    settings = hull.hull
    draft, before = settings.draft, volume(hull)
    (doubt,) = lowered(hull, depth).plausible.doubts
    assert doubt.remedy == "KEEL"
    assert BUTTONS[doubt.remedy](doubt) == {"FINISHED"}
    assert doubts(hull) == [] and settings.draft == draft
    assert volume(hull) == pytest.approx(before, rel=1e-5)
    with pytest.raises(RuntimeError, match="on the base line already"):
        bpy.ops.hull.put_keel_on_base_line()


def test_every_doubt_has_a_button_that_clears_it():
    hull = sample("coaster")
    settings = hull.hull
    settings.length_pp, settings.beam = 0.61 * 89.0, 30.0
    bpy.ops.hull.make_whole()
    settings.half = True
    state = lowered(hull, 2.0)
    assert {doubt.remedy for doubt in state.plausible.doubts} == {"WHOLE", "TAKE", "KEEL"}
    for doubt in list(state.plausible.doubts):
        assert BUTTONS[doubt.remedy](doubt) == {"FINISHED"}
    assert doubts(hull) == []


def test_one_side_that_counts_as_whole_is_counted_as_half():
    hull = sample("coaster")
    before = volume(hull)
    hull.hull.half = False
    assert doubts(hull)[0] == ("HALF", ())
    assert refreshed(hull).plausible.doubts[0].message.startswith("Only the port side is modelled")
    assert BUTTONS["HALF"](None) == {"FINISHED"}
    assert doubts(hull) == [] and volume(hull) == pytest.approx(before, rel=1e-12)


@pytest.mark.parametrize("stays", [True, False])
def test_what_lies_in_space_goes_up_with_the_keel(stays):
    hull = add_hull()
    settings = hull.hull
    settings.length_pp, settings.beam, settings.draft, settings.depth = LENGTH, 4.0, 1.5, 3.0
    settings.lines.waterlines = "1 2"
    bpy.ops.hull.add_downflooding_point()
    settings.loading.downflooding_points[0].position = (5.0, 2.0, 2.5)
    settings.loading.kg = 1.25
    once = volume(hull)
    lowered(hull, 0.5)
    deeper = volume(hull)
    assert deeper == pytest.approx(LENGTH * 4.0 * 2.0, rel=1e-6)
    assert bpy.ops.hull.put_keel_on_base_line(draft_stays=stays) == {"FINISHED"}
    assert volume(hull) == pytest.approx(once if stays else deeper, rel=1e-6)
    assert settings.loading.downflooding_points[0].position[2] == pytest.approx(3.0)
    moved = 0.0 if stays else 0.5
    heights = settings.draft, settings.depth, settings.loading.kg
    assert heights == pytest.approx((1.5 + moved, 3.0 + moved, 1.25 + moved))
    assert settings.lines.waterlines == ("1 2" if stays else "1.5 2.5")
    assert mesh_points(hull)[:, 2].min() == pytest.approx(0.0, abs=1e-6)
    assert doubts(hull) == []


def test_samples_are_not_doubted():
    for name in part("features.hull.samples").sample_files():
        bpy.ops.hull.load_sample(name=name)
        assert refreshed(bpy.context.object).plausible.doubts == [], name
