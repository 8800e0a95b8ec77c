# SPDX-License-Identifier: GPL-3.0-or-later
"""Combs, colours and lines of light: the numbers of the native module, only where switched on."""

from types import SimpleNamespace

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import LENGTH, add_hull, make_active, part, state_of


def round_hull():
    """A smooth hull, so that it has curvature."""
    hull = add_hull()
    hull.hull.length_pp, hull.hull.lines.station_count = LENGTH, 5
    hull.hull.lines.waterline_spacing = hull.hull.lines.buttock_spacing = 0.5
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.hull.tag_smooth()
    bpy.ops.object.mode_set(mode="OBJECT")
    update()
    return hull


def update():
    bpy.context.view_layer.update()


def move_a_point(hull, by=0.1):
    hull.data.vertices[3].co.y += by
    hull.data.update_tag()
    update()


def test_combs_are_those_of_the_native_module():
    hull = round_hull()
    hull.hull.fairness.comb_stations = True
    update()
    state, lines = state_of(hull), part("features.lines.lines")
    (group,) = state.fairness.combs.values()
    native = part("bridge.native").require()
    planes = np.array([section.cut.plane for section in group.sections])
    wanted = native.section_fairness(state.ship.surface, planes, **group.rules)
    wanted = [curve for curves in wanted for curve in curves]
    assert len(wanted) == len(group.curves) > 3
    for ours, theirs in zip(group.curves, wanted):
        assert np.array_equal(ours.points, theirs.points)
        assert np.array_equal(ours.curvatures, theirs.curvatures)
    scale = native.suggested_comb_scale(wanted, height=0.05 * lines.size_of(state.ship.surface))
    assert group.scale == pytest.approx(scale)
    segments, teeth = group.segments(scale)
    assert teeth == sum(len(curve.points) for curve in wanted)
    both = [curve.comb(scale=scale) for curve in wanted]
    assert np.array_equal(
        segments[:teeth], np.concatenate([c[: len(w.points)] for c, w in zip(both, wanted)])
    )
    assert len(segments) == sum(map(len, both))
    for name in ("inflection", "maximum", "minimum"):
        assert group.mark_counts[name] == len(group.marks[name])
    assert group.mark_counts["inflection"] == sum(c.inflection_count for c in wanted)
    extrema = group.mark_counts["maximum"] + group.mark_counts["minimum"]
    assert extrema == sum(c.extremum_count for c in wanted)


def test_a_plane_has_the_combs_of_both_sides():
    hull = round_hull()
    plane = hull.hull.lines.planes.add()
    plane.normal, plane.point = (1.0, 0.5, 0.0), (5.0, 0.0, 0.0)
    hull.hull.fairness.comb_planes = True
    update()
    (group,) = state_of(hull).fairness.combs.values()
    segments, _ = group.segments(1.0)
    assert segments[:, :, 1].min() < -1.0 and segments[:, :, 1].max() > 1.0
    assert 2 * sum(group.mark_counts.values()) >= sum(map(len, group.marks.values()))


def test_the_scale_of_combs_stays_while_points_move():
    hull = round_hull()
    hull.hull.fairness.comb_stations = True
    update()
    before = state_of(hull).fairness.combs["station"]
    move_a_point(hull, 1.0)
    after = state_of(hull).fairness.combs["station"]
    assert after is not before and after.scale == before.scale > 0.0
    hull.hull.fairness.comb_stations = False
    update()
    hull.hull.fairness.comb_stations = True
    update()
    assert state_of(hull).fairness.combs["station"].scale != before.scale


def test_combs_of_lines_that_are_straight():
    hull = add_hull()
    for name in part("features.fairness.combs").SWITCHES.values():
        setattr(hull.hull.fairness, name, True)
    update()
    state = state_of(hull)
    assert not state.fairness.status
    for group in state.fairness.combs.values():
        segments, count = group.segments(group.scale)
        assert np.isfinite(segments).all()
        teeth = np.linalg.norm(segments[:count, 1] - segments[:count, 0], axis=1)
        assert (teeth < 1e-6 * LENGTH).all()


FAIRNESS = {
    "sections",
    "feature_curves",
    "feature_fairness",
    "surface_field",
    "colour_scale",
    "isophotes",
    "reflection_lines",
    "silhouette",
}


