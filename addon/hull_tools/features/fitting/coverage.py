# SPDX-License-Identifier: GPL-3.0-or-later
"""What of a hull a target covers, and how far all of the target is from the hull."""

from dataclasses import dataclass

import numpy as np
from mathutils import kdtree

from ...bridge import native
from ...bridge.mesh.face_sides import ends_of_sides, next_corners
from ...bridge.mesh.mesh_arrays import edge_keys

# A target counts where its normal is within 60° of the surface's, as in the fit.
_AGREEMENT = 0.5
# Over so much of a part its targets spread at least. A scan of a bow covers its side; what stands
# on a deck, or strays there, covers no deck.
_LEAST_SPREAD = 0.1
# Of one part no more are looked at; and so many places of all borders, on each half of an edge.
_MOST_HITS, _MOST_BORDER_PLACES, _ON_HALF_EDGE = 2000, 20000, (4, 64)


@dataclass(frozen=True, eq=False)
class Uncovered:
    """Of ControlArrays what a fit is to leave alone. points (k,); face_count: how many faces;
    is_beside (n,): the targets that are nearest to these faces."""

    points: np.ndarray
    face_count: int
    is_beside: np.ndarray


def uncovered(control, surface, targets, normals, reach):
    """The Uncovered of whole parts between creases, as a deck, over which no targets spread.

    targets (n, 3) m; normals (n, 3) turned as the surface's, or None; reach: m. Points that such
    a part shares with others are not among its. A target that is no further from the border of its
    part than from the surface belongs to no part: it may go on beyond, as a bulwark does.
    """
    near = native.require().SurfaceTree(surface).closest_points(targets, reach)
    found = near.cells >= 0
    if normals is not None and found.any():
        own = surface.normals(near.cells[found], near.uv[found])
        found[found] = (own * normals[found]).sum(axis=1) >= _AGREEMENT
    owner = np.repeat(np.arange(len(control.face_sizes)), control.face_sizes)
    ends = ends_of_sides(control.face_sizes, control.face_vertices)
    parts = _parts_between_creases(control, owner, ends)
    part_of_target = np.where(found, parts[owner[near.cells]], -1)
    is_covered = np.zeros(len(parts), dtype=bool)
    border = None
    for part in np.unique(part_of_target[found]).tolist():
        border = border or _Border(surface, control, ends)
        hits = np.flatnonzero(part_of_target == part)
        hits = hits[:: max(1, len(hits) // _MOST_HITS)]
        places = surface.positions(near.cells[hits], near.uv[hits])
        places = places[border.is_within(places, near.distances[hits])]
        is_covered[part] = _spread(places, control, parts == part) >= _LEAST_SPREAD
    if not is_covered.any():
        return Uncovered(np.empty(0, dtype=np.int64), 0, np.zeros(len(targets), dtype=bool))
    is_left = ~is_covered[parts]
    covered = control.face_vertices[~is_left[owner]]
    alone = np.setdiff1d(control.face_vertices[is_left[owner]], covered)
    is_beside = (near.cells >= 0) & is_left[owner[near.cells]]
    return Uncovered(alone, int(np.count_nonzero(is_left)), is_beside)


def _spread(places, control, is_part):
    """Over which share of a part, some of the faces, places (n, 3) on it spread: by their scatter
    along its two main directions, where a single one of them, or a few close together, have none.
    """
    if len(places) < 3:
        return 0.0
    scatter = _scatter(control, is_part)
    values, axes = np.linalg.eigh(scatter)
    if values[1] <= 0.0:
        return 0.0
    own = np.cov(places @ axes[:, 1:], rowvar=False, bias=True)
    return float(np.sqrt(max(np.linalg.det(own), 0.0) / (values[1] * values[2])))


def _scatter(control, is_part):
    """(3, 3) covariance of the area of some of the control faces, as fans of triangles."""
    first = np.cumsum(control.face_sizes) - control.face_sizes
    fans = np.repeat(np.flatnonzero(is_part), control.face_sizes[is_part] - 2)
    steps = np.concatenate([np.arange(1, size - 1) for size in control.face_sizes[is_part]])
    at = first[fans]
    corners = control.points[
        control.face_vertices[np.stack([at, at + steps, at + steps + 1], axis=1)]
    ]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.linalg.norm(across, axis=1)
    if not areas.sum() > 0.0:
        return np.zeros((3, 3))
    weights, sums = areas / areas.sum(), corners.sum(axis=1)
    corners = corners - weights @ sums / 3.0
    sums = corners.sum(axis=1)
    moments = np.einsum("tki,tkj->tij", corners, corners) + np.einsum("ti,tj->tij", sums, sums)
    return np.einsum("t,tij->ij", weights, moments) / 12.0


class _Border:
    """Places along all creases and borders of a surface."""

    def __init__(self, surface, control, ends):
        keys = edge_keys(ends)
        _, inverse, counts = np.unique(keys, return_inverse=True, return_counts=True)
        is_border = np.isin(keys, edge_keys(control.creases)) | (counts[inverse] == 1)
        corners = np.flatnonzero(is_border)
        fewest, most = _ON_HALF_EDGE
        count = int(np.clip(_MOST_BORDER_PLACES // max(2 * len(corners), 1), fewest, most))
        places = surface.positions(*places_along(control, corners, count))
        halves = places.reshape(-1, count + 1, 3)
        lengths = np.linalg.norm(np.diff(halves, axis=1), axis=2).max(axis=1, initial=0.0)
        self._gaps = np.repeat(0.5 * lengths, count + 1)
        self._tree = kdtree.KDTree(len(places))
        for index, place in enumerate(places.tolist()):
            self._tree.insert(place, index)
        self._tree.balance()

    def is_within(self, places, distances):
        """(n,) which places (n, 3) are further from the border than these distances (n,)."""
        if not len(self._gaps):
            return np.ones(len(places), dtype=bool)
        found = [self._tree.find(place) for place in places.tolist()]
        gaps = self._gaps[[index for _, index, _ in found]]
        return np.array([away for _, _, away in found]) > distances + gaps


def places_along(control, corners, count):
    """(cells, uv) of a surface along the edges that begin at corners (k,) of ControlArrays' faces,
    each half of an edge divided into a count of parts."""
    following = next_corners(control.face_sizes)[corners]
    t = np.linspace(0.0, 1.0, count + 1)
    cells = np.repeat(np.concatenate([corners, following]), count + 1)
    along = np.stack([np.tile(t, len(corners)), np.zeros(len(corners) * (count + 1))], axis=1)
    return cells.astype(np.int32), np.concatenate([along, along[:, ::-1]])


def _parts_between_creases(control, owner, ends):
    """(f,) of each face the number of one face of its part; edges that are no creases join."""
    keys = edge_keys(ends)
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
