# SPDX-License-Identifier: GPL-3.0-or-later
"""Developable strips, cones and cylinders from chains of edges in Blender."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, mesh_points, part
from edited_hulls import edit, select
from test_developables import edited_boat, regions, row_of

BOTTOM, DECK = ((0, 2, 0), (10, 2, 0)), ((0, 2, 3), (10, 2, 3))


def edges_along(hull, begin, end):
    """Edges of a box's chain between two places, which lie on one line."""
    a, b = np.array(begin, float), np.array(end, float)
    way = (b - a) / np.linalg.norm(b - a)

    def is_on(vertex):
        off = np.array(vertex.co) - a
        return np.linalg.norm(off - (off @ way) * way) < 1e-6

    bm = bmesh.from_edit_mesh(hull.data)
    return [
        tuple(vertex.index for vertex in edge.verts)
        for edge in bm.edges
        if all(map(is_on, edge.verts))
    ]


def box(*lines):
    hull = add_hull()
    edit(hull, (False, True, False))
    select(hull, "edge", [edge for line in lines for edge in edges_along(hull, *line)])
    return hull


def made_by(hull, **options):
    """(points (n, 3), faces) of the object that is made."""
    before = set(bpy.data.objects)
    assert bpy.ops.hull.developable_strip(**options) == {"FINISHED"}
    assert hull.mode == "OBJECT" and bpy.context.object == hull
    (shown,) = set(bpy.data.objects) - before
    assert shown.parent == hull
    return mesh_points(shown), [tuple(face.vertices) for face in shown.data.polygons]


def test_a_strip_between_a_box_s_knuckle_and_deck_edge():
    hull = box(BOTTOM, DECK)
    points, faces = made_by(hull, count=20)
    assert points[:, 1] == pytest.approx(2.0, abs=1e-6)
    assert set(np.round(points[:, 2], 5)) == {0.0, 3.0}
    assert area(points, faces) == pytest.approx(30.0, rel=1e-6)


def area(points, faces):
    whole = 0.0
    for face in faces:
        first, *others = points[list(face)].astype(float)
        for a, b in zip(others, others[1:]):
            whole += 0.5 * np.linalg.norm(np.cross(a - first, b - first))
    return whole


def test_a_cone_to_the_cursor():
    hull = box(DECK)
    bpy.context.scene.cursor.location = (5.0, -4.0, 7.0)
    points, faces = made_by(hull, form="CONE", count=20)
    assert len(faces) == 20 and {len(face) for face in faces} == {3}
    apex = np.flatnonzero((np.abs(points - [5.0, -4.0, 7.0]) < 1e-6).all(axis=1))
    assert len(apex) == 1 and all(int(apex[0]) in face for face in faces)
    # A triangle of the deck edge, 10 m, and the distance from it, 6 m and 4 m.
    assert area(points, faces) == pytest.approx(0.5 * 10.0 * np.hypot(6.0, 4.0), rel=1e-6)


def test_a_cylinder_along_a_direction():
    hull = box(DECK)
    points, faces = made_by(hull, form="CYLINDER", shift=(0.0, -1.0, 2.0), count=20)
    assert len(faces) == 20 and len(points) == 42
    assert area(points, faces) == pytest.approx(10.0 * np.sqrt(5.0), rel=1e-6)


def test_a_strip_between_two_knuckles_of_a_boat():
    """Of a row that is nearly developable the strip between its knuckles is next to it, and its own
    rulings have no warp."""
    hull, _ = edited_boat()
    assert bpy.ops.hull.make_developable(warp=0.5, distance=0.1) == {"FINISHED"}
    (region,) = regions(hull)
    row, ids = row_of(hull, region)
    ends = row.rulings(3)
    own = set(ids[row.points].tolist())
    creased = part("features.hull.hull_state").state_of(hull).ship.surface
    features = part("bridge.native").require().feature_curves(creased)
    pairs = {
        tuple(sorted((int(ids[a]), int(ids[b]))))
        for curve in features
        if curve.kind == "crease"
        for a, b in zip(curve.vertices, curve.vertices[1:])
    }
    bpy.context.tool_settings.mesh_select_mode = (False, True, False)
    part("bridge.mesh.selection").deselect_all(hull)
    select(hull, "edge", [pair for pair in pairs if set(pair) <= own])
    points, faces = made_by(hull, count=80)
    tree = part("bridge.native").require().SurfaceTree(creased)
    assert tree.closest_points(points.astype(float)).distances.max() < 1e-5
    middles = np.array([points[list(face)].mean(axis=0) for face in faces], dtype=float)
    broad = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).max()
    assert tree.closest_points(middles).distances.max() < 0.02 * broad
    assert area(points, faces) > 0.0


@pytest.mark.parametrize(
    "lines, options, told",
    [((DECK,), {}, "two chains of edges that do not touch: 1 chain is selected"),
     ((), {}, "0 chains are selected"),
     ((BOTTOM, DECK), {"form": "CONE"}, "Select one chain of edges: 2 chains are"),
     ((DECK, ((10, 0, 3), (10, 2, 3))), {}, "1 chain is"),
     ((BOTTOM, DECK, ((0, 2, 0), (0, 2, 3)), ((10, 2, 0), (10, 2, 3))), {}, "go round in a ring"),
     ((BOTTOM, ((10, 0, 0), (10, 2, 0)), ((10, 2, 0), (10, 2, 3))), {}, "branch"),
     ((DECK, ((0, 0, 0), (0, 2, 0))), {}, "no developable surface joins them"),
     ((DECK,), {"form": "CYLINDER", "shift": (1.0, 0.0, 0.0)}, "runs along the straight line"),
     ((DECK,), {"form": "CYLINDER", "shift": (0.0, 0.0, 0.0)}, "a length above 0 m")],
)  # fmt: skip
def test_what_makes_no_surface_is_one_sentence(lines, options, told):
    hull = box(*lines)
    before = set(bpy.data.objects)
    with pytest.raises(RuntimeError, match=told):
        bpy.ops.hull.developable_strip(**options)
    assert set(bpy.data.objects) == before and hull.mode == "EDIT"


def test_a_cone_whose_apex_is_on_the_chain_is_refused():
    hull = box(DECK)
    bpy.context.scene.cursor.location = (4.0, 2.0, 3.0)
    with pytest.raises(RuntimeError, match="runs along the straight line"):
        bpy.ops.hull.developable_strip(form="CONE")
    assert hull.mode == "EDIT"
