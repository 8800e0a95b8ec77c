# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of docs/panels/networks.md, by their files' names: STEPS of a network that is made from
nothing, and one that is taken from a hull."""

import bpy
import numpy as np
from addon_under_test import make_active, part

# A launch of 20 m.
PROFILE = [(-0.6, 0, 1.0), (0.4, 0, 0.55), (4, 0, 0.1), (8, 0, 0), (12, 0, 0), (16, 0, 0.15),
           (18.6, 0, 0.9), (19.8, 0, 2.3), (20.3, 0, 3.3)]  # fmt: skip
TRANSOM = [(-0.6, 0, 1.0), (-0.6, 1.1, 1.1), (-0.6, 1.9, 1.6), (-0.6, 2.1, 2.6)]
STATIONS = {
    5.0: [(5, 1.2, 0.35), (5, 2.2, 0.95), (5, 2.6, 1.8), (5, 2.65, 2.7)],
    10.0: [(10, 1.4, 0.25), (10, 2.35, 0.85), (10, 2.7, 1.7), (10, 2.75, 2.8)],
    15.0: [(15, 0.8, 0.5), (15, 1.5, 1.2), (15, 1.95, 2.0), (15, 2.15, 2.95)],
}


def launch():
    """A network of a profile, a transom, three stations and a deck edge, all tied."""
    bpy.ops.hull.new_network(name="Launch")
    scene, adding = bpy.context.scene, part("features.networks.adding")
    (network,) = part("bridge.objects.networks").all_networks()
    adding.add(network, scene, "PROFILE", points=PROFILE)
    adding.add(network, scene, "STATION", TRANSOM[0][0], points=TRANSOM)
    keel = part("features.networks.network_state").state_of(network)
    for x, points in STATIONS.items():
        (foot,) = adding.crossing_points(
            keel, *part("features.networks.planes").carrier("X", None, x)
        )
        adding.add(network, scene, "STATION", x, points=[foot, *points])
        keel = part("features.networks.network_state").state_of(network)
        keel = _only_profile(keel)
    ends = [TRANSOM[-1], *(points[-1] for points in STATIONS.values()), PROFILE[-1]]
    deck = adding.add(network, scene, "DECK_EDGE", points=ends)
    transom = next(one for one in network.objects if one.name.startswith("Station -0.6"))
    transom.name = "Transom"
    make_active(deck)
    bpy.context.view_layer.update()
    return network


def _only_profile(state):
    """The same state with the profile alone, so that planes meet nothing else."""
    from types import SimpleNamespace

    return SimpleNamespace(curves={"Profile": state.curves["Profile"]}, scale=state.scale)


def finished():
    part("features.networks.following").finish()


def _alone(window):
    with window.in_view():
        bpy.ops.screen.screen_full_area()
    yield
    space = window.space
    space.show_region_toolbar, space.lens, space.overlay.show_floor = False, 90.0, False
    space.overlay.show_axis_x = space.overlay.show_axis_y = space.overlay.show_cursor = False
    space.shading.color_type = "MATERIAL"


def _look(window, network, angles, place, closer):
    make_active(max((one for one in network.objects if one.type == "CURVE"),
                    key=lambda one: one.dimensions.x))  # fmt: skip
    window.look(bpy.context.view_layer.objects.active, angles, is_perspective=True)
    view = window.space.region_3d
    view.view_location, view.view_distance = place, view.view_distance / closer
    window.space.clip_start = 1e-3 * max(bpy.context.view_layer.objects.active.dimensions)


def _drawn(window):
    """A waterline is being drawn, and is on a station."""
    yield from _alone(window)
    network = launch()
    bpy.context.scene.cursor.location = (0.0, 0.0, 1.5)
    window.open_sidebar()
    yield
    _look(window, network, (68.0, 0.0, 152.0), (9.9, 1.2, 1.3), 1.6)
    bpy.context.scene.cursor.location = (0.0, 0.0, 1.5)
    yield
    with window.in_view():
        bpy.ops.hull.draw_network_curve("INVOKE_DEFAULT", kind="WATERLINE", position=1.5)
    for x in (5.0, 10.0):
        window.move_to_place(_on_station(network, x, 1.5))
        window.click()
    window.move_to_place(_on_station(network, 15.0, 1.5))
    yield


def _on_station(network, x, z):
    known = part("features.networks.network_state").state_of(network).curves[f"Station {x:g}"]
    line = part("features.networks.curve_shapes").samples(known.pieces, 40)
    return line[np.abs(line[:, 2] - z).argmin()]


def _with_surface(window):
    """Its surface, with a waterline and a station cut from it; a comb."""
    yield from _alone(window)
    network = launch()
    network.hull_network.show_surface = True
    bpy.context.view_layer.update()
    bpy.ops.hull.add_network_section(kind="WATERLINE", position=1.5)
    bpy.ops.hull.add_network_section(kind="STATION", position=12.5)
    network.objects["Waterline 1.5"].hull.curve.show_comb = True
    bpy.context.view_layer.update()
    window.open_sidebar()
    yield
    _look(window, network, (68.0, 0.0, 152.0), (9.9, 1.2, 1.3), 1.6)
    make_active(network.objects["Station 12.5"])
    finished()
    yield


def _from_hull(window):
    yield from _alone(window)
    with window.in_view():
        bpy.ops.hull.load_sample(name="coaster")
    hull = bpy.context.view_layer.objects.active
    stations = " ".join(f"{x:.2f}" for x in np.linspace(0.0, 84.0, 15)[1:-1])
    bpy.ops.hull.network_from_hull(stations=stations, waterlines="1.5 3 4.5 6 7.5")
    (network,) = part("bridge.objects.networks").all_networks()
    for obj in (hull, hull.hull.surface_object):
        obj.hide_set(True)
    network.hull_network.show_surface = True
    bpy.context.view_layer.update()
    window.open_sidebar()
    yield
    _look(window, network, (72.0, 0.0, 146.0), (42.0, 3.0, 4.0), 1.6)
    finished()
    yield


def _to_hull(window):
    yield from _from_hull(window)
    (network,) = part("bridge.objects.networks").all_networks()
    network.hull_network.show_surface = False
    bpy.ops.hull.network_to_hull()
    for obj in network.objects:
        obj.hide_set(obj.type != "CURVE")
    bpy.context.view_layer.update()
    yield


# Of the tab.
PANELS = ("networks", "network_curve", "network_surface", "network_hull", "network_problems")
STEPS = {
    "networks/drawn": _drawn,
    "networks/surface": _with_surface,
    "networks/hull": _from_hull,
    "networks/to_hull": _to_hull,
}


def prepare_panel(hull):
    """What the picture of the panel shows: a curve of a network at hand, and a problem."""
    hull.hide_set(True)
    network = launch()
    network.hull_network.show_surface = True
    station = network.objects["Station 10"]
    station.hull.curve.end = "STRAIGHT"
    bpy.context.view_layer.update()
    make_active(station)
    finished()
