# SPDX-License-Identifier: GPL-3.0-or-later
"""The headless half of the plots over the 3D view: arrays, places, and when they are made anew."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from addon_under_test import part


def layout():
    return part("features.analyses.plot_layout")


def arrays_of(plot, placement=None):
    card = layout().card_of(plot, placement or layout().Placement())
    return part("overlays.plot_arrays").arrays_of(card)


def levers(top=1.0):
    hn = part("bridge.native").require()
    heel = np.radians(np.arange(0, 95, 5))
    gz = top * np.sin(2.0 * heel)
    areas = [(0.0, math.radians(30.0), 0.25 * top)]
    return hn.righting_lever_plot(heel, gz, gm=2.0 * top, areas=areas, deck_edge=0.4)


def test_arrays_are_on_the_card():
    arrays = arrays_of(levers())
    size = (arrays.width_mm, arrays.height_mm)
    assert size == (layout().Placement().width_mm, layout().Placement().height_mm)
    drawn = [*arrays.segments, arrays.areas, arrays.patches]
    for one in drawn:
        assert one.points.shape == (len(one.colours), 2) and one.colours.shape[1] == 4
        assert (one.points >= 0.0).all() and (one.points <= size).all()
    assert all(len(one.points) % 2 == 0 for one in arrays.segments)
    assert len(arrays.areas.points) % 3 == 0 and len(arrays.areas.points) > 0
    assert {"Heel φ [°]", "Righting lever GZ [m]"} <= {label["text"] for label in arrays.labels}


def test_triangles_cover_the_shaded_area():
    hn = part("bridge.native").require()
    sheet = hn.lay_out_plot(levers(), width_mm=125.0, height_mm=88.0, margin_mm=3.0)
    corners = arrays_of(levers()).areas.points.reshape(-1, 3, 2).astype(float)
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


def test_cards_are_as_large_as_is_said():
    placement = layout().Placement.sized("TOP_RIGHT", 1.2)
    arrays = arrays_of(levers(), placement)
    assert (arrays.width_mm, arrays.height_mm) == (1.2 * 125.0, 1.2 * 88.0)


def test_what_cannot_be_laid_out_is_refused():
    with pytest.raises(ValueError):
        arrays_of(levers(), layout().Placement("TOP_LEFT", 20.0, 20.0))
    with pytest.raises(ValueError, match="corner"):
        layout().Placement("MIDDLE")


@pytest.mark.parametrize("corner", ["BOTTOM_LEFT", "BOTTOM_RIGHT", "TOP_LEFT", "TOP_RIGHT"])
@pytest.mark.parametrize("count", [1, 2, 5])
def test_cards_stand_apart_within_the_room(corner, count):
    left, bottom, width, height = room = (50.0, 10.0, 1000.0, 700.0)
    places, factor = layout().in_room([(400.0, 300.0)] * count, corner, room, 12.0)
    assert len(places) == count and 0.2 <= factor <= 1.0
    w, h = 400.0 * factor, 300.0 * factor
    for i, (x, y) in enumerate(places):
        assert left <= x <= left + width - w and bottom <= y <= bottom + height - h
        assert all(abs(x - u) >= w or abs(y - v) >= h for u, v in places[:i])


@pytest.mark.parametrize("is_shown", [True, False])
def space(show_text=False, show_overlays=True):
    return SimpleNamespace(
        overlay=SimpleNamespace(show_text=show_text, show_overlays=show_overlays)
    )


@pytest.mark.parametrize("is_shown", [True, False])
def test_blenders_texts_at_the_top_keep_their_room(is_shown):
    below_texts, view = part("bridge.blender.view_room").below_texts, space(is_shown)
    left, bottom, width, height = below_texts((5.0, 10.0, 300.0, 200.0), view, 2.0)
    assert (left, bottom, width) == (5.0, 10.0, 300.0)
    assert height == (200.0 - 2.0 * 56.0 if is_shown else 200.0)
    assert below_texts((0.0, 0.0, 300.0, 20.0), view, 2.0)[3] >= 0.0


def view(show_overlays=True):
    """(area, region) of a 3D view with a toolbar, as far as places go by it."""
    region = SimpleNamespace(type="WINDOW", x=100, y=50, width=1600, height=900)
    tools = SimpleNamespace(type="TOOLS", x=100, y=50, width=60, height=900)
    spaces = SimpleNamespace(active=space(show_overlays=show_overlays))
    return SimpleNamespace(regions=[region, tools], spaces=spaces), region


def test_places_follow_from_view_and_cards_alone():
    """Whoever asks, and whether anything was drawn: the rectangle between the axes is in the card,
    where the sheet has it."""
    cards = [layout().card_of(levers(top), layout().Placement()) for top in (1.0, 2.0)]
    found = layout().places_of(cards, "BOTTOM_LEFT", *view(), 1.25)
    assert found == layout().places_of(cards, "BOTTOM_LEFT", *view(), 1.25)
    assert [place.card for place in found] == cards
    for place in found:
        left, bottom, right, top = place.rectangle
        assert left > 60.0 and right < 1600.0 and bottom > 0.0 and top < 900.0
        assert right - left == pytest.approx(125.0 * place.dots)
        assert top - bottom == pytest.approx(88.0 * place.dots)
        inner = np.array(place.diagram)
        in_mm = (inner - (left, top, left, top)) / place.dots * (1.0, -1.0, 1.0, -1.0)
        assert np.allclose(in_mm[[0, 3, 2, 1]], place.card.sheet.diagram)
    larger = layout().places_of(cards[:1], "BOTTOM_LEFT", *view(), 1.25, 1.1)
    assert larger[0].dots == pytest.approx(1.1 * found[0].dots)
    assert found[0].dots == pytest.approx(4.4 * 1.25)
    assert found[0].rectangle[2] < found[1].rectangle[0]
    assert layout().places_of(cards, "BOTTOM_LEFT", *view(show_overlays=False), 1.25) == []
    assert layout().places_of([], "BOTTOM_LEFT", *view(), 1.25) == []
