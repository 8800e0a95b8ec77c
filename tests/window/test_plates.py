# SPDX-License-Identifier: GPL-3.0-or-later
"""The shell laid out in plates while Blender stays at work; Esc ends it; seams over the view."""

import bpy
from addon_under_test import part
from test_tag_overlay import seen


def coaster(window):
    with window.in_view():
        bpy.ops.hull.load_sample(name="coaster")
    hull = bpy.context.view_layer.objects.active
    rules = hull.hull.plates.rules
    for kind, value in (("strakes", 3.0), ("butts", 20.0)):
        rule = rules.add()
        rule.kind, rule.value = kind, value
    return hull


def begin(window):
    with window.in_view():
        bpy.ops.hull.lay_out_plates("INVOKE_DEFAULT")


def last(hull):
    return part("features.production.plate_files").last_plates(hull)[0]


def is_running(hull):
    return part("features.conversion.conversions").running(hull) is not None


def test_plates_are_laid_out_while_blender_is_at_work(window):
    hull = coaster(window)
    yield
    begin(window)
    yield lambda: is_running(hull)
    assert last(hull) is None
    yield lambda: not is_running(hull)
    assert len(last(hull).rows) > 20 and last(hull).mass_t > 10.0


def test_escape_ends_it(window):
    hull = coaster(window)
    yield
    begin(window)
    yield lambda: is_running(hull)
    window.press("ESC")
    yield lambda: not is_running(hull)
    assert last(hull) is None


def test_seams_are_seen_and_go_with_their_switch(window):
    hull = coaster(window)
    lines = part("features.lines.lines")
    for switch in lines.SWITCHES.values():
        setattr(hull.hull.lines, switch, False)
    hull.hull.lines.width = 6.0
    window.look(hull, (70.0, 0.0, 150.0))
    yield
    inks = [("seam", "plates", is_on_light) for is_on_light in (True, False)]
    before = [seen(window, *ink) for ink in inks]
    with window.in_view():
        assert bpy.ops.hull.lay_out_plates() == {"FINISHED"}
    window.area.tag_redraw()
    yield
    assert max(seen(window, *ink) - was for ink, was in zip(inks, before)) > 200
    hull.hull.plates.show_seams = False
    window.area.tag_redraw()
    yield
    assert max(seen(window, *ink) - was for ink, was in zip(inks, before)) < 20
