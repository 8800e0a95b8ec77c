# SPDX-License-Identifier: GPL-3.0-or-later
"""Networks made hulls: what is laid, told, taken back and refused."""

import bpy
import numpy as np
import pytest
from addon_under_test import make_active, part, sample
from networks import add, grid_network, move_point, new_network
from test_panels import texts

pytestmark = pytest.mark.once

BUDGET = 100


def panel_of(network):
    make_active(next(obj for obj in network.objects if obj.type == "CURVE"))
    return texts()["HULL_PT_network_hull"]


def coaster_network():
    """(the hull, its network of nine stations and four waterlines)."""
    hull = sample("coaster")
    stations = " ".join(f"{x:.4f}" for x in np.linspace(-2.0, 84.0, 11)[1:-1])
    waterlines = " ".join(f"{z:.4f}" for z in np.linspace(0.0, 11.0, 6)[1:-1])
    assert bpy.ops.hull.network_from_hull(stations=stations, waterlines=waterlines) == {"FINISHED"}
    (network,) = part("bridge.objects.networks").all_networks()
    network.hull_network.hull_points = BUDGET
    return hull, network


def distances(hull, points):
    """Of points (n, 3), m, from the surface of a hull as it is in Blender."""
    surface = part("features.hull.hull_state").up_to_date(hull, bpy.context.scene).ship.surface
    tree = part("bridge.native").require().SurfaceTree(surface)
    return np.asarray(tree.closest_points(points).distances)


def test_the_lines_of_a_hull_become_a_hull():
    source, network = coaster_network()
    to_hull = part("features.networks.to_hull")
    length = source.dimensions.x
    assert bpy.ops.hull.network_to_hull() == {"FINISHED"}
    hull = bpy.context.view_layer.objects.active
    assert hull.hull.is_hull and hull.hull.half and hull == network.hull_network.hull
    assert len(hull.data.vertices) <= BUDGET and len(hull.data.polygons) > 50
    report, is_current = to_hull.last_report(network)
    assert is_current and report.points == len(hull.data.vertices)
    # Between few lines, and with fewer points than the sample has.
    assert report.rms < 3e-4 * length and report.largest < 2e-3 * length
    # By another way: of what the mesh is in Blender, to single precision.
    worst = report.curves[0]
    assert worst.largest == report.largest
    assert distances(hull, [worst.place])[0] == pytest.approx(worst.largest, abs=1e-6 * length)
    # The flat bottom is the source's.
    flats = part("features.constraints.flats").regions(hull)
    (bottom,) = (region for region in flats if region.kind == "BOTTOM")
    assert bottom.plane[3] == pytest.approx(min(v.co.z for v in source.data.vertices), abs=1e-5)
    assert any(f"{1e3 * report.rms:.3g} mm" in text for text in panel_of(network))
    told = to_hull.of_curve(network, worst.name)
    assert told.largest == worst.largest
    bpy.ops.hull.show_network_miss(index=0)
    assert np.allclose(bpy.context.scene.cursor.location, worst.place, atol=1e-4)
    # What is changed later is told.
    curves = part("bridge.objects.networks").curves_of(network)
    curve = next(one for one in curves if one.hull.curve.kind == "STATION")
    move_point(curve, 1, (0.0, 0.25, 0.0))
    assert not to_hull.last_report(network)[1] and to_hull.of_curve(network, worst.name) is None
    assert any("Out of date" in text for text in panel_of(network))
    move_point(curve, 1, (0.0, -0.25, 0.0))
    assert to_hull.last_report(network)[1]
    hull.data.vertices[0].co.z += 0.1
    hull.data.update()
    bpy.context.view_layer.update()
    part("features.hull.hull_state").up_to_date(hull, bpy.context.scene)
    assert not to_hull.last_report(network)[1]
    assert any("Out of date" in text for text in panel_of(network))
    # The network keeps a hull that was deleted, which is told of no longer.
    for collection in hull.users_collection:
        collection.objects.unlink(hull)
    assert to_hull.last_report(network) == (None, False)


def test_a_layout_of_ones_own_is_taken():
    source, network = coaster_network()
    network.hull_network.layout_hull = source
    bpy.ops.ed.undo_push(message="before")
    before = len(bpy.data.objects)
    make_active(source)
    assert bpy.ops.hull.network_to_hull() == {"FINISHED"}
    hull = bpy.context.view_layer.objects.active
    assert hull != source and len(hull.data.vertices) == len(source.data.vertices)
    assert len(hull.data.polygons) == len(source.data.polygons)
    report, _ = part("features.networks.to_hull").last_report(network)
    # Its own lines by few points each are within 5e-5 of the size.
    assert report.largest < 2e-4 * source.dimensions.x
    bpy.ops.ed.undo_push(message="after")
    bpy.ops.ed.undo()
    assert len(bpy.data.objects) == before
    (network,) = part("bridge.objects.networks").all_networks()
    assert part("features.networks.to_hull").last_report(network) == (None, False)


def refused(words):
    before = {block.name for block in bpy.data.objects}
    with pytest.raises(RuntimeError, match=words):
        bpy.ops.hull.network_to_hull()
    assert {block.name for block in bpy.data.objects} == before


def test_what_makes_no_hull_is_refused_and_nothing_is_left():
    refused("Select a curve of a network first")
    network = new_network()
    refused("has no curves")
    add("PROFILE", [(0, 0, 1), (5, 0, 0), (9, 0, 2)])
    refused("The network has no regions")
    bpy.data.collections.remove(network)
    network = grid_network()
    refused("rises to no stem")
    hull = sample("coaster")
    hull.location.y = 3.0
    bpy.context.view_layer.update()
    network.hull_network.layout_hull = hull
    make_active(next(iter(network.objects)))
    refused("is not at the origin")
    hull.location.y, hull.hull.half = 0.0, False
    bpy.context.view_layer.update()
    refused("whole hull")
    hull.hull.half = True
    network.hull_network.layout_hull = None
