# SPDX-License-Identifier: GPL-3.0-or-later
"""The control mesh of a HullGrid: faces between rows and columns, the bar along the contour, flat
ends; its creases, and which line of the outline each border and crease is to go along."""

from dataclasses import dataclass, field

import numpy as np

from .._core import ControlMesh, LimitSurface, tolerances


@dataclass
class GridMesh:
    """numbers (rows, columns + 1): of the control points, -1 where there are none; where the first
    column ends those of one point. row_of: of all points. faces, and between which rows and which
    columns they are, -1 for neither. lines: of edges the names of lines, as line_named() has them.
    partners: of the contour's points those in the middle of a bar."""

    grid: object
    numbers: object
    points: list = field(default_factory=list)
    row_of: list = field(default_factory=list)
    faces: list = field(default_factory=list)
    strips: list = field(default_factory=list)
    lines: dict = field(default_factory=dict)
    creases: set = field(default_factory=set)
    partners: dict = field(default_factory=dict)
    ends: dict = field(default_factory=dict)  # "aft", "forward": the points of the end's plane
    feet: set = field(default_factory=set)  # where a first column ends

    def surface(self, points):
        corners = [corner for face in self.faces for corner in face]
        sizes = [len(face) for face in self.faces]
        return LimitSurface(ControlMesh(points, sizes, corners, sorted(self.creases), []))

    def add_point(self, place, row):
        self.points.append(np.array(place, dtype=float))
        self.row_of.append(row)
        return len(self.points) - 1

    def add_face(self, corners, strip=(-1, -1)):
        """Of corners that may be there twice, one after the other; nothing of less than three."""
        face = [int(a) for a, b in zip(corners, [*corners[1:], corners[0]]) if a != b]
        if len(face) > 2:
            self.faces.append(face)
            self.strips.append(strip)

    def add_line(self, chain, name, is_crease=False):
        for a, b in zip(chain, chain[1:]):
            if a != b:
                edge = (int(min(a, b)), int(max(a, b)))
                self.lines[edge] = name
                if is_crease:
                    self.creases.add(edge)


def line_named(grid, name):
    """The line (n, 3) that edges of the name are to go along."""
    outline = grid.outline
    if isinstance(name, tuple):
        end, part = name
        if end == "row":
            return grid.rows[part].line
        return grid.knuckles[part] if end == "knuckle" else outline.ends[end][part]
    return getattr(outline, name)


def grid_mesh(grid):
    """The GridMesh of a HullGrid whose rows have points."""
    mesh = GridMesh(grid, np.full((len(grid.rows), grid.columns + 1), -1))
    for i, row in enumerate(grid.rows):
        for j in range(row.low, grid.columns + 1):
            mesh.numbers[i, j] = mesh.add_point(row.points[j], i)
    _end_first_columns(mesh)
    for i in range(len(grid.rows) - 1):
        for j in range(grid.rows[i].low, grid.columns):
            aft, forward = mesh.numbers[i], mesh.numbers[i + 1]
            mesh.add_face([aft[j], aft[j + 1], forward[j + 1], forward[j]], (i, j))
    path = _contour_path(mesh)
    has_bar = grid.outline.middle is not None
    mesh.add_line([number for number, _ in path], "contour", has_bar)
    mesh.add_line(mesh.numbers[:, -1], "deck")
    if has_bar:
        _add_bar(mesh, path)
    _add_knuckles(mesh)
    _add_ends(mesh)
    return _without_unused(mesh)


def _end_first_columns(mesh):
    """The corner of the grid is left out, so that its border stays smooth there and the irregular
    point is inside."""
    numbers, rows = mesh.numbers, mesh.grid.rows
    if rows[-1].kind == "stem":
        numbers[-2, 0] = numbers[-1, 1] = numbers[-1, 0]
        mesh.feet.add(int(numbers[-1, 0]))
    first = 0 if rows[0].kind == "post" else mesh.grid.arch_row
    if first is not None:
        numbers[first, 1] = numbers[first + 1, 0] = numbers[first, 0]
        mesh.feet.add(int(numbers[first, 0]))


