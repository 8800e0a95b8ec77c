# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots over the 3D view: those of the active hull, as its switches and its shape say."""

from types import SimpleNamespace

import addon_utils
import bpy
import pytest
from addon_under_test import add_hull, compute, make_active, module_name, part, state_of


def live():
    return part("features.analyses.live_analyses")


def shown():
    """The plot_layout.Card of each plot that views show."""
    return [one.card for one in live().plots().shown]


def with_plot(name="sectional_areas"):
    hull = add_hull()
    setattr(hull.hull.plots, name, True)
    bpy.context.view_layer.update()
    return hull


@pytest.fixture(autouse=True)
def nothing_shown():
    yield
    part("features.analyses.live_analyses").stop()


def test_a_switch_shows_a_plot_and_hides_it():
    hull = with_plot()
    assert len(shown()) == 1
    texts = {label["text"] for label in shown()[0].sheet.labels}
    assert "Sectional area curve" in texts
    hull.hull.plots.sectional_areas = False
    bpy.context.view_layer.update()
    assert not shown()


def test_a_quick_plot_follows_the_mesh():
    hull = with_plot()
    before = shown()
    hull.data.vertices[0].co.x -= 1.0
    hull.data.update_tag()
    bpy.context.view_layer.update()
    assert len(shown()) == 1 and shown()[0] is not before[0]


def test_a_plot_that_takes_time_comes_when_it_was_computed():
    hull = with_plot("righting_levers")
    assert not shown()  # in the background nobody waits for it
    part("features.analyses").outcome_of(hull, bpy.context.scene, "righting_levers")
    hull.update_tag()
    bpy.context.view_layer.update()
    assert len(shown()) == 1


def test_only_the_active_hull_shows_plots():
    hull = with_plot()
    empty = bpy.data.objects.new("empty", None)
    bpy.context.collection.objects.link(empty)
    make_active(empty)
    hull.update_tag(refresh={"DATA"})
    bpy.context.view_layer.update()
    assert not shown()
    make_active(hull.hull.surface_object)
    hull.update_tag(refresh={"DATA"})
    bpy.context.view_layer.update()
    assert len(shown()) == 1


def test_a_hull_with_nothing_under_water_shows_no_plot():
    hull = with_plot()
    for vertex in hull.data.vertices:
        vertex.co.z += 10.0
    hull.data.update_tag()
    bpy.context.view_layer.update()
    assert not shown()
    outcome, _ = part("features.analyses").last_outcome(hull, bpy.context.scene, "sectional_areas")
    assert "Nothing is under water" in outcome.message
    assert not state_of(hull).status


def test_a_new_file_shows_none():
    with_plot()
    bpy.ops.wm.read_homefile(use_empty=True)
    assert not shown()


def test_an_addon_that_is_off_shows_none():
    with_plot()
    name = module_name()
    live = part("features.analyses.live_analyses")
    assert len(live.plots().shown) == 1
    addon_utils.disable(name)
    try:
        assert not live.plots().shown
    finally:
        addon_utils.enable(name, default_set=True)
    bpy.context.view_layer.update()


def test_a_plot_is_laid_out_anew_only_when_something_changed():
    hull = with_plot()
    (first,) = shown()
    hull.update_tag(refresh={"DATA"})
    bpy.context.view_layer.update()
    assert shown() == [first]
    hull.hull.plots.size = 1.5
    bpy.context.view_layer.update()
    (larger,) = shown()
    assert larger is not first and larger.width_mm == pytest.approx(1.5 * 125.0)
    hull.hull.plots.corner = "TOP_RIGHT"
    bpy.context.view_layer.update()
    assert live().plots().corner == "TOP_RIGHT"


def test_each_hull_keeps_its_own_plots():
    hulls = [with_plot(), with_plot()]
    (second,) = shown()
    for hull, is_second in zip(hulls * 2, (False, True) * 2):
        make_active(hull)
        hull.update_tag(refresh={"DATA"})
        bpy.context.view_layer.update()
        assert (shown() == [second]) == is_second


