# SPDX-License-Identifier: GPL-3.0-or-later
"""A network by mouse: a profile, three stations and a deck edge drawn, tied, smoothed, with the
surface shown; a point is moved and taken back; a hull is laid over all, and taken back."""

import math

import bpy
import numpy as np
import sidebar
from addon_under_test import part
from mathutils import Euler
from window import FROM_ABOVE, FROM_AHEAD, FROM_PORT

PROFILE = [(0, 0, 0.5), (2, 0, 0.1), (6, 0, 0), (10, 0, 0), (14, 0, 0), (18, 0, 0.3), (20, 0, 3)]
STATIONS = {3.0: 1.8, 10.0: 2.4, 16.0: 1.6}


def network():
    (found,) = part("bridge.objects.networks").all_networks()
    return found


def state():
    return part("features.networks.network_state").state_of(network())


def points_of(name):
    return part("bridge.objects.bezier_curves").read(network().objects[name]).points


def look(window, angles_deg):
    view = window.space.region_3d
    view.view_rotation = Euler(map(math.radians, angles_deg)).to_quaternion()
    view.view_perspective, view.view_location, view.view_distance = "ORTHO", (10, 0, 1), 24.0


def draw(window, kind, position, places, knuckle_after=None):
    """Clicks through places, and Enter."""
    with window.in_view():
        bpy.ops.hull.draw_network_curve("INVOKE_DEFAULT", kind=kind, position=position)
    for number, place in enumerate(places):
        window.move_to_place(place)
        window.click()
        if number == knuckle_after:
            window.press("K")
    window.press("RET")
    yield


def begin(window):
    bpy.ops.hull.new_network()
    bpy.ops.ed.undo_push(message="network")
    sidebar.show_panels(window, "networks", "network_curve", "network_problems")
    yield


def drawn(window):
    look(window, FROM_PORT)
    yield
    yield from draw(window, "PROFILE", 0.0, PROFILE)
    look(window, FROM_AHEAD)
    yield
    for x, breadth in STATIONS.items():
        places = [(x, 0, 0.05), (x, 0.7 * breadth, 0.3), (x, breadth, 1.2), (x, 1.1 * breadth, 3)]
        yield from draw(window, "STATION", x, places)
    look(window, FROM_ABOVE)
    yield
    ends = [points_of(f"Station {x:g}")[-1] for x in STATIONS]
    bow = points_of("Profile")[-1]
    yield from draw(window, "DECK_EDGE", 0.0, [*ends, bow])


def test_a_network_is_drawn_and_edited(window):
    yield from begin(window)
    try:
        yield from drawn(window)
        assert len(state().curves) == 5
        for x in STATIONS:
            points, profile = points_of(f"Station {x:g}"), points_of("Profile")
            assert np.abs(points[:, 0] - x).max() < 1e-6
            assert np.abs(profile - points[0]).max(axis=1).min() < 1e-6, "snapped and tied"
            deck = points_of("Deck edge")
            assert np.abs(deck - points[-1]).max(axis=1).min() < 1e-6
        window.open_sidebar()
        yield
        yield from sidebar.press(window, "hull.tie_curves")
        assert state().is_joined and state().network.region_count >= 3
        yield from sidebar.press(window, "show_surface")
        shown = network().hull_network.surface_object
        yield lambda: state().surface.is_finished
        assert len(shown.data.polygons) > 100
        yield from smoothed(window)
        yield from moved_and_taken_back(window)
        yield from made_a_hull(window)
    finally:
        sidebar.show_all_panels()


def smoothed(window):
    profile = network().objects["Profile"]
    with window.in_view():
        bpy.ops.object.select_all(action="DESELECT")
    profile.select_set(True)
    bpy.context.view_layer.objects.active = profile
    bpy.ops.ed.undo_push(message="select")
    before = points_of("Profile")
    yield from sidebar.press(window, "hull.smooth_network_curve")
    after = points_of("Profile")
    moves = np.linalg.norm(after - before, axis=1)
    assert 0.0 < np.sqrt(np.mean(moves**2)) < 0.0101
    for x in STATIONS:
        assert np.abs(after - points_of(f"Station {x:g}")[0]).max(axis=1).min() < 1e-6
    window.move_to_middle()
    window.undo()
    yield
    assert np.abs(points_of("Profile") - before).max() < 1e-6


