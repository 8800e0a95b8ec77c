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
