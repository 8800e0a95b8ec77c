# SPDX-License-Identifier: GPL-3.0-or-later
"""The three views of a lines plan put together in space, by its layers: BASE_LINE and CENTRE_LINE
tell where the views are, GRID where stations, waterlines and buttocks; which curve is which follows
from the other views, whose curves it has to meet.

The layers are those of the add-on's own drawings (docs/lines-plan.md).
"""

from dataclasses import replace

import numpy as np

from ..mirror import AT_CENTRE_LINE
from .drawn_views import LAYERS, PER_SPAN, sampled, views_of
from .values import polyline

# Of the length: curves of two views meet where they are no further apart; ends are the same.
_MEETS, _SAME = 4e-5, 1e-5
# Of the length: a line across reaches no further along the ship.
_ACROSS = 0.05
# Of the length: what is no further from the centre plane is drawn as its line, for a hull whose
# size, the diagonal, is no more than a fifth larger.
_AT_CENTRE = 1.2 * AT_CENTRE_LINE


def placed_views(geometry):
    """The Geometry of a lines plan with its curves in space, x forward, y to port, z up; any other
    geometry as it is. What can't be placed is told in left_out."""
    layers = {}
    for curve in geometry.curves:
        if np.ptp(curve.points[:, 2]) == 0.0:
            layers.setdefault(curve.group.upper(), []).append(sampled(curve)[:, :2])
    if geometry.meshes or not all(layers.get(name) for name in LAYERS):
        return geometry
    views = views_of(layers)
    if views is None:
        return geometry
    placer = _Placer(layers, views)
    curves = [curve for curve in placer.curves() if curve is not None]
    if not any(curve.kind == "station" for curve in curves):
        return geometry
    left_out = list(geometry.left_out)
    if placer.lost:
        left_out.append(f"Curves of the lines plan that fit to no other view ({placer.lost}).")
    return replace(
        geometry, curves=tuple(curves), left_out=tuple(left_out),
        is_half=True, on_ship_axes=True,
    )  # fmt: skip


