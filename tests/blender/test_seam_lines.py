# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams and butts over the view: where they are, and that they follow the hull."""

import time

import bpy
import numpy as np
import pytest
from addon_under_test import part, sample
from test_plate_drawings import plated

pytestmark = pytest.mark.once


def shown(hull):
    return part("features.production.seam_lines").shown(hull)


def laid_out(*name, **sizes):
    hull = plated(*name, **sizes)
    assert bpy.ops.hull.lay_out_plates() == {"FINISHED"}
    return hull


def surface_of(hull):
    return part("features.hull.hull_state").state_of(hull).ship.surface


def distances(hull, points):
    tree = part("bridge.native").require().SurfaceTree(surface_of(hull))
    return tree.closest_points(points).distances


def test_nothing_is_shown_before_plates_are_laid_out():
    assert shown(sample("planing_boat")) is None


def test_the_seams_of_the_layout_are_shown():
    hull = laid_out()
    group = shown(hull)
    kept = part("features.hull.hull_state").state_of(hull)
    layout = kept.of(part("features.production.plate_files").KeptPlates).layout
    assert group.is_current and len(group.polylines) == len(layout.seams)
    for line, curve in zip(group.polylines, layout.seams):
        np.testing.assert_allclose(line, curve.points, atol=1e-12)
    assert group.names[0] == "P1" and len(group.names) == len(layout.listed)
    np.testing.assert_allclose(distances(hull, group.places), 0.0, atol=1e-9)
    assert shown(hull) is group
    hull.hull.plates.show_seams = False
    assert shown(hull) is None


def test_seams_stay_on_the_hull_while_it_moves():
    hull = laid_out()
    before = shown(hull)
    for vertex in hull.data.vertices:
        vertex.co.z *= 1.1
    hull.data.update()
    bpy.context.view_layer.update()
    start = time.perf_counter()
    after = shown(hull)
    assert time.perf_counter() - start < 1.0
    assert not after.is_current
    # A scaled surface has its scaled points at the same parameters.
    for was, line in zip(before.polylines, after.polylines):
        np.testing.assert_allclose(line, was * [1.0, 1.0, 1.1], atol=1e-6)
    points = np.concatenate(after.polylines)
    np.testing.assert_allclose(distances(hull, points), 0.0, atol=1e-8)
    for vertex in hull.data.vertices:
        vertex.co.z /= 1.1


def test_seams_follow_a_curved_hull():
    """Bent, so that nothing of it is the old one scaled: on the new surface and off the old one, at
    the same parameters."""
    hull = laid_out("planing_boat", strake=2.0, butts=20.0)
    before, tree = shown(hull), part("bridge.native").require().SurfaceTree(surface_of(hull))
    was = np.concatenate(before.polylines)
    places = tree.closest_points(was)
    length = max(vertex.co.x for vertex in hull.data.vertices)
    for vertex in hull.data.vertices:
        along = vertex.co.x / length
        vertex.co.y *= 1.0 + 0.2 * along**2
        vertex.co.z += 0.1 * along**2
    hull.data.update()
    bpy.context.view_layer.update()
    after = shown(hull)
    assert not after.is_current and len(after.polylines) == len(before.polylines) > 2
    points, surface = np.concatenate(after.polylines), surface_of(hull)
    assert distances(hull, points).max() < 1e-9 * surface.mesh.size
    assert distances(hull, was).max() > 0.02
    there = surface.positions(places.cells, places.uv)
    np.testing.assert_allclose(points, there, atol=1e-6 * surface.mesh.size)


def test_seams_of_other_faces_are_not_shown():
    hull = laid_out()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide(number_cuts=1)
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.context.view_layer.update()
    assert shown(hull) is None


def test_names_are_of_plates_that_face_the_eye():
    from types import SimpleNamespace

    from mathutils import Matrix

    seams = part("overlays.seams")
    places, normals = np.zeros((3, 3)), np.array([[0, 0, 1.0], [0, 0, -1.0], [3.0, 0, 4.0]])
    view = SimpleNamespace(view_matrix=Matrix.Translation((0, 0, -5)), is_perspective=True)
    np.testing.assert_allclose(seams.facing(places, normals, view), [1.0, 0.0, 0.8], atol=1e-7)
    view.is_perspective = False
    np.testing.assert_allclose(seams.facing(places, normals, view), [1.0, 0.0, 0.8], atol=1e-7)


def test_what_is_not_laid_out_leaves_the_seams_of_before():
    hull = laid_out()
    before = shown(hull)
    bpy.ops.hull.change_plate_list(action="ADD_RULE")
    hull.hull.plates.rules[-1].kind, hull.hull.plates.rules[-1].value = "station", 1e3
    with pytest.raises(RuntimeError):
        bpy.ops.hull.lay_out_plates()
    assert shown(hull) is before
