# SPDX-License-Identifier: GPL-3.0-or-later
"""Keels and tunnels from the Add menu, changed in the panels, as a person does it."""

import bpy
import pytest
from addon_under_test import part, sample, state_of
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
