# SPDX-License-Identifier: GPL-3.0-or-later
"""Combs and inflections of rows of control points: a mesh that looks good gives a surface that
looks good (Greshake 2021, 6.5).

The curvature at a point is that of the circle through it and its neighbours. Inflections that an
eye sees (hull_fairness.inflections) are counted in the views that a row is faired in: in plan and
in profile where it runs along the ship, else in the body plan.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ....hull_fairness import inflections as seen
from ....hull_fairness.lines import LEAST_DEPTH
from ....hull_io import control_rows
from ...bridge.mesh import curve_marks, row_marks
from ..lines import lines
from .combs import HEIGHT, MARKS, STRAIGHT

KIND = "row"
# The axes of a view that are seen.
_PLAN, _PROFILE, _BODY = (0, 1), (0, 2), (1, 2)
_NEARLY_ALL = 0.95
# Between two points of a row.
_SAMPLES = 16


@dataclass(frozen=True, eq=False)
class RowGroup:
    """As a combs.CombGroup: rows of control points. points (n, 3) of all control points, m."""

    key: tuple
    is_mirrored: bool
    rows: tuple
    points: np.ndarray
    scale: float = 0.0

    kind = KIND

    def comb(self, scale):
        """(points (n, 3), ends of their teeth (n, 3), pairs (m, 2) of ends that a line joins), in
        m; scale in m²."""
        places, tips, pairs, count = [np.empty((0, 3))], [np.empty((0, 3))], [], 0
        for own, bends in self._bent:
            places.append(own)
            tips.append(own - scale * bends)
            firsts = np.arange(count, count + len(own) - 1)
            pairs.append(np.column_stack([firsts, firsts + 1]))
            count += len(own)
        pairs.append(np.empty((0, 2), dtype=np.int64))
        return np.concatenate(places), np.concatenate(tips), np.concatenate(pairs)

    @cached_property
    def _bent(self):
        """(points, curvature vectors) of each part of a row, but for what is at its ends."""
        found = []
        for row in self.rows:
            for part, is_closed in row.parts():
                own, bends = bends_of(self.points[row.points[part]], is_closed)
                if len(own):
                    found.append((own, bends))
        return found

    @property
    def usual_bend(self):
        """1/m: that nearly all curvatures are below."""
        bends = [np.linalg.norm(bends, axis=1) for _, bends in self._bent]
        return float(np.quantile(np.concatenate(bends), _NEARLY_ALL)) if bends else 0.0

    @cached_property
    def marks(self):
        """Points (n, 3) in m by combs.MARKS."""
        found = [inflections(self.points, row) for row in self.rows]
        none = np.empty((0, 3))
        return {**dict.fromkeys(MARKS, none), "inflection": np.concatenate([none, *found])}

    @cached_property
    def mark_counts(self):
        return {name: len(points) for name, points in self.marks.items()}


def bends_of(points, is_closed=False):
    """(points (m, 3), curvature vectors (m, 3) in 1/m) of a row's points (n, 3), by the circle
    through each and its neighbours, towards its centre: of all but the ends. What has no such
    circle is straight."""
    points = _with_neighbours(points, is_closed)
    if len(points) < control_rows.LEAST_POINTS:
        return np.empty((0, 3)), np.empty((0, 3))
    back, on = points[:-2] - points[1:-1], points[2:] - points[1:-1]
    squares = [(each**2).sum(axis=1)[:, None] for each in (back, on, on - back)]
    divisor = squares[0] * squares[1] * squares[2]
    bends = 2.0 * np.cross(squares[0] * on - squares[1] * back, np.cross(back, on))
    with np.errstate(divide="ignore", invalid="ignore"):
        bends = np.where(divisor > 0.0, bends / divisor, 0.0)
    return points[1:-1], bends


def _with_neighbours(points, is_closed):
    return np.concatenate([points[-1:], points, points[:2]]) if is_closed else points


def inflections(points, row):
    """Where a control_rows.Row changes the side it bends to as far as is seen, (k, 3): points
    (n, 3) of all control points, m."""
    own, least = points[row.points], least_depth(points)
    extent = np.ptp(own, axis=0)
    views = (_PLAN, _PROFILE) if extent[0] >= extent[1:].max() else (_BODY,)
    found = [np.empty((0, 3))]
    for part, is_closed in row.parts():
        part = _with_neighbours(own[part], is_closed)
        found += [_inflections_in(part, view, least) for view in views]
    return np.concatenate(found)


def least_depth(points):
    """m: what is less deep is not seen on a hull with these control points (n, 3)."""
    return LEAST_DEPTH * 2.0 * float(np.abs(points[:, 1]).max())


def _inflections_in(points, view, least):
    flat = np.zeros_like(points)
    flat[:, :2] = points[:, view]
    steps = np.diff(flat, axis=0)
    _, bends = bends_of(flat)
    if len(bends) < 2:
        return np.empty((0, 3))
    sides = np.sign(np.cross(steps[:-1], steps[1:])[:, 2])
    lengths = np.concatenate([[0.0], np.cumsum(np.linalg.norm(steps, axis=1))])
    if not lengths[-1] > 0.0:
        return np.empty((0, 3))
    # Ends have no circle, and bend to neither side.
    values = np.concatenate([[0.0], sides * np.linalg.norm(bends, axis=1), [0.0]])
    places = np.arange(len(points))
    fine = np.linspace(0.0, places[-1], _SAMPLES * places[-1] + 1)
    marks = seen.marks(np.interp(fine, places, lengths), np.interp(fine, places, values), least)
    at = [fine[mark.index] for mark in marks if mark.kind == seen.INFLECTION]
    return np.column_stack([np.interp(at, places, points[:, axis]) for axis in range(3)])


def follow(known, obj, ship, settings):
    """The RowGroup of the rows that are marked to be shown, None where there is none or none is
    wanted. `known`: that of before, or None, of which what is the same is kept; the scale is chosen
    when rows are shown or other ones are."""
    if not settings.fairness.comb_rows or ship.surface is None:
        return None
    control = ship.source.control
    marked = shown_edges(obj, control.vertex_ids)
    topology = (ship.topology_key, tuple(marked))
    key = (ship.geometry_key, topology, settings.half)
    if known is not None and known.key == key:
        return known
    if known is not None and known.key[1] == topology:
        rows, scale = known.rows, known.scale
    else:
        rows = tuple(control_rows.RowNet(control).rows_of(marked, are_whole=False))
        scale = 0.0
    if not rows:
        return None
    size = lines.steady_size(ship.surface)
    points = np.array(control.points)
    group = RowGroup(key, settings.half, rows, points, scale)
    if scale:
        return group
    # Teeth of a handy length; what is straight to rounding gets none that show.
    return replace(group, scale=HEIGHT * size / max(group.usual_bend, STRAIGHT / size))


def marked_edges(mesh, vertex_ids):
    """The edges of a Blender mesh that are marked to be shown as rows, as pairs of control points
    by their place among vertex_ids (n,), rising."""
    found = row_marks.marked(mesh)
    if not len(found):
        return []
    own = np.isin(found, vertex_ids).all(axis=1)
    pairs = np.searchsorted(vertex_ids, found[own])
    return sorted(control_rows.edge_key(a, b) for a, b in pairs.tolist())


def shown_edges(obj, vertex_ids):
    """The same of a hull, without those of control curves that are switched off."""
    hidden = [curve.number for curve in obj.hull.fairness.curves if not curve.is_shown]
    marked = marked_edges(obj.data, vertex_ids)
    if not hidden or not marked:
        return marked
    edges, numbers = curve_marks.numbered(obj.data)
    edges = edges[np.isin(numbers, hidden)]
    edges = edges[np.isin(edges, vertex_ids).all(axis=1)]
    pairs = np.searchsorted(vertex_ids, edges)
    left_out = {control_rows.edge_key(a, b) for a, b in pairs.tolist()}
    return [edge for edge in marked if edge not in left_out]
