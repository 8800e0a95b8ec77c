# SPDX-License-Identifier: GPL-3.0-or-later
"""Tools for networks: from a hull, by sections of the surface, smoothed, tied, taken from Blender's
curves."""

import bpy
import numpy as np
import pytest
from addon_under_test import make_active, part, sample
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

_ROUNDING = 2e-6


def networks():
    return part("bridge.objects.networks").all_networks()


def test_the_lines_of_a_hull_make_its_surface():
    hull = sample("coaster")
    length = hull.dimensions.x
    stations = " ".join(f"{x:.4f}" for x in np.linspace(-2.0, 84.0, 21)[1:-1])
    waterlines = " ".join(f"{z:.4f}" for z in np.linspace(0.0, 11.0, 11)[1:-1])
    assert bpy.ops.hull.network_from_hull(stations=stations, waterlines=waterlines) == {"FINISHED"}
    (network,) = networks()
    network.hull_network.show_surface = True
    bpy.context.view_layer.update()
    finish()
    state = state_of(network)
    assert len(state.curves) > 30 and state.network.region_count > 140
    surface = part("features.hull.hull_state").state_of(hull).ship.surface
    tree = part("bridge.native").require().SurfaceTree(surface)
    apart = np.asarray(tree.closest_points(surface_points(network).astype(float)).distances)
    # That of the dense lines is 3.7e-4 (docs/networks.md).
    assert np.sqrt(np.mean(apart**2)) < 5e-4 * length
    # Curves are within their tolerance of the hull, by few points.
    curves = np.concatenate([points_of(network.objects[name]) for name in state.curves])
    assert np.asarray(tree.closest_points(curves).distances).max() < 1e-4 * length
    assert np.median([len(one.points) for one in state.curves.values()]) < 30
    assert_follows_moves(network, length)
    planes = [obj.hull.curve for obj in network.objects if obj.type == "CURVE"]
    assert {one.kind for one in planes} >= {"STATION", "WATERLINE", "PROFILE", "DECK_EDGE"}
    assert any(one.role == "KNUCKLE" for one in planes)


def assert_follows_moves(network, length):
    """Points of a station are moved without a pause: what is shown is the patches' all the same."""
    station = next(one for one in network.objects if one.name.startswith("Station 4"))
    for index in (3, 4, 3, 5):
        move_point(station, index, (0.0, 0.05, 0.0))
    shown, wanted = surface_points(network).astype(float), patch_points(network)
    assert len(shown) == len(wanted)
    for some in np.array_split(shown, 40):
        nearest = np.linalg.norm(some[:, None] - wanted[None], axis=2).min(axis=1)
        assert nearest.max() < 2e-6 * length


def test_a_section_lies_on_the_patches_and_is_tied():
    network = grid_network(show_surface=True)
    bpy.context.view_layer.update()
    assert bpy.ops.hull.add_network_section(kind="STATION", position=3.0) == {"FINISHED"}
    made = bpy.context.view_layer.objects.active
    points = points_of(made)
    assert made.hull.curve.kind == "STATION" and abs(made.hull.curve.position - 3.0) < _ROUNDING
    assert np.abs(points[:, 0] - 3.0).max() < _ROUNDING
    assert np.abs(points[:, 2] - height(points[:, 0], points[:, 1])).max() < 1e-3
    for y in (0.0, 5.0, 10.0):
        buttock = points_of(network.objects[f"Buttock {y:g}"])
        near = np.abs(buttock - (3.0, y, height(3.0, y))).max(axis=1)
        assert near.min() < 1e-4
        own = np.abs(points - buttock[near.argmin()]).max(axis=1).min()
        assert own < _ROUNDING
    state = state_of(network)
    assert state.network.region_count == 6 and state.problems == []
    with pytest.raises(RuntimeError, match="does not cut the surface"):
        bpy.ops.hull.add_network_section(kind="WATERLINE", position=50.0)


def wavy_station(network):
    at = np.linspace(0.0, 10.0, 21)
    noise = np.random.default_rng(7).normal(0.0, 0.02, len(at))
    noise[[0, -1]] = 0.0
    return add("STATION", [(5.0, y, 0.05 * y**2 + n) for y, n in zip(at, noise)], position=5.0)


def test_smoothing_moves_points_by_the_mean_deviation():
    network = new_network()
    station = wavy_station(network)
    before = points_of(station)
    make_active(station)
    assert bpy.ops.hull.smooth_network_curve(deviation_mm=8.0) == {"FINISHED"}
    after = points_of(station)
    moves = np.linalg.norm(after - before, axis=1)
    assert abs(np.sqrt(np.mean(moves**2)) - 0.008) < 1e-5
    assert np.abs(after[:, 0] - 5.0).max() == 0.0 and np.abs(moves[[0, -1]]).max() < _ROUNDING
    assert np.abs(np.diff(after[:, 2], 3)).max() < 0.8 * np.abs(np.diff(before[:, 2], 3)).max()
    bpy.ops.hull.smooth_network_curve(deviation_mm=0.0)
    assert np.abs(points_of(station) - after).max() < _ROUNDING


