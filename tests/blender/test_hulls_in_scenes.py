# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls in several scenes of one file, which may have other units."""

import bpy
import pytest
from addon_under_test import add_hull, part, values


@pytest.fixture
def hull():
    """Of draft 1, in the scene at hand; another scene, the last of the file, is in millimetres."""
    bpy.data.scenes.new("Z").unit_settings.scale_length = 0.001
    hull = add_hull()
    hull.hull.draft = 1.0
    bpy.context.view_layer.update()
    return hull


def test_all_are_followed_by_the_unit_of_their_scene(hull):
    """Also those that share a mesh with a hull of another scene."""
    twin = bpy.data.objects.new("twin", hull.data)
    twin.hull.is_hull, twin.hull.draft = True, 1.0
    bpy.data.scenes["Z"].collection.objects.link(twin)
    bpy.context.view_layer.update()
    follow = part("handlers.follow")
    for each in (follow.after_undo, follow.after_load):
        each()
        assert values(hull).displaced_volume == pytest.approx(40.0)
        assert values(twin).displaced_volume == pytest.approx(40.0e-9)


def test_a_hull_in_two_scenes_is_as_that_at_hand_has_it(hull):
    bpy.data.scenes["Z"].collection.objects.link(hull)
    part("handlers.follow").after_undo()
    assert values(hull).displaced_volume == pytest.approx(40.0)


def test_plots_are_of_the_scene_at_hand(hull, monkeypatch):
    follow, shown = part("handlers.follow"), []
    monkeypatch.setattr(follow.live_analyses, "show_plots", lambda *asked: shown.append(asked))
    follow.after_undo()
    assert shown[-1] == (hull, bpy.context.scene)


def test_what_is_hidden_in_one_view_layer_stays_as_it_is_in_another(hull):
    look_after = part("bridge.objects.surface_upkeep").look_after
    scene, shown = bpy.context.scene, hull.hull.surface_object
    here, other = bpy.context.view_layer, scene.view_layers.new("other")
    try:
        look_after(here)
        hull.hide_set(True)
        look_after(here)
        assert shown.hide_get()
        shown.hide_set(True, view_layer=other)
        for _ in range(2):
            look_after(other)
            assert shown.hide_get(view_layer=other) and not hull.hide_get(view_layer=other)
            look_after(here)
            assert shown.hide_get()
        hull.hide_set(False)
        look_after(other)
        look_after(here)
        assert not shown.hide_get() and shown.hide_get(view_layer=other)
    finally:
        scene.view_layers.remove(other)
