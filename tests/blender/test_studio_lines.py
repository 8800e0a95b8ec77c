# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines drawn on the samples lie on their hulls: no end sticks out, none is lost in a facet."""

import bpy
import numpy as np
import pytest
from addon_under_test import ROOT, part, state_of
from mathutils.bvhtree import BVHTree

# One of so many points of tubes that have six around: all sides of them.
_EACH = 5
SAMPLES = sorted(path.name.split(".")[0] for path in (ROOT / "samples").glob("*.hull.json"))


def set_up(name):
    """(hull, the curves drawn on it)."""
    bpy.ops.hull.load_sample(name=name)
    hull = bpy.context.object
    bpy.ops.hull.make_studio()
    collection = part("features.studio").find(bpy.context.scene)
    return hull, [obj for obj in collection.objects if obj.type == "CURVE"]


def points_drawn(curve):
    """Vertices (n, 3) of what Blender makes of a curve."""
    evaluated = curve.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = evaluated.to_mesh()
    points = np.empty((len(mesh.vertices), 3), dtype=np.float32)
    mesh.vertices.foreach_get("co", points.reshape(-1))
    evaluated.to_mesh_clear()
    return points.astype(np.float64)


def assert_on_the_surface(hull, curve):
    """The curve itself is on the exact surface, but for a small part of its breadth."""
    breadth, curve.data.bevel_depth = curve.data.bevel_depth, 0.0
    points = points_drawn(curve)
    curve.data.bevel_depth = breadth
    assert len(points) > 100
    if hull.hull.half:
        assert points[:, 1].min() < 0.0
        points[:, 1] = np.abs(points[:, 1])
    tree = part("bridge.native").require().SurfaceTree(state_of(hull).ship.surface)
    off = tree.closest_points(points).distances
    assert off.max() < 0.1 * breadth, (curve.name, points[off.argmax()])


def assert_on_what_is_shown(faces, curve):
    """The tube around it stands off the faces by no more than its breadth."""
    points = points_drawn(curve)[::_EACH]
    off = np.array([faces.find_nearest(point)[3] for point in points])
    assert off.max() < 1.1 * curve.data.bevel_depth, (curve.name, points[off.argmax()])


@pytest.mark.parametrize("name", SAMPLES)
def test_lines_of_samples_lie_on_the_surface(name):
    hull, curves = set_up(name)
    mesh = hull.hull.surface_object.data
    corners = [vertex.co[:] for vertex in mesh.vertices]
    faces = BVHTree.FromPolygons(corners, [face.vertices[:] for face in mesh.polygons])
    assert len(curves) == 4
    for curve in curves:
        assert_on_the_surface(hull, curve)
        assert_on_what_is_shown(faces, curve)


def test_there_are_only_so_many_waterlines():
    """Of a draft that is next to nothing, as while it is typed, and of a hull without height."""
    found = part("features.studio.lines_on_hull")._even_waterlines
    cut = part("features.lines.lines").Cut
    box = np.array([(0.0, 0.0, 0.0), (20.0, 4.0, 10.0)])
    usual = found((cut((0.0, 0.0, 1.0, 5.0)),), box)
    assert 5 < len(usual) < 40
    assert found((cut((0.0, 0.0, 1.0, 1e-3)),), box) == found((), box)
    assert found((), box * (1.0, 1.0, 0.0)) == ()
    assert part("features.studio.lines_on_hull")._even_stations(box * (0.0, 1.0, 1.0)) == ()
