# SPDX-License-Identifier: GPL-3.0-or-later
"""Ties of control points: that a point is where others say, whatever moves these.

    LINE    on the straight line between two points, at a share of the way
    ANCHOR  at a fixed distance from another point, along all axes
    LEVEL   as high as another point
    MIRROR  the mirror image of another point on the centre plane
    CAMBER  deck at side: lower than another point by a share of the breadth at the point

All of a tie is in attributes of the mesh's points, so that it survives saving, undo, copying and
renumbering: a number that names the point, the same of the points that it follows, which need one
for it, what the tie is, and its numbers. A check goes with these, for Blender makes means of
numbers where it divides edges; of several points with one name, as after extruding, the one that
comes first has it. Blender keeps single precision, in which few lines meet their points: solved()
is exact.
"""

import zlib
from dataclasses import dataclass

import bmesh
import numpy as np

from . import own_attributes, tie_order

NAME, TIE, FIRST, SECOND = "hull_point", "hull_tie", "hull_tied_to", "hull_tied_to_2"
NUMBERS = "hull_tie_numbers"
_WHOLE = NAME, TIE, FIRST, SECOND
KINDS = ("LINE", "ANCHOR", "LEVEL", "MIRROR", "CAMBER")
LINE, ANCHOR, LEVEL, MIRROR, CAMBER = range(len(KINDS))
# Of each kind the axes along which the point may not move by itself.
AXES = ((0, 1, 2), (0, 1, 2), (2,), (0, 1, 2), (2,))
_SIGNS = {ANCHOR: (1.0, 1.0, 1.0), LEVEL: (1.0, 1.0, 1.0), MIRROR: (1.0, -1.0, 1.0)}
_KINDS_ROOM = 8  # in the attribute of the kind, beside the check


@dataclass(frozen=True, eq=False)
class PointTies:
    """points (k,) of the mesh in such an order that those they follow come before them; kinds (k,)
    by number of KINDS; leaders (k, 2), twice the same where there is one; numbers (k, 3) in
    Blender's units: the share of the way of a LINE, of the breadth of a CAMBER, the distances of
    others. levels: slices of these without any that follows another of the same slice. lost
    {point: why its tie does not count}, by the values of tie_order.REASONS. copies (c,): points
    that have the name of one before them."""

    points: np.ndarray
    kinds: np.ndarray
    leaders: np.ndarray
    numbers: np.ndarray
    levels: tuple
    lost: dict
    copies: np.ndarray

    def __len__(self):
        return len(self.points)

    def solved(self, points):
        """(n, 3) double: points (n, 3) of the mesh with the tied ones where they belong."""
        found = np.array(points, dtype=np.float64)
        for level in self.levels:
            for kind in np.unique(self.kinds[level]).tolist():
                own = np.arange(level.start, level.stop)[self.kinds[level] == kind]
                places, axes = self._places(own, kind, found), list(AXES[kind])
                found[np.ix_(self.points[own], axes)] = places[:, axes]
        return found

    def _places(self, own, kind, points):
        first, second = points[self.leaders[own, 0]], points[self.leaders[own, 1]]
        numbers = self.numbers[own]
        if kind == LINE:
            share = numbers[:, :1]
            return (1.0 - share) * first + share * second
        if kind == CAMBER:
            breadth = 2.0 * np.abs(points[self.points[own], 1])
            return first - np.outer(numbers[:, 0] * breadth, (0.0, 0.0, 1.0))
        return first * _SIGNS[kind] + numbers

    def exact(self, points, tolerance):
        """solved(), where points are not farther than that from what Blender keeps of them."""
        found = self.solved(points)
        far = (np.abs(found - points) > tolerance).any(axis=1)
        found[far] = points[far]
        return found

    def numbers_at(self, points):
        """(k, 3) the numbers by which the ties hold where the points (n, 3) are; of a LINE those of
        the nearest place on it, of a CAMBER those that it has."""
        points = np.asarray(points, dtype=np.float64)
        first, second = points[self.leaders[:, 0]], points[self.leaders[:, 1]]
        at, found = points[self.points], self.numbers.copy()
        for kind, signs in _SIGNS.items():
            found[self.kinds == kind] = (at - first * signs)[self.kinds == kind]
        found[self.kinds == LEVEL, :2] = 0.0
        way = second - first
        length = (way * way).sum(axis=1)
        share = ((at - first) * way).sum(axis=1) / np.where(length > 0.0, length, 1.0)
        lines = self.kinds == LINE
        found[lines, 0] = np.clip(share, 0.0, 1.0)[lines]
        return found

    def lead(self, points, moved):
        """(leaders (m,), (m, 3) where they go) of pairs whose follower is among moved (n,), and
        they are not, nor follow others: pairs of LEVEL and MIRROR go together by either."""
        leaders, places, tied = [], [], set(self.points.tolist())
        for row in np.flatnonzero((self.kinds == LEVEL) | (self.kinds == MIRROR)).tolist():
            point, leader, kind = self.points[row], int(self.leaders[row, 0]), self.kinds[row]
            if not moved[point] or moved[leader] or leader in tied or leader in leaders:
                continue
            axes, place = list(AXES[kind]), points[leader].astype(np.float64)
            there = (points[point] - self.numbers[row]) * _SIGNS[int(kind)]
            place[axes] = there[axes]
            leaders.append(leader)
            places.append(place)
        return np.array(leaders, dtype=np.int64), np.array(places).reshape(-1, 3)