def test_points_count_by_their_weights():
    network = new_network()
    station = wavy_station(network)
    before = points_of(station)
    make_active(station)
    bpy.ops.hull.smooth_network_curve(deviation_mm=8.0)
    moved = abs(points_of(station)[8] - before[8]).max()
    bpy.data.objects.remove(station)
    station = wavy_station(network)
    station.data.splines[0].bezier_points[8].weight_softbody = 50.0
    make_active(station)
    bpy.ops.hull.smooth_network_curve(deviation_mm=8.0)
    assert abs(points_of(station)[8] - before[8]).max() < 0.2 * moved


def test_smoothing_takes_tied_curves_along():
    network = new_network()
    station = wavy_station(network)
    place = points_of(station)[8]
    line = add("WATERLINE", [(0, 3, place[2]), tuple(place), (10, 3, place[2])], position=place[2])
    make_active(station)
    bpy.ops.hull.smooth_network_curve(deviation_mm=15.0)
    now = points_of(station)[8]
    assert np.abs(now - points_of(line)[1]).max() < _ROUNDING
    assert abs(now[2] - place[2]) < _ROUNDING, "it stays in the waterline's plane"


def test_curves_that_miss_are_tied_within_the_reach():
    network = new_network()
    station = add("STATION", [(5, 0, 0), (5, 5, 2), (5, 10, 6)], position=5.0)
    line = add("FREE", [(0, 5, 2.03), (4, 5.2, 2.03), (10, 5, 2.03)])
    kinds = {one.text.split(":")[0] for one in state_of(network).problems}
    assert kinds
    assert bpy.ops.hull.tie_curves(reach=0.4) == {"FINISHED"}
    distance = np.linalg.norm(points_of(station)[:, None] - points_of(line)[None], axis=2)
    assert distance.min() < _ROUNDING and np.abs(points_of(station)[:, 0] - 5.0).max() == 0.0
    assert bpy.ops.hull.tie_curves() == {"FINISHED"}


def test_blenders_curves_of_all_kinds_are_taken():
    data = bpy.data.curves.new("imported", "CURVE")
    data.dimensions = "3D"
    poly = data.splines.new("POLY")
    poly.points.add(4)
    for i, point in enumerate(poly.points):
        point.co = (2.0, i, 0.1 * i * i, 1.0)
    nurbs = data.splines.new("NURBS")
    nurbs.points.add(5)
    for i, point in enumerate(nurbs.points):
        point.co = (i, 0.3 * i * i, 4.0, 1.0)
    nurbs.order_u, nurbs.use_endpoint_u = 4, True
    bezier = data.splines.new("BEZIER")
    bezier.bezier_points.add(2)
    for i, knot in enumerate(bezier.bezier_points):
        knot.co = (3.0 * i, 0.0, 0.5 * i * i)
        knot.handle_left_type = knot.handle_right_type = "AUTO"
    obj = bpy.data.objects.new("imported", data)
    bpy.context.collection.objects.link(obj)
    obj.location = (10.0, 0.0, 0.0)
    make_active(obj)
    bpy.context.view_layer.update()
    assert bpy.ops.hull.curves_to_network() == {"FINISHED"}
    (network,) = networks()
    kinds = sorted(one.hull.curve.kind for one in network.objects)
    assert kinds == ["PROFILE", "STATION", "WATERLINE"]
    assert sorted(round(one.hull.curve.position, 4) for one in network.objects) == [0.0, 4.0, 12.0]
    line = next(one for one in network.objects if one.hull.curve.kind == "WATERLINE")
    assert np.abs(points_of(line)[[0, -1]] - [(10, 0, 4), (15, 7.5, 4)]).max() < _ROUNDING
    assert len(state_of(network).curves) == 3


def test_slaves_follow_and_circles_are_named():
    network = new_network()
    master = add("FREE", [(0, 0, 0), (5, 1, 0), (10, 0, 0)])
    slave = add("FREE", [(5, 1, 0), (5.5, 5, 2), (6, 10, 6)])
    slave.hull.curve.start = "SLAVE_TANGENT"
    bpy.context.view_layer.update()
    assert any("follows no curve" in one.text for one in state_of(network).problems)
    slave.hull.curve.start_master = master
    bpy.context.view_layer.update()
    assert not any("follows" in one.text for one in state_of(network).problems)
    first, second = (
        slave.data.splines[0].bezier_points[0],
        master.data.splines[0].bezier_points[1],
    )
    own, other = first.handle_right - first.co, second.handle_right - second.co
    assert own.normalized().cross(other.normalized()).length < 1e-5
    master.hull.curve.start, master.hull.curve.start_master = "SLAVE_TANGENT", slave
    bpy.context.view_layer.update()
    assert any("circle" in one.text for one in state_of(network).problems)


