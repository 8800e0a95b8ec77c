# SPDX-License-Identifier: GPL-3.0-or-later
"""Networks through undo, files, copies, deletions and what other tools do to curves: never a
traceback, always a sentence."""

import bpy
import numpy as np
import pytest
from addon_under_test import make_active, part
from networks import (
    add,
    finish,
    grid_network,
    move_point,
    new_network,
    patch_points,
    points_of,
    state_of,
    surface_points,
)


def networks():
    return part("bridge.objects.networks").all_networks()


def texts(network):
    return " ".join(one.text for one in state_of(network).problems)


def test_undo_takes_all_back():
    network = grid_network(show_surface=True)
    bpy.ops.ed.undo_push(message="network")
    before, shown = points_of(network.objects["Buttock 5"]), surface_points(network)
    move_point(network.objects["Station 5"], 1, (0.0, 0.0, 1.0))
    bpy.ops.ed.undo_push(message="moved")
    moved = points_of(network.objects["Buttock 5"])
    assert np.abs(moved - before).max() > 0.9
    bpy.ops.ed.undo()
    (network,) = networks()
    assert np.array_equal(points_of(network.objects["Buttock 5"]), before)
    assert np.abs(surface_points(network) - shown).max() < 1e-6
    bpy.ops.ed.redo()
    (network,) = networks()
    assert np.array_equal(points_of(network.objects["Buttock 5"]), moved)
    assert np.abs(surface_points(network) - patch_points(network)).max() < 1e-6
    assert state_of(network).problems == []


def test_undo_in_edit_mode_takes_tied_curves_back():
    network = grid_network()
    station = network.objects["Station 5"]
    make_active(station)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.ed.undo_push(message="edit")
    before = points_of(network.objects["Buttock 5"])
    move_point(station, 1, (0.0, 0.0, 1.0))
    bpy.ops.ed.undo_push(message="moved")
    assert np.abs(points_of(network.objects["Buttock 5"]) - before).max() > 0.9
    bpy.ops.ed.undo()
    (network,) = networks()
    bpy.context.view_layer.update()
    station, buttock = network.objects["Station 5"], network.objects["Buttock 5"]
    assert np.abs(points_of(buttock) - before).max() < 1e-6
    assert np.abs(points_of(station)[1] - points_of(buttock)[1]).max() < 1e-6