def test_nothing_is_computed_that_is_off(monkeypatch):
    hull, native = round_hull(), part("bridge.native")
    real, asked = native.require(), []

    class Recorder:
        def __getattr__(self, name):
            if name in FAIRNESS:
                asked.append(name)
            return getattr(real, name)

    def recorded(name):
        function = getattr(moves, name)
        return lambda *given, **named: (asked.append(name), function(*given, **named))[1]

    monkeypatch.setattr(native, "require", Recorder)
    moves = part("bridge.mesh.moves").Moves
    for name in ("sections", "fairness"):
        monkeypatch.setattr(moves, name, recorded(name))
    for name in part("features.lines.lines").SWITCHES.values():
        setattr(hull.hull.lines, name, False)
    update()
    asked.clear()
    move_a_point(hull)
    assert asked == []
    hull.hull.fairness.comb_buttocks = True
    update()
    assert asked == ["sections", "fairness"]
    asked.clear()
    hull.data.update_tag()
    update()
    assert asked == []


def test_marks_have_symbols_of_their_own_in_the_picture():
    marks = part("overlays.mark_arrays")
    assert set(marks.SHAPES) == set(part("features.fairness.combs").MARKS)
    to_clip = np.diag([0.5, 0.5, 0.5, 1.0])
    places = marks.in_picture(np.array([(1.0, 1.0, 0.0), (3.0, 0.0, 0.0)]), to_clip)
    assert places.tolist() == [[0.5, 0.5, 0.0]]
    for name, (_, shape) in marks.SHAPES.items():
        corners = marks.symbols(name, places, 10.0, (1000.0, 500.0))
        assert len(corners) == len(shape)
        reach = np.abs(corners - places)[:, :2].max(axis=0)
        assert reach[1] == pytest.approx(2.0 * reach[0], rel=0.2)  # round on the screen
        assert reach[0] == pytest.approx(0.02, rel=0.2)


def corner_colours(hull):
    mesh = hull.hull.surface_object.data
    colours = np.empty((len(mesh.loops), 4), dtype=np.float32)
    mesh.color_attributes["Hull colours"].data.foreach_get("color", colours.reshape(-1))
    return colours[:, :3]


def has_colours(hull):
    return "Hull colours" in hull.hull.surface_object.data.color_attributes


KINDS = ("GAUSSIAN", "MEAN", "MAXIMUM", "MINIMUM", "SLOPE")


@pytest.mark.parametrize("kind", KINDS)
def test_colours_are_those_of_the_native_module(kind):
    hull = round_hull()
    hull.hull.fairness.colours, hull.hull.fairness.logarithmic = kind, False
    update()
    state, native = state_of(hull), part("bridge.native").require()
    tessellation = state.ship.surface.tessellate(hull.hull.samples)
    values = native.surface_field(state.ship.surface, tessellation, kind=kind.lower())
    weights = native.field_weights(tessellation)
    scale = native.colour_scale(values, kind=kind.lower(), weights=weights)
    assert (state.shown.colour_scale.low, state.shown.colour_scale.high) == (scale.low, scale.high)
    wanted = scale.colours(values)[tessellation.normal_indices].reshape(-1, 3)
    shown = corner_colours(hull)
    assert len(shown) > len(wanted)
    as_srgb = np.where(shown <= 0.0031308, 12.92 * shown, 1.055 * shown ** (1 / 2.4) - 0.055)
    assert np.abs(as_srgb[: len(wanted)] - wanted).max() < 1e-4
    mesh = hull.hull.surface_object.data
    assert mesh.color_attributes.active_color.name == "Hull colours"


def test_the_other_side_has_the_same_colours():
    hull = round_hull()
    hull.hull.fairness.colours = "MEAN"
    update()
    mesh, shown = hull.hull.surface_object.data, corner_colours(hull)
    by_place = {}
    for loop in mesh.loops:
        x, y, z = mesh.vertices[loop.vertex_index].co
        key = (round(x, 4), round(abs(y), 4), round(z, 4))
        by_place.setdefault(key, []).append(shown[loop.index])
    assert max(np.ptp(np.array(own), axis=0).max() for own in by_place.values()) < 1e-4


def test_colours_follow_and_go():
    hull = round_hull()
    surface = hull.hull.surface_object
    own = surface.active_material
    hull.hull.fairness.colours = "GAUSSIAN"
    update()
    assert surface.active_material.name == "Hull colours" and surface.data.materials[0] == own
    before = corner_colours(hull)
    move_a_point(hull, 0.5)
    assert np.abs(corner_colours(hull) - before).max() > 0.01
    hull.hull.samples = 2
    update()
    assert len(corner_colours(hull)) < len(before)
    surface.active_material.name = "Hull colours.001"  # as it comes from another file
    hull.hull.fairness.colours = "NONE"
    update()
    assert not has_colours(hull) and surface.active_material == own
    assert state_of(hull).shown.colour_scale is None


