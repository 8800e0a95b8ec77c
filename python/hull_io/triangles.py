# SPDX-License-Identifier: GPL-3.0-or-later
"""What a fit takes of a mesh of triangles: places spread evenly over it, its edges, its cut by the
centre plane. Arrays in and out, always the same for the same arguments."""

import numpy as np

# Of the plane sequence with the least gaps: parts of the plastic number.
_STEPS = (0.7548776662466927, 0.5698402909980532)
# Of the mean area: triangles with less have no normal to speak of.
_NO_AREA = 1e-12


def normals_of(points, triangles):
    """((m, 3) unit normals, zero where there is none; (m,) areas)."""
    a, b, c = points[triangles].transpose(1, 0, 2)
    normals = np.cross(b - a, c - a)
    doubles = np.linalg.norm(normals, axis=1)
    is_flat = doubles <= _NO_AREA * max(doubles.mean(), np.finfo(float).tiny)
    normals = np.where(is_flat[:, None], 0.0, normals) / np.where(is_flat, 1.0, doubles)[:, None]
    return normals, 0.5 * doubles


def spread_points(points, triangles, count):
    """(places (k, 3), normals (k, 3)): `count` or a few less, by area."""
    normals, areas = normals_of(points, triangles)
    ends = np.cumsum(areas)
    if not len(ends) or not ends[-1] > 0.0:
        return np.empty((0, 3)), np.empty((0, 3))
    wanted = (np.arange(count) + 0.5) * ends[-1] / count
    chosen = np.minimum(np.searchsorted(ends, wanted), len(ends) - 1)
    chosen = chosen[normals[chosen].any(axis=1)]
    u, v = (np.outer(_STEPS, np.arange(len(chosen))) + 0.5) % 1.0
    beyond = u + v > 1.0
    u, v = np.where(beyond, 1.0 - u, u), np.where(beyond, 1.0 - v, v)
    a, b, c = points[triangles[chosen]].transpose(1, 0, 2)
    return a + u[:, None] * (b - a) + v[:, None] * (c - a), normals[chosen]


def feature_edges(points, triangles, angle):
    """(k, 2, 3) ends of the edges where normals turn by `angle` (radians) or more, and of those
    that only one triangle has."""
    normals, _ = normals_of(points, triangles)
    edges = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2), axis=2)
    edges = edges.reshape(-1, 2)
    owners = np.repeat(np.arange(len(triangles)), 3)
    order = np.lexsort((edges[:, 1], edges[:, 0]))
    edges, owners = edges[order], owners[order]
    is_new = np.ones(len(edges), dtype=bool)
    is_new[1:] = (edges[1:] != edges[:-1]).any(axis=1)
    first = np.flatnonzero(is_new)
    counts = np.diff(np.append(first, len(edges)))
    is_sharp = counts == 1
    two = first[counts == 2]
    a, b = normals[owners[two]], normals[owners[two + 1]]
    turns = (a * b).sum(axis=1) <= np.cos(angle)
    is_sharp[counts == 2] = turns & a.any(axis=1) & b.any(axis=1)
    return points[edges[first[is_sharp]]]


def centre_cut(points, triangles):
    """(k, 2, 3) the pieces of the line in which triangles cross the plane y = 0."""
    y = points[triangles][:, :, 1]
    ahead = y >= 0.0
    crossing = triangles[ahead.any(axis=1) & ~ahead.all(axis=1)]
    if not len(crossing):
        return np.empty((0, 2, 3))
    corners = points[crossing]
    following = np.roll(corners, -1, axis=1)
    y, next_y = corners[:, :, 1], following[:, :, 1]
    crosses = (y >= 0.0) != (next_y >= 0.0)
    shares = np.where(crosses, y / np.where(crosses, y - next_y, 1.0), 0.0)
    places = corners + shares[:, :, None] * (following - corners)
    places[:, :, 1] = 0.0
    return places[crosses].reshape(-1, 2, 3)


def divided(edges, spacing):
    """Lines (k, 3) along edges (n, 2, 3), with points no further apart than about `spacing`."""
    lengths = np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1)
    lines = []
    for (a, b), length in zip(edges, lengths):
        if length > 0.0:
            shares = np.linspace(0.0, 1.0, 1 + max(1, int(np.ceil(length / spacing))))
            lines.append(a + shares[:, None] * (b - a))
    return lines
