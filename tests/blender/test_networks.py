# SPDX-License-Identifier: GPL-3.0-or-later
"""Networks of curves: what is tied moves along, in the planes; the surface follows."""

import bpy
import numpy as np
from addon_under_test import make_active, part
from networks import (
    add,
    finish,
    grid_network,
    height,
    move_point,
    new_network,
    patch_points,
    points_of,
    state_of,
    surface_points,
)

_ROUNDING = 1e-6


def test_a_grid_is_joined():
    network = grid_network()
    state = state_of(network)
    assert state.problems == [] and len(state.curves) == 6
    assert state.network.region_count == 4 and len(state.network.nodes) == 9


def test_tied_points_follow_in_their_planes():
    network = grid_network()
    station = network.objects["Station 5"]
    move_point(station, 1, (1.0, 0.7, 0.5))
    buttock = network.objects["Buttock 5"]
    place = points_of(station)[1]
    assert np.array_equal(place, points_of(buttock)[1])
    assert np.abs(place - (5.0, 5.0, height(5.0, 5.0) + 0.5)).max() < _ROUNDING
    assert state_of(network).problems == []


def test_the_shape_is_that_of_the_native_curve():
    network = grid_network(5)
    station = network.objects["Station 5"]
    move_point(station, 1, (0.0, 0.0, 0.3))
    known = state_of(network).curves[station.name]
    part_of = station.data.splines[0].bezier_points
    (piece,) = known.pieces
    shapes = part("features.networks.curve_shapes")
    t = shapes.parameters_at(piece, known.points)
    for i in range(len(part_of) - 1):
        corners = [part_of[i].co, part_of[i].handle_right, part_of[i + 1].handle_left,
                   part_of[i + 1].co]  # fmt: skip
        for share in (0.25, 0.5, 0.75):
            weights = [(1 - share) ** 3, 3 * share * (1 - share) ** 2,
                       3 * share**2 * (1 - share), share**3]  # fmt: skip
            bezier = sum(w * np.array(c) for w, c in zip(weights, corners))
            wanted = shapes.evaluate(piece, [t[i] + share * (t[i + 1] - t[i])])[0][0]
            assert np.abs(bezier - wanted).max() < 2e-6


def test_the_surface_follows():
    network = grid_network(show_surface=True)
    before = surface_points(network)
    assert len(before) > 4 * 16
    assert np.abs(before - patch_points(network)).max() < 1e-6
    assert np.abs(before[:, 2] - height(before[:, 0], before[:, 1])).max() < 1e-3
    move_point(network.objects["Station 10"], 2, (0.0, 0.0, 1.0))
    after = surface_points(network)
    assert after.shape == before.shape and after[:, 2].max() > before[:, 2].max() + 0.9
    assert np.abs(after - patch_points(network)).max() < 1e-5
    finish()
    assert np.abs(surface_points(network) - patch_points(network)).max() < 1e-6


def test_a_curve_that_moves_as_a_whole_takes_its_plane_along():
    network = grid_network()
    station = network.objects["Station 5"]
    station.location.x += 1.0
    bpy.context.view_layer.update()
    assert abs(station.hull.curve.position - 6.0) < _ROUNDING
    for y in (0.0, 5.0, 10.0):
        points = points_of(network.objects[f"Buttock {y:g}"])
        assert np.abs(points[1, :2] - (6.0, y)).max() < _ROUNDING
    assert state_of(network).problems == []


def test_stations_and_a_profile_from_nothing():
    network = new_network(length=30.0, half_breadth=4.0, depth=5.0)
    profile = add("PROFILE")
    for x in (5.0, 15.0, 25.0):
        add("STATION", position=x)
    assert len(state_of(network).curves) == 4
    assert np.abs(points_of(profile)[:, 1]).max() == 0.0
    deck = add("DECK_EDGE", [(5, 4, 5), (15, 4, 5), (25, 4, 5)])
    line = add("WATERLINE", position=3.0)
    assert len(points_of(line)) >= 3 and np.abs(points_of(line)[:, 2] - 3.0).max() < _ROUNDING
    assert state_of(network).network.region_count == 3
    assert deck.hull.curve.plane == "NONE"


def test_what_is_drawn_over_the_view():
    network = grid_network(show_surface=True)
    arrays, state = part("overlays.network_arrays"), state_of(network)
    found = arrays.of_network(network, state)
    assert set(found.lines) == {"station", "buttock"} and len(found.nodes) == 9
    assert not found.teeth and not len(found.problems)
    assert arrays.of_network(network, state) is found, "kept until something changes"
    station = network.objects["Station 5"]
    station.hull.curve.show_comb = True
    combed = arrays.of_network(network, state)
    teeth = combed.teeth["station"]
    assert len(teeth) > 10
    (piece,) = state.curves[station.name].pieces
    _, bends = part("features.networks.curve_shapes").curvature(piece, piece[1][:1])
    tooth = teeth.points[teeth.segments[0, 1]] - teeth.points[teeth.segments[0, 0]]
    assert np.abs(tooth + combed.comb_scale * bends[0]).max() < 1e-5
    make_active(station)
    bpy.ops.object.mode_set(mode="EDIT")
    edited = arrays.of_network(network, state_of(network))
    assert len(edited.nodes) == 6, "Blender shows the points of what is edited"
    assert len(edited.lines["station"]) < len(combed.lines["station"])
    bpy.ops.object.mode_set(mode="OBJECT")
    network.hull_network.tie = False
    move_point(station, 1, (0.0, 0.0, 0.02))
    assert len(arrays.of_network(network, state_of(network)).problems)


def test_without_curves_there_is_no_surface():
    network = grid_network(3, show_surface=True)
    finish()
    shown = part("bridge.objects.networks").surface_of(network)
    assert len(shown.data.polygons)
    for obj in [one for one in network.objects if one.type == "CURVE"]:
        bpy.data.objects.remove(obj)
    bpy.context.view_layer.update()
    finish()
    assert not len(shown.data.polygons)


def test_a_curve_is_drawn_in_its_scene_alone():
    network, drawing = grid_network(), part("features.networks.drawing")
    other = bpy.data.scenes.new("other")
    pen = drawing.begin(network, bpy.context.scene, "STATION", 5.0, 0.0)
    try:
        assert drawing.at_hand(bpy.context.scene) is pen and drawing.at_hand(other) is None
    finally:
        drawing.end()
    assert drawing.at_hand(bpy.context.scene) is None