def shading():
    screens = (area for screen in bpy.data.screens for area in screen.areas)
    view = next(area for area in screens if area.type == "VIEW_3D")
    return view.spaces.active.shading


def test_solid_views_show_colours_while_there_are_some():
    hull = round_hull()
    shading().color_type, shading().light = "OBJECT", "MATCAP"
    hull.hull.fairness.colours = "MEAN"
    assert (shading().color_type, shading().light) == ("VERTEX", "FLAT")
    hull.hull.fairness.colours = "SLOPE"
    hull.hull.fairness.colours = "NONE"
    assert (shading().color_type, shading().light) == ("OBJECT", "MATCAP")
    hull.hull.fairness.colours = "MEAN"
    shading().color_type = "RANDOM"
    hull.hull.fairness.colours = "NONE"
    assert shading().color_type == "RANDOM"


def test_views_of_wires_show_colours_once_they_are_solid():
    hull = round_hull()
    shading().color_type = "OBJECT"
    shading().type = "WIREFRAME"
    hull.hull.fairness.colours = "MEAN"
    assert shading().type == "WIREFRAME"
    shading().type = "SOLID"
    assert shading().color_type == "VERTEX"
    shading().type = "WIREFRAME"
    hull.hull.fairness.colours = "NONE"
    assert shading().type == "WIREFRAME"
    shading().type = "SOLID"
    assert shading().color_type == "OBJECT"


def test_undo_brings_colours_back():
    hull = round_hull()
    hull.hull.fairness.colours = "MEAN"
    update()
    before = corner_colours(hull)
    bpy.ops.ed.undo_push(message="before")
    hull.hull.fairness.colours = "NONE"
    move_a_point(hull, 0.5)
    bpy.ops.ed.undo_push(message="after")
    bpy.ops.ed.undo()
    hull = bpy.data.objects["box"]
    assert np.abs(corner_colours(hull) - before).max() < 1e-6
    assert state_of(hull).shown.colour_scale is not None


def test_a_limit_and_decades():
    hull = round_hull()
    fairness = hull.hull.fairness
    fairness.colours, fairness.colour_limit, fairness.logarithmic = "MEAN", 0.25, False
    update()
    scale = state_of(hull).shown.colour_scale
    assert (scale.low, scale.high) == pytest.approx((-0.25, 0.25))
    fairness.logarithmic = True
    update()
    assert state_of(hull).shown.colour_scale.mapping == "logarithmic"
    fairness.colours, fairness.colour_limit = "SLOPE", 90.0
    update()
    scale = state_of(hull).shown.colour_scale
    assert scale.high == pytest.approx(np.pi / 2) and scale.mapping == "linear"


def test_the_legend_says_what_the_colours_mean():
    hull = round_hull()
    legend = part("overlays.legend")
    assert legend.legend_of(hull) is None
    hull.hull.fairness.colours = "GAUSSIAN"
    update()
    arrays = legend.legend_of(hull)
    assert (arrays.title, arrays.unit) == ("Gaussian curvature", "1/m²")
    heights = [height for height, _ in arrays.labels]
    assert len(heights) >= 3 and heights == sorted(heights)
    assert legend.legend_of(hull) is arrays
    points, colours = arrays.bar
    assert len(points) == len(colours)
    scale = state_of(hull).shown.colour_scale
    assert colours[0][:3] == pytest.approx(scale.legend_colours(2)[0])
    assert legend.legend_of(None) is None


def test_a_hull_that_is_not_seen_has_no_legend():
    hull, legend = round_hull(), part("overlays.legend")
    hull.hull.fairness.colours = "GAUSSIAN"
    bpy.context.view_layer.update()
    areas = (area for screen in bpy.data.screens for area in screen.areas)
    view = next(area.spaces.active for area in areas if area.type == "VIEW_3D")
    context = SimpleNamespace(view_layer=bpy.context.view_layer, space_data=view)
    assert legend.legend_in_view(context, hull) is legend.legend_of(hull) is not None
    assert legend.legend_in_view(context, None) is None
    view.shading.type = "WIREFRAME"
    assert legend.legend_in_view(context, hull) is None
    view.shading.type = "SOLID"
    hull.hull.surface_object.hide_set(True)
    bpy.context.view_layer.update()
    assert legend.legend_in_view(context, hull) is None
    hull.hull.surface_object.hide_set(False)
    bpy.context.view_layer.update()
    assert legend.legend_in_view(context, hull) is not None


