# SPDX-License-Identifier: GPL-3.0-or-later
"""The sidebar's tab as it is drawn: the log tells of what a panel trips over."""

import bpy
from addon_under_test import part
from scans import lay_scan
from sidebar import hull_panels


def open_all():
    """Registers the panels anew, each of them unfolded from the start."""
    classes = hull_panels()
    for cls in reversed(classes):
        bpy.utils.unregister_class(cls)
    for cls in classes:
        cls.bl_options = set()
        bpy.utils.register_class(cls)


def noted_draws(classes):
    """Names of those classes whose draw functions Blender has called; a set that grows."""
    drawn = set()

    def noting(name, draw):
        def draw_and_note(self, context):
            draw(self, context)
            drawn.add(name)

        return draw_and_note

    for cls in classes:
        cls.draw = noting(cls.__name__, cls.draw)
    return drawn


def make_morph(hull):
    """Of a hull in edit mode and a longer one, which have one layout."""
    bpy.ops.object.mode_set(mode="OBJECT")
    other = hull.copy()
    other.data = hull.data.copy()
    for vertex in other.data.vertices:
        vertex.co.x *= 1.1
    bpy.context.scene.collection.objects.link(other)
    bpy.context.view_layer.update()
    other.select_set(True)
    hull.select_set(True)
    assert bpy.ops.hull.make_morph() == {"FINISHED"}


def make_network():
    """With its first curve, active."""
    assert bpy.ops.hull.new_network() == {"FINISHED"}
    assert bpy.ops.hull.add_network_curve(kind="STATION", position=2.0) == {"FINISHED"}


def test_every_panel_is_drawn_to_its_end(window):
    open_all()
    wanted = {cls.__name__ for cls in hull_panels()}
    drawn = noted_draws(hull_panels())
    with window.in_view():
        bpy.ops.hull.load_sample(name="coaster")
    window.open_sidebar()
    yield
    # All of a hull's panels are higher than the window: tiny letters bring them in.
    bpy.context.preferences.view.ui_scale = 0.5
    hull = bpy.context.view_layer.objects.active
    hull.hull.fairness.comb_stations = hull.hull.fairness.show_reflections = True
    hull.hull.fairness.colours = "MEAN"
    for name in ("add_load_case", "add_downflooding_point"):
        getattr(bpy.ops.hull, name)()
    yield
    with window.in_view():
        bpy.ops.object.mode_set(mode="EDIT")
    yield lambda: is_computed(hull, "criteria")
    yield lambda: not part("bridge.background.worker").is_busy()
    assert not is_computed(hull, "cross_curves"), "nothing shows them"
    hull.hull.plots.cross_curves = True
    yield lambda: is_computed(hull, "cross_curves")
    yield lambda: len(part("features.analyses.live_analyses").plots().shown) == 1
    with window.in_view():
        make_morph(hull)
    yield
    with window.in_view():
        make_network()
    yield
    lay_scan(window)
    with window.in_view():
        assert bpy.ops.hull.hull_from_mesh(points=90) == {"FINISHED"}
    yield
    bpy.context.preferences.view.ui_scale = 1.0
    assert drawn == wanted


def is_computed(hull, name):
    """Whether an analysis of a hull is known as it is now."""
    outcome, is_current = part("features.analyses").last_outcome(hull, bpy.context.scene, name)
    return is_current and outcome is not None and outcome.result is not None
