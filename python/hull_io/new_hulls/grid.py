# SPDX-License-Identifier: GPL-3.0-or-later
"""The port half of a hull as a grid of control points, and the control mesh that it makes."""

from dataclasses import dataclass, field

import numpy as np

from ..hull_data import Flat, HullData, Particulars, edge_key, face_edges, shell_and_transom
from . import splines


@dataclass
class HullGrid:
    """Control points (sections, points, 3): section 0 is furthest aft, point 0 of a section on the
    keel, the last one on the sheer line.

    With a stem the last section is the stem, in the centre plane. Its foot is joined to the keel:
    the corner [-1, 0] of the grid and its neighbours [-2, 0] and [-1, 1] are one control point,
    that at [-2, 0], so that keel and stem are one smooth curve. Section 0 is the rim of a plane
    transom; so is the last one without a stem.

    rake: how far the aft transom leans, x over z. creases: pairs of grid places (section, point) of
    two neighbours.
    """

    points: np.ndarray
    has_stem: bool = True
    rake: float = 0.0
    creases: list = field(default_factory=list)

    @property
    def sheer(self):
        return self.points[:, -1]

    @property
    def centre_lines(self):
        """Chains of control points of keel and stem, from the transom to the stem's head; a chain
        ends where a crease comes in."""
        if not self.has_stem:
            return [self.points[:, 0]]
        last = len(self.points) - 1
        ends = sorted(row for crease in self.creases for i, row in crease if i == last)
        line = np.vstack([self.points[:-1, 0], self.points[-1, 2:]])
        # Point 2 of the stem is the one after the foot.
        cuts = [0, *(last + row - 2 for row in ends), len(line) - 1]
        return [line[first : end + 1] for first, end in zip(cuts, cuts[1:]) if end > first]


def move_foot(points, along, up):
    """Moves the stem's foot, in place, by parts of the way to the next point of the stem: the more,
    the more evenly the keel turns into the stem. The point beside it follows by a third."""
    way = points[-1, 2] - points[-2, 0]
    points[-2, 0] += way * (along, 0.0, up)
    points[-2, 1, 0] += along / 3.0 * way[0]


def fitted(grid, dimensions, widest):
    """The grid with its surface scaled to its dimensions, in place; returns it.

    widest: number of the row of points along the ship, a crease or border, that is the widest
    place of the hull.
    """
    points = grid.points
    keel = min(splines.minimum(line, 2) for line in grid.centre_lines)
    draft = dimensions.draft
    if keel != 0.0:
        points[:, :, 2] = (points[:, :, 2] - keel) * (draft / (draft - keel))
    points[:, -1, 2] += dimensions.depth - splines.minimum(grid.sheer, 2)
    points[:, :, 1] *= 0.5 * dimensions.beam / splines.maximum(points[:, widest], 1)
    points[0, :, 0] = points[0, -1, 0] + grid.rake * (points[0, :, 2] - points[0, -1, 2])
    aft, forward = _waterline_ends(grid, draft)
    points[:, :, 0] = (points[:, :, 0] - aft) * (dimensions.length / (forward - aft))
    grid.rake *= dimensions.length / (forward - aft)
    _snap(points[:, :, 1], (0.0, 0.5 * dimensions.beam))
    _snap(points[:, :, 2], (0.0, dimensions.depth))
    return grid


def _snap(coordinates, values):
    """Takes the rounding off coordinates, in place, that are meant to have one of the values."""
    for value in values:
        coordinates[np.abs(coordinates - value) < 1e-12 * max(values)] = value


def _waterline_ends(grid, draft):
    """x where the water crosses the profile: its keel, stem and transoms."""
    crossings = [x for line in grid.centre_lines for x in splines.crossings(line, 2, draft)[:, 0]]
    for section in (0,) if grid.has_stem else (0, -1):
        low, high = grid.points[section, 0], grid.points[section, -1]
        if low[2] <= draft <= high[2]:
            part = (draft - low[2]) / (high[2] - low[2])
            crossings.append(low[0] + part * (high[0] - low[0]))
    return min(crossings), max(crossings)


