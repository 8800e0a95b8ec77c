# SPDX-License-Identifier: GPL-3.0-or-later
"""Control curves of FREE!ship's files, lists of points along edges: a hull's shown rows."""

from collections import Counter, namedtuple

from .cleanup import creases_of_faces
from .control_rows import RowNet
from .freeship_points import CORNER, point_kinds
from .hull_data import edge_key

_Net = namedtuple("_Net", "face_sizes face_vertices creases corners")


def row_edges(curves, faces, notes):
    """The edges of control curves, pairs as HullData.shown_rows; parts of curves that lie along no
    edge of a face are left out, and noted."""
    edges = {edge_key(a, b) for curve in curves for a, b in zip(curve, curve[1:]) if a != b}
    found = creases_of_faces(edges, faces)
    if len(found) < len(edges):
        count = len(edges) - len(found)
        notes.append(f"Left out of control curves, since no face has such an edge: {count} parts.")
    return found


def control_curves(data):
    """Lists of points for the rows of a HullData that are shown and for its control curves, that of
    a closed one with its first point again at its end. Each edge is in one. A row goes on straight,
    and where only two end at a point that is no corner they are one."""
    sizes = [len(face) for face in data.faces]
    vertices = [point for face in data.faces for point in face]
    net = RowNet(_Net(sizes, vertices, data.creases, data.corners))
    open_ones, closed = [], []
    edges = {*data.shown_rows, *(edge for curve in data.curves for edge in curve.edges)}
    for row in net.rows_of(edges, are_whole=False):
        points = row.points.tolist()
        if row.is_closed:
            closed.append(points + points[:1])
        else:
            open_ones.append(points)
    corners = {point for point, kind in enumerate(point_kinds(data)) if kind == CORNER}
    return sorted(closed + _joined(open_ones, corners))


def _joined(lines, corners):
    """Lists of points, those joined that end at one point, none of `corners`, where no other
    does."""
    counts = Counter(end for line in lines for end in (line[0], line[-1]))
    ends = {point for point, count in counts.items() if count == 2} - corners
    left, made = list(lines), []
    while left:
        line = left.pop()
        for _ in range(2):
            line = line[::-1]
            while (other := _going_on(line, left, ends)) is not None:
                left.remove(other)
                line = line + (other if other[0] == line[-1] else other[::-1])[1:]
        made.append(line)
    return made


def _going_on(line, others, ends):
    end = line[-1]
    if end not in ends or line[0] == end:
        return None
    return next((other for other in others if end in (other[0], other[-1])), None)
