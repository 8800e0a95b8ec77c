# SPDX-License-Identifier: GPL-3.0-or-later
"""What of a hull a target covers, and how far all of the target is from the hull."""

import numpy as np

from ...bridge import native
from ...bridge.mesh.mesh_arrays import edge_keys

# A target counts where its normal is within 60° of the surface's, as in the fit.
_AGREEMENT = 0.5


def uncovered(control, surface, targets, normals, reach):
    """(points (k,), faces) of ControlArrays that a fit is to leave alone: those of whole parts
    between creases, as a deck, in which no target is nearest; and how many faces these have.

    targets (n, 3) m; normals (n, 3) turned as the surface's, or None; reach: m. Points that such
    a part shares with others are not among them.
    """
    near = native.require().SurfaceTree(surface).closest_points(targets, reach)
    found = near.cells >= 0
    if normals is not None and found.any():
        own = surface.normals(near.cells[found], near.uv[found])
        found[found] = (own * normals[found]).sum(axis=1) >= _AGREEMENT
    owner = np.repeat(np.arange(len(control.face_sizes)), control.face_sizes)
    parts = _parts_between_creases(control, owner)
    is_covered = np.zeros(len(parts), dtype=bool)
    is_covered[parts[owner[near.cells[found]]]] = True
    if not is_covered.any():
        return np.empty(0, dtype=np.int64), 0
    is_left = ~is_covered[parts]
    covered = control.face_vertices[~is_left[owner]]
    alone = np.setdiff1d(control.face_vertices[is_left[owner]], covered)
    return alone, int(np.count_nonzero(is_left))


def _parts_between_creases(control, owner):
    """(f,) of each face the number of one face of its part; edges that are no creases join."""
    ends = np.cumsum(control.face_sizes)
    following = np.roll(control.face_vertices, -1)
    following[ends - 1] = control.face_vertices[ends - control.face_sizes]
    keys = edge_keys(np.stack([control.face_vertices, following], axis=1))
    smooth = ~np.isin(keys, edge_keys(control.creases))
    order = np.argsort(keys[smooth], kind="stable")
    keys, faces = keys[smooth][order], owner[smooth][order]
    pairs = np.flatnonzero(keys[1:] == keys[:-1])
    parts = np.arange(len(control.face_sizes))
    while True:
        lowest = parts.copy()
        for a, b in ((faces[pairs], faces[pairs + 1]), (faces[pairs + 1], faces[pairs])):
            np.minimum.at(lowest, a, parts[b])
        lowest = lowest[lowest]
        if (lowest == parts).all():
            return parts
        parts = lowest


def distances(surface, targets):
    """(n,) m: of all of the targets (n, 3) from a surface."""
    return native.require().SurfaceTree(surface).closest_points(targets).distances
