# SPDX-License-Identifier: GPL-3.0-or-later
"""The control mesh replaced by the one subdivided once by the rules of its surface, which stays the
same: four times the faces to work on.

Only the whole mesh can be subdivided so: uniform B-splines have no knot insertion in one place
(row_insertion does nearly that). Tags, layers, marks, locks, weights of vertex groups and what is
selected come along. Faces that do not belong to the shell stay, and get the points of the edges
that they share with it.
"""

from dataclasses import dataclass, replace

import bmesh
import numpy as np

from ...bridge import limits
from ...bridge.blender import blender_versions, units
from ...bridge.mesh import corner_layers, mesh_arrays, mesh_check
from ...bridge.mesh.mesh_editing import check_single_user, editing
from ..constraints import flats, planes, point_locks
from ..hull import hull_state

# Of the size: coordinates that are zero but for the rounding of the sums they are.
_ZERO = 1e-13


@dataclass(frozen=True)
class Subdivided:
    """How many points and faces the mesh has now. no_longer_flat: how many faces at the rims of
    flats are not kept flat: the surface, and with it their points, leaves the plane there."""

    points: int
    faces: int
    no_longer_flat: int


def subdivide(obj, scene):
    """Subdivides a hull's control mesh, in edit mode or not; returns what came of it.

    ValueError when the mesh has errors, is used by other objects too, or would have more faces than
    limits.MOST_CONTROL_FACES.
    """
    check_single_user(obj.data)
    state = hull_state.up_to_date(obj, scene)
    source, surface = state.ship.source, state.ship.surface
    if surface.cell_count > limits.MOST_CONTROL_FACES:
        raise ValueError(
            f"The mesh would have {surface.cell_count} faces, more than "
            f"{limits.MOST_CONTROL_FACES}: nobody can work on so many"
        )
    mesh = surface.refined_mesh()
    control = replace(
        source.control, face_sizes=mesh.face_sizes, face_vertices=np.ravel(mesh.face_vertices)
    )
    if mesh_check.is_too_fine(control, source.half):
        raise ValueError(
            f"The mesh would have {len(mesh.face_sizes)} faces, of which too many have irregular "
            "corners for the surface to follow: make quadrilaterals of triangles first"
        )
    points = np.where(np.abs(mesh.points) <= _ZERO * mesh.size, 0.0, mesh.points)
    points /= units.metres_per_unit(scene)
    with editing(obj.data) as bm:
        faces = _chosen_faces(bm, source.control.face_ids)
        for cell, own in zip(_replace(bm, faces), mesh.face_vertices.reshape(-1, 4).tolist()):
            for vertex, number in zip(cell, own):
                vertex.co = points[number]
        bm.normal_update()
    released = _release_rims(obj)
    state = hull_state.follow_edit(obj, scene, is_by_hand=False).checked()
    data = mesh_arrays.read_mesh(obj.data)
    return Subdivided(len(data.points), len(data.face_sizes), released)


def _chosen_faces(bm, indices):
    bm.faces.ensure_lookup_table()
    return [bm.faces[index] for index in indices.tolist()]


def _replace(bm, faces):
    """Puts quadrilaterals, one a corner, in the place of faces; returns their points, in the order
    of hull_native's cells. Points of before keep their indices."""
    chosen = [part for parts in (bm.verts, bm.edges, faces) for part in parts if part.select]
    loops = [[(loop.vert, loop.edge) for loop in face.loops] for face in faces]
    parts = _split_edges(bm, dict.fromkeys(edge for own in loops for _, edge in own))
    layers, loop_layers = _point_layers(bm), corner_layers.of(bm)
    cells = []
    for face, own in zip(faces, loops):
        centre = _centre(bm, face, layers)
        corners = {loop.vert: loop for loop in face.loops}
        made = []
        for place, (vertex, edge) in enumerate(own):
            cell = (vertex, parts[edge][0], centre, parts[own[place - 1][1]][0])
            made.append(_quad(bm, face, cell, corners, loop_layers))
            cells.append(cell)
        parts[face] = (centre, *made)
    _select(bm, [one for part in chosen for one in (part, *parts.get(part, ()))], faces)
    bmesh.ops.delete(bm, geom=faces, context="FACES_ONLY")
    bm.verts.index_update()
    return cells


def _split_edges(bm, edges):
    """Halves edges, which leaves their tags with both parts; returns {edge: (the point in its
    middle, the other half)}."""
    corner_layer, lock_layer = _point_layers(bm)
    parts = {}
    for edge in edges:
        ends, is_hidden = list(edge.verts), edge.hide
        half, middle = bmesh.utils.edge_split(edge, ends[0], 0.5)
        half.hide = middle.hide = is_hidden
        _tag(middle, ends, corner_layer, lock_layer)
        parts[edge] = (middle, half)
    return parts


def _point_layers(bm):
    """The layers of corners and locks; None for one that the mesh has not."""
    return (
        blender_versions.find_crease_layers(bm)[1],
        bm.verts.layers.int.get(point_locks.ATTRIBUTE),
    )


def _tag(vertex, parents, corner_layer, lock_layer):
    """A new point is no corner, where Blender takes the mean of its parents', and is locked where
    all of these are."""
    if corner_layer is not None:
        vertex[corner_layer] = 0.0
    if lock_layer is not None:
        vertex[lock_layer] = int(all(parent[lock_layer] for parent in parents))


def _centre(bm, face, layers):
    """A new point of a face whose edges are halved, with the mean of what its points have."""
    centre = bm.verts.new(face.calc_center_median())
    centre.copy_from_face_interp(face)
    centre.hide = face.hide
    _tag(centre, face.verts, *layers)
    return centre


def _quad(bm, face, cell, corners, loop_layers):
    """A new face at a corner of one whose loops by point are `corners`; it has all that one has."""
    new = bm.faces.new(cell, face)
    for loop in new.loops:
        of_corner = corners.get(loop.vert, corners[cell[0]])
        corner_layers.copy(loop_layers, of_corner, loop)
        if loop.vert is cell[2]:
            for layer in bm.loops.layers.uv.values():
                loop[layer].uv = _mean([corner[layer].uv for corner in face.loops])
    new.hide = face.hide
    for edge in new.edges:
        if cell[2] in edge.verts:
            edge.hide = face.hide
    return new


def _mean(vectors):
    return sum(vectors[1:], vectors[0].copy()) / len(vectors)


def _select(bm, chosen, leaving):
    for vertex in bm.verts:
        vertex.select_set(False)
    for part in set(chosen).difference(leaving):
        part.select_set(True)
    bm.select_flush_mode()


def _release_rims(obj):
    """Lets faces go that are not in the plane of their flat; returns how many."""
    data = mesh_arrays.read_mesh(obj.data)
    ends = np.cumsum(data.face_sizes)
    released = []
    for region in flats.regions(obj):
        off = np.abs(planes.heights(data.points.astype(np.float64), region.plane))
        is_off = off > planes.tolerance(data.points)
        for face in region.faces.tolist():
            if is_off[data.face_vertices[ends[face] - data.face_sizes[face] : ends[face]]].any():
                released.append(face)
    if released:
        flats.release(obj, released)
    return len(released)