def test_places_are_told_without_drawing():
    """Those who work in a plot with the mouse need nobody to have drawn it, and drawing keeps
    nothing."""
    with_plot()
    region = SimpleNamespace(type="WINDOW", x=0, y=0, width=1400, height=900)
    overlay = SimpleNamespace(show_text=False, show_overlays=True)
    spaces = SimpleNamespace(active=SimpleNamespace(overlay=overlay))
    area = SimpleNamespace(regions=[region], spaces=spaces)
    place = live().place_of("sectional_areas", area, region)
    assert [place] == live().places(area, region) and place.card is shown()[0]
    assert live().place_of("cross_curves", area, region) is None
    overlay.show_overlays = False
    assert live().place_of("sectional_areas", area, region) is None


def test_what_was_missed_for_a_pause_is_computed(monkeypatch):
    live, worker = part("features.analyses.live_analyses"), part("bridge.background.worker")
    hull = add_hull()
    bpy.context.view_layer.update()
    scene, now = bpy.context.scene, [100.0]
    monkeypatch.setattr(live, "monotonic", lambda: now[0])
    assert live.latest(hull, scene, "cross_curves") == (None, False)
    live.follow_wanted()
    assert not worker.is_busy(), "no pause yet"
    now[0] += 0.15
    hull.hull.draft += 0.1
    hull.data.vertices[0].co.x -= 1.0
    hull.data.update_tag()
    bpy.context.view_layer.update()
    live.latest(hull, scene, "cross_curves")
    now[0] += 0.15
    live.follow_wanted()
    assert not worker.is_busy(), "it has changed meanwhile"
    now[0] += 0.15
    live.latest(hull, scene, "cross_curves")
    live.follow_wanted()
    assert worker.is_busy()
    worker.finish()
    assert live.take_finished() and live.latest(hull, scene, "cross_curves")[1]


def test_what_nobody_looks_at_any_longer_is_not_computed(monkeypatch):
    hull, live = add_hull(), part("features.analyses.live_analyses")
    bpy.context.view_layer.update()
    monkeypatch.setattr(live, "monotonic", lambda: 100.0)
    live.latest(hull, bpy.context.scene, "cross_curves")
    hull.data.vertices[0].co.x -= 1.0
    hull.data.update_tag()
    bpy.context.view_layer.update()
    monkeypatch.setattr(live, "monotonic", lambda: 101.0)
    live.follow_wanted()
    assert not part("bridge.background.worker").is_busy()


def test_what_was_asked_for_is_computed_and_shown():
    hull = with_plot("cross_curves")
    live, scene = part("features.analyses.live_analyses"), bpy.context.scene
    assert live.latest(hull, scene, "cross_curves") == (None, False)
    compute([(hull.name, "cross_curves"), ("a hull that was deleted", "criteria")])
    outcome, is_current = live.latest(hull, scene, "cross_curves")
    assert outcome.result is not None and is_current
    assert len(shown()) == 1


def test_plots_have_the_size_that_is_set():
    hull = with_plot()
    for size in (0.6, 0.75, 2.0):
        hull.hull.plots.size = size
        bpy.context.view_layer.update()
        (card,) = shown()
        assert card.width_mm == pytest.approx(size * 125.0, rel=1e-6)
        assert card.height_mm == pytest.approx(size * 88.0, rel=1e-6)


def test_two_plots_leave_most_of_a_usual_view_free():
    hull = with_plot()
    hull.hull.plots.righting_levers = True
    part("features.analyses").outcome_of(hull, bpy.context.scene, "righting_levers")
    hull.update_tag()
    bpy.context.view_layer.update()
    layout, preferences = part("features.analyses.plot_layout"), part("bridge.blender.preferences")
    dots = part("bridge.blender.view_room").DOTS_PER_MM * preferences.DEFAULTS["plot_size"]
    sizes = [(card.width_mm * dots, card.height_mm * dots) for card in shown()]
    assert len(sizes) == 2
    # The 3D view of a window of 1920 × 1080, with sidebar, outliner and properties beside it.
    room = (40.0, 0.0, 1200.0, 900.0)
    places, factor = layout.in_room(sizes, "BOTTOM_LEFT", room, layout._GAP)
    assert factor == 1.0 and len(places) == 2
    assert sum(width * height for width, height in sizes) < 0.25 * room[2] * room[3]
