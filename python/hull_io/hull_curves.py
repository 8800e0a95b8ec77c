# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of a hull file that tells its control curves.

    "curves": [{"name": "...", "shown": true, "edges": [[point, point], ...]}, ...]

Each edge is one of a face, and of one curve.
"""

from dataclasses import dataclass, field

from .hull_data import edge_key, face_edges

KEY = "curves"
_KEYS = ("name", "shown", "edges")


@dataclass
class ControlCurve:
    """A chain of edges, pairs (a, b), a < b; shown: with its comb."""

    name: str
    edges: list = field(default_factory=list)
    shown: bool = True

    def with_images(self, image):
        """Takes the edges on, too, whose points are images {point: point} of its own."""
        own = [edge for edge in self.edges if edge[0] in image and edge[1] in image]
        images = {edge_key(image[a], image[b]) for a, b in own}
        self.edges = sorted({*self.edges, *images})

    def within(self, edges):
        """Leaves out the edges that are not among these."""
        self.edges = [edge for edge in self.edges if edge in edges]


def parsed(check, content, faces, point_count):
    """The list of ControlCurve in the content of a hull file; raises HullFileError."""
    known = {edge_key(a, b) for face in faces for a, b in face_edges(face)}
    seen = set()
    return [
        _curve(check, entry, f"{KEY}[{index}]", point_count, known, seen)
        for index, entry in enumerate(check.list(content.get(KEY, []), KEY))
    ]


def _curve(check, value, where, point_count, known, seen):
    entries = check.object(value, where, _KEYS)
    if "edges" not in entries:
        raise check.error(f"{where}.edges", "it is missing", "add it")
    edges = []
    for place, edge in enumerate(check.list(entries["edges"], f"{where}.edges")):
        at = f"{where}.edges[{place}]"
        for end, point in enumerate(check.list(edge, at, 2)):
            check.index(point, f"{at}[{end}]", point_count, "point")
        if edge_key(*edge) not in known:
            raise check.error(at, f"{edge} is no edge of a face", "take it out")
        if edge_key(*edge) in seen:
            raise check.error(at, "it is named twice", "name it once")
        seen.add(edge_key(*edge))
        edges.append(edge_key(*edge))
    name = check.text(entries.get("name", ""), f"{where}.name")
    return ControlCurve(
        name, sorted(edges), check.flag(entries.get("shown", True), f"{where}.shown")
    )


def entries(data):
    """What a hull file says of a HullData's control curves, by its key; nothing without any."""
    if not data.curves:
        return {}
    return {
        KEY: [
            {
                "name": curve.name,
                "shown": bool(curve.shown),
                "edges": [[int(a), int(b)] for a, b in curve.edges],
            }
            for curve in data.curves
        ]
    }
