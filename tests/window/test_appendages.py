# SPDX-License-Identifier: GPL-3.0-or-later
"""Keels and tunnels from the Add menu, changed in the panels, as a person does it."""

import bpy
import pytest
from addon_under_test import part, sample, state_of
from sidebar import press, show_all_panels, show_panels, type_in


def volume(hull):
    return state_of(hull).hydrostatics.values.displaced_volume


def bodies(hull):
    return part("bridge.objects.appendages").of_hull(hull)


def start(window):
    with window.in_view():
        hull = sample("coaster")
    return hull


def test_a_tunnel_from_the_menu(window):
    """Counted at once; its radius changed in the sidebar; left out by its box; undone."""
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
    yield from type_in(window, "radius", "1")
    yield
    assert tunnel.hull.appendage.radius == pytest.approx(1.0)
    assert volume(hull) < with_tunnel
    yield from press(window, "counts", across=0.08)
    yield
    assert not tunnel.hull.appendage.counts
    assert volume(hull) == pytest.approx(whole, rel=1e-9)
    window.move_to_middle()
    window.undo()
    yield
    yield
    hull = bpy.data.objects[hull.name]
    assert bodies(hull)[0].hull.appendage.counts and volume(hull) < whole
    show_all_panels()


def test_a_keel_moved_by_the_mouse(window):
    """G, Z: the hull's numbers follow; G, X the other way round."""
    hull = start(window)
    yield
    whole = volume(hull)
    window.move_to_middle()
    window.search("fin keel")
    yield
    yield
    (keel,) = bodies(hull)
    before = volume(hull)
    assert before > whole
    window.press("G")
    window.press("Z")
    window.write("-.3")
    window.press("RET")
    yield
    yield
    assert volume(hull) > before
    window.undo()
    yield
    yield
    hull = bpy.data.objects[hull.name]
    assert volume(hull) == pytest.approx(before, rel=1e-9)
