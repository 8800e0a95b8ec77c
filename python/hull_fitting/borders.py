# SPDX-License-Identifier: GPL-3.0-or-later
"""Borders of meshes that were put together of patches: seams, along which another patch goes on
without common points, are none."""

import numpy as np

from .triangle_edges import components, edge_lines, edge_table

# Lines go the same way where the cosine between them is above this.
_ALIKE = 0.8
# Pairs of places and edges looked at at once.
_AT_ONCE = 2_000_000


def border_edges(points, triangles, tolerance):
    """(k, 2) ends of edges of one triangle alone: in the centre plane; and of others all but those
    beside which, within tolerance (m), another one runs."""
    table = edge_table(triangles)
    edges = table.ends[table.is_border]
    is_central = (points[edges][:, :, 1] == 0.0).all(axis=1)
    others = edges[~is_central]
    return edges[is_central], others[~_is_beside_another(points, others, tolerance)]


def bodies(points, triangles, tolerance):
    """(m,) numbers from 0 of what triangles hang together by common edges, or by edges that run
    beside one another within tolerance, m."""
    table = edge_table(triangles)
    edges, owners = table.ends[table.is_border], table.owners[table.is_border, 0]
    beside = _beside(points, edges, tolerance)
    seams = np.stack([owners, owners[beside]], axis=1)[beside >= 0]
    return components(len(triangles), np.concatenate([table.owners[table.counts > 1], seams]))


def _is_beside_another(points, edges, tolerance):
    return _beside(points, edges, tolerance) >= 0


def _beside(points, edges, tolerance):
    """(k,) of edges the number of one that runs beside, -1 where none does."""
    start, way = points[edges[:, 0]], points[edges[:, 1]] - points[edges[:, 0]]
    length = np.linalg.norm(way, axis=1)
    unit = way / np.maximum(length, 1e-300)[:, None]
    middle = start + 0.5 * way
    found = np.full(len(edges), -1)
    step = max(1, _AT_ONCE // max(len(edges), 1))
    for low in range(0, len(edges), step):
        part = slice(low, low + step)
        cosines = unit[part] @ unit.T
        away = middle[part, None] - start[None]
        along = np.einsum("ikd,kd->ik", away, unit)
        off = np.linalg.norm(away - along[:, :, None] * unit[None], axis=2)
        beside = (off < tolerance) & (along > 0.0) & (along < length)
        beside &= np.abs(cosines) > _ALIKE
        beside &= ~_goes_on(edges[part], edges, cosines)
        found[part] = np.where(beside.any(axis=1), beside.argmax(axis=1), -1)
    return found


def _goes_on(some, edges, cosines):
    """Whether an edge is another one itself, or goes on from its end."""
    same = np.equal(some[:, None, :, None], edges[None, :, None, :])
    itself = same[:, :, 0, 0] & same[:, :, 1, 1]
    at_like_ends = same[:, :, 0, 0] | same[:, :, 1, 1]
    at_unlike_ends = same[:, :, 0, 1] | same[:, :, 1, 0]
    return itself | (at_like_ends & (cosines < 0.0)) | (at_unlike_ends & (cosines > 0.0))


def joined_lines(points, edges, reach):
    """Lines (n, 3) along edges, joined where their ends are within reach, m, the nearest first."""
    return joined([points[line] for line in edge_lines(edges)], reach)


def joined(lines, reach):
    """The same of lines that there are."""
    lines = list(lines)
    while len(lines) > 1:
        ends = np.array([[line[0], line[-1]] for line in lines])
        flat = ends.reshape(-1, 3)
        apart = np.linalg.norm(flat[:, None] - flat[None], axis=2)
        owner = np.arange(len(flat)) // 2
        apart[owner[:, None] == owner[None]] = np.inf
        i, k = np.unravel_index(np.argmin(apart), apart.shape)
        if apart[i, k] > reach:
            break
        first, second = lines[owner[i]], lines[owner[k]]
        first = first[::-1] if i % 2 == 0 else first
        second = second if k % 2 == 0 else second[::-1]
        joined = np.concatenate([first, second[1:] if apart[i, k] == 0.0 else second])
        lines = [line for n, line in enumerate(lines) if n not in (owner[i], owner[k])]
        lines.append(joined)
    return lines


def without_spurs(line, reach):
    """A line (n, 3) without what ends within reach, m, of where it began: there and back along a
    gap between two patches."""
    kept, i = [], 0
    while i < len(line):
        kept.append(i)
        near = np.flatnonzero(np.linalg.norm(line[i + 1 :] - line[i], axis=1) < reach)
        i += 1 + (int(near[-1]) if len(near) else 0)
    if kept[-1] != len(line) - 1:
        kept.append(len(line) - 1)
    return line[kept]