def test_the_legend_is_of_the_colours_that_are_left_when_the_mesh_has_errors():
    hull, legend = round_hull(), part("overlays.legend")
    hull.hull.fairness.colours = "GAUSSIAN"
    update()
    face = hull.data.polygons[0]
    hull.data.polygons[1].vertices = face.vertices[:]
    hull.data.update()
    update()
    assert state_of(hull).status
    for setting in ("NONE", "SLOPE"):
        hull.hull.fairness.colours = setting
        update()
        assert legend.legend_of(hull).title == "Gaussian curvature"


def level_lines(hull):
    return state_of(hull).fairness.level_lines


def test_isophotes_have_their_angle():
    hull = round_hull()
    fairness = hull.hull.fairness
    fairness.show_isophotes = True
    fairness.isophote_direction = (0.0, 1.0, 0.0)
    fairness.isophote_spacing = np.radians(30.0)
    update()
    (group,) = level_lines(hull).values()
    native, surface = part("bridge.native").require(), state_of(hull).ship.surface
    wanted = native.isophotes(
        surface, direction=np.array([0.0, 1.0, 0.0]), angles=np.radians([30, 60, 90, 120, 150])
    )
    assert len(wanted) == len(group.polylines) >= 1 and group.is_mirrored
    for ours, theirs in zip(group.polylines, wanted):
        assert np.abs(ours - theirs.points).max() < 1e-6 * LENGTH


def test_lines_of_light_of_both_sides():
    hull = round_hull()
    fairness = hull.hull.fairness
    fairness.show_reflections = fairness.show_silhouette = True
    fairness.eye_direction, fairness.light_direction = (0.3, 1.0, 0.4), (0.0, 1.0, 0.5)
    update()
    found = level_lines(hull)
    assert list(found) == ["reflection", "silhouette"]
    before = found["silhouette"]
    assert found["reflection"].is_mirrored and not before.is_mirrored
    y = np.concatenate(before.polylines)[:, 1]
    assert y.min() < -0.1 and y.max() > 0.1
    fairness.light_direction = (0.0, 0.8, 0.6)
    update()
    assert level_lines(hull)["silhouette"] is before
    assert level_lines(hull)["reflection"] is not found["reflection"]
    fairness.eye_direction = (0.0, 0.0, 0.0)
    update()
    assert "Eye" in state_of(hull).fairness.status and not state_of(hull).status


def select_faces(hull, wanted):
    make_active(hull)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.context.tool_settings.mesh_select_mode = (False, False, True)
    bm = bmesh.from_edit_mesh(hull.data)
    for face in bm.faces:
        face.select_set(wanted(face.calc_center_median()))
    bmesh.update_edit_mesh(hull.data)


def selected_points(hull):
    bm = bmesh.from_edit_mesh(hull.data)
    return {vertex.index for vertex in bm.verts if vertex.select}


def flat_hull():
    """A box whose side has an inner point, which is to be pushed out."""
    hull = add_hull()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide(number_cuts=1)
    bpy.ops.object.mode_set(mode="OBJECT")
    update()
    inner = next(
        v for v in hull.data.vertices if v.co[1] > 1.99 and 1 < v.co[0] < 9 and 1 < v.co[2] < 2
    )
    return hull, inner


def test_a_flat_side_is_flat():
    hull, _ = flat_hull()
    select_faces(hull, lambda centre: centre.y > 1.9)
    check = part("features.modelling.flat_check").check_selected(hull, bpy.context.scene, 0.0)
    assert check.distance < 1e-6 and not check.at_fault and "Flat" in check.message
    assert bpy.ops.hull.check_flat() == {"FINISHED"}


def test_the_point_at_fault_is_selected():
    hull, inner = flat_hull()
    index = inner.index  # the vertex itself may be gone after an update
    inner.co.y += 0.2
    hull.data.update_tag()
    update()
    select_faces(hull, lambda centre: centre.y > 1.9)
    check = part("features.modelling.flat_check").check_selected(hull, bpy.context.scene, 0.0)
    assert index in check.at_fault and check.distance > 0.02
    assert bpy.ops.hull.check_flat(tolerance=0.12) == {"FINISHED"}
    assert selected_points(hull) == {index}


def test_points_around_bend_the_rim():
    """A smooth box: its faces have flat control polygons, but their surface is round."""
    hull = round_hull()
    select_faces(hull, lambda centre: centre.y > 1.9)
    inside = selected_points(hull)
    check = part("features.modelling.flat_check").check_selected(hull, bpy.context.scene, 0.0)
    assert check.distance > 0.01 and "around" in check.message
    assert check.at_fault and not inside & set(check.at_fault)


def test_flatness_needs_faces():
    hull, _ = flat_hull()
    select_faces(hull, lambda centre: False)
    with pytest.raises(RuntimeError, match="Select the faces"):
        bpy.ops.hull.check_flat()
