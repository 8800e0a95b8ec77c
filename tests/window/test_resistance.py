# SPDX-License-Identifier: GPL-3.0-or-later
"""Resistance in the window: beside a variant, an input that is given, the waves over the view;
all of it comes while nobody waits."""

import bpy
from addon_under_test import part
from editing import hull_at_hand
from sidebar import show_all_panels, show_panels, to, type_in


def shown(name):
    """The plot of an analysis over the view, once it is of the hull as it is; else None."""
    plots = part("features.analyses.live_analyses").plots().shown
    return next((one.card.plot for one in plots if one.name == name and one.is_current), None)


def rows(hull):
    latest = part("features.analyses.live_analyses").latest
    outcome, is_current = latest(hull, bpy.context.scene, "resistance_curves")
    return outcome.result.rows if outcome and outcome.result and is_current else None


def test_resistance_beside_and_waves(window):
    with window.in_view():
        bpy.ops.hull.load_sample(name="coaster")
        bpy.ops.hull.keep_variant(name="narrow")
        bpy.ops.ed.undo_push(message="begin")
    hull = hull_at_hand()
    for vertex in hull.data.vertices:
        vertex.co.y *= 1.08
    hull.data.update()
    own = hull.hull.resistance
    own.speed_from, own.speed_step = 12.0, 2.0  # so that the panel fits into the window
    window.look(hull)
    window.open_sidebar()
    show_panels(window, "resistance", "resistance_waves")
    yield
    try:
        yield from to(window, "resistance_curves")
        window.click()
        yield lambda: shown("resistance_curves")
        assert shown("resistance_curves").curve_names[-1] == "narrow"
        before = rows(hull)
        own.holtrop.entrance_angle_deg = 15.0
        yield lambda: rows(hull) not in (None, before)
        assert rows(hull)[-1]["wave_kN"] < before[-1]["wave_kN"]
        hull.hull.plots.resistance_curves = False
        yield from type_in(window, "wave_speed_kn", "13")
        for name in ("wave_pattern", "wave_spectrum"):
            yield from to(window, name)
            window.click()
            yield lambda name=name: shown(name)
        assert "13 kn" in shown("wave_pattern").subtitles[0]
        yield
    finally:
        show_all_panels()
