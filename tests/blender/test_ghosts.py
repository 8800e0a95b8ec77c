# SPDX-License-Identifier: GPL-3.0-or-later
"""The ghost: another hull's lines at the places of this one's, following that hull alone."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, lined_hull, make_active, part, state_of
from edited_hulls import edit


def ghost_of(hull):
    return part("features.variants.ghosts").follow(hull, bpy.context.scene)


def with_ghost():
    """A box with lines of every kind, and itself as it is as its ghost."""
    hull = lined_hull()
    bpy.ops.hull.keep_variant(name="A")
    hull.hull.variants.show_ghost = True
    bpy.context.view_layer.update()
    return hull


def polylines(groups):
    return {kind: [line.tolist() for line in groups[kind].polylines] for kind in groups}


def move(hull, axis, by):
    for vertex in hull.data.vertices:
        vertex.co[axis] += by
    hull.data.update()
    bpy.context.view_layer.update()


def test_a_variants_lines_are_those_that_the_hull_had():
    hull = with_ghost()
    before = polylines(state_of(hull).lines.groups)
    before.pop("flat")
    move(hull, 0, 0.25)
    hull.data.vertices[0].co.y = 1.5
    bpy.context.view_layer.update()
    ghost = ghost_of(hull)
    assert ghost.status == ""
    assert polylines(ghost.groups) == before
    assert polylines(state_of(hull).lines.groups)["station"] != before["station"]


def test_it_shows_the_kinds_that_the_hull_shows_and_outlines_always():
    hull = with_ghost()
    lines = part("features.lines.lines")
    for switch in lines.SWITCHES.values():
        setattr(hull.hull.lines, switch, switch == "show_buttocks")
    assert list(ghost_of(hull).groups) == ["buttock", "feature"]
    hull.hull.lines.buttock_spacing = 0.5
    assert ghost_of(hull).groups["buttock"].cut_count == 3
    hull.hull.variants.show_ghost = False
    assert ghost_of(hull).groups == {}


def test_nothing_of_it_is_made_anew_while_the_hull_is_edited():
    hull = with_ghost()
    groups = dict(ghost_of(hull).groups)
    bm = edit(hull)
    for step in range(3):
        for vertex in bm.verts:
            vertex.co.x *= 1.01
        bmesh.update_edit_mesh(hull.data)
        bpy.context.view_layer.update()
        ghost = state_of(hull).of(part("features.variants.ghosts").Ghost)
        assert all(ghost.groups[kind] is groups[kind] for kind in groups)  # untouched
        ghost_of(hull)  # the pause finds that all is as it was
        assert all(ghost.groups[kind] is groups[kind] for kind in groups)


def test_another_hull_is_followed():
    hull, other = lined_hull(), add_hull("other")
    other.location.x = 40.0  # where it stands does not matter
    make_active(hull)
    variants = hull.hull.variants
    variants.show_ghost, variants.compared_with = True, "HULL"
    assert "Choose the other hull" in ghost_of(hull).status
    variants.other_hull = other
    ghost = ghost_of(hull)
    assert polylines(ghost.groups)["station"] == polylines(state_of(hull).lines.groups)["station"]
    bm = edit(other)
    for vertex in bm.verts:
        vertex.co.y *= 2.0
    bmesh.update_edit_mesh(other.data)
    bpy.context.view_layer.update()
    for own, doubled in zip(state_of(hull).lines.groups["station"].polylines,
                            ghost_of(hull).groups["station"].polylines):  # fmt: skip
        low, high = [0.0, 0.0, 0.0], own.max(axis=0) * [1.0, 2.0, 1.0]
        low[0] = high[0]
        assert np.allclose([doubled.min(axis=0), doubled.max(axis=0)], [low, high], atol=1e-12)


def test_another_hull_that_goes_is_told():
    hull, other = lined_hull(), add_hull("other")
    make_active(hull)
    variants = hull.hull.variants
    variants.show_ghost, variants.compared_with, variants.other_hull = True, "HULL", other
    assert ghost_of(hull).groups
    make_active(other)
    bpy.ops.object.delete()
    ghost = ghost_of(hull)
    assert not ghost.groups and '"other" is in no scene' in ghost.status
    bpy.data.objects.remove(other)
    assert "Choose the other hull" in ghost_of(hull).status
    variants.other_hull = hull  # a script may
    assert "Choose the other hull" in ghost_of(hull).status
    variants.compared_with = "VARIANT"
    assert "Keep the hull as a variant first" in ghost_of(hull).status


def test_a_variant_that_has_errors_says_which():
    hull = lined_hull()
    hull.data.clear_geometry()
    bpy.ops.hull.keep_variant(name="nothing")
    hull.hull.variants.show_ghost = True
    assert ghost_of(hull).status.startswith('"nothing" has no surface: ')


@pytest.mark.parametrize("scale", [0.001, 0.3048, 1.0])
def test_any_unit_of_the_scene(scale):
    hull = with_ghost()
    settings = bpy.context.scene.unit_settings
    settings.scale_length = scale
    bpy.context.view_layer.update()
    ghost, own = ghost_of(hull).groups, state_of(hull).lines.groups
    assert set(ghost) == set(own) - {"flat"} and ghost["station"].polylines
    for kind in ghost:
        for line, other in zip(ghost[kind].polylines, own[kind].polylines):
            np.testing.assert_allclose(line, other, rtol=0.0, atol=1e-12 * scale)


def test_whole_hulls_and_halves():
    """A whole ghost has both sides of its own, a half one its image."""
    hull = with_ghost()
    assert ghost_of(hull).groups["buttock"].is_mirrored
    bpy.ops.hull.make_whole()
    bpy.ops.hull.keep_variant(name="whole")
    bpy.ops.hull.go_back_to_variant(variant="A")
    assert hull.hull.half
    groups = ghost_of(hull).groups  # of the whole one, which is chosen
    assert not groups["buttock"].is_mirrored
    ys = {round(float(line[0][1]), 6) for line in groups["buttock"].polylines}
    assert ys == {-1.5, -0.75, 0.75, 1.5}


def curves_beside(hull):
    analyses = part("features.analyses")
    return analyses.others_beside(state_of(hull), "sectional_areas")


def test_its_areas_are_in_the_plot():
    hull = with_ghost()
    hull.hull.plots.sectional_areas = True
    ghost_of(hull)
    hull.hull.draft = 2.0
    bpy.context.view_layer.update()
    ghost_of(hull)
    (curve,) = curves_beside(hull)
    assert curve.name == "A"
    assert curve.y.max() == pytest.approx(4.0 * 1.25, rel=1e-9)  # its own draft
    # As the ghost in the view is.
    assert curve.colour == part("bridge.blender.preferences").colour("ghost", "ghost")
    hull.hull.variants.afloat = "SAME"
    ghost_of(hull)
    assert curves_beside(hull)[0].y.max() == pytest.approx(4.0 * 2.0, rel=1e-9)
    live = part("features.analyses.live_analyses")
    live.show_plots(hull, bpy.context.scene)
    plot = live.plots().shown[0].card.plot
    live.show_plots(hull, bpy.context.scene)
    assert live.plots().shown[0].card.plot is plot  # not made again
    hull.hull.variants.show_ghost = False
    ghost_of(hull)
    assert curves_beside(hull) == ()
    live.show_plots(hull, bpy.context.scene)
    assert live.plots().shown[0].card.plot is not plot
    live.show_plots(None, bpy.context.scene)


@pytest.mark.parametrize("draft", [-5.0, float("nan"), 1e30])
def test_a_ghost_that_does_not_float_has_no_curve(draft):
    hull = with_ghost()
    hull.hull.plots.sectional_areas = True
    hull.hull.variants.kept[0].draft = draft
    ghost = ghost_of(hull)
    assert ghost.status == "" and ghost.groups and curves_beside(hull) == ()


def test_it_is_in_the_plot_that_is_written(tmp_path):
    hull = with_ghost()
    hull.hull.plots.sectional_areas = True
    path = tmp_path / "areas.svg"
    sizes = []
    for shown in (True, False):
        hull.hull.variants.show_ghost = shown
        ghost_of(hull)
        bpy.ops.hull.export_plot(filepath=str(path), analysis="sectional_areas")
        sizes.append(len(path.read_text()))
    assert sizes[0] > sizes[1]
