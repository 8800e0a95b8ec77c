# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls in edit mode, and what is selected of them."""

import bmesh
import bpy
import numpy as np
from addon_under_test import make_active, mesh_points, part, state_of

# Of the box: port side, bottom and both ends, open above and on the centre plane.
KNUCKLES, BORDERS = 5, 6


def edit(hull, mode=(True, False, False)):
    make_active(hull)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.context.tool_settings.mesh_select_mode = mode
    bpy.ops.mesh.select_all(action="DESELECT")
    return bmesh.from_edit_mesh(hull.data)


def edit_to_twice_the_depth(hull):
    """In edit mode, which goes on; everything has followed."""
    bm = edit(hull)
    for vertex in bm.verts:
        vertex.co.z *= 2.0
    bmesh.update_edit_mesh(hull.data)
    bpy.context.view_layer.update()


def select(hull, kind, elements):
    part("bridge.mesh.selection").select(bpy.context, hull, kind, elements)


def selected(hull, kind):
    return part("bridge.mesh.selection").selected(hull, kind)


def keys(edges):
    return {tuple(sorted(map(int, edge))) for edge in edges}


def find(hull, *place):
    points = np.array([vertex.co for vertex in bmesh.from_edit_mesh(hull.data).verts])
    return int(np.abs(points - place).sum(axis=1).argmin())


def faces_in(hull, plane):
    """Faces whose points are all in a plane (nx, ny, nz, d), in object mode."""
    points, plane = mesh_points(hull), np.array(plane)
    return [
        polygon.index
        for polygon in hull.data.polygons
        if np.abs(points[list(polygon.vertices)] @ plane[:3] - plane[3]).max() < 1e-5
    ]


def grid_hull(columns=6, rows=5):
    """A bulged smooth sheet to port, the half of a hull without any crease inside."""
    points = [
        (float(i), 1.0 + 0.1 * i * (columns - 1 - i) + 0.2 * j, float(j))
        for i in range(columns)
        for j in range(rows)
    ]
    faces = [
        (a, a + rows, a + rows + 1, a + 1)
        for a in (i * rows + j for i in range(columns - 1) for j in range(rows - 1))
    ]
    mesh = bpy.data.meshes.new("grid")
    mesh.from_pydata(points, [], faces)
    hull = bpy.data.objects.new("grid", mesh)
    bpy.context.collection.objects.link(hull)
    make_active(hull)
    assert bpy.ops.hull.make_hull(half=True) == {"FINISHED"}
    assert not state_of(hull).status
    return hull


def at(i, j, rows=5):
    return i * rows + j


def tags_of(hull):
    return part("features.hull.tags").of_hull(hull, bpy.context.scene)


def centre_normals(surface):
    """(n, 3) in the middle of the sides of cells that are on the centre plane."""
    middles = np.array([(0.5, 0.0), (1.0, 0.5), (0.5, 1.0), (0.0, 0.5)])
    cells = np.repeat(np.arange(surface.cell_count), 4)
    uv = np.tile(middles, (surface.cell_count, 1))
    on_plane = np.abs(surface.positions(cells, uv)[:, 1]) < 1e-6
    return surface.normals(cells[on_plane], uv[on_plane])
