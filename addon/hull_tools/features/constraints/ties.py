# SPDX-License-Identifier: GPL-3.0-or-later
"""Tying control points to others, as bridge.mesh.point_ties has it, and what tools make of ties."""

import numpy as np
from mathutils import kdtree

from ...bridge.counts import counted_are
from ...bridge.mesh import mesh_points, point_ties, tie_order, tie_writing
from ...bridge.mesh.point_ties import ANCHOR, AXES, CAMBER, KINDS, LEVEL, LINE, MIRROR
from . import point_locks, tie_keeping

# Of the size: how far from a mirror image its point may be.
_IMAGE = 1e-3


def tie_selected(obj, kind, share=0.02):
    """Ties the points that are selected in edit mode by one of KINDS, and brings them where they
    belong; returns how many. share: of the breadth, for CAMBER.

    LINE: those between the two that are farthest apart; MIRROR: those to starboard of which the
    image is selected, too; all others follow the active point. ValueError, and nothing is changed,
    where points can't be tied so.
    """
    indices, points = mesh_points.selected(obj.data), mesh_points.read(obj.data)
    number = KINDS.index(kind)
    followers, leaders = _CHOICES[number](obj, indices, points)
    tie_points(obj, number, followers, leaders, share)
    return len(followers)


def tie_points(obj, kind, followers, leaders, share=0.02):
    """Ties points (k,) to others (k, 2), by the number of a kind; see tie_selected."""
    points = mesh_points.read(obj.data)
    followers = np.asarray(followers, dtype=np.int64)
    leaders = np.asarray(leaders, dtype=np.int64).reshape(-1, 2)
    known = point_ties.read(obj.data)
    _check_circle(known, followers, leaders)
    wanted = point_ties.PointTies(
        followers,
        np.full(len(followers), kind),
        leaders,
        np.zeros((len(followers), 3)),
        (slice(0, len(followers)),),
        {},
        np.empty(0, dtype=np.int64),
    )
    wanted.numbers[:] = _numbers(wanted, kind, points, share)
    _check_held(obj, wanted.solved(points), points, followers)
    tie_writing.tie(obj.data, followers, kind, leaders, wanted.numbers)


def _numbers(wanted, kind, points, share):
    if kind == CAMBER:
        return (share, 0.0, 0.0)
    return wanted.numbers_at(points) if kind in (LINE, ANCHOR) else 0.0


def _check_circle(known, followers, leaders):
    follows = {} if known is None else dict(zip(known.points.tolist(), known.leaders.tolist()))
    follows.update(zip(followers.tolist(), leaders.tolist()))
    for point in followers.tolist():
        way = tie_order.cycle_through(point, follows)
        if way:
            others = " and ".join(f"{other}" for other in way[1:])
            by = f", by {'points' if len(way) > 2 else 'point'} {others}" if others else ""
            raise ValueError(
                f"Point {point} would follow itself{by}: untie one of them first, or choose others"
            )


def _check_held(obj, places, points, followers):
    locked = np.intersect1d(followers, point_locks.locked_points(obj.data))
    if len(locked):
        raise ValueError(
            f"{counted_are(len(locked), 'point')} locked: unlock what is to follow others"
        )
    stay = tie_keeping.held_elsewhere(obj, followers, places, points)
    if stay:
        raise ValueError(
            f"{counted_are(len(stay), 'point')} kept in a flat, a plane or on the centre plane "
            "that the tie would have them leave: release or free them first"
        )


def _others_to_active(obj, indices, points):
    active = mesh_points.active(obj.data)
    if active is None or active not in indices:
        raise ValueError("Select the points, last of all the one that they are to follow")
    others = indices[indices != active]
    if not len(others):
        raise ValueError("Select the points that are to follow, too, before the one they follow")
    return others, np.full((len(others), 2), active)


def _between_ends(obj, indices, points):
    if len(indices) < 3:
        raise ValueError("Select at least three points: the ends, and what is to be between them")
    chosen = points[indices]
    # Of all pairs: rows of points are short.
    apart = np.linalg.norm(chosen[:, None] - chosen, axis=2)
    ends = np.array(np.unravel_index(np.argmax(apart), apart.shape))
    others = np.delete(indices, ends)
    return others, np.tile(indices[np.sort(ends)], (len(others), 1))


def _images(obj, indices, points):
    if obj.hull.half:
        raise ValueError("A half hull has no other side: its image follows in any case")
    tree = kdtree.KDTree(len(points))
    for index in indices.tolist():
        tree.insert(points[index], index)
    tree.balance()
    near, followers, leaders = _IMAGE * np.abs(points).max(initial=0.0), [], []
    for index in indices[points[indices, 1] < -near].tolist():
        _, image, distance = tree.find(points[index] * (1.0, -1.0, 1.0))
        if distance <= near:
            followers.append(index)
            leaders.append((image, image))
    if not followers:
        raise ValueError("Select points of both sides: none has its mirror image selected, too")
    return np.array(followers), np.array(leaders)


