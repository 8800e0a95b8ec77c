# SPDX-License-Identifier: GPL-3.0-or-later
"""What a hull's control points may do while a tool moves them: the one place that tools ask.

Locked points stay; those of flats, on the centre plane of a half hull, and kept in stations,
waterlines or buttocks stay in their planes.
"""

from dataclasses import dataclass, replace

import numpy as np

from ...bridge import native
from . import held_points, point_locks


@dataclass(frozen=True, eq=False)
class MoveLimits:
    """Of control points, by their index: locked (l,) stay; held_points (h,) move across their
    normals, held_normals (h, 3), only. A point may be held several times."""

    locked: np.ndarray
    held_points: np.ndarray
    held_normals: np.ndarray

    def with_locked(self, points):
        """The same where these (k,) stay, too."""
        points = np.asarray(points, dtype=np.int64)
        return replace(self, locked=np.union1d(self.locked, points))

    def arguments(self):
        """As keyword arguments of hull_native's functions that move control points."""
        return {
            "locked": self.locked,
            "held_points": self.held_points,
            "held_normals": self.held_normals,
        }

    def reshape_arguments(self, surface):
        """As keyword arguments of hull_native.Reshape, with what keeps the hull_native.LimitSurface
        square to the centre plane where it is so."""
        hull_native = native.require()
        tied, directions = hull_native.square_ties(surface)
        return {
            **self.arguments(),
            "tied": tied,
            "tied_directions": directions,
            "kept": hull_native.square_sums(surface),
        }


def of_hull(obj, vertex_ids, points, size):
    """The MoveLimits of a hull whose control points (n, 3), in m, have these indices in its mesh;
    size: of the surface, m."""
    locked = np.flatnonzero(np.isin(vertex_ids, point_locks.locked_points(obj.data)))
    return MoveLimits(locked, *held_points.held_points(obj, vertex_ids, points, size))
