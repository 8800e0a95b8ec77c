# SPDX-License-Identifier: GPL-3.0-or-later
"""Which control points make a section's bilge, and the circle between its flats; arrays only.

Indices are those of the control mesh; places in a section are (y, z).
"""

from dataclasses import dataclass

import numpy as np

# Of the section's size: points nearer to a line than this lie in the flat.
_IN_FLAT = 1e-4
# Points between the borders of the flats.
_FEWEST_BETWEEN, _MOST_BETWEEN = 3, 8


class BilgeError(ValueError):
    """The selection is no section with a bilge."""


@dataclass(frozen=True)
class End:
    """The border of a flat: whether it is a crease; the next point of the flat beyond it; where
    that may be moved to keep a smooth border, the point after it, else None. None: the rim."""

    is_crease: bool
    outer: object
    further: object

    @property
    def is_moved(self):
        return self.further is not None


@dataclass(frozen=True, eq=False)
class BilgeSection:
    """row: control points from border to border, from below upwards; its Ends."""

    row: list
    bottom: End
    side: End


def beyond(border, following):
    """(1, 2) where the point beyond a smooth border is to be, for the section to be as at a
    crease."""
    return (2.0 * border - following)[None]


def in_plane(points):
    return np.asarray(points)[:, 1:]


def sections_of(points, mesh, selected):
    """The BilgeSections of the selected points (k,), from aft forward.

    mesh: hull_native.ControlMesh. BilgeError where they are none.
    """
    graph, crossed = _across(points, mesh), _crossed(points, mesh)
    return [_trimmed(row, points, graph, crossed) for row in _rows(points, graph, selected)]


def _rows(points, graph, selected):
    """The selected points as rows across the ship, from aft forward, each from below upwards."""
    chosen = set(selected.tolist())
    beside = {p: [q for q in graph[p] if q in chosen] for p in chosen}
    rows = []
    while beside:
        part = _component(beside, next(iter(beside)))
        ends = [p for p in part if len(beside[p]) == 1]
        if len(part) < 5 or len(ends) != 2 or any(len(beside[p]) > 2 for p in part):
            raise BilgeError(
                "Select whole rows of points across the ship, from the border of the flat bottom "
                "to that of the flat side, both with them: five to ten points"
            )
        first = min(ends, key=lambda p: (points[p, 2], abs(points[p, 1])))
        rows.append(_walk(beside, first))
        for p in part:
            del beside[p]
    if not rows:
        raise BilgeError("Select the points of a section from flat bottom to flat side first")
    return sorted(rows, key=lambda row: points[row[0], 0])


def _across(points, mesh):
    """{point: points} that edges join across the ship rather than along it."""
    graph = {p: [] for p in range(len(points))}
    for a, b in _edges_of(mesh):
        if _is_across(points[b] - points[a]):
            graph[a].append(b)
            graph[b].append(a)
    return graph


def _is_across(way):
    return abs(way[0]) < np.hypot(way[1], way[2])


def _crossed(points, mesh):
    """(n,) whether a crease or border runs along the ship through a point."""
    crossed = np.zeros(len(points), dtype=bool)
    for a, b in mesh.creases.tolist():
        if not _is_across(points[b] - points[a]):
            crossed[[a, b]] = True
    return crossed


def _edges_of(mesh):
    """The edges of a control mesh as pairs, each once."""
    edges, start = set(), 0
    vertices = mesh.face_vertices.tolist()
    for size in mesh.face_sizes.tolist():
        loop = vertices[start : start + size]
        edges.update((min(a, b), max(a, b)) for a, b in zip(loop, loop[1:] + loop[:1]))
        start += size
    return sorted(edges)


def _component(beside, first):
    found, waiting = [], [first]
    while waiting:
        p = waiting.pop()
        if p not in found:
            found.append(p)
            waiting.extend(beside[p])
    return found


def _walk(beside, first):
    row, last = [first], None
    while True:
        following = [q for q in beside[row[-1]] if q != last]
        if not following:
            return row
        last = row[-1]
        row.append(following[0])


def _trimmed(row, points, graph, crossed):
    """The BilgeSection of a row that may go on in the flats."""
    row, bottom = _trim_end(row, points, graph, crossed)
    _refuse_few(row, points)
    back, side = _trim_end(row[::-1], points, graph, crossed)
    row = back[::-1]
    _refuse_few(row, points)
    if crossed[row[1:-1]].any():
        raise BilgeError(
            "A crease runs through the points of the bilge: make it smooth, or select from there"
        )
    if len(row) - 2 > _MOST_BETWEEN:
        raise _odd_count(len(row) - 2, points[row[0], 0])
    return BilgeSection(row, bottom, side)


def _refuse_few(row, points):
    """A flat may reach so far that too few points, even one alone, are left of a row."""
    if len(row) - 2 < _FEWEST_BETWEEN:
        raise _odd_count(max(len(row) - 2, 0), points[row[0], 0])


def _odd_count(count, x):
    return BilgeError(
        f"There {'is 1 point' if count == 1 else f'are {count} points'} between the borders of "
        f"the flats at x = {x:.2f} m: a bilge takes three to eight, best four to six"
    )


def _trim_end(row, points, graph, crossed):
    """(row, End) where the flat ends that the row begins in."""
    places, outer = in_plane(points), _beyond(row, points, graph)
    if outer is None:
        # It begins at the rim of the mesh: up to where it turns it is flat.
        run = _straight_run(places[row])
        creases = [k for k in range(1, run) if crossed[row[k]]]
        start = creases[-1] if creases else run - 2
        if start < 1:
            raise BilgeError(
                "A row begins at the rim and is not flat there: select from the border of the "
                "flat on, with two points in it at least"
            )
        row, outer = row[start:], row[start - 1]
    is_crease, further = bool(crossed[row[0]]), None
    if not is_crease:
        further = _beyond([outer, row[0]], points, graph)
        if further is not None:
            is_free = not crossed[outer] and _on_a_line(places[[further, outer, row[0]]])
            further = further if is_free else None
    return row, End(is_crease, outer, further)


