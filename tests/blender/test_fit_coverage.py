# SPDX-License-Identifier: GPL-3.0-or-later
"""What a target does not cover is left alone by a fit: decks, whatever stands on or beside them."""

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, part
from test_fit import box_target, points_of, wanted


def decked_box():
    """The box with a deck of two by two faces, its middle point 0.4 m up."""
    hull = add_hull()
    mesh = hull.data
    points = [vertex.co[:] for vertex in mesh.vertices]
    faces = [tuple(polygon.vertices) for polygon in mesh.polygons]
    top = {(x, y): points.index((x, y, 3.0)) for x in (0.0, 10.0) for y in (0.0, 2.0)}
    number = len(points)
    points += [(5.0, 0.0, 3.0), (5.0, 2.0, 3.0), (0.0, 1.0, 3.0), (10.0, 1.0, 3.0), (5.0, 1.0, 3.4)]
    keel, side, aft, fore, middle = range(number, number + 5)
    a, b, c, d = top[0.0, 0.0], top[0.0, 2.0], top[10.0, 2.0], top[10.0, 0.0]
    deck = [(a, keel, middle, aft), (keel, d, fore, middle), (aft, middle, side, b)]
    deck.append((middle, fore, c, side))
    low = {(x, y): points.index((x, y, 0.0)) for x in (0.0, 10.0) for y in (0.0, 2.0)}
    hull_faces = [(low[0.0, 2.0], b, side, c, low[10.0, 2.0]), faces[1]]
    hull_faces += [(low[0.0, 0.0], a, aft, b, low[0.0, 2.0])]
    hull_faces += [(low[10.0, 0.0], low[10.0, 2.0], c, fore, d)]
    mesh.clear_geometry()
    mesh.from_pydata(points, [], hull_faces + deck)
    inner = {tuple(sorted((middle, other))) for other in (keel, side, aft, fore)}
    edges = [edge.index for edge in mesh.edges if tuple(sorted(edge.vertices)) not in inner]
    part("bridge.blender.blender_versions").set_creases(mesh, edges, [])
    bpy.context.view_layer.update()
    assert wanted(hull).mesh.face_count == 8
    return hull, middle


def test_a_deck_without_target_is_left_alone():
    hull, middle = decked_box()
    hull.hull.fit.target = box_target(False)
    hull.hull.fit.fairness = 1e-2
    before = points_of(hull)
    assert bpy.ops.hull.fit() == {"FINISHED"}
    report, _ = part("features.fitting.fitting").last_report(hull)
    assert report.faces_alone == 4
    assert (points_of(hull)[middle] == before[middle]).all()
    assert np.abs(points_of(hull) - before).max() > 0.05
    rows = dict(part("features.fitting.fitting").rows(report))
    assert rows["Faces without target"] == "4"


def cloud_target(points):
    mesh = bpy.data.meshes.new("cloud")
    mesh.from_pydata(points, [], [])
    obj = bpy.data.objects.new("cloud", mesh)
    bpy.context.collection.objects.link(obj)
    return obj


@pytest.mark.parametrize("leaning", [0.0, 0.1])
def test_a_bulwark_of_points_covers_no_deck(leaning):
    """Points alone of side and bottom; they go on above the deck, and may lean over it."""
    hull, middle = decked_box()
    xs, heights = np.linspace(0.1, 9.9, 50), np.linspace(0.1, 3.3, 33)
    side = [(x, 2.1 - leaning * max(z - 2.0, 0.0), z) for x in xs for z in heights]
    bottom = [(x, y, 0.0) for x in xs for y in np.linspace(0.05, 1.95, 20)]
    hull.hull.fit.target = cloud_target([*side, *bottom])
    before = points_of(hull)
    assert bpy.ops.hull.fit() == {"FINISHED"}
    report, _ = part("features.fitting.fitting").last_report(hull)
    assert report.faces_alone >= 4
    assert (points_of(hull)[middle] == before[middle]).all()
    assert np.abs(points_of(hull) - before).max() > 0.05


@pytest.mark.parametrize("kind", ["plate", "point"])
def test_what_stands_on_a_deck_covers_none(kind):
    hull, middle = decked_box()
    target = box_target(False)
    if kind == "plate":
        points = [vertex.co[:] for vertex in target.data.vertices]
        faces = [tuple(polygon.vertices) for polygon in target.data.polygons]
        number = len(points)
        points += [(4.7, 0.7, 2.9), (5.3, 0.7, 2.9), (5.3, 1.2, 2.9), (4.7, 1.2, 2.9)]
        faces.append(tuple(range(number, number + 4)))
        target.data.clear_geometry()
        target.data.from_pydata(points, [], faces)
    else:
        xs, ys = np.linspace(0.1, 9.9, 40), np.linspace(0.1, 1.9, 20)
        side = [(x, 2.1, z) for x in xs for z in np.linspace(0.1, 2.9, 20)]
        bottom = [(x, y, 0.0) for x in xs for y in ys]
        target = cloud_target([*side, *bottom, (5.0, 1.0, 2.9)])
    hull.hull.fit.target = target
    before = points_of(hull)
    assert bpy.ops.hull.fit() == {"FINISHED"}
    report, _ = part("features.fitting.fitting").last_report(hull)
    assert report.faces_alone >= 4 and report.left_out > 0
    assert (points_of(hull)[middle] == before[middle]).all()
    assert np.abs(points_of(hull) - before).max() > 0.05


def test_a_deck_with_targets_all_over_is_fitted():
    hull, middle = decked_box()
    target = box_target(False)
    points = [vertex.co[:] for vertex in target.data.vertices]
    faces = [tuple(polygon.vertices) for polygon in target.data.polygons]
    target.data.clear_geometry()
    target.data.from_pydata(points, [], [*faces, (1, 5, 7, 3)])
    hull.hull.fit.target = target
    before = points_of(hull)
    assert bpy.ops.hull.fit() == {"FINISHED"}
    report, _ = part("features.fitting.fitting").last_report(hull)
    assert report.faces_alone == 0
    assert points_of(hull)[middle][2] < before[middle][2] - 0.2
