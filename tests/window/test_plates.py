# SPDX-License-Identifier: GPL-3.0-or-later
"""The shell laid out in plates while Blender stays at work; Esc ends it."""

import bpy
from addon_under_test import part


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
    return part("features.exchange.plate_files").last_plates(hull)[0]


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
