# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeping tied points where others say, while any of them are moved.

`lead` comes before flats and planes are kept: pairs that go together by either are led by the one
that was dragged. `kept` comes last: tied points go where they belong, but for those whose flat,
plane or centre plane would not have it, which counts. Distances and shares go along with all points
of a hull that was moved or scaled as a whole, and on first sight of a hull; a point that was
dragged along its line has its share of it anew.
"""

import dataclasses
from dataclasses import dataclass, field

import numpy as np

from ...bridge.counts import counted_are
from ...bridge.mesh import mesh_points, point_ties, tie_order, tie_writing
from ...bridge.objects import hull_objects
from . import flats, kept_points, plane_keeping, planes

_TIED = "Points stay where they are tied: Untie under Edges and Points frees them."
# Ties whose numbers are not given by their kind.
_FREE_KINDS = (point_ties.LINE, point_ties.ANCHOR)


@dataclass
class Memory:
    """What has been seen of one hull: where its points (n, 3) were last, None before the first
    time. told: sentences for the user, of what was not kept. moved (n,): which points the edit
    that is being followed moved, None where nobody knows; is_whole: all of them, as one body."""

    points: object = None
    told: list = field(default_factory=list)
    moved: object = None
    is_whole: bool = False


def lead(obj, memory, is_by_hand):
    """Moves the other one of pairs in Blender's mesh; the first step, of an edit as it comes."""
    memory.told, memory.moved, memory.is_whole = [], None, False
    if not point_ties.is_any(obj.data) or hull_objects.locked(obj):
        return
    points, before = mesh_points.read(obj.data), memory.points
    if before is None or len(before) != len(points):
        return
    memory.moved = (points != before).any(axis=1)
    memory.is_whole = _is_whole_move(before, points, memory.moved)
    ties = point_ties.read(obj.data)
    if not is_by_hand or ties is None or memory.is_whole or not memory.moved.any():
        return
    leaders, places = ties.lead(points, memory.moved)
    if len(leaders):
        mesh_points.write(obj.data, leaders, places)
        memory.moved[leaders] = True


def _is_whole_move(before, points, moved):
    return bool(moved.any()) and plane_keeping.affine_map(before, points) is not None


def kept(obj, data, memory, is_by_hand):
    """The MeshData of a hull with its tied points where they belong, in Blender's mesh too. The
    Memory is for this hull alone. is_by_hand: see keeping."""
    if data.ties is None or hull_objects.locked(obj):
        memory.points = data.points
        return data
    data = _without_lost(obj, data, memory)
    rows = _to_go_along(data, memory, is_by_hand and not obj.data.is_editmode)
    if len(rows):
        numbers = data.ties.numbers_at(data.points)[rows]
        tie_writing.give_numbers(obj.data, data.ties, rows, numbers)
        data = dataclasses.replace(data, ties=point_ties.read(obj.data))
    if _is_other_mesh(data, memory) and not is_by_hand:
        data = _released(obj, data, memory)
    if data.ties is not None:
        data = _placed(obj, data, memory)
    memory.points = data.points
    return data


def hold_from(obj, points):
    """Ties that points (n, 3) of the mesh do not hold, where a tool is to bring it back, have their
    distances and shares from these: they were made while it showed the points elsewhere."""
    ties = point_ties.read(obj.data)
    if ties is None:
        return
    off = np.isin(ties.kinds, _FREE_KINDS) & _are_off(ties, points)
    if off.any():
        stays = held_elsewhere(obj, ties.points[off], ties.solved(points), points)
        rows = np.flatnonzero(off & ~np.isin(ties.points, stays))
        tie_writing.give_numbers(obj.data, ties, rows, ties.numbers_at(points)[rows])


def _is_other_mesh(data, memory):
    return memory.points is not None and len(memory.points) != len(data.points)


