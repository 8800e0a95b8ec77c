# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn of the tags of a hull's control mesh, in the picture: see tag_arrays."""

from dataclasses import dataclass, field

import bmesh
import numpy as np
from mathutils import Vector

from ..bridge.blender import preferences
from ..bridge.mesh import mesh_check, selection
from ..features.hull import tags
from ..features.modelling import developable_making
from . import label_places, tag_arrays

# Of each kind of points: its switch, colour, outline, and radius and width of the outline in dots
# at a scale of 1 for marks of the usual size.
_POINTS = {
    "corner": ("show_corners", "corner", "square", 6.0, 2.5),
    "automatic_corner": ("show_corners", "corner", "square", 5.0, 1.2),
    "dart": ("show_darts", "corner", "diamond", 6.0, 2.0),
    "irregular": ("show_irregular", "irregular", "ring", 9.5, 1.6),
}
_LOCKED = ("pins", 10.5, 2.2)
# Of points kept in planes across x, y and z.
_KEPT = (("station", 8.0, 2.2), ("buttock", 8.0, 2.2), ("waterline", 8.0, 2.2))
_TIED = ("diamond", 8.0, 2.2)
_PROBLEM = ("ring", 13.0, 2.5)
_DIGIT_HEIGHT, _DIGIT_WIDTH = 14.0, 1.7
_GAP = 3.0  # in dots at a scale of 1, at least between numbers, for their strokes and halo
_BESIDE, _CENTRED = (11.0, 5.0), (-3.5, -7.0)  # from a place to the lower left of its number
_USUAL_MARK = 5.0
# Marks are smaller where points are nearer to one another in the picture than so many dots, numbers
# are left out where marks are smaller than a part of what they are elsewhere.
_ROOM, _SMALLEST, _LEGIBLE = 26.0, 0.5, 0.7
# Of tagged edges, and farther out of those with problems and of the rim of what is kept flat.
_RAIL_DISTANCE, _RAIL_WIDTH, _USUAL_WIDTH = 2.6, 1.8, 3.0
_OUTER, _FINE = 2.0, 0.6  # times the distance, times the width
_WITHIN = 1.0005  # of what rulings' warp may be: it is known to rounding
_HALO, _HALO_WIDTH = (1.0, 1.0, 1.0), 1.6  # around marks and numbers, wider by so much


@dataclass(frozen=True, eq=False)
class Picture:
    """What draws: to_clip, a 4 × 4 matrix from the hull's metres to what the graphics card clips
    by; viewport (width, height) in dots; scale of the interface; metres_per_unit of the scene."""

    to_clip: object
    viewport: tuple
    scale: float
    metres_per_unit: float


@dataclass(frozen=True, eq=False)
class Drawing:
    """fills: (colour, corners (n, 3) of triangles); lines: (colour, width in dots, corners (n, 3)
    of segments), in the order in which they cover one another; corners in the picture."""

    fills: list = field(default_factory=list)
    lines: list = field(default_factory=list)


