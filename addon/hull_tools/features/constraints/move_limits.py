# SPDX-License-Identifier: GPL-3.0-or-later
"""What a hull's control points may do while a tool moves them: the one place that tools ask.

Locked points stay; those of flats, on the centre plane of a half hull, and kept in stations,
waterlines or buttocks stay in their planes; tied points go with those that they follow.
"""

from dataclasses import dataclass, replace
from itertools import chain

import numpy as np

from ...bridge import native
from . import held_points, point_locks, ties


@dataclass(frozen=True, eq=False)
class MoveLimits:
    """Of control points, by their index: locked (l,) stay; held_points (h,) move across their
    normals, held_normals (h, 3), only. A point may be held several times. tied: as ties.move_sums
    has them."""

    locked: np.ndarray
    held_points: np.ndarray
    held_normals: np.ndarray
    tied: tuple = ()

    def with_locked(self, points):
        """The same where these (k,) stay, too."""
        points = np.asarray(points, dtype=np.int64)
        return replace(self, locked=np.union1d(self.locked, points))

    def of_planes(self):
        """As keyword arguments of hull_native's functions that move control points, without
        ties."""
        return {
            "locked": self.locked,
            "held_points": self.held_points,
            "held_normals": self.held_normals,
        }

    def arguments(self):
        """As keyword arguments of hull_native's functions that move control points."""
        return {**self.of_planes(), "kept": self.tied}

    def key(self):
        """Equal for equal limits."""
        arrays = (self.locked, self.held_points, self.held_normals, *chain(*self.tied))
        return tuple(array.tobytes() for array in arrays)

    def reshape_arguments(self, surface):
        """As keyword arguments of hull_native.Reshape, with what keeps the hull_native.LimitSurface
        square to the centre plane where it is so."""
        hull_native = native.require()
        tied, directions = hull_native.square_ties(surface)
        return {
            **self.arguments(),
            "tied": tied,
            "tied_directions": directions,
            "kept": (*hull_native.square_sums(surface), *self.tied),
        }


def of_hull(obj, vertex_ids, points):
    """The MoveLimits of a hull whose control points (n, 3), in m, have these indices in its
    mesh."""
    locked = np.flatnonzero(np.isin(vertex_ids, point_locks.locked_points(obj.data)))
    held = held_points.held_points(obj, vertex_ids, points)
    return MoveLimits(locked, *held, ties.move_sums(obj.data, vertex_ids, points))
