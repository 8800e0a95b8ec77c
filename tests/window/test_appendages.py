# SPDX-License-Identifier: GPL-3.0-or-later
"""Keels and tunnels from the Add menu, changed in the panels, as a person does it."""

import time

import bpy
import pytest
from addon_under_test import make_active, part, sample, state_of
from editing import editing_a_bilge_point, select
from sidebar import show_all_panels, show_panels, to


def volume(hull):
    return state_of(hull).hydrostatics.values.displaced_volume


def bodies(hull):
    return part("bridge.objects.appendages").of_hull(hull)


def start(window):
    with window.in_view():
        hull = sample("coaster")
    return hull


def test_a_tunnel_from_the_menu(window):
    """Counted at once; its radius changed in the sidebar; undone and done again."""
    hull = start(window)
    yield
    whole = volume(hull)
    window.move_to_middle()
    window.search("thruster tunnel")
    yield
    yield
    (tunnel,) = bodies(hull)
    assert bpy.context.object == tunnel and tunnel.hull.appendage.is_cut
    with_tunnel = volume(hull)
    assert with_tunnel < whole
    window.open_sidebar()
    show_panels(window, "appendages")
    yield
    yield from to(window, "radius", across=0.7)
    window.press("RET")
    window.press("A", ctrl=True)
    window.write("1")
    window.press("RET")
    yield
    yield
    show_all_panels()
    assert tunnel.hull.appendage.radius == pytest.approx(1.0)
    assert volume(hull) < with_tunnel
    name, with_larger = hull.name, volume(hull)
    window.move_to_middle()
    window.undo()
    yield
    yield
    assert volume(bpy.data.objects[name]) == pytest.approx(with_tunnel, rel=1e-6)
    window.redo()
    yield
    yield
    assert volume(bpy.data.objects[name]) == pytest.approx(with_larger, rel=1e-6)


def test_a_keel_moved_by_the_mouse(window):
    """G, Z: the hull's numbers follow; undone they are as before."""
    hull = start(window)
    yield
    whole = volume(hull)
    window.move_to_middle()
    window.search("fin keel")
    yield
    yield
    (keel,) = bodies(hull)
    before, name = volume(hull), hull.name
    assert before > whole
    window.press("G")
    window.press("Z")
    window.write("-1")
    window.press("RET")
    yield
    yield
    assert volume(hull) > before
    window.undo()
    yield
    yield
    assert volume(bpy.data.objects[name]) == pytest.approx(before, rel=1e-6)


def test_points_are_dragged_with_a_tunnel(window):
    """While they move the hull alone is measured; when they rest, the tunnel counts again."""
    hull, point, _ = editing_a_bilge_point(window)
    yield
    bpy.ops.object.mode_set(mode="OBJECT")
    window.move_to_middle()
    window.search("thruster tunnel")
    yield
    yield
    make_active(hull)
    bpy.ops.object.mode_set(mode="EDIT")
    select(hull, point)
    yield
    with_tunnel, late_joining = volume(hull), part("features.hull.late_joining")
    waiting, ask = [], late_joining.ask
    late_joining.ask = lambda: waiting.append(state_of(hull).ship.not_joined) or ask()
    window.press("G")
    window.move_by(12, 15)
    yield
    window.click()
    yield
    late_joining.ask = ask
    assert waiting and all("rest" in words for words in waiting)
    for _ in range(40):
        yield
        time.sleep(0.05)
        if not state_of(hull).ship.waits:
            break
    state = state_of(hull)
    assert not state.ship.waits and not state.ship.not_joined
    assert state.ship.body.joined_volume is not None
    assert volume(hull) == pytest.approx(with_tunnel, rel=0.05)