def _contour_path(mesh):
    """(number, strip after it) of the points along the contour, from aft."""
    numbers, rows, arch = mesh.numbers, mesh.grid.rows, mesh.grid.arch_row
    path, first = [], 0
    if rows[0].kind == "post":
        path += [(numbers[0, j], (-1, j - 1)) for j in range(mesh.grid.columns, 0, -1)]
    elif arch is not None:
        low, first = rows[0].low, arch
        path += [(numbers[i, low], (i, -1)) for i in range(arch)]
        path += [(numbers[arch, j], (-1, j - 1)) for j in range(low, 0, -1)]
    path += [(numbers[i, 0], (i, -1)) for i in range(first, len(rows))]
    if rows[-1].kind == "stem":
        path += [(numbers[-1, j], (-1, j)) for j in range(1, mesh.grid.columns + 1)]
    return [(int(a), strip) for (a, strip), (b, _) in zip(path, [*path[1:], (-1, None)]) if a != b]


def _add_bar(mesh, path):
    for number, _ in path:
        x, y, z = mesh.points[number]
        is_end = abs(y) < tolerances.ON_CENTRE_PLANE * mesh.grid.outline.size
        mesh.partners[number] = (
            number if is_end else mesh.add_point((x, 0.0, z), mesh.row_of[number])
        )
        if number in mesh.feet:
            mesh.feet.add(mesh.partners[number])
    for (a, strip), (b, _) in zip(path, path[1:]):
        mesh.add_face([a, b, mesh.partners[b], mesh.partners[a]], strip)
    mesh.add_line([mesh.partners[number] for number, _ in path], "middle")


def _add_knuckles(mesh):
    rows = mesh.grid.rows
    for number, column in enumerate(mesh.grid.knuckle_columns):
        having = [i for i, row in enumerate(rows) if number in row.knuckles]
        chain = mesh.numbers[having[0] : having[-1] + 1, column]
        mesh.add_line([n for n in chain if n >= 0], ("knuckle", number), True)
    for i, row in enumerate(rows):
        if row.is_knuckle:
            mesh.add_line(mesh.numbers[i], ("row", i), True)


def _add_ends(mesh):
    rows, ends = mesh.grid.rows, mesh.grid.outline.ends
    for name, i, kind in (("aft", 0, "transom"), ("forward", -1, "bow")):
        if rows[i].kind != kind:
            continue
        rim = [int(n) for n in mesh.numbers[i, rows[i].low :]]
        mesh.add_line(rim, name, name in ends)
        mesh.ends[name] = set(rim)
        if name in ends:
            _add_flat_end(mesh, name, rim)


def _add_flat_end(mesh, name, rim):
    """Strips across a flat end within its rim, whose end in the centre plane is a further point."""
    middle, _ = mesh.grid.outline.ends[name]
    if rim[0] in mesh.partners:
        mesh.add_line([mesh.partners[rim[0]], rim[0]], None, True)
        rim = [mesh.partners[rim[0]], *rim]
    top = mesh.add_point(middle[-1], mesh.row_of[rim[0]])
    mesh.add_line([rim[0], top], (name, 0))
    mesh.add_line([rim[-1], top], (name, 1))
    ring = [*rim, top]
    mesh.ends[name] = set(ring)
    turned = -1 if name == "aft" else 1
    low, high = 0, len(ring) - 1
    while high - low >= 5:
        strip = [ring[low], ring[low + 1], ring[high - 1], ring[high]]
        mesh.add_face(strip[::turned])
        low, high = low + 1, high - 1
    mesh.add_face(ring[low : high + 1][::turned])


def _without_unused(mesh):
    """Points of first columns that end before have no faces."""
    used = sorted({corner for face in mesh.faces for corner in face})
    new = np.full(len(mesh.points) + 1, -1)
    new[used] = np.arange(len(used))
    mesh.points = [mesh.points[number] for number in used]
    mesh.row_of = [mesh.row_of[number] for number in used]
    mesh.numbers = new[mesh.numbers]
    mesh.faces = [[int(new[corner]) for corner in face] for face in mesh.faces]

    def renumbered(edge):
        a, b = int(new[edge[0]]), int(new[edge[1]])
        return min(a, b), max(a, b)

    mesh.lines = {renumbered(edge): name for edge, name in mesh.lines.items()}
    mesh.creases = {renumbered(edge) for edge in mesh.creases}
    mesh.partners = {int(new[a]): int(new[b]) for a, b in mesh.partners.items()}
    mesh.ends = {name: {int(new[n]) for n in points} for name, points in mesh.ends.items()}
    mesh.feet = {int(new[n]) for n in mesh.feet}
    return mesh
