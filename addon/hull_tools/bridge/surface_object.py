# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface as a Blender mesh: exact points, exact normals, both sides of a half hull."""

import hashlib

import numpy as np

from . import blender_versions, materials, mesh_arrays

# Points nearer to the centre plane than this part of the hull's size are put on it exactly and are
# shared by both sides.
_CENTRE_PLANE_TOLERANCE = 1e-9


def surface_arrays(tessellation, half):
    """(points (n, 3) in metres, quads (k, 4), corner normals (k, 4, 3)) of the whole hull."""
    points, quads = tessellation.points, tessellation.quads
    normals = tessellation.corner_normals
    if not half:
        return points, quads, normals
    on_plane = np.abs(points[:, 1]) <= _CENTRE_PLANE_TOLERANCE * np.ptp(points, axis=0).max()
    points = np.where(on_plane[:, None], points * [1.0, 0.0, 1.0], points)
    mirror_of = np.arange(len(points))
    mirror_of[~on_plane] = len(points) + np.arange(np.count_nonzero(~on_plane))
    off_plane = ~on_plane[quads].all(axis=1)
    turned = slice(None, None, -1)
    flip = np.array([1.0, -1.0, 1.0])
    return (
        np.concatenate([points, points[~on_plane] * flip]),
        np.concatenate([quads, mirror_of[quads[off_plane]][:, turned]]),
        np.concatenate([normals, normals[off_plane][:, turned] * flip]),
    )


def topology_of(quads):
    """Equal for surfaces that differ by the places of their points only."""
    return hashlib.blake2b(np.ascontiguousarray(quads).data, digest_size=16).digest()


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