def _beyond(row, points, graph):
    """The point that continues a row backwards, as straight as there is one; None at the rim."""
    others = [q for q in graph[row[0]] if q != row[1]]
    if not others:
        return None
    way = points[row[0]] - points[row[1]]
    return max(others, key=lambda q: _cosine(points[q] - points[row[0]], way))


def _cosine(a, b):
    return a @ b / max(np.linalg.norm(a) * np.linalg.norm(b), 1e-300)


def _straight_run(places):
    """How many places from the first on lie on the line of the first two."""
    for count in range(3, len(places) + 1):
        if not _on_a_line(places[:count]):
            return count - 1
    return len(places)


def _on_a_line(places):
    way = places[-1] - places[0]
    size = np.abs(places - places[0]).max()
    away = (places - places[0]) @ np.array([-way[1], way[0]]) / max(np.linalg.norm(way), 1e-300)
    return np.abs(away).max() <= _IN_FLAT * size


class Corner:
    """The circle of a radius between two flats, in a section's plane. angle: between the flats'
    directions, radians."""

    def __init__(self, radius, angle, centre, along, outwards):
        self.radius, self.angle, self._centre = radius, angle, centre
        self._frame = np.array([along, -outwards])  # rows: along the bottom, inwards

    def places(self, unit):
        """(k, 2) of (k, 2) that are for the circle of radius 1 around the origin."""
        return self._centre + self.radius * np.asarray(unit) @ self._frame

    def _to_unit(self, places):
        return (places - self._centre) @ self._frame.T / self.radius

    def _flat(self, k):
        """(point where the circle touches flat k, the way out of the bilge in it), for radius 1."""
        if k == 0:
            return np.array([0.0, -1.0]), np.array([-1.0, 0.0])
        c, s = np.cos(self.angle), np.sin(self.angle)
        return np.array([s, -c]), np.array([c, s])

    def outer_distance(self, k, point):
        """How far beyond the circle a point (3,) of flat 0 (bottom) or 1 (side) is, in radii."""
        touch, out = self._flat(k)
        return float((self._to_unit(point[1:]) - touch) @ out)

    def refuse_beyond_flats(self, section, points, arc):
        """BilgeError when points come to lie beyond the next points of the flats."""
        for k, end in enumerate((section.bottom, section.side)):
            last = (arc[0], arc[1]) if k == 0 else (arc[-1], arc[-2])
            last = beyond(*last)[0] if end.is_moved else last[0]
            limit = end.further if end.is_moved else end.outer
            touch, out = self._flat(k)
            if limit is not None and (last - touch) @ out >= self.outer_distance(k, points[limit]):
                raise BilgeError(
                    f"The radius is too large: the flat {('bottom', 'side')[k]} would end beyond "
                    "its next control point"
                )

    def deviation(self, places):
        """The largest distance from the circle of the places (k, 2) on a section between the flats,
        in m; None when none is near it."""
        unit = self._to_unit(places)
        turn = np.arctan2(unit[:, 0], -unit[:, 1])
        off = np.abs(np.hypot(*unit.T) - 1.0)
        near = (turn >= 0.0) & (turn <= self.angle) & (off < 0.5)
        return float(off[near].max() * self.radius) if near.any() else None


def corner_of(section, points, radius):
    """The Corner of a BilgeSection. BilgeError where its flats do not meet, or meet too flatly."""
    low, _, along, up = _flats(section, points)
    angle, turn = _angle(along, up)
    t = _to_meeting(section, points)[0]
    touch = low + along * (t - radius * np.tan(0.5 * angle))
    inwards = np.sign(turn) * np.array([-along[1], along[0]])
    return Corner(radius, angle, touch + radius * inwards, along, -inwards)


def present_radius(section, points):
    """The radius of the largest circle that touches the flats between the borders as they are."""
    _, _, along, up = _flats(section, points)
    return min(_to_meeting(section, points)) / np.tan(0.5 * _angle(along, up)[0])


def _flats(section, points):
    """(border of the bottom, border of the side, direction of the bottom, of the side)."""
    places = in_plane(points)
    low, high = places[section.row[0]], places[section.row[-1]]
    along = _way(places, section.bottom.outer, section.row[0])
    up = _way(places, section.row[-1], section.side.outer)
    if along is None:
        along = np.array([np.sign(high[0] - low[0]) or 1.0, 0.0])
    return low, high, along, np.array([0.0, 1.0]) if up is None else up


def _angle(along, up):
    """(radians that the side is turned from the bottom, positive; the signed sine)."""
    turn = along[0] * up[1] - along[1] * up[0]
    angle = float(np.arctan2(abs(turn), along @ up))
    if not np.radians(10.0) <= angle <= np.radians(170.0):
        raise BilgeError(
            f"The flats beside the bilge are turned by {np.degrees(angle):.1f}° only: there must "
            "be a flat bottom and a flat side, 10° to 170° apart"
        )
    return angle, turn


def _to_meeting(section, points):
    """Distances along the bottom and the side from their borders to where the flats meet."""
    low, high, along, up = _flats(section, points)
    _, turn = _angle(along, up)
    way = high - low
    return (way[0] * up[1] - way[1] * up[0]) / turn, (along[0] * way[1] - along[1] * way[0]) / turn


def _way(places, start, end):
    """The direction from one point to another; None without one of them."""
    if start is None or end is None:
        return None
    way = places[end] - places[start]
    length = np.linalg.norm(way)
    return way / length if length > 0.0 else None
