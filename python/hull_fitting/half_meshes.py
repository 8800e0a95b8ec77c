# SPDX-License-Identifier: GPL-3.0-or-later
"""The port half of a hull's meshes as one mesh: welded, clipped at the centre plane, its normals
outwards."""

from dataclasses import dataclass

import numpy as np

from .beside import normals_of
from .triangle_edges import components, edge_table

# Of the length: points are one; points of triangles so near the centre plane are put there. More
# than for control points: files of triangles are in single precision, or to few decimals, and what
# was left beside the plane would be clipped into slivers.
_WELD, _TO_CENTRE_PLANE = 1e-6, 1e-5
# What a triangle's normal tells of what is outside: outwards is to port and downwards.
_DOWNWARDS = 0.3
# Faces of CAD files are a few thousand pieces; each is held against each.
_MOST_PIECES = 20_000


@dataclass(frozen=True)
class HalfMesh:
    """points (n, 3), m, at y >= 0; those in the centre plane are at 0 exactly. triangles (m, 3),
    counter-clockwise seen from outside. length: m, along x."""

    points: np.ndarray
    triangles: np.ndarray
    length: float

    def kept(self, which):
        """The HalfMesh of some triangles, a mask (m,)."""
        return HalfMesh(self.points, self.triangles[which], self.length)


def half_mesh(geometry):
    """The HalfMesh of an oriented Geometry's meshes; ValueError where it has none."""
    if not geometry.meshes:
        raise ValueError(f"{geometry.name}: it has no surface: give a mesh or faces.")
    firsts = np.cumsum([0, *(len(mesh.points) for mesh in geometry.meshes)])
    points = np.concatenate([mesh.points for mesh in geometry.meshes])
    triangles = np.concatenate(
        [mesh.triangles + first for mesh, first in zip(geometry.meshes, firsts)]
    )
    length = float(np.ptp(points[:, 0]))
    if not length > 0.0:
        raise ValueError(f"{geometry.name}: its surface has no length; give a mesh of a hull.")
    points, triangles = _welded(points, triangles, _WELD * length)
    points = np.where(
        (np.abs(points) < _TO_CENTRE_PLANE * length) & [False, True, False], 0.0, points
    )
    points, triangles = clipped(points, triangles, 1, 0.0)
    _, areas = normals_of(points, triangles)
    is_central = (points[triangles][:, :, 1] == 0.0).all(axis=1)
    triangles = triangles[(areas > 1e-14 * length**2) & ~is_central]
    if not len(triangles):
        raise ValueError(
            f"{geometry.name}: none of its triangles has an area beside the centre plane; give a "
            "mesh of the hull's surface."
        )
    triangles, count = _outwards(points, triangles)
    if count > _MOST_PIECES:
        raise ValueError(
            f"{geometry.name}: its surface is in {count} pieces without common edges; join them, "
            "as by welding their points, or give one surface."
        )
    return HalfMesh(points, triangles, length)


def _welded(points, triangles, tolerance):
    for shift in (0.0, 0.5):
        cells = np.round(points / tolerance + shift).astype(np.int64)
        _, first, which = np.unique(cells, axis=0, return_index=True, return_inverse=True)
        points, triangles = points[first], which.reshape(-1)[triangles]
    following = np.roll(triangles, -1, axis=1)
    triangles = triangles[(triangles != following).all(axis=1)]
    _, first = np.unique(np.sort(triangles, axis=1), axis=0, return_index=True)
    return points, triangles[np.sort(first)]


def clipped(points, triangles, axis, place, keep_above=True):
    """(points, triangles) of what is on one side of the plane where the coordinate is `place`;
    points are added at the end, in the plane exactly."""
    sign = 1.0 if keep_above else -1.0
    off = sign * (points[:, axis] - place)
    inside = off[triangles] >= 0.0
    count = inside.sum(axis=1)
    whole = triangles[count == 3]
    parts, added, cuts = [whole], [], []
    number = len(points)
    for wanted in (1, 2):
        some = triangles[count == wanted]
        if not len(some):
            continue
        alone = inside[count == wanted] == (wanted == 1)
        turn = np.argmax(alone, axis=1)[:, None]
        a, b, c = np.take_along_axis(some, (turn + np.arange(3)) % 3, axis=1).T
        cuts += [np.stack([a, b], axis=1), np.stack([a, c], axis=1)]
        ab, ac = number + np.arange(len(a)), number + len(a) + np.arange(len(a))
        number += 2 * len(a)
        if wanted == 1:
            parts.append(np.stack([a, ab, ac], axis=1))
        else:
            parts += [np.stack([ab, b, c], axis=1), np.stack([ab, c, ac], axis=1)]
    if not cuts:
        return points, whole
    cuts, which = np.unique(np.sort(np.concatenate(cuts), axis=1), axis=0, return_inverse=True)
    which = which.reshape(-1)
    start, end = points[cuts[:, 0]], points[cuts[:, 1]]
    share = off[cuts[:, 0]] / (off[cuts[:, 0]] - off[cuts[:, 1]])
    added = start + share[:, None] * (end - start)
    added[:, axis] = place
    new = np.concatenate([np.arange(len(points)), len(points) + which])
    triangles = new[np.concatenate(parts)]
    following = np.roll(triangles, -1, axis=1)
    triangles = triangles[(triangles != following).all(axis=1)]
    return np.concatenate([points, added]), triangles


def _outwards(points, triangles):
    """(triangles, how many pieces they are in): those within which triangles run alike are turned
    as a whole."""
    table = edge_table(triangles)
    inner = table.counts == 2
    ends, owners = table.ends[inner], table.owners[inner]
    ways = [_runs_along(triangles[owners[:, side]], ends) for side in (0, 1)]
    piece = components(len(triangles), owners[ways[0] != ways[1]])
    normals, areas = normals_of(points, triangles)
    told = areas * (normals[:, 1] - _DOWNWARDS * normals[:, 2])
    is_inwards = np.bincount(piece, told)[piece] < 0.0
    count = components(len(triangles), table.owners[table.counts > 1]).max() + 1
    return np.where(is_inwards[:, None], triangles[:, ::-1], triangles), int(count)


def _runs_along(triangles, ends):
    return ((triangles == ends[:, :1]) & (np.roll(triangles, -1, axis=1) == ends[:, 1:])).any(
        axis=1
    )
