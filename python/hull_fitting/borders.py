# SPDX-License-Identifier: GPL-3.0-or-later
"""Borders of meshes that were put together of patches: seams, along which another patch goes on
without common points, are none."""

import heapq

import numpy as np

from .triangle_edges import components, edge_lines, edge_table

# Lines go the same way where the cosine between them is above this.
_ALIKE = 0.8
# Pairs of places and edges looked at at once.
_AT_ONCE = 2_000_000
# The mean length of edges, in cells: the more, the fewer pairs of edges are looked at, and the more
# places along them.
_CELLS_OF_AN_EDGE = 32


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
    """(k,) of edges the number of one that runs beside, the first of several; -1 where none
    does."""
    start, way = points[edges[:, 0]], points[edges[:, 1]] - points[edges[:, 0]]
    length = np.linalg.norm(way, axis=1)
    unit = way / np.maximum(length, 1e-300)[:, None]
    middle = start + 0.5 * way
    found = np.full(len(edges), len(edges))
    for some, others in _near_pairs(middle, start, way, tolerance):
        away = middle[some] - start[others]
        along = np.einsum("kd,kd->k", away, unit[others])
        off = np.linalg.norm(away - along[:, None] * unit[others], axis=1)
        cosines = np.einsum("kd,kd->k", unit[some], unit[others])
        beside = (off < tolerance) & (along > 0.0) & (along < length[others])
        beside &= np.abs(cosines) > _ALIKE
        beside &= ~_goes_on(edges[some], edges[others], cosines)
        np.minimum.at(found, some[beside], others[beside])
    return np.where(found < len(edges), found, -1)


def _near_pairs(middles, starts, ways, tolerance):
    """Arrays (numbers of middles, numbers of edges) of all that may be within tolerance, by parts;
    some pairs several times."""
    if not len(middles):
        return
    length = np.linalg.norm(ways, axis=1)
    corner, extent = middles.min(axis=0), np.ptp(middles, axis=0).max()
    # Places along an edge are a cell apart at most, so that what is near lies in a cell beside one.
    size = max(2.0 * tolerance, length.mean() / _CELLS_OF_AN_EDGE, 1e-6 * extent, 1e-300)
    counts = np.ceil(length / size).astype(int) + 1
    edge = np.repeat(np.arange(len(ways)), counts)
    at = np.arange(len(edge)) - np.repeat(np.cumsum(counts) - counts, counts)
    at = at / np.maximum(counts[edge] - 1, 1)
    cells = np.floor((middles - corner) / size).astype(np.int64) + 1
    grid = cells.max(axis=0) + 2
    keys = (cells[:, 0] * grid[1] + cells[:, 1]) * grid[2] + cells[:, 2]
    order = np.argsort(keys, kind="stable")
    keys = keys[order]
    places = starts[edge] + at[:, None] * ways[edge]
    of_places = np.floor((places - corner) / size).astype(np.int64) + 1
    is_inside = ((of_places >= 0) & (of_places < grid)).all(axis=1)
    edge, (i, j, k) = edge[is_inside], of_places[is_inside].T
    for di, dj in np.ndindex(3, 3):
        row = ((i + di - 1) * grid[1] + j + dj - 1) * grid[2] + k
        low = np.searchsorted(keys, row - 1, "left")
        yield from _ranges(order, low, np.searchsorted(keys, row + 1, "right"), edge)


def _ranges(order, low, high, owners):
    """(order[low to high], the owner of each range), by parts."""
    counts = high - low
    ends = np.cumsum(counts)
    part = np.searchsorted(ends, np.arange(_AT_ONCE, ends[-1] + _AT_ONCE, _AT_ONCE))
    for first, last in zip([0, *part + 1], part + 1):
        own = counts[first:last]
        if own.sum():
            inner = np.arange(own.sum()) - np.repeat(np.cumsum(own) - own, own)
            yield order[np.repeat(low[first:last], own) + inner], np.repeat(owners[first:last], own)


def _goes_on(some, others, cosines):
    """Whether an edge is the other one itself, or goes on from its end; pair by pair."""
    same = np.equal(some[:, :, None], others[:, None, :])
    itself = same[:, 0, 0] & same[:, 1, 1]
    at_like_ends = same[:, 0, 0] | same[:, 1, 1]
    at_unlike_ends = same[:, 0, 1] | same[:, 1, 0]
    return itself | (at_like_ends & (cosines < 0.0)) | (at_unlike_ends & (cosines > 0.0))


def joined_lines(points, edges, reach):
    """Lines (n, 3) along edges, joined where their ends are within reach, m, the nearest first."""
    return joined([points[line] for line in edge_lines(edges)], reach)


def joined(lines, reach):
    """The same of lines that there are."""
    lines = dict(enumerate(lines))
    if len(lines) < 2:
        return list(lines.values())
    # Of an end: twice the number of its line, and one more where that ends; -1 within a line.
    ends = np.arange(2 * len(lines))
    places = np.array([place for line in lines.values() for place in (line[0], line[-1])])
    order = np.argsort(places[:, 0], kind="stable")
    sorted_x = places[order, 0]
    window = 1.001 * reach  # for rounding
    # How near another line's end is at least: as lines are joined, it can but grow.
    heap = [(0.0, end, end) for end in range(len(ends))]
    of_end = dict(enumerate(range(len(ends))))
    following = len(lines)
    while len(lines) > 1 and heap:
        bound, number, place = heapq.heappop(heap)
        if ends[place] != number:
            continue
        low = np.searchsorted(sorted_x, places[place, 0] - window, "left")
        near = order[low : np.searchsorted(sorted_x, places[place, 0] + window, "right")]
        near = near[(ends[near] >= 0) & (ends[near] // 2 != number // 2)]
        apart = np.linalg.norm(places[place] - places[near], axis=1)
        least = float(apart.min(initial=np.inf))
        if least > reach:
            continue
        if least > bound:
            heapq.heappush(heap, (least, number, place))
            continue
        other = int(ends[near[apart == least]].min())
        first, second = lines.pop(number // 2), lines.pop(other // 2)
        first = first[::-1] if number % 2 == 0 else first
        second = second if other % 2 == 0 else second[::-1]
        lines[following] = np.concatenate([first, second[1:] if least == 0.0 else second])
        ends[[place, of_end[other]]] = -1
        for end, outer in ((2 * following, number ^ 1), (2 * following + 1, other ^ 1)):
            of_end[end] = of_end.pop(outer)
            ends[of_end[end]] = end
            heapq.heappush(heap, (least, end, of_end[end]))
        following += 1
    return list(lines.values())


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
