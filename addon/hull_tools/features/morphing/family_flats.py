# SPDX-License-Identifier: GPL-3.0-or-later
"""Flats of the hull that gave a family its layout: the faces are remembered by members, and kept
flat again when one becomes a hull of its own, where they are flat in that."""

import numpy as np

from ...bridge.mesh import face_numbers, mesh_arrays
from ..constraints import flat_keeping, flat_marks, flats, planes

ATTRIBUTE = "hull_family_flat"


def numbers_of(obj, count):
    """(count,) of each face of a hull the number of its flat, 0 for none."""
    found = np.zeros(count, dtype=np.int32)
    for region in flats.regions(obj):
        found[region.faces] = region.number
    return found


def remember(mesh, numbers):
    """Has a mesh, not in edit mode, know the numbers (f,) of its faces' flats."""
    faces = np.flatnonzero(numbers)
    if len(faces):
        face_numbers.write(mesh, ATTRIBUTE, faces, np.asarray(numbers)[faces])


def keep_again(obj):
    """Keeps flat what was so in the layout, as far as it is flat in this hull; no point moves.
    Returns how many flats there are."""
    data = mesh_arrays.read_mesh(obj.data)
    numbers, count = face_numbers.read(obj.data, ATTRIBUTE), 0
    corners = np.split(data.face_vertices, np.cumsum(data.face_sizes)[:-1])
    places = data.points.astype(np.float64)
    for number in np.unique(numbers[numbers != 0]).tolist():
        faces = np.flatnonzero(numbers == number)
        plane, own = _largest_flat(places, [corners[face] for face in faces])
        if plane is not None:
            made = flats.new_number(obj)
            flat_marks.write(obj.data, faces[own], made)
            flats.store_plane(obj, made, plane)
            count += 1
    return count


def _largest_flat(places, corners):
    """(plane, which of the faces with these corners lie in it): that of most of them, (None, ())
    where none has two, nor all there are. A parent's flat may reach less far than the layout's."""
    best, most = (None, ()), min(len(corners), 2) - 1
    allowed = planes.tolerance(places[np.concatenate(corners)])
    for own in corners:
        plane = flat_keeping.common_plane(places[own])
        if plane is None:
            continue
        is_in = [np.abs(planes.heights(places[one], plane)).max() <= allowed for one in corners]
        if sum(is_in) > most:
            best, most = (plane, np.flatnonzero(is_in)), sum(is_in)
    if best[0] is None:
        return best
    # By all points of it the plane is closer than by those of one face.
    points = places[np.unique(np.concatenate([corners[k] for k in best[1]]))]
    plane = flat_keeping.common_plane(points)
    return (None, ()) if plane is None else (plane, best[1])
