# SPDX-License-Identifier: GPL-3.0-or-later
"""The control mesh that a family gets from a hull: its shell with tags and layers, subdivided as
often as the fits needed it; what is no part of a family is left out (locks, kept points)."""

from dataclasses import dataclass

import bpy
import numpy as np

from ...bridge import native
from ...bridge.mesh import mesh_arrays
from ...bridge.mesh.face_sides import ends_of_sides
from . import family_flats


@dataclass(frozen=True, eq=False)
class Layout:
    """Faces as mesh_arrays.ControlArrays has them, without points; slots (f,): material slots;
    flats (f,): numbers of flats, 0 for none."""

    face_sizes: np.ndarray
    face_vertices: np.ndarray
    slots: np.ndarray
    creases: np.ndarray
    corners: np.ndarray
    deck_edge: np.ndarray
    flats: np.ndarray


def layout_of(obj, found, control):
    """The Layout of a hull, of its hull_mesh.HullMesh and the ControlArrays of that."""
    flats = family_flats.numbers_of(obj, len(found.data.face_sizes))
    return Layout(
        control.face_sizes,
        control.face_vertices,
        found.data.face_slots[control.face_ids],
        control.creases,
        control.corners,
        control.deck_edge,
        flats[control.face_ids],
    )


def subdivided(layout, surface, times):
    """The Layout of a surface subdivided so many times by the rules of the surface, numbered as
    hull_native.LimitSurface.refined_mesh() does."""
    for _ in range(times):
        fine = surface.refined_mesh()
        layout = _subdivided_once(layout, fine)
        surface = native.require().LimitSurface(fine, surface.scheme)
    return layout


def _subdivided_once(layout, fine):
    """Cells are in the order (face, corner of that face): each begins at its corner, and goes on
    with the middle of the edge to the next one."""
    sizes, corners = layout.face_sizes, layout.face_vertices
    cells = np.asarray(fine.face_vertices).reshape(-1, 4)
    image = np.full(corners.max() + 1, -1, dtype=np.int64)
    image[corners] = cells[:, 0]
    middles = dict(zip(_keys_from_corners(sizes, corners).tolist(), cells[:, 1].tolist()))

    def halves(edges):
        keys = mesh_arrays.edge_keys(edges).tolist()
        parts = [((image[a], middles[key]), (middles[key], image[b]))
                 for key, (a, b) in zip(keys, np.asarray(edges).tolist())]  # fmt: skip
        return np.array(parts, dtype=np.int64).reshape(-1, 2)

    return Layout(
        np.asarray(fine.face_sizes),
        np.asarray(fine.face_vertices),
        np.repeat(layout.slots, sizes),
        halves(layout.creases),
        image[layout.corners],
        halves(layout.deck_edge),
        np.repeat(layout.flats, sizes),
    )


def _keys_from_corners(sizes, corners):
    """Of each corner of a face the key of the edge to the next one."""
    return mesh_arrays.edge_keys(ends_of_sides(sizes, corners))


def new_mesh(name, layout, points, materials):
    """A mesh of Blender's with a Layout; points (n, 3) in Blender's units; materials by slot."""
    mesh = bpy.data.meshes.new(name)
    mesh_arrays.write_faces(mesh, points, layout.face_sizes, layout.face_vertices)
    mesh_arrays.write_tags(mesh, layout.creases, layout.corners, layout.deck_edge)
    for material in materials:
        mesh.materials.append(material)
    if materials:
        mesh.polygons.foreach_set("material_index", np.asarray(layout.slots, dtype=np.int32))
    family_flats.remember(mesh, layout.flats)
    mesh.update()
    return mesh


def with_points(mesh, name, points):
    """A copy of a mesh with other points (n, 3) in Blender's units."""
    made = mesh.copy()
    made.name = name
    made.vertices.foreach_set("co", np.ascontiguousarray(points, dtype=np.float32).reshape(-1))
    made.update()
    return made