def drawing_of(hull, state, scene, picture):
    """The Drawing of a hull in edit mode with its HullState."""
    settings, colours = hull.hull.tags, preferences.colours("tags")
    bm = bmesh.from_edit_mesh(hull.data)
    known = None if state.status else tags.of_state(state)
    if known is None or known.vertex_ids[-1] >= len(bm.verts):
        points, known = tags.of_broken(hull, scene)
    else:
        points = state.ship.surface.mesh.points
    pen = _Pen(picture, points, _seen_points(bm, known))
    if settings.show_flats:
        for faces in tags.flat_faces(hull, known):
            pen.draw_flat(faces, colours["flat"])
    if settings.show_developables:
        for each in developable_making.warps(hull, state):
            most = _WITHIN * each.region.warp / picture.metres_per_unit
            over = each.warps > most
            pen.draw_rulings(each.rulings[~over], colours["flat"])
            pen.draw_rulings(each.rulings[over], colours["problem"])
    if settings.show_odd_faces:
        pen.draw_odd_faces(known.odd_face_vertices, colours["odd_face"])
    for kind, edges in known.edges.items():
        if not getattr(settings, f"show_{kind}"):
            continue
        if kind == "border" and hull.hull.half:
            is_inner = mesh_check.on_centre_plane(points)[edges].all(axis=1)
            pen.draw_edges(edges[is_inner], colours[kind], width=_FINE)
            edges = edges[~is_inner]
        pen.draw_edges(edges, colours[kind])
    for kind, (switch, colour, *shape) in _POINTS.items():
        if getattr(settings, switch):
            pen.draw_points(known.points[kind], colours[colour], *shape)
    if settings.show_irregular:
        pen.write_beside(known.points["irregular"], known.valences, colours["irregular"])
    if settings.show_locked:
        locked = tags.locked_points(hull, known)
        pen.draw_points(locked, colours["locked"], *_LOCKED)
    if settings.show_kept:
        for kept, shape in zip(tags.kept_points_of(hull, known), _KEPT):
            pen.draw_points(kept, colours["kept"], *shape)
        tied = tags.tied_points_of(hull, known)
        pen.draw_edges(tied, colours["kept"], width=_FINE)
        pen.draw_points(np.unique(tied[:, 0]), colours["kept"], *_TIED)
    if settings.show_problems:
        for problem in state.ship.check.problems:
            pen.draw_problem(bm, problem, colours["problem"])
    pen.write_numbers()
    return pen.drawing


def _seen_points(bm, known):
    """(n,) which control points are not hidden."""
    hidden = np.array([vertex.hide for vertex in bm.verts], dtype=bool)
    return ~hidden[known.vertex_ids]


def _middle(element):
    """Of an edge or face of a BMesh."""
    return sum((vertex.co for vertex in element.verts), Vector()) / len(element.verts)


