# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull's control mesh as it is now, with what of its settings decides on its surface and body."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..mesh import mesh_arrays
from . import appendages, hull_objects


@dataclass(frozen=True, eq=False)
class HullMesh:
    """data: mesh_arrays.MeshData; topology: its digest. excluded: material slots that do not belong
    to the shell. openings: as hull_native.HullBody takes them. appendages: AppendageBody of each
    that counts."""

    data: mesh_arrays.MeshData
    topology: bytes
    excluded: frozenset
    half: bool
    scheme: str
    openings: str
    appendages: tuple = ()

    @property
    def topology_key(self):
        """Equal for hulls whose surfaces differ by the places of points only."""
        return self.topology, self.excluded, self.half, self.scheme

    @cached_property
    def points_digest(self):
        """Equal for equal points."""
        return self.data.points_digest()

    def with_points(self, data):
        """The same hull with a MeshData that differs by the places of points only."""
        return replace(self, data=data)

    def control(self, metres_per_unit):
        """mesh_arrays.ControlArrays of the shell."""
        return mesh_arrays.control_arrays(self.data, metres_per_unit, self.excluded)


def read(obj):
    """HullMesh of a hull; its mesh is only read."""
    settings, data = obj.hull, mesh_arrays.read_mesh(obj.data)
    return HullMesh(
        data,
        data.topology_digest(),
        hull_objects.excluded_slots(obj),
        settings.half,
        settings.scheme,
        "closed" if settings.deck_closed else "open",
        appendages.read(obj),
    )


def shell_slots(obj):
    """(n,) int32: the material slot of each face of a hull that belongs to its shell."""
    slots = mesh_arrays.read_mesh(obj.data).face_slots
    return slots[~np.isin(slots, sorted(hull_objects.excluded_slots(obj)))].astype(np.int32)