def test_a_file_keeps_it(tmp_path):
    network = grid_network(show_surface=True)
    finish()
    shown = surface_points(network)
    network.objects["Station 5"].hull.curve.role = "KNUCKLE"
    path = str(tmp_path / "network.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_homefile(use_empty=True)
    assert networks() == []
    bpy.ops.wm.open_mainfile(filepath=path)
    (network,) = networks()
    assert network.objects["Station 5"].hull.curve.role == "KNUCKLE"
    state = state_of(network)
    assert state.network.region_count == 4
    assert surface_points(network).shape == shown.shape
    move_point(network.objects["Station 5"], 1, (0.0, 0.0, 1.0))
    assert np.array_equal(
        points_of(network.objects["Buttock 5"])[1], points_of(network.objects["Station 5"])[1]
    )


def test_a_deleted_curve_goes_and_comes_back_as_a_copy():
    network = grid_network(show_surface=True)
    bpy.data.objects.remove(network.objects["Station 5"])
    bpy.context.view_layer.update()
    assert state_of(network).network.region_count == 2
    station = network.objects["Station 10"]
    make_active(station)
    bpy.ops.object.duplicate()
    copy = bpy.context.view_layer.objects.active
    assert "Station 10" in texts(network)  # a duplicate lies on it
    copy.location.x -= 5.0
    bpy.context.view_layer.update()
    assert abs(copy.hull.curve.position - 5.0) < 1e-6
    assert np.abs(points_of(station)[:, 0] - 10.0).max() < 1e-6, "the copy's ties are its own"


def test_a_deleted_surface_is_not_made_again():
    network = grid_network(show_surface=True)
    shown = network.hull_network.surface_object
    bpy.data.objects.remove(shown)
    bpy.context.view_layer.update()
    move_point(network.objects["Station 5"], 1, (0.0, 0.0, 1.0))
    network.hull_network.show_surface = False
    bpy.context.view_layer.update()
    network.hull_network.show_surface = True
    bpy.context.view_layer.update()
    assert len(surface_points(network)) == len(patch_points(network))


def test_without_ties_a_point_moves_alone():
    network = grid_network()
    network.hull_network.tie = False
    move_point(network.objects["Station 5"], 1, (0.0, 0.0, 1.0))
    assert points_of(network.objects["Buttock 5"])[1][2] < 0.6
    assert state_of(network).problems  # they miss one another


def odd_edits(network):
    """Pairs (what is done to a curve, words of the sentence that comes of it)."""
    station = network.objects["Station 5"]
    data = station.data

    def two_splines():
        data.splines.new("BEZIER").bezier_points.add(1)

    def closed():
        data.splines[0].use_cyclic_u = True

    def empty():
        data.splines.clear()

    def polygon():
        data.splines.clear()
        data.splines.new("POLY").points.add(3)

    def flat():
        station.scale = (1.0, 0.0, 1.0)

    def nowhere():
        data.splines[0].bezier_points[1].co = (float("nan"), 0.0, 0.0)

    def one_place():
        for knot in data.splines[0].bezier_points:
            for name in ("co", "handle_left", "handle_right"):
                setattr(knot, name, (5.0, 5.0, 0.5))

    def no_normal():
        station.hull.curve.plane, station.hull.curve.normal = "OWN", (0.0, 0.0, 0.0)

    def no_direction():
        station.hull.curve.end, station.hull.curve.end_direction = "TANGENT", (0.0, 0.0, 0.0)

    def self_master():
        station.hull.curve.start = "SLAVE_TANGENT"
        station.hull.curve.start_master = station

    return {
        "two_splines": (two_splines, "2 splines"),
        "closed": (closed, "closed"),
        "empty": (empty, "0 splines"),
        "polygon": (polygon, "no Bézier curve"),
        "flat": (flat, "scaled to nothing"),
        "nowhere": (nowhere, "without a place"),
        "one_place": (one_place, "Station 5"),
        "no_normal": (no_normal, "no normal"),
        "no_direction": (no_direction, "no direction"),
        "self_master": (self_master, "no other curve of the network"),
    }


@pytest.mark.parametrize("name", [
    "two_splines", "closed", "empty", "polygon", "flat", "nowhere", "one_place", "no_normal",
    "no_direction", "self_master"])  # fmt: skip
def test_odd_edits_are_told(name):
    network = grid_network(show_surface=True)
    network.hull_network.tie = name != "one_place"
    edit, words = odd_edits(network)[name]
    edit()
    network.objects["Station 5"].data.update_tag()
    network.objects["Station 5"].update_tag()
    bpy.context.view_layer.update()
    assert words in texts(network)
    index = next(i for i, one in enumerate(state_of(network).problems) if words in one.text)
    if state_of(network).problems[index].curves:
        assert bpy.ops.hull.select_network_problem(index=index) == {"FINISHED"}
        assert bpy.context.view_layer.objects.active.name == "Station 5"
    # The others go on.
    network.hull_network.tie = True
    move_point(network.objects["Station 10"], 1, (0.0, 0.0, 0.5))
    assert abs(points_of(network.objects["Buttock 5"])[-1][2] - 1.5) < 1e-5


def test_random_orders_end_in_no_traceback(capsys):
    random = np.random.default_rng(11)
    network = grid_network(show_surface=True)
    bpy.ops.ed.undo_push(message="begin")
    for step in range(60):
        (network,) = networks()
        curves = [one for one in network.objects if one.type == "CURVE"]
        if not curves:
            add("STATION", position=float(random.uniform(0, 10)))
            continue
        obj = curves[random.integers(len(curves))]
        what = random.integers(8)
        knots = obj.data.splines[0].bezier_points if obj.data.splines else ()
        if what == 0 and len(knots) and obj.data.splines[0].type == "BEZIER":
            move_point(obj, int(random.integers(len(knots))), random.normal(0.0, 0.3, 3))
        elif what == 1:
            obj.location = random.normal(0.0, 0.2, 3)
        elif what == 2:
            obj.hull.curve.role = ("FOUND", "KNUCKLE", "REFERENCE")[random.integers(3)]
        elif what == 3 and len(curves) > 3:
            bpy.data.objects.remove(obj)
        elif what == 4:
            make_active(obj)
            bpy.ops.object.duplicate()
        elif what == 5:
            network.hull_network.show_surface = bool(random.integers(2))
        elif what == 6 and bpy.ops.ed.undo.poll():
            bpy.ops.ed.undo()
        elif what == 7 and len(knots):
            make_active(obj)
            bpy.ops.object.mode_set(mode="EDIT")
            bpy.ops.curve.select_all(action="SELECT")
            bpy.ops.curve.subdivide()
            bpy.ops.object.mode_set(mode="OBJECT")
        bpy.context.view_layer.update()
        bpy.ops.ed.undo_push(message=str(step))
    finish()
    printed = capsys.readouterr()
    assert "Traceback" not in printed.out + printed.err


def test_an_extruded_point_leaves_what_is_tied():
    network = grid_network()
    station, buttock = network.objects["Station 5"], network.objects["Buttock 10"]
    before = points_of(buttock)
    make_active(station)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.curve.select_all(action="DESELECT")
    last = station.data.splines[0].bezier_points[-1]
    last.select_control_point = last.select_left_handle = last.select_right_handle = True
    bpy.ops.curve.extrude()
    bpy.context.view_layer.update()
    move_point(station, 3, (0.0, 1.0, 1.0))
    assert len(points_of(station)) == 4
    assert np.array_equal(points_of(buttock), before)
    move_point(station, 2, (0.0, 0.0, 0.5))
    assert abs(points_of(buttock)[1][2] - before[1][2] - 0.5) < 1e-6


def test_turned_and_scaled_objects_come_to_rest():
    network = grid_network()
    station = network.objects["Station 5"]
    writes = []
    curves = part("bridge.objects.bezier_curves")
    write = curves.write
    curves.write = lambda obj, *more: (writes.append(obj.name), write(obj, *more))
    try:
        for location, turn, scale in (
            ((3000.0, 0.0, 0.0), 0.0, 1.0), ((0.0, 0.0, 0.0), 0.7, 0.3), ((1e4, 1e4, 0.0), 2.0, 7.0)
        ):  # fmt: skip
            station.location, station.scale = location, (scale,) * 3
            station.rotation_euler = (turn, 0.3 * turn, turn)
            for _ in range(3):
                bpy.context.view_layer.update()
            writes.clear()
            for _ in range(3):
                station.update_tag()
                bpy.context.view_layer.update()
            assert not writes
    finally:
        curves.write = write


def test_units_of_the_scene_count():
    bpy.context.scene.unit_settings.scale_length = 0.01
    network = grid_network()
    assert np.abs(np.asarray(state_of(network).network.nodes)).max() < 0.11
    move_point(network.objects["Station 5"], 1, (0.0, 0.0, 1.0))
    assert abs(points_of(network.objects["Buttock 5"])[1][2] - 1.5) < 1e-5
    bpy.context.scene.unit_settings.scale_length = 1.0
    bpy.context.view_layer.update()
    assert np.abs(np.asarray(state_of(network).network.nodes)).max() > 9.9


def test_a_network_that_shares_its_curves_and_one_left_out():
    network = grid_network(show_surface=True)
    copy = network.copy()
    bpy.context.scene.collection.children.link(copy)
    bpy.context.view_layer.update()
    move_point(network.objects["Station 5"], 1, (0.0, 0.0, 1.0))
    assert np.abs(surface_points(network) - patch_points(network)).max() < 1e-5
    bpy.data.collections.remove(copy)
    bpy.context.view_layer.update()
    bpy.context.view_layer.objects.active = None
    bpy.context.view_layer.layer_collection.children[network.name].exclude = True
    bpy.context.view_layer.update()
    with pytest.raises(RuntimeError, match="outliner"):
        bpy.ops.hull.add_network_curve(kind="STATION", position=3.0)


def test_refused_input_has_a_sentence():
    with pytest.raises(RuntimeError, match="make a network"):
        bpy.ops.hull.add_network_curve(kind="STATION")
    network = new_network()
    for text, words in (("1 2", "x y z"), ("1 2 3", "two points"), ("0 0 0; 0 0 0", "same place"),
                        ("0 0 0; nan 0 0", "no place")):  # fmt: skip
        with pytest.raises(RuntimeError, match=words):
            bpy.ops.hull.add_network_curve(kind="FREE", points=text)
    with pytest.raises(RuntimeError, match="has no curves"):
        bpy.ops.hull.tie_curves()
    with pytest.raises(RuntimeError, match="no longer"):
        bpy.ops.hull.select_network_problem(index=3)
    with pytest.raises(RuntimeError, match="Select curves"):
        bpy.ops.hull.smooth_network_curve()
    with pytest.raises(RuntimeError, match="Select curve objects"):
        bpy.ops.hull.curves_to_network()
    line = add("FREE", [(0, 0, 0), (1, 0, 0)])
    with pytest.raises(RuntimeError, match="fewer than 5 points"):
        bpy.ops.hull.smooth_network_curve()
    assert bpy.ops.hull.remove_from_network() == {"FINISHED"}
    assert line.name not in network.objects


def test_what_is_tied_follows_a_curve_that_was_renamed():
    network = grid_network()
    station = network.objects["Station 5"]
    station.name = "Main frame"
    bpy.context.view_layer.update()
    before = points_of(network.objects["Buttock 5"])
    move_point(station, 1, (0.0, 0.0, 1.0))
    moved = points_of(network.objects["Buttock 5"])
    assert np.abs(moved - before).max() == pytest.approx(1.0, abs=1e-6)
    assert "Main frame" in state_of(network).curves and "Station 5" not in state_of(network).curves


def test_a_copy_that_shares_its_data_moves_nothing():
    """As Alt D makes it: what was written to one would move the other."""
    network = grid_network()
    curves = part("bridge.objects.networks").curves_of(network)
    station = next(one for one in curves if one.name == "Station 10")
    before = points_of(station)
    twin = station.copy()
    network.objects.link(twin)
    for x in (5.0, 7.0):
        twin.location.x = x
        bpy.context.view_layer.update()
        assert np.array_equal(points_of(station), before)
    (told,) = (one for one in state_of(network).problems if twin.name in one.curves)
    assert "single-user" in told.text and state_of(network).is_joined
    move_point(station, 1, (0.0, 0.0, 0.3))
    assert np.allclose(points_of(station)[1], before[1] + (0.0, 0.0, 0.3), atol=1e-5)
    twin.data = twin.data.copy()
    bpy.context.view_layer.update()
    assert not any("single-user" in one.text for one in state_of(network).problems)
    assert twin.name in state_of(network).curves