class _Pen:
    """Collects the Drawing of one hull, of what is not hidden."""

    def __init__(self, picture, points, is_seen):
        self.drawing = Drawing()
        self._picture, self._points, self._is_seen = picture, points, is_seen
        self._labels = []  # (numbers, at, shift, colour) of numbers that are not written yet
        self._taken = [np.empty((0, 4))]  # boxes of points' marks, which no number covers
        self._clip = tag_arrays.in_clip(points, picture.to_clip)
        room = tag_arrays.spacing(self._clip, picture.viewport) / (_ROOM * picture.scale)
        self._crowding = min(max(room, _SMALLEST), 1.0)
        usual = picture.scale * preferences.value("mark_size") / _USUAL_MARK
        self._mark = self._crowding * usual
        self._rail = picture.scale * preferences.value("tag_width") / _USUAL_WIDTH

    def draw_edges(self, edges, colour, *, outwards=1.0, width=1.0):
        edges = edges[self._is_seen[edges].all(axis=1)]
        self._draw_rails(tag_arrays.segments(self._clip, edges), colour, outwards, width)

    def draw_points(self, indices, colour, outline, radius, width):
        at, is_shown = self._places(indices)
        self._draw_outlines(at[is_shown], colour, outline, radius, width)
        middles = tag_arrays.in_dots(at[is_shown], self._picture.viewport)
        reach = radius * self._mark
        self._taken.append(np.hstack([middles - reach, middles + reach]))

    def write_beside(self, indices, numbers, colour):
        at, is_shown = self._places(indices)
        self._labels.append((numbers[is_shown], at[is_shown], _BESIDE, colour))

    def draw_odd_faces(self, faces, colour):
        """Faces, arrays of points, with the number of their corners in each."""
        faces = self._fill(faces, colour)
        middles = tag_arrays.middles(self._points, faces)
        at, is_shown = tag_arrays.places(tag_arrays.in_clip(middles, self._picture.to_clip))
        counts = np.array([len(face) for face in faces], dtype=np.int32)
        self._labels.append((counts[is_shown], at[is_shown], _CENTRED, colour))

    def draw_flat(self, faces, colour):
        """Faces, arrays of points, with the rim of all of them."""
        faces = self._fill(faces, colour)
        self.draw_edges(tag_arrays.rim(faces), colour, outwards=_OUTER, width=_FINE)

    def draw_rulings(self, rulings, colour):
        """Segments (k, 2, 3), m."""
        clip = tag_arrays.in_clip(rulings.reshape(-1, 3), self._picture.to_clip)
        ends = np.arange(2 * len(rulings)).reshape(-1, 2)
        places = tag_arrays.segments(clip, ends)
        self._draw_lines(colour, _FINE * _RAIL_WIDTH * self._rail, places.reshape(-1, 3))

    def draw_problem(self, bm, problem, colour):
        """Of a mesh_check.Problem; not the faces of mere warnings, which may be all there are."""
        if problem.kind == "mesh" or (problem.kind == "face" and problem.severity == "warning"):
            return
        found = selection.found(bm, problem.kind, problem.elements)
        elements = [element for element in found if not element.hide]
        if problem.kind == "vertex":
            rings = self._clip_of([vertex.co for vertex in elements])
        else:
            edges = elements if problem.kind == "edge" else [e for f in elements for e in f.edges]
            clip = self._clip_of([vertex.co for edge in edges for vertex in edge.verts])
            segments = tag_arrays.segments(clip, np.arange(len(clip)))
            self._draw_rails(segments, colour, _OUTER)
            rings = self._clip_of([_middle(element) for element in elements])
        at, is_shown = tag_arrays.places(rings)
        self._draw_outlines(at[is_shown], colour, *_PROBLEM)

    def write_numbers(self):
        """Those noted so far that cover no mark; of those that would cover one another the
        nearest."""
        if not self._labels or self._crowding < _LEGIBLE:
            return
        height, gap = _DIGIT_HEIGHT * self._mark, _GAP * self._picture.scale
        corners, sizes, depths = [], [], []
        for numbers, at, shift, _ in self._labels:
            places = tag_arrays.in_dots(at, self._picture.viewport)
            corners.append(places + np.array(shift) * self._mark)
            sizes.append(tag_arrays.number_sizes(numbers, height) + gap)
            depths.append(at[:, 2])
        is_written = label_places.written(
            *map(np.concatenate, (corners, sizes, depths, self._taken))
        )
        ends = np.cumsum([len(at) for _, at, _, _ in self._labels])
        for (numbers, at, shift, colour), kept in zip(
            self._labels, np.split(is_written, ends[:-1])
        ):
            self._write(numbers[kept], at[kept], np.array(shift) * self._mark, colour)

    def _write(self, numbers, at, shift, colour):
        height = _DIGIT_HEIGHT * self._mark
        corners = tag_arrays.numbers(numbers, at, height, shift, self._picture.viewport)
        self._draw_with_halo(colour, _DIGIT_WIDTH * self._mark, corners)

    def _places(self, indices):
        at, is_shown = tag_arrays.places(self._clip[indices])
        return at, is_shown & self._is_seen[indices]

    def _clip_of(self, places):
        points = np.array(places).reshape(-1, 3)
        return tag_arrays.in_clip(points * self._picture.metres_per_unit, self._picture.to_clip)

    def _fill(self, faces, colour):
        """Fills the faces that are not hidden; returns them."""
        faces = [face for face in faces if self._is_seen[face].all()]
        corners = self._clip[tag_arrays.fan_triangles(faces).reshape(-1)]
        at, _ = tag_arrays.places(corners)
        is_before = (corners[:, 3] > 0.0).reshape(-1, 3).all(axis=1)
        if is_before.any():
            self.drawing.fills.append((colour, at[np.repeat(is_before, 3)]))
        return faces

    def _draw_rails(self, segments, colour, outwards=1.0, width=1.0):
        distance = outwards * _RAIL_DISTANCE * self._rail
        corners = tag_arrays.rails(segments, distance, self._picture.viewport).reshape(-1, 3)
        self._draw_lines(colour, width * _RAIL_WIDTH * self._rail, corners)

    def _draw_outlines(self, at, colour, outline, radius, width):
        corners = tag_arrays.outlines(outline, at, radius * self._mark, self._picture.viewport)
        self._draw_with_halo(colour, width * self._mark, corners)

    def _draw_with_halo(self, colour, width, corners):
        self._draw_lines(_HALO, width + _HALO_WIDTH * self._picture.scale, corners)
        self._draw_lines(colour, width, corners)

    def _draw_lines(self, colour, width, corners):
        if len(corners):
            self.drawing.lines.append((colour, width, corners))