def _without_lost(obj, data, memory):
    """Copies of tied points are free; what else is lost is told, for undo may bring it back."""
    if len(data.ties.copies):
        tie_writing.rename(obj.data, data.ties.copies)
        data = dataclasses.replace(data, ties=point_ties.read(obj.data))
    lost = [] if data.ties is None else list(data.ties.lost.values())
    for reason, text in (
        (tie_order.GONE, "no longer tied: a point that they followed is gone"),
        (tie_order.CYCLE, "tied in a circle, and free until one of them is untied"),
    ):
        if reason in lost:
            memory.told.append(f"{counted_are(lost.count(reason), 'point')} {text}.")
    return data


def _are_off(ties, points):
    """(k,) which of the ties do not hold, but for what single precision leaves."""
    off = np.abs(ties.solved(points) - points)[ties.points]
    return (off > planes.tolerance(points)).any(axis=1)


def _to_go_along(data, memory, may_be_joined):
    """(m,) rows of the ties whose numbers are to be taken from the points."""
    ties, going = data.ties, np.zeros(0, dtype=bool)
    if ties is None:
        return np.flatnonzero(going)
    is_joined = may_be_joined and _is_other_mesh(data, memory)
    if memory.is_whole:
        going = ties.kinds != point_ties.CAMBER
    elif memory.points is None or is_joined:
        going = np.isin(ties.kinds, _FREE_KINDS)
    elif memory.moved is not None:
        going = memory.moved[ties.points] & (ties.kinds == point_ties.LINE)
    return (
        np.flatnonzero(going & _are_off(ties, data.points)) if going.any() else going.nonzero()[0]
    )


def _released(obj, data, memory):
    """A tool has made another mesh, whose points need not be where those of before were."""
    if data.ties is None:
        return data
    off = data.ties.points[_are_off(data.ties, data.points)]
    if not len(off):
        return data
    tie_writing.free(obj.data, off)
    memory.told.append(f"{counted_are(len(off), 'point')} no longer tied: the mesh is another one.")
    return dataclasses.replace(data, ties=point_ties.read(obj.data))


def _placed(obj, data, memory):
    solved = data.ties.solved(data.points)
    places = solved.astype(np.float32)
    own = data.ties.points
    moved = (places != data.points).any(axis=1)
    stays = held_elsewhere(obj, own[moved[own]], solved, data.points)
    if stays:
        memory.told.append(
            f"{counted_are(len(stays), 'point')} kept in a flat, a plane or on the centre plane, "
            "which their ties would have them leave: untie or free them."
        )
        moved[stays] = False
    indices = np.flatnonzero(moved)
    if not len(indices):
        return data
    dragged = memory.moved is not None and memory.moved[indices].any() and not memory.is_whole
    if dragged and _are_off(data.ties, data.points).any() and not stays:
        memory.told.append(_TIED)
    points = data.points.copy()
    points[indices] = places[indices]
    mesh_points.write(obj.data, indices, places[indices])
    return dataclasses.replace(data, points=points)


def held_elsewhere(obj, indices, places, points):
    """Those of the points (m,) whose planes places (n, 3) are out of, as a list."""
    if not len(indices):
        return []
    allowed, held = planes.tolerance(points), held_planes(obj)
    if obj.hull.half:
        for index in indices[points[indices, 1] == 0.0].tolist():
            held.setdefault(index, []).append(planes.across_axis(1, 0.0))
    return [
        index
        for index in indices.tolist()
        if any(abs(places[index] @ plane[:3] - plane[3]) > allowed for plane in held.get(index, ()))
    ]


def held_planes(obj):
    """{point of the mesh: planes (4,) that hold it}: flats, stations, waterlines, buttocks."""
    found = {}
    for part, plane in flats.flat_planes(obj):
        for index in np.asarray(part).tolist():
            found.setdefault(index, []).append(np.array(plane))
    for index, own in kept_points.read(obj.data).planes().items():
        found.setdefault(index, []).extend(own)
    return found
