# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeping regions developable while points are moved.

Points that the user moves stay where they are put. The other points of the knuckles of a region
move from where they were put last, first of all along their knuckles, until no ruling has more warp
than the region allows; no knuckle leaves its place by more than the region's distance. What undo or
numbers have placed is taken as it is.
"""

import dataclasses
from dataclasses import dataclass, field
from math import radians

import numpy as np

from ...bridge import native
from ...bridge.mesh import mesh_points
from . import developables, held_points, point_locks

_BEYOND = (
    "A developable region keeps more warp than it is to have: its knuckles would have to move "
    "further than they may."
)


@dataclass
class Memory:
    """What was seen of one hull last: key of its topology; points (n, 3) of its mesh as they were,
    and origins (n, 3), where they were put; rows: the RuledRow of faces, by their bytes. told: a
    sentence for the user, in a list, or nothing."""

    key: object = None
    points: object = None
    origins: object = None
    rows: dict = field(default_factory=dict)
    told: list = field(default_factory=list)

    def remember(self, points):
        """They are where they were put."""
        self.points, self.origins = points, points.copy()


def kept(obj, found, memory, before, is_by_hand):
    """The MeshData of a hull with its regions' points where they are to be, in Blender's mesh too.

    found: its hull_mesh.HullMesh as it is; before: the LiveShip of the hull as it was.
    """
    memory.told = []
    data, regions = found.data, [one for one in developables.regions(obj) if one.kept]
    if not regions:
        memory.key = None
        return data
    points = data.points.astype(np.float64)
    if memory.key != found.topology_key:
        # Points that have other numbers now have not moved.
        memory.key = found.topology_key
        memory.rows.clear()
        memory.remember(points)
        return data
    moved = (points != memory.points).any(axis=1)
    if not moved.any():
        return data
    has_surface = before.surface is not None and before.topology_key == found.topology_key
    if not (is_by_hand and has_surface):
        memory.remember(points)
        return data
    memory.origins[moved] = points[moved]
    ids = before.source.control.vertex_ids
    there = points.copy()
    there[ids] = _developed(obj, regions, memory, before, points[ids], moved[ids])
    memory.points = there
    changed = np.flatnonzero((there != points).any(axis=1))
    if not len(changed):
        return data
    mesh_points.write(obj.data, changed, there[changed])
    return dataclasses.replace(data, points=there.astype(data.points.dtype))


def _developed(obj, found, memory, before, points, moved):
    """(n, 3) the control points with those of touched regions moved, as Blender keeps them."""
    there = points.copy()
    control = before.source.control
    locked = np.flatnonzero(np.isin(control.vertex_ids, point_locks.locked_points(obj.data)))
    held = held_points.held_points(obj, control.vertex_ids, control.points)
    for region in together(found):
        faces = np.flatnonzero(np.isin(control.face_ids, region.faces))
        try:
            row = _row(memory, before.surface, faces)
            if row is None or not moved[row.points].any():
                continue
            made = row.develop(
                radians(region.warp),
                region.distance,
                locked=np.union1d(locked, np.flatnonzero(moved)),
                held_points=held[0],
                held_normals=held[1],
                points=memory.origins[control.vertex_ids],
            )
        except ValueError as error:
            memory.told = [str(error)]
            continue
        there[row.points] = np.asarray(made.points)[row.points].astype(np.float32)
        if not made.reached:
            memory.told = [_BEYOND]
    return there


def _row(memory, surface, faces):
    """The RuledRow of control faces, None without any."""
    if not len(faces):
        return None
    key = faces.tobytes()
    if key not in memory.rows:
        memory.rows[key] = native.require().RuledRow(surface, faces)
    return memory.rows[key]


def together(found):
    """Regions with the same limits as one, so that those with a common knuckle move it once."""
    limits = {}
    for region in found:
        limits.setdefault((region.warp, region.distance), []).append(region.faces)
    return [
        developables.Region(0, np.unique(np.concatenate(faces)), warp, distance, True)
        for (warp, distance), faces in limits.items()
    ]