_CHOICES = {
    LINE: _between_ends,
    ANCHOR: _others_to_active,
    LEVEL: _others_to_active,
    MIRROR: _images,
    CAMBER: _others_to_active,
}


def untie(obj, indices):
    """Points (k,) follow no others any longer; returns how many did."""
    tied = tied_points(obj.data)
    tie_writing.free(obj.data, np.intersect1d(indices, tied))
    return int(np.isin(tied, indices).sum())


def tied_points(mesh):
    """(k,) the tied points of a Blender mesh, those whose tie does not count included."""
    ties = point_ties.read(mesh)
    if ties is None:
        return np.empty(0, dtype=np.int64)
    return np.unique(np.concatenate([ties.points, np.array(list(ties.lost), dtype=np.int64)]))


def stored_ties(mesh):
    """[(kind by its name, point, points it follows, three numbers as Blender keeps them)]."""
    ties = point_ties.read(mesh)
    if ties is None:
        return []
    return [
        (KINDS[kind], point, tuple(to[: 2 if kind == LINE else 1]), tuple(numbers))
        for kind, point, to, numbers in zip(
            ties.kinds.tolist(), ties.points.tolist(), ties.leaders.tolist(), ties.numbers.tolist()
        )
    ]


def pairs(mesh):
    """(k, 2) of the tied points of a Blender mesh: the point, one that it follows."""
    ties = point_ties.read(mesh)
    if ties is None:
        return np.empty((0, 2), dtype=np.int64)
    found = np.concatenate([np.stack([ties.points, ties.leaders[:, i]], axis=1) for i in range(2)])
    return np.unique(found, axis=0)


def store_ties(mesh, stored):
    """Ties points of a Blender mesh so, as they are: none is moved."""
    for kind in sorted({own[0] for own in stored}):
        _, points, leaders, numbers = zip(*(own for own in stored if own[0] == kind))
        leaders = [(to[0], to[-1]) for to in leaders]
        tie_writing.tie(mesh, points, KINDS.index(kind), leaders, numbers)


def mirror(mesh, image):
    """Ties the points of the other side that a Blender mesh was given as those of this side are.
    image {point: its mirror image}, itself on the centre plane."""
    stored = stored_ties(mesh)
    copies = [other for point, other in image.items() if other != point]
    tie_writing.rename(mesh, np.array(copies, dtype=np.int64))
    store_ties(
        mesh,
        [
            (kind, image[point], tuple(image.get(one, one) for one in to), _image(kind, numbers))
            for kind, point, to, numbers in stored
            if image.get(point, point) != point
        ],
    )


def _image(kind, numbers):
    x, y, z = numbers
    return (x, -y if KINDS.index(kind) in (ANCHOR, LEVEL, MIRROR) else y, z)


def go_along(obj):
    """Distances and shares are as the points of a hull are now, which a tool has placed."""
    ties = point_ties.read(obj.data)
    if ties is None:
        return
    numbers = ties.numbers_at(mesh_points.read(obj.data))
    tie_writing.give_numbers(obj.data, ties, np.arange(len(ties)), numbers)


def move_sums(mesh, vertex_ids, points):
    """What ties mean for tools that move control points (n, 3), with these indices in a Blender
    mesh: tuples (control points (k,), slopes (k, 3)), sums of slope · move that stay zero, as
    hull_native's functions take them. A point on a line keeps its share of the way."""
    ties = point_ties.read(mesh)
    if ties is None:
        return ()
    place = {index: at for at, index in enumerate(vertex_ids.tolist())}
    found = []
    for row, point in enumerate(ties.points.tolist()):
        if point in place:
            for axis in AXES[ties.kinds[row]]:
                found.append(_sum(ties, row, axis, place, points))
    return tuple(found)


def _sum(ties, row, axis, place, points):
    kind, numbers, unit = ties.kinds[row], ties.numbers[row], np.eye(3)[axis]
    own = place[int(ties.points[row])]
    first, second = (place.get(index) for index in ties.leaders[row].tolist())
    slope, terms = unit.copy(), []
    if kind == LINE:
        terms = [(first, -(1.0 - numbers[0]) * unit), (second, -numbers[0] * unit)]
    elif kind == MIRROR and axis == 1:
        terms = [(first, unit)]
    else:
        terms = [(first, -unit)]
    if kind == CAMBER:
        slope[1] = 2.0 * numbers[0] * np.sign(points[own, 1])
    # Points that do not belong to the shell stay.
    terms = [(own, slope), *((at, part) for at, part in terms if at is not None)]
    return (
        np.array([at for at, _ in terms], dtype=np.int64),
        np.array([part for _, part in terms]),
    )
