# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeping points in their station, waterline or buttock while they are moved.

Points that were dragged off go back to the nearest place in all the planes that hold them, those of
flats too. Planes go along with points that numbers or undo have placed, with all points of a hull
that was moved or scaled as a whole, and on first sight of a hull: what was done without the add-on
was meant. New points that were extruded or duplicated from kept ones are free.
"""

import dataclasses
from dataclasses import dataclass

import numpy as np

from ...bridge.mesh import mesh_points
from ...bridge.objects import hull_objects
from . import flat_marks, flats, kept_points, planes

# Of the size: how far from an affine image points may be that single precision rounds.
_AFFINE = 2e-6
# Positions along an axis that a hull has at least, or any move of some of its points is affine.
_LEAST_POSITIONS = 3


@dataclass
class Memory:
    """What `kept` has seen of one hull: where its points (n, 3) were last, None before the first
    time. contradicted: how many points are held by planes that do not meet."""

    points: object = None
    contradicted: int = 0


def kept(obj, data, memory, is_by_hand):
    """The MeshData of a hull with its kept points brought back into their planes, in Blender's mesh
    too. The Memory is for this hull alone. is_by_hand: see keeping."""
    points, before = data.points, memory.points
    memory.points, memory.contradicted = points, 0
    found = kept_points.read(obj.data)
    if not len(found) or hull_objects.locked(obj):
        return data
    if is_by_hand:
        found = _without_copies(obj.data, found, points, before)
    astray = _are_off(found, points)
    indices = found.indices[astray]
    if not len(indices):
        return data
    if not is_by_hand or before is None or _is_of_mesh(obj, before, points):
        kept_points.write(obj.data, indices, found.is_kept[astray], points[indices])
        return data
    places = _places(obj, found, indices, points, memory)
    moved = (places != points[indices]).any(axis=1)
    if not moved.any():
        return data
    memory.points = points.copy()
    memory.points[indices] = places
    mesh_points.write(obj.data, indices[moved], places[moved])
    return dataclasses.replace(data, points=memory.points)


def _are_off(found, points):
    """(k,) which of the KeptPoints are not where they are kept."""
    return (found.is_kept & (points[found.indices] != found.places)).any(axis=1)


def _without_copies(mesh, found, points, before):
    """The KeptPoints without those that were just extruded or duplicated, which are freed."""
    if before is None or not mesh.is_editmode or len(before) >= len(points):
        return found
    is_new = found.indices >= len(before)
    known = {tuple(place) for place in points[: len(before)].tolist()}
    is_twin = np.array([tuple(place) in known for place in points[found.indices].tolist()])
    is_copy = is_new & (_are_off(found, points) | is_twin)
    if not is_copy.any():
        return found
    kept_points.free(mesh, found.indices[is_copy])
    return kept_points.KeptPoints(*(part[~is_copy] for part in vars(found).values()))


def _is_of_mesh(obj, before, points):
    """Whether points off their planes are there for a reason other than a drag of theirs: they were
    joined to the hull, or all of it was moved, turned or scaled."""
    if len(before) != len(points):
        return not obj.data.is_editmode and len(points) > len(before)
    return bool((before != points).any()) and affine_map(before, points) is not None


def affine_map(before, after):
    """(matrix (3, 3), shift (3,)): after = before @ matrix + shift, points (n, 3), but for the
    rounding of single precision; None where there is no such map, a coordinate is no number, or
    there are so few positions of points that this means nothing."""
    size = max(np.abs(before).max(initial=0.0), np.abs(after).max(initial=0.0))
    if not np.isfinite(size):
        return None
    if _is_held(before, after, _AFFINE * size):
        return None
    if any(len(np.unique(part)) < _LEAST_POSITIONS for part in before.T):
        return None
    columns = _with_ones(before.astype(np.float64))
    found = np.linalg.lstsq(columns, after, rcond=None)[0]
    if np.abs(columns @ found - after).max(initial=0.0) > _AFFINE * size:
        return None
    return found[:3], found[3]


def _is_held(before, after, allowed):
    """Whether four points that stay forbid every affine map, as where some points are dragged: one
    that is off by no more than `allowed` leaves each point where it is but for `allowed` times the
    sum of its coordinates by the four. Where there are no such four, this is False."""
    stays = (before == after).all(axis=1)
    still = before[stays].astype(np.float64)
    if len(still) < 4 or stays.all():
        return False
    x, y, z = still.T
    four = still[[x.argmin(), x.argmax(), y.argmax(), z.argmax()]]
    others = before[~stays].astype(np.float64)
    try:
        parts = np.linalg.solve(_with_ones(four).T, _with_ones(others).T)
    except np.linalg.LinAlgError:
        return False
    moved = np.abs(after[~stays] - others).max(axis=1)
    return bool((moved > 2.0 * allowed * (1.0 + np.abs(parts).sum(axis=0))).any())


def _with_ones(points):
    return np.column_stack([points, np.ones(len(points))])


def _places(obj, found, indices, points, memory):
    """(m, 3) float32: where points (m,) of the mesh are held; those that are held in
    planes that do not meet stay where they are, and are counted."""
    of_points = found.planes()
    flat = flat_marks.read(obj.data)
    known = {number: flats.plane_of(entry) for number, entry in flats.plane_entries(obj).items()}
    of_flats = {} if flat is None else flats.planes_of_points(flat, known)
    allowed, places = planes.tolerance(points), points[indices]
    for row, index in enumerate(indices.tolist()):
        own = [*of_points[index], *of_flats.get(index, ())]
        place = planes.into_planes(places[row].astype(np.float64), own)
        if max(abs(planes.heights(place[None], plane)[0]) for plane in own) <= allowed:
            places[row] = place
        else:
            memory.contradicted += 1
    return places