def is_any(mesh):
    """Whether a Blender mesh has ever had ties."""
    if mesh.is_editmode:
        return bmesh.from_edit_mesh(mesh).verts.layers.int.get(TIE) is not None
    return own_attributes.found(mesh, TIE, "INT", "POINT") is not None


def read(mesh):
    """The PointTies of a Blender mesh, in edit mode or not; None without any, lost ones too."""
    if not is_any(mesh):
        return None
    indices, whole, numbers = _read_edited(mesh) if mesh.is_editmode else _read_stored(mesh)
    names, ties = whole[:, 0].tolist(), whole[:, 1].tolist()
    owners, rows, copies = {}, [], []
    for row, (index, name) in enumerate(zip(indices.tolist(), names)):
        if owners.setdefault(name, index) != index:
            copies.append(index)
        if _is_whole(ties[row], whole[row], numbers[row]):
            rows.append(row)
    if not rows:
        return None
    followed = {}
    for row in rows:
        own = [owners.get(name) for name in whole[row, 2:].tolist()]
        followed.setdefault(int(indices[row]), (row, owners[names[row]], own))
    return _ordered(followed, whole, numbers, copies)


def _is_whole(tie, whole, numbers):
    kind, (name, _, first, second) = tie % _KINDS_ROOM, whole.tolist()
    return kind < len(KINDS) and tie > 0 and tie == checked(kind, name, first, second, numbers)


def _ordered(followed, whole, numbers, copies):
    levels, lost = tie_order.levels(
        {point: (owner, leaders) for point, (_, owner, leaders) in followed.items()}
    )
    points = [point for level in levels for point in level]
    rows = [followed[point][0] for point in points]
    ends = np.cumsum([0, *map(len, levels)]).tolist()
    return PointTies(
        np.array(points, dtype=np.int64),
        whole[rows, 1] % _KINDS_ROOM,
        np.array([followed[point][2] for point in points], dtype=np.int64).reshape(-1, 2),
        numbers[rows].astype(np.float64),
        tuple(slice(a, b) for a, b in zip(ends, ends[1:])),
        lost,
        np.array(copies, dtype=np.int64),
    )


def checked(kind, name, first, second, numbers):
    """A tie as its attribute has it: the kind, and a check of all else."""
    content = np.array([name, first, second], np.int32).tobytes() + numbers.tobytes()
    return kind + _KINDS_ROOM * (1 + zlib.crc32(content) % 2**26)


def _read_edited(mesh):
    bm = bmesh.from_edit_mesh(mesh)
    layers = [bm.verts.layers.int.get(name) for name in _WHOLE]
    of_numbers = bm.verts.layers.float_vector.get(NUMBERS)
    if None in layers or of_numbers is None:
        return _NOTHING
    name = layers[0]
    found = [(index, vertex) for index, vertex in enumerate(bm.verts) if vertex[name]]
    whole = [[vertex[layer] for layer in layers] for _, vertex in found]
    numbers = [tuple(vertex[of_numbers]) for _, vertex in found]
    return (
        np.array([index for index, _ in found], dtype=np.int64),
        np.array(whole, dtype=np.int64).reshape(-1, 4),
        np.array(numbers, dtype=np.float32).reshape(-1, 3),
    )


_NOTHING = (
    np.empty(0, dtype=np.int64),
    np.empty((0, 4), dtype=np.int64),
    np.empty((0, 3), dtype=np.float32),
)


def _read_stored(mesh):
    columns = [own_attributes.found(mesh, name, "INT", "POINT") for name in _WHOLE]
    of_numbers = own_attributes.found(mesh, NUMBERS, "FLOAT_VECTOR", "POINT")
    if None in columns or of_numbers is None:
        return _NOTHING
    whole = np.stack([_values(mesh, column) for column in columns], axis=1)
    indices = np.flatnonzero(whole[:, 0])
    return indices, whole[indices].astype(np.int64), _vectors(mesh, of_numbers)[indices]


def _values(mesh, attribute):
    values = np.zeros(len(mesh.vertices), dtype=np.int32)
    attribute.data.foreach_get("value", values)
    return values


def _vectors(mesh, attribute):
    values = np.zeros((len(mesh.vertices), 3), dtype=np.float32)
    attribute.data.foreach_get("vector", values.reshape(-1))
    return values