def moved_and_taken_back(window):
    look(window, FROM_AHEAD)
    station = network().objects["Station 10"]
    station.select_set(True)
    bpy.context.view_layer.objects.active = station
    with window.in_view():
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.curve.select_all(action="DESELECT")
    last = station.data.splines[0].bezier_points[-1]
    last.select_control_point = last.select_left_handle = last.select_right_handle = True
    bpy.ops.ed.undo_push(message="select point")
    before, deck = points_of("Station 10"), points_of("Deck edge")
    shown = surface_points()
    window.move_to_place(before[-1])
    window.press("G")
    window.press("Y")
    window.move_by(40, 0)
    yield
    during = points_of("Station 10")
    assert np.abs(during[-1] - before[-1]).max() > 0.1
    assert np.abs(points_of("Deck edge") - during[-1]).max(axis=1).min() < 1e-6, "tied, live"
    assert np.abs(surface_points() - shown).max() > 0.1
    window.click()
    yield
    window.undo()
    yield
    assert np.abs(points_of("Station 10") - before).max() < 1e-6
    assert np.abs(points_of("Deck edge") - deck).max() < 1e-6
    assert np.abs(surface_points() - shown).max() < 1e-4
    with window.in_view():
        bpy.ops.object.mode_set(mode="OBJECT")


def made_a_hull(window):
    before = len(bpy.data.objects)
    network().hull_network.hull_points = 90  # in less time
    bpy.ops.ed.undo_push(message="edited")
    sidebar.show_panels(window, "networks", "network_hull")
    yield
    yield from sidebar.to(window, "hull.network_to_hull")
    window.click()
    yield lambda: network().hull_network.hull is not None
    yield
    hull = network().hull_network.hull
    assert bpy.context.view_layer.objects.active == hull and hull.hull.half
    report, is_current = part("features.networks.to_hull").last_report(network())
    assert is_current and report.points <= network().hull_network.hull_points
    # Three stations of a boat of 17 m.
    assert report.rms < 5e-3 and report.largest < 0.05 and len(state().curves) == 5
    window.move_to_middle()
    window.undo()
    yield
    assert len(bpy.data.objects) == before and network().hull_network.hull is None


def surface_points():
    mesh = network().hull_network.surface_object.data
    points = np.empty((len(mesh.vertices), 3), dtype=np.float32)
    mesh.vertices.foreach_get("co", points.reshape(-1))
    return points


def test_escape_draws_nothing(window):
    yield from begin(window)
    try:
        look(window, FROM_PORT)
        yield
        with window.in_view():
            bpy.ops.hull.draw_network_curve("INVOKE_DEFAULT", kind="PROFILE", position=0.0)
        for place in PROFILE[:3]:
            window.move_to_place(place)
            window.click()
        window.press("BACK_SPACE")
        yield
        assert len(part("features.networks.drawing").at_hand(bpy.context.scene).points) == 2
        window.press("ESC")
        yield
        assert part("features.networks.drawing").at_hand(bpy.context.scene) is None
        assert not network().objects
    finally:
        sidebar.show_all_panels()


def test_escape_takes_nothing_from_a_hull(window):
    with window.in_view():
        bpy.ops.hull.load_sample(name="container_ship")
    sidebar.show_panels(window, "networks", "network_problems")
    window.open_sidebar()
    yield
    try:
        count = len(bpy.data.objects)
        yield from sidebar.to(window, "hull.network_from_hull")
        window.click()
        window.press("ESC")
        yield lambda: not part("bridge.background.jobs")._unfinished
        yield
        assert not part("bridge.objects.networks").all_networks()
        assert len(bpy.data.objects) == count
    finally:
        sidebar.show_all_panels()


def test_escape_makes_no_hull(window):
    with window.in_view():
        bpy.ops.hull.load_sample(name="coaster")
        bpy.ops.hull.network_from_hull()
    sidebar.show_panels(window, "networks", "network_hull")
    window.open_sidebar()
    yield
    try:
        count = len(bpy.data.objects)
        yield from sidebar.to(window, "hull.network_to_hull")
        window.click()
        yield
        assert part("bridge.background.jobs")._unfinished
        window.press("ESC")
        yield lambda: not part("bridge.background.jobs")._unfinished
        yield
        assert len(bpy.data.objects) == count and network().hull_network.hull is None
    finally:
        sidebar.show_all_panels()


def test_the_button_of_a_problem_leads_to_it(window):
    bpy.context.preferences.view.ui_scale = 0.6  # the list is below all else
    bpy.ops.hull.new_network()
    sidebar.show_panels(window, "networks", "network_problems")
    yield
    try:
        with window.in_view():
            for x in (0.0, 10.0):
                bpy.ops.hull.add_network_curve(kind="STATION", position=x)
        bpy.ops.ed.undo_push(message="apart")
        window.open_sidebar()
        yield
        problems = state().problems
        assert problems
        yield from sidebar.press(window, "hull.select_network_problem")
        assert bpy.context.view_layer.objects.active.name in problems[0].curves
        place = np.array(bpy.context.scene.cursor.location)
        assert np.abs(place - problems[0].places[0]).max() < 1e-6
    finally:
        bpy.context.preferences.view.ui_scale = 1.0
        sidebar.show_all_panels()