def test_exact_shapes():
    network = new_network()
    arc = add("FREE", [(0, 0, 0), (0.2928932, 0.7071068, 0), (1, 1, 0)])
    arc.hull.curve.shape = "ARC"
    bpy.context.view_layer.update()
    (piece,) = state_of(network).curves[arc.name].pieces
    shapes = part("features.networks.curve_shapes")
    points = shapes.evaluate(piece, np.linspace(piece[1][0], piece[1][-1], 9))[0]
    assert np.abs(np.hypot(points[:, 0] - 1.0, points[:, 1]) - 1.0).max() < 1e-6
    _, bends = shapes.curvature(piece, np.linspace(piece[1][0], piece[1][-1], 9))
    assert np.abs(np.linalg.norm(bends, axis=1) - 1.0).max() < 1e-6
    arc.hull.curve.shape = "LINE"
    bpy.context.view_layer.update()
    assert state_of(network).problems, "a line has two points"


def bowl_network():
    """A half hull y = 2 - 0.5 (z - 2)² over x = 0 … 10, from its keel at z = 0 to z = 2."""
    network = new_network()
    at = np.linspace(0.0, 2.0, 9)
    for x in (0.0, 5.0, 10.0):
        add("STATION", [(x, 2.0 - 0.5 * (z - 2.0) ** 2, z) for z in at], position=x)
    for z in (0.0, 1.0, 2.0):
        y = 2.0 - 0.5 * (z - 2.0) ** 2
        add("WATERLINE", [(0.0, y, z), (5.0, y, z), (10.0, y, z)], position=z)
    bpy.context.view_layer.update()
    return network


def test_the_surface_is_measured_and_written(tmp_path):
    network = bowl_network()
    network.hull_network.draft = 1.0
    assert bpy.ops.hull.measure_network() == {"FINISHED"}
    measured = state_of(network).measured
    assert measured.lines[0] == "4 patches" and measured.revision == state_of(network).revision
    told = next(line for line in measured.lines if line.startswith("Displaced volume"))
    # 2 · 10 · ∫ 2 - (z - 2)² / 2 over z = 0 … 1, to what single precision leaves of the points.
    assert abs(float(told.split()[2]) - 20.0 * (2.0 - 7.0 / 6.0)) < 2e-3
    hn = part("bridge.native").require()
    for ending, both in ((".step", False), (".igs", True)):
        path = str(tmp_path / f"bowl{ending}")
        assert bpy.ops.hull.export_network(filepath=path, is_whole=both) == {"FINISHED"}
        report = hn.read_cad_report(path)
        assert report["valid"] and report["shells"] == 1
        assert report["faces"] == (8 if both else 4)
    before = sorted(tmp_path.iterdir())
    for nameless in ("", str(tmp_path) + "/"):
        with pytest.raises(RuntimeError, match="The file has no name: give one"):
            bpy.ops.hull.export_network(filepath=nameless, format=".igs")
    assert sorted(tmp_path.iterdir()) == before
    move_point(network.objects["Station 5"], 4, (0.0, 0.1, 0.0))
    assert state_of(network).revision != measured.revision


def test_where_one_curve_cannot_be_smoothed_none_is():
    network = grid_network(7)
    wavy = network.objects["Station 5"]
    short = add("BUTTOCK", [(0.0, 20.0, 0.0), (10.0, 20.0, 0.0)], position=20.0)
    move_point(wavy, 3, (0.0, 0.0, 0.3))
    before = points_of(wavy)
    wavy.select_set(True)
    short.select_set(True)
    with pytest.raises(RuntimeError, match="fewer than 5 points"):
        bpy.ops.hull.smooth_network_curve(deviation_mm=100.0)
    assert np.array_equal(points_of(wavy), before)


def test_what_cannot_be_taken_makes_no_network():
    data = bpy.data.curves.new("point", "CURVE")
    data.splines.new("POLY")
    alone = bpy.data.objects.new("point", data)
    bpy.context.collection.objects.link(alone)
    make_active(alone)
    before = set(bpy.data.collections)
    with pytest.raises(RuntimeError, match="no line of two points"):
        bpy.ops.hull.curves_to_network()
    assert set(bpy.data.collections) == before and alone.name in bpy.data.objects


def test_another_kind_is_placed_at_the_cursor_once_more():
    """As when a curve is added anew as another kind, with what was filled in meanwhile."""
    new_network()
    bpy.context.scene.cursor.location = (6.0, 1.5, 2.0)
    filled = {"position": 6.0, "placed_as": "STATION"}
    for kind, position, more in (
        ("STATION", 6.0, {}), ("WATERLINE", 2.0, filled), ("BUTTOCK", 1.5, filled),
        ("WATERLINE", 1.25, {**filled, "position": 1.25}), ("STATION", 6.0, filled),
    ):  # fmt: skip
        assert add(kind, **more).hull.curve.position == pytest.approx(position), (kind, more)


def test_a_network_that_is_deleted_while_it_is_measured_is_told_of():
    network = grid_network()
    name = network.name
    tasks = part("features.networks.surface_tasks")
    assert tasks.Measuring(network, bpy.context.scene).write()[0] == name
    task = tasks.Measuring(network, bpy.context.scene)
    bpy.data.collections.remove(network)
    with pytest.raises(ValueError, match="was deleted meanwhile"):
        task.write()
