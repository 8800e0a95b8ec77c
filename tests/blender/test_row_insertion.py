# SPDX-License-Identifier: GPL-3.0-or-later
"""A row of control points inserted: the surface stays nearly as it is, and so do tags."""

import bpy
import numpy as np
import pytest
from addon_under_test import part, state_of
from edited_hulls import edit, select


def new_hull():
    bpy.ops.hull.add_hull(kind="ROUND_BILGE", length=80.0, beam=13.0, draft=5.0, depth=7.0)
    return bpy.context.view_layer.objects.active


def edge_at(hull, place):
    """The edge along the ship whose middle is nearest to a place."""
    points = part("bridge.mesh.mesh_points").read(hull.data)
    edges = np.array([edge.vertices[:] for edge in hull.data.edges])
    along = np.abs(np.diff(points[edges], axis=1)[:, 0, 0]) > 1.0
    distances = np.linalg.norm(points[edges].mean(axis=1) - place, axis=1)
    return edges[np.argmin(np.where(along, distances, np.inf))].tolist()


def insert(hull, *edges):
    edit(hull, (False, True, False))
    select(hull, "edge", edges)
    found = part("features.modelling.row_insertion").insert_rows(hull, bpy.context.scene)
    bpy.ops.object.mode_set(mode="OBJECT")
    return found


@pytest.mark.parametrize("place", [(64.0, 5.0, 3.0), (8.0, 6.0, 3.0), (38.0, 6.0, 3.0)])
def test_the_surface_stays_nearly(place):
    hull = new_hull()
    old = state_of(hull).ship.source.new_surface()
    volume, count = state_of(hull).hydrostatics.values.displaced_volume, len(hull.data.vertices)
    found = insert(hull, edge_at(hull, place))
    state = state_of(hull)
    assert not state.status and len(hull.data.vertices) == count + found.count > count
    points = state.ship.surface.tessellate(7).points
    native = part("bridge.native").require()
    distance = native.SurfaceTree(old).closest_points(points).distances.max()
    assert distance == pytest.approx(found.change, rel=0.2)
    assert found.change < min(3e-3, found.cut_change)
    assert found.cut_change < 10e-3 or found.change < 0.05 * found.cut_change
    assert abs(state.hydrostatics.values.displaced_volume - volume) < 0.1


def test_rows_may_cross():
    hull = new_hull()
    points = part("bridge.mesh.mesh_points").read(hull.data)
    along = edge_at(hull, (38.0, 6.0, 3.0))
    edges = [edge.vertices[:] for edge in hull.data.edges]
    across = next(
        edge
        for edge in edges
        if along[0] in edge and abs(points[edge[0], 0] - points[edge[1], 0]) < 1e-3
    )
    before = len(hull.data.vertices)
    found = insert(hull, along, list(across))
    assert len(hull.data.vertices) == before + found.count and not state_of(hull).status


def test_locked_points_and_flats_stay():
    bpy.ops.hull.load_sample(name="bulk_carrier")
    hull = bpy.context.view_layer.objects.active
    middle = 0.5 * max(hull.dimensions)
    insert(hull, edge_at(hull, (middle, 0.4 * hull.dimensions[1], 0.5 * hull.hull.draft)))
    flats = part("features.constraints.flats")
    points = part("bridge.mesh.mesh_points").read(hull.data)
    for indices, plane in flats.flat_planes(hull):
        off = points[np.array(indices)] @ np.array(plane[:3]) - plane[3]
        assert np.abs(off).max() < 1e-4


def test_what_is_missing_is_said():
    hull = new_hull()
    edit(hull, (False, True, False))
    with pytest.raises(RuntimeError, match="Select an edge"):
        bpy.ops.hull.insert_row()
    bpy.ops.object.mode_set(mode="OBJECT")


def test_so_many_points_that_it_would_take_long_are_refused():
    hull = new_hull()
    bpy.ops.hull.subdivide_exactly()
    before = part("bridge.mesh.mesh_points").read(hull.data).tobytes()
    edit(hull, (False, True, False))
    bpy.ops.mesh.select_all(action="SELECT")
    with pytest.raises(RuntimeError, match="more than 200 points: .* Subdivide Exactly"):
        bpy.ops.hull.insert_row()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert part("bridge.mesh.mesh_points").read(hull.data).tobytes() == before
