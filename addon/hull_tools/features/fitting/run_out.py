# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a fit lets borders run out beyond the target. Where no line of the target says where a
border ends, a surface that goes on along it is as near to all points."""

import numpy as np
from mathutils import kdtree

from ...bridge.mesh.face_sides import ends_of_sides
from ...bridge.mesh.mesh_arrays import edge_keys
from . import coverage

_ON_HALF_EDGE = 2


class RunOut:
    """How far places along the borders of a surface, of ControlArrays, are from targets (n, 3) m;
    `by` tells how much farther the same places of another surface are, m."""

    def __init__(self, surface, control, targets):
        keys = edge_keys(ends_of_sides(control.face_sizes, control.face_vertices))
        _, inverse, counts = np.unique(keys, return_inverse=True, return_counts=True)
        corners = np.flatnonzero(counts[inverse] == 1)
        self._places = coverage.places_along(control, corners, _ON_HALF_EDGE)
        self._tree = kdtree.KDTree(len(targets))
        for index, point in enumerate(targets.tolist()):
            self._tree.insert(point, index)
        self._tree.balance()
        self._before = self._apart(surface)

    def _apart(self, surface):
        places = surface.positions(*self._places)
        return np.array([self._tree.find(place)[2] for place in places.tolist()])

    def by(self, surface):
        return float((self._apart(surface) - self._before).max(initial=0.0))
