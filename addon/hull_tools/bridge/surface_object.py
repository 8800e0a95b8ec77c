# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface as a Blender mesh: exact points, exact normals, both sides of a half hull."""

import numpy as np

from . import blender_versions, materials, mesh_arrays

# Points nearer to the centre plane than this part of the hull's size are put on it exactly and are
# shared by both sides.
_CENTRE_PLANE_TOLERANCE = 1e-9


def surface_points(tessellation, half):
    """(points (n, 3) in metres of the whole hull, (k,) which of the modelled ones both sides
    share)."""
    points = tessellation.points
    if not half:
        return points, np.ones(len(points), dtype=bool)
    size = (points.max(axis=0) - points.min(axis=0)).max()
    on_plane = np.abs(points[:, 1]) <= _CENTRE_PLANE_TOLERANCE * size
    points[on_plane, 1] = 0.0
    return np.concatenate([points, points[~on_plane] * [1.0, -1.0, 1.0]]), on_plane


def surface_faces(tessellation, shared):
    """(quads (k, 4), corner normals (k, 4, 3)) between surface_points, of which so many are
    shared."""
    quads, normals = tessellation.quads, tessellation.corner_normals
    mirror_of = np.arange(len(shared))
    mirror_of[~shared] = len(shared) + np.arange(np.count_nonzero(~shared))
    on_one_side = ~shared[quads].all(axis=1)
    turned = slice(None, None, -1)
    return (
        np.concatenate([quads, mirror_of[quads[on_one_side]][:, turned]]),
        np.concatenate([normals, normals[on_one_side][:, turned] * [1.0, -1.0, 1.0]]),
    )


def both_sides(tessellation, shared, values):
    """Values (k, 4, ...) of the corners of the modelled side's faces, for all surface_faces."""
    on_one_side = ~shared[tessellation.quads].all(axis=1)
    return np.concatenate([values, values[on_one_side][:, ::-1]])


def write_surface(mesh, points, quads, metres_per_unit):
    """Replaces the geometry of `mesh`; points (n, 3) in metres, quads (k, 4)."""
    sizes = np.full(len(quads), 4, dtype=np.int32)
    mesh_arrays.write_faces(mesh, points / metres_per_unit, sizes, quads.reshape(-1))
    mesh.polygons.foreach_set("use_smooth", np.ones(len(quads), dtype=bool))
    if not mesh.materials:
        mesh.materials.append(materials.surface_material())


def move_surface(mesh, points, metres_per_unit):
    """Moves the points of a `mesh` whose faces stay.

    The normals turn along with the faces, so that they stay close to the surface's own.
    """
    co = np.ascontiguousarray(points / metres_per_unit, dtype=np.float32)
    mesh.vertices.foreach_set("co", co.reshape(-1))
    mesh.update()


def write_normals(mesh, normals):
    """Gives a surface its exact normals, (k, 4, 3)."""
    blender_versions.set_corner_normals(mesh, normals.reshape(-1, 3))
