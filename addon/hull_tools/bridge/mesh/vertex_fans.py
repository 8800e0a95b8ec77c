# SPDX-License-Identifier: GPL-3.0-or-later
"""The faces around a point of a BMesh, in order, parted by creases: how irregular the point is.

Regular is a smooth point or a dart with four faces, one on a crease or border with two to each
side, and a corner with one between any two creases (docs/conventions.md).
"""

from dataclasses import dataclass

from ..blender import blender_versions


@dataclass(frozen=True, eq=False)
class Fan:
    """spokes: the BMEdges of a point, counter-clockwise as seen from the water; faces: the BMFace
    that follows each. An open fan, of a border, has a spoke more than faces. creases: the
    places of the spokes that are creases or borders. is_corner: whether the point is tagged so."""

    vertex: object
    spokes: list
    faces: list
    creases: tuple
    is_corner: bool

    @property
    def is_open(self):
        return len(self.spokes) > len(self.faces)

    @property
    def regular_size(self):
        """How many faces a sector of a regular point like this has."""
        if len(self.creases) < 2:
            return 4
        is_end = self.is_open and len(self.faces) == 1
        return 1 if self.is_corner or is_end or len(self.creases) > 2 else 2

    def sectors(self):
        """The places of the spokes of each sector, with those at both of its ends; of a point
        without creases those of all around, the first one again at the end."""
        count = len(self.spokes)
        if not self.creases:
            return [[*range(count), 0]]
        cuts = list(self.creases)
        if self.is_open:
            return [list(range(a, b + 1)) for a, b in zip(cuts, cuts[1:])]
        ends = [*cuts[1:], cuts[0] + count]
        return [[k % count for k in range(a, b + 1)] for a, b in zip(cuts, ends)]

    def inner(self, sector):
        """The places of a sector's spokes that are no creases."""
        return sector[1:-1] if self.creases else sector[:-1]

    def has_too_many(self):
        """Whether a sector has more faces than a regular point's."""
        return any(len(sector) - 1 > self.regular_size for sector in self.sectors())

    def sector_size(self, spoke):
        """How many faces the sector has that a spoke, not a crease, lies within."""
        place = self.spokes.index(spoke)
        return next(len(sector) - 1 for sector in self.sectors() if place in self.inner(sector))


def fan(bm, vertex):
    """The Fan of a BMVert; ValueError where the faces around it are no surface."""
    edge_layer, vertex_layer = blender_versions.find_crease_layers(bm)
    loops = list(vertex.link_loops)
    if not loops:
        raise ValueError(f"Point {vertex.index} has no face")
    first = next((loop for loop in loops if loop.edge.is_boundary), loops[0])
    spokes, faces, loop = [], [], first
    while loop is not None:
        spokes.append(loop.edge)
        faces.append(loop.face)
        if len(faces) > len(loops):
            break
        last = loop.link_loop_prev.edge
        loop = _next_loop(last, loop.face, vertex)
        if loop is first:
            break
    else:
        spokes.append(last)
    if len(faces) != len(loops):
        raise ValueError(
            f"The faces at point {vertex.index} are no surface turned one way: see Mesh Check"
        )
    is_crease = [
        edge.is_boundary or bool(edge_layer is not None and edge[edge_layer] >= 1.0)
        for edge in spokes
    ]
    return Fan(
        vertex,
        spokes,
        faces,
        tuple(place for place, crease in enumerate(is_crease) if crease),
        bool(vertex_layer is not None and vertex[vertex_layer] >= 1.0),
    )


def _next_loop(edge, face, vertex):
    """The loop that begins at the vertex along the edge in the face across it; None at a border."""
    for loop in edge.link_loops:
        if loop.face is not face and loop.vert is vertex:
            return loop
    return None