class _Placer:
    def __init__(self, layers, views):
        self.views, self.lost = views, 0
        self.by_view = {}
        for name, curves in layers.items():
            for points in curves:
                view = views.view_of(points)
                self.by_view.setdefault((name, view), []).append(views.in_ship(points, view))
        outline = self._of("OUTLINE", "profile")
        self.length = float(np.ptp(np.concatenate(outline)[:, 0])) if outline else 1.0
        self.reach = _MEETS * self.length
        self.xs = self._grid("profile", 0)
        self.zs = self._grid("profile", 1)

    def _of(self, name, view):
        return self.by_view.get((name, view), [])

    def _grid(self, view, axis):
        """Rising places of straight lines across an axis of a view."""
        found = set()
        for name in ("GRID", "MIDSHIP", "PERPENDICULARS", "DESIGN_WATERLINE", "BASE_LINE"):
            for points in self._of(name, view):
                if len(points) == 2 and points[0, axis] == points[1, axis]:
                    found.add(round(float(points[0, axis]), 6))
        return sorted(found)

    def curves(self):
        contour, edges = self._lines()
        waterlines = self._waterlines(contour, edges)
        stations = self._stations(waterlines, contour, edges)
        for points in contour:
            yield polyline(points, kind="profile", name="profile")
        for kind, points in edges:
            yield polyline(points, kind=kind, name=kind.replace("_", " "))
        for z, points in waterlines:
            yield polyline(points, kind="waterline", name=f"waterline {z:g}")
        for x, points in stations:
            yield polyline(points, kind="station", name=f"station at {x:g}")

    def _lines(self):
        """(lines of the contour, [(kind, line)]) in space: a line of the profile goes with that of
        the plan, or of the body plan, that has the same ends."""
        contour, edges = [], []
        for name, kind in (("OUTLINE", "deck_edge"), ("KNUCKLES", "knuckle")):
            plan, body = self._of(name, "plan"), self._of(name, "body")
            # Of lines with the same ends the upper one is the deck edge, the lowest the contour.
            plan, body = list(plan), list(body)
            drawn = sorted(self._of(name, "profile"), key=lambda line: -line[:, 1].mean())
            for points in drawn:
                line, is_across = self._joined(points, plan, body)
                if line is None and np.ptp(points, axis=0).max() < _SAME * self.length:
                    continue
                if line is None and name == "OUTLINE":
                    contour.append(np.insert(points, 1, 0.0, axis=1))
                elif line is None:
                    self.lost += 1
                elif is_across:
                    edges.append(("border", line))
                else:
                    edges.append((kind, line))
        return contour, edges

    def _joined(self, points, plan, body):
        """(line (n, 3) or None, whether it is across the ship)."""
        same = _SAME * self.length
        if np.ptp(points, axis=0).max() < same:
            return None, True  # seen from its end
        for others, axis in ((body, 1), (plan, 0)):
            for other in others:
                line = self._of_both(points, other, axis)
                if line is not None:
                    self._drop(plan, line[:, :2])
                    self._drop(body, line[:, 1:])
                    return line, self._is_across(line)
        if np.ptp(points[:, 0]) < 1e-2 * self.length:
            # Across the ship the body plan shows it best; x goes with the height.
            for other in body:
                for way in (other, other[::-1]):
                    if np.abs(way[[0, -1], 1] - points[[0, -1], 1]).max() < same:
                        if way[:, 0].max() > same:
                            order = np.argsort(points[:, 1])
                            x = np.interp(way[:, 1], points[order, 1], points[order, 0])
                            return np.column_stack([x, way]), True
            return None, True
        for other in plan:
            for way in (other, other[::-1]):
                if np.abs(way[[0, -1], 0] - points[[0, -1], 0]).max() < same:
                    if way[:, 1].max() > same:
                        order = np.argsort(way[:, 0])
                        y = np.interp(points[:, 0], way[order, 0], way[order, 1])
                        plan[:] = [one for one in plan if one is not other]
                        return np.column_stack([points[:, 0], y, points[:, 1]]), False
        return None, False

    def _drop(self, drawn, line):
        """Takes what has the ends of a line, (n, 2) as the view has it, out of a view's curves."""
        ends, same = line[[0, -1]], _SAME * self.length
        drawn[:] = [
            one
            for one in drawn
            if min(np.abs(one[at] - ends).max() for at in ([0, -1], [-1, 0])) > same
        ]

    def _is_across(self, line):
        along, *others = np.ptp(line, axis=0)
        return along < _ACROSS * self.length and along < 0.5 * max(others)

    def _of_both(self, points, other, axis):
        """The line (n, 3) of two views of a spline, that of the profile and another one, which have
        x (axis 0) or z (1) in common; None where they are not of one."""
        if len(points) != len(other) or len(points) < 2 * PER_SPAN:
            return None
        common = other[:, 1] if axis == 1 else other[:, 0]
        if np.abs(points[:, axis] - common).max() > _SAME * self.length:
            return None
        y = other[:, 0] if axis == 1 else other[:, 1]
        if y.max() < _SAME * self.length or np.ptp(common) < _SAME * self.length:
            return None
        return np.column_stack([points[:, 0], y, points[:, 1]])

    def _waterlines(self, contour, edges):
        """(z, line (n, 3)): each at the level at which its ends are on the lines in space."""
        segments = [*contour, *(line for _, line in edges)]
        found = []
        for name in ("WATERLINES", "DESIGN_WATERLINE"):
            for points in self._of(name, "plan"):
                if len(points) < 3:
                    continue
                ends = points[[0, -1]]
                off = [max(self._from_lines(segments, x, y, z) for x, y in ends) for z in self.zs]
                if np.ptp(points[:, 0]) < self.reach:
                    continue
                if not off or min(off) > self.reach:
                    self.lost += 1
                    continue
                z = self.zs[int(np.argmin(off))]
                found.append((z, np.insert(points, 2, z, axis=1)))
        return found

    def _from_lines(self, lines, x, y, z):
        """m: of a place from the nearest line; keel, stem and stern beside the centre plane, as of
        a bar, are drawn as its own."""
        y = 0.0 if y < _AT_CENTRE * self.length else y
        place, best = np.array([x, y, z]), np.inf
        for line in lines:
            start, way = line[:-1], np.diff(line, axis=0)
            squares = np.maximum((way * way).sum(axis=1), 1e-300)
            share = np.clip(((place - start) * way).sum(axis=1) / squares, 0.0, 1.0)
            off = np.linalg.norm(start + share[:, None] * way - place, axis=1).min()
            best = min(best, float(off))
        return best

    def _stations(self, waterlines, contour, edges):
        """(x, piece (n, 3)): the curves of the body plan that meet all waterlines, and end on lines
        in space, at x."""
        segments = [*contour, *(line for _, line in edges)]
        pieces = []
        for points in self._of("STATIONS", "body"):
            if not any(self._is_same(points, other) for other in pieces):
                pieces.append(points)
        used, found = set(), []
        for x in self.xs:
            at_x = {}
            for z, line in waterlines:
                crossing = _where(line[:, :2], 0, x)
                at_x.setdefault(z, []).extend(crossing)
            off = [self._apart(points, x, at_x, segments) for points in pieces]
            kept = []
            for number in np.argsort(off, kind="stable").tolist():
                points = pieces[number]
                if np.isfinite(off[number]) and not self._is_doubled(points, kept):
                    kept.append(points)
                    used.add(number)
                    found.append((x, np.column_stack([np.full(len(points), x), points])))
        self.lost += len(pieces) - len(used)
        return found

    def _is_same(self, points, other):
        if len(points) != len(other):
            return False
        apart = min(np.abs(points - way).max() for way in (other, other[::-1]))
        return apart < _SAME * self.length

    def _is_doubled(self, points, others):
        """Whether another piece has the same ends, as where stations are nearly the same."""
        same = 1e-3 * self.length
        ends = points[[0, -1]]
        return any(
            np.abs(ends - way).max() < same for o in others for way in (o[[0, -1]], o[[-1, 0]])
        )

    def _apart(self, points, x, at_x, segments):
        """m: how far a piece of the body plan is from waterlines and ends at x; infinite where that
        is beyond the reach."""
        count, most = 0, 0.0
        for z, breadths in at_x.items():
            own = _where(points, 1, z)
            inner = points[:, 1].min() + self.reach < z < points[:, 1].max() - self.reach
            if not (inner and own and breadths):
                continue
            off = min(abs(y - other) for y in own for other in breadths)
            most = max(most, off)
            count += 1
        ends = [self._from_lines(segments, x, y, z) for y, z in points[[0, -1]]]
        most = max(most, min(ends) if count else max(ends))
        return most if most < self.reach else np.inf


def _where(line, axis, place):
    """The other coordinate where a plane line comes through a place of one."""
    off = line[:, axis] - place
    at = np.flatnonzero((off[:-1] <= 0.0) != (off[1:] <= 0.0))
    share = off[at] / (off[at] - off[at + 1])
    other = line[:, 1 - axis]
    return (other[at] + share * (other[at + 1] - other[at])).tolist()
