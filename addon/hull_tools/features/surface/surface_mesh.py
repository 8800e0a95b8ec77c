# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface as a Blender mesh: exact points, exact normals, both sides of a half hull."""

import hashlib

import numpy as np

from ...bridge.blender import blender_versions
from ...bridge.mesh import mesh_arrays
from . import materials


def surface_faces(tessellation, shared):
    """(quads (k, 4), corner normals (k, 4, 3)) between hull_native.ShownPoints, which say what of
    the tessellation's points is shared."""
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


def write_surface(mesh, points, quads):
    """Replaces the geometry of `mesh`; points (n, 3) in Blender's units, quads (k, 4)."""
    sizes = np.full(len(quads), 4, dtype=np.int32)
    mesh_arrays.write_faces(mesh, points, sizes, quads.reshape(-1))
    mesh.polygons.foreach_set("use_smooth", np.ones(len(quads), dtype=bool))
    if not mesh.materials:
        mesh.materials.append(materials.surface_material())


def move_surface(mesh, points):
    """Moves the points, (n, 3) float32 in Blender's units, of a `mesh` whose faces stay.

    Blender shades it by its faces until write_normals: corner normals cost it several times as much
    as all the rest.
    """
    mesh.vertices.foreach_set("co", points.reshape(-1))
    blender_versions.rest_corner_normals(mesh)
    mesh.update()


def write_normals(mesh, normals):
    """Gives a surface its exact normals, (k, 4, 3)."""
    blender_versions.set_corner_normals(mesh, normals.reshape(-1, 3))


def points_of(mesh):
    """(n, 3) float32 in Blender's units."""
    points = np.empty((len(mesh.vertices), 3), dtype=np.float32)
    mesh.vertices.foreach_get("co", points.reshape(-1))
    return points


def faces_digest(mesh):
    """As text: equal for equal faces that are shaded alike."""
    corners = np.empty(len(mesh.loops), dtype=np.int32)
    mesh.loops.foreach_get("vertex_index", corners)
    sizes = np.empty(len(mesh.polygons), dtype=np.int32)
    mesh.polygons.foreach_get("loop_total", sizes)
    are_smooth = np.empty(len(mesh.polygons), dtype=bool)
    mesh.polygons.foreach_get("use_smooth", are_smooth)
    return _digest(corners, sizes, are_smooth)


def normals_digest(mesh):
    """As text: equal for equal normals of the corners, as Blender keeps them."""
    return _digest(blender_versions.corner_normals(mesh))


def _digest(*arrays):
    state = hashlib.blake2b(digest_size=16)
    for array in arrays:
        state.update(array.size.to_bytes(8, "little"))
        state.update(array.data)
    return state.hexdigest()
