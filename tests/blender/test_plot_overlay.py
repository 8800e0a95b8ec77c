# SPDX-License-Identifier: GPL-3.0-or-later
"""The headless half of the plots over the 3D view: arrays, places, and when they are made anew."""

import math
from types import SimpleNamespace

import addon_utils
import numpy as np
import pytest
from addon_under_test import module_name, part


@pytest.fixture
def overlay():
    plots = part("overlays.plots")
    yield plots
    plots.hide()


def levers(top=1.0):
    hn = part("bridge.native").require()
    heel = np.radians(np.arange(0, 95, 5))
    gz = top * np.sin(2.0 * heel)
    areas = [(0.0, math.radians(30.0), 0.25 * top)]
    return hn.righting_lever_plot(heel, gz, gm=2.0 * top, areas=areas, deck_edge=0.4)


def test_arrays_are_on_the_card(overlay):
    overlay.show([levers()])
    (arrays,) = overlay.shown_arrays()
    size = (arrays.width_mm, arrays.height_mm)
    assert size == (overlay.Placement().width_mm, overlay.Placement().height_mm)
    drawn = [*arrays.segments, arrays.areas, arrays.patches]
    for one in drawn:
        assert one.points.shape == (len(one.colours), 2) and one.colours.shape[1] == 4
        assert (one.points >= 0.0).all() and (one.points <= size).all()
    assert all(len(one.points) % 2 == 0 for one in arrays.segments)
    assert len(arrays.areas.points) % 3 == 0 and len(arrays.areas.points) > 0
    assert {"Heel φ [°]", "Righting lever GZ [m]"} <= {label["text"] for label in arrays.labels}


def test_triangles_cover_the_shaded_area(overlay):
    hn = part("bridge.native").require()
    sheet = hn.lay_out_plot(levers(), width_mm=125.0, height_mm=88.0, margin_mm=3.0)
    overlay.show([levers()])
    corners = overlay.shown_arrays()[0].areas.points.reshape(-1, 3, 2).astype(float)
    sides = corners[:, 1:] - corners[:, :1]
    covered = 0.5 * np.abs(np.linalg.det(sides)).sum()
    x, y = sheet.areas[0][0].T
    wanted = 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))
    assert covered == pytest.approx(wanted, rel=1e-4)


def test_dashes_are_as_long_as_the_pen_says():
    dashed = part("overlays.plot_arrays")._dashed
    points = np.array([[0.0, 0.0], [7.0, 0.0], [7.0, 13.0]])
    pairs = dashed(points, (2.0, 1.0, 0.5, 1.5)).reshape(-1, 2, 2)
    assert np.linalg.norm(pairs[:, 1] - pairs[:, 0], axis=1).sum() == pytest.approx(4 * 2.5)
    # Every piece lies on the line: none cuts the corner.
    assert all(a[1] == b[1] == 0.0 or a[0] == b[0] == 7.0 for a, b in pairs)


def test_arrays_are_made_only_when_something_changed(overlay):
    overlay.show([levers()])
    first = overlay.shown_arrays()[0]
    overlay.show([levers()])
    assert overlay.shown_arrays()[0] is first
    overlay.show([levers(top=2.0)])
    assert overlay.shown_arrays()[0] is not first
    overlay.show([levers(top=2.0)], overlay.Placement("TOP_RIGHT", 150.0, 100.0))
    assert overlay.shown_arrays()[0].width_mm == 150.0
    overlay.hide()
    assert overlay.shown_arrays() == ()


def test_what_cannot_be_shown_leaves_what_is(overlay):
    overlay.show([levers()])
    first = overlay.shown_arrays()[0]
    with pytest.raises(ValueError):
        overlay.show([levers()], overlay.Placement("TOP_LEFT", 20.0, 20.0))
    assert overlay.shown_arrays()[0] is first
    with pytest.raises(ValueError, match="corner"):
        overlay.Placement("MIDDLE")


@pytest.mark.parametrize("corner", ["BOTTOM_LEFT", "BOTTOM_RIGHT", "TOP_LEFT", "TOP_RIGHT"])
@pytest.mark.parametrize("count", [1, 2, 5])
def test_cards_stand_apart_within_the_room(overlay, corner, count):
    left, bottom, width, height = room = (50.0, 10.0, 1000.0, 700.0)
    places, factor = overlay.card_places([(400.0, 300.0)] * count, corner, room, 12.0)
    assert len(places) == count and 0.2 <= factor <= 1.0
    w, h = 400.0 * factor, 300.0 * factor
    for i, (x, y) in enumerate(places):
        assert left <= x <= left + width - w and bottom <= y <= bottom + height - h
        assert all(abs(x - u) >= w or abs(y - v) >= h for u, v in places[:i])


@pytest.mark.parametrize("is_shown", [True, False])
def test_blenders_texts_at_the_top_keep_their_room(overlay, is_shown):
    context = SimpleNamespace(
        space_data=SimpleNamespace(overlay=SimpleNamespace(show_text=is_shown)),
        preferences=SimpleNamespace(system=SimpleNamespace(ui_scale=2.0)),
    )
    left, bottom, width, height = overlay.below_texts((5.0, 10.0, 300.0, 200.0), context)
    assert (left, bottom, width) == (5.0, 10.0, 300.0)
    assert height == (200.0 - 2.0 * 56.0 if is_shown else 200.0)
    assert overlay.below_texts((0.0, 0.0, 300.0, 20.0), context)[3] >= 0.0


def test_disabling_the_addon_takes_the_plots_away(overlay):
    overlay.show([levers()])
    addon_utils.disable(module_name())
    assert overlay.shown_arrays() == ()
    addon_utils.enable(module_name(), default_set=True)
