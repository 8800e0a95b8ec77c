# SPDX-License-Identifier: GPL-3.0-or-later
"""Edges of triangles: who shares them, what is joined by them, lines along them."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class EdgeTable:
    """ends (k, 2): of each edge once, the lower number first. owners (k, 2): triangles that have
    it, -1 where there is no second one; of an edge of more triangles two of them. counts (k,)."""

    ends: np.ndarray
    owners: np.ndarray
    counts: np.ndarray

    @property
    def is_border(self):
        return self.counts == 1


def edge_table(triangles):
    """The EdgeTable of triangles (m, 3)."""
    directed = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    sides = np.sort(directed, axis=1)
    owners = np.repeat(np.arange(len(triangles)), 3)
    order = np.lexsort((sides[:, 1], sides[:, 0]))
    sides, owners = sides[order], owners[order]
    is_new = np.ones(len(sides), dtype=bool)
    is_new[1:] = (sides[1:] != sides[:-1]).any(axis=1)
    first = np.flatnonzero(is_new)
    counts = np.diff(np.append(first, len(sides)))
    second = np.where(counts > 1, owners[np.minimum(first + 1, len(owners) - 1)], -1)
    return EdgeTable(sides[first], np.stack([owners[first], second], axis=1), counts)


def components(count, pairs):
    """(count,) numbers from 0 of what is joined by pairs (k, 2)."""
    label = np.arange(count)
    while True:
        low = np.minimum(label[pairs[:, 0]], label[pairs[:, 1]])
        new = label.copy()
        np.minimum.at(new, label[pairs[:, 0]], low)
        np.minimum.at(new, label[pairs[:, 1]], low)
        new = new[new]
        if (new == label).all():
            break
        label = new
    return np.unique(label, return_inverse=True)[1]


def members(numbers):
    """For each number from 0 where in `numbers` (n,) it stands, rising."""
    order = np.argsort(numbers, kind="stable")
    return np.split(order, np.cumsum(np.bincount(numbers))[:-1])


def edge_lines(edges):
    """Lists of point numbers along edges (k, 2): lines that end where other than two edges meet,
    and rings, whose last number is their first."""
    beside = {}
    for number, (a, b) in enumerate(edges.tolist()):
        beside.setdefault(a, []).append((number, b))
        beside.setdefault(b, []).append((number, a))
    used = np.zeros(len(edges), dtype=bool)
    starts = [point for point, there in beside.items() if len(there) != 2]
    lines = []
    for start in [*starts, *beside]:
        for number, following in beside[start]:
            if used[number]:
                continue
            used[number] = True
            line = [start, following]
            while len(beside[line[-1]]) == 2 and line[-1] != start:
                onward = [(n, p) for n, p in beside[line[-1]] if not used[n]]
                if not onward:
                    break
                used[onward[0][0]] = True
                line.append(onward[0][1])
            lines.append(line)
    return lines