def hull_of(grid, dimensions, name, source):
    """The HullData of a grid: points, faces turned outwards, tags, layers, flats."""
    builder = _Builder(grid)
    builder.add_shell()
    builder.add_transom(0)
    if not grid.has_stem:
        builder.add_transom(len(grid.points) - 1)
    return HullData(
        name=name,
        points=builder.used_points(),
        faces=builder.faces,
        creases=sorted(builder.creases),
        half=True,
        layers=shell_and_transom(),
        face_layers=builder.face_layers,
        particulars=Particulars(
            length_pp=dimensions.length,
            beam=dimensions.beam,
            draft=dimensions.draft,
            depth=dimensions.depth,
        ),
        deck_edge=builder.sheer_edges(),
        flats=builder.transoms
        + builder.plane_faces(1, 0.5 * dimensions.beam)
        + builder.plane_faces(2, 0.0),
        source=source,
    )


class _Builder:
    def __init__(self, grid):
        self.grid = grid
        self.sections, self.rows = grid.points.shape[:2]
        self.places = {}
        self.points = []
        self.faces = []
        self.face_layers = []
        self.creases = set()
        self.transoms = []

    def used_points(self):
        return np.array(self.points)

    def index(self, section, row):
        """The point of a grid place; places come into being as they are used."""
        last = self.sections - 1
        if self.grid.has_stem and section == last and row < 2:
            section, row = last - 1, 0
        key = (section, row)
        if key not in self.places:
            self.places[key] = len(self.points)
            self.points.append(self.grid.points[section, row])
        return self.places[key]

    def add_shell(self):
        for i in range(self.sections - 1):
            for j in range(self.rows - 1):
                corners = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)]
                face = list(dict.fromkeys(self.index(*corner) for corner in corners))
                # Three of the foremost lowest face's corners are one point.
                if len(face) > 2:
                    self.faces.append(face)
                    self.face_layers.append(0)
        for a, b in self.grid.creases:
            self.creases.add(edge_key(self.index(*a), self.index(*b)))

    def add_transom(self, section):
        """Faces across the ship from the rim to the centre plane, the rim a crease."""
        rim = [self.index(section, row) for row in range(self.rows)]
        self.creases.update(edge_key(a, b) for a, b in zip(rim, rim[1:]))
        x, _, z = self.points[rim[-1]]
        top = len(self.points)
        self.points.append(np.array([x, 0.0, z]))
        ring = [*rim, top]
        low, high = 0, len(ring) - 1
        first = len(self.faces)
        # Strips across, and one face of four or five corners where the rim turns up.
        while high > low:
            last = high - low < 5
            inner = range(low, high + 1) if last else (low, low + 1, high - 1, high)
            face = [ring[k] for k in inner]
            self.faces.append(face if section else face[::-1])
            self.face_layers.append(1)
            low, high = (high, high) if last else (low + 1, high - 1)
        rake = 0.0 if section else self.grid.rake
        normal = np.array([1.0, 0.0, -rake]) / np.hypot(1.0, rake)
        faces = list(range(first, len(self.faces)))
        self.transoms.append(Flat(faces, tuple(normal.tolist()), float(normal @ self.points[top])))

    def plane_faces(self, axis, position):
        """The faces of the shell in the plane across an axis, as Flats: one or none."""
        faces = [
            index
            for index, face in enumerate(self.faces)
            if not self.face_layers[index]
            and all(self.points[point][axis] == position for point in face)
        ]
        normal = tuple(float(axis == k) for k in range(3))
        return [Flat(faces, normal, position)] if faces else []

    def sheer_edges(self):
        edges = {edge_key(a, b) for face in self.faces for a, b in face_edges(face)}
        row = self.rows - 1
        line = [self.index(section, row) for section in range(self.sections)]
        return [edge for edge in map(edge_key, line, line[1:]) if edge in edges]
