# SPDX-License-Identifier: GPL-3.0-or-later
"""The tags of a hull's control mesh over the 3D view, while it is edited: see tag_arrays."""

from dataclasses import dataclass

import bmesh
import gpu
import numpy as np
from gpu.types import GPUBatch, GPUVertBuf
from mathutils import Matrix

from ..bridge import blender_versions, selection, tags
from . import tag_arrays
from .view import Handler, hulls_in_view

# sRGB, to be told from light and dark grounds alike, and from the orange of what is selected.
COLOURS = {
    "knuckle": (0.86, 0.08, 0.62),
    "border": (0.00, 0.66, 0.70),
    "deck_edge": (0.48, 0.72, 0.00),
    "corner": (0.86, 0.08, 0.62),
    "automatic_corner": (0.86, 0.08, 0.62),
    "dart": (0.86, 0.08, 0.62),
    "irregular": (0.48, 0.30, 0.95),
    "odd_face": (0.80, 0.58, 0.00),
    "problem": (0.92, 0.06, 0.06),
}
# Of each kind of points: its switch, outline, radius and width of the line in dots at a scale of 1.
_POINTS = {
    "corner": ("show_corners", "square", 6.0, 2.5),
    "automatic_corner": ("show_corners", "square", 5.0, 1.2),
    "dart": ("show_darts", "diamond", 6.0, 2.0),
    "irregular": ("show_irregular", "ring", 9.5, 1.6),
}
_RAIL_DISTANCE, _RAIL_WIDTH = 2.6, 1.8
_DIGIT_HEIGHT, _DIGIT_WIDTH = 11.0, 1.8
_BESIDE, _CENTRED = (11.0, 5.0), (-2.5, -5.0)  # from a place to the lower left of its number
_HALO, _HALO_WIDTH = (1.0, 1.0, 1.0), 1.6  # around what is written, by so much wider
_FILL_ALPHA = 0.22
_BEHIND_ALPHA = 0.30  # of what is behind the surface
_PROBLEM_RADIUS, _PROBLEM_DISTANCE, _PROBLEM_WIDTH = 13.0, 5.5, 2.5
_LAYER = 6  # before lines, and so that the hull's own slope does not cut symbols


@dataclass(frozen=True, eq=False)
class Drawing:
    """fills: (colour, corners (n, 3) of triangles); lines: (colour, width in dots, corners (n, 3)
    of segments), in the order in which they cover one another; corners in the picture."""

    fills: list
    lines: list


def _draw():
    for shown in hulls_in_view():
        if shown.hull.mode == "EDIT" and shown.hull.hull.tags.show:
            _draw_drawing(drawing_of(shown))


def drawing_of(shown):
    """The Drawing of a HullInView in edit mode."""
    settings, state = shown.hull.hull.tags, shown.state
    bm = bmesh.from_edit_mesh(shown.hull.data)
    if state.status:
        points, known = tags.of_broken(shown.hull, shown.context.scene)
    else:
        points, known = state.surface.mesh.points, tags.of_state(state)
    pen = _Pen(shown, points, _seen_points(bm, known))
    if settings.show_odd_faces:
        pen.draw_faces(known.odd_face_vertices, COLOURS["odd_face"])
    for kind, edges in known.edges.items():
        if getattr(settings, f"show_{kind}"):
            pen.draw_edges(edges, COLOURS[kind])
    for kind, (switch, *shape) in _POINTS.items():
        if getattr(settings, switch):
            numbers = known.valences if kind == "irregular" else None
            pen.draw_points(known.points[kind], numbers, COLOURS[kind], *shape)
    if settings.show_problems:
        for problem in state.check.problems:
            pen.draw_problem(bm, problem)
    return pen.drawing


def _seen_points(bm, known):
    """(n,) which control points are not hidden."""
    hidden = np.array([vertex.hide for vertex in bm.verts], dtype=bool)
    return ~hidden[known.vertex_ids]


class _Pen:
    """Collects the Drawing of one hull, of what is not hidden."""

    def __init__(self, shown, points, is_seen):
        self.drawing = Drawing([], [])
        self._points, self._is_seen = points, is_seen
        self._to_clip = shown.context.region_data.window_matrix @ shown.to_view(layer=_LAYER)
        self._clip = tag_arrays.in_clip(points, self._to_clip)
        self._viewport = gpu.state.viewport_get()[2:]
        self._metres_per_unit = shown.metres_per_unit
        self._scale = shown.context.preferences.system.ui_scale

    def draw_edges(self, edges, colour):
        edges = edges[self._is_seen[edges].all(axis=1)]
        found = tag_arrays.segments(self._clip, edges)
        found = tag_arrays.rails(found, _RAIL_DISTANCE * self._scale, self._viewport)
        self._draw_lines(colour, _RAIL_WIDTH, found.reshape(-1, 3))

    def draw_points(self, indices, numbers, colour, outline, radius, width):
        """With `numbers`, one beside each point."""
        at, is_shown = tag_arrays.places(self._clip[indices])
        is_shown &= self._is_seen[indices]
        at = at[is_shown]
        corners = tag_arrays.outlines(outline, at, radius * self._scale, self._viewport)
        self._draw_with_halo(colour, width, corners)
        if numbers is not None:
            self._write(numbers[is_shown], at, _BESIDE, colour)

    def draw_faces(self, faces, colour):
        """With its number of corners in each of `faces`, arrays of points."""
        faces = [face for face in faces if self._is_seen[face].all()]
        corners = self._clip[tag_arrays.fan_triangles(faces).reshape(-1)]
        found, _ = tag_arrays.places(corners)
        is_before = (corners[:, 3] > 0.0).reshape(-1, 3).all(axis=1)
        self.drawing.fills.append((colour, found[np.repeat(is_before, 3)]))
        middles = tag_arrays.middles(self._points, faces)
        at, is_shown = tag_arrays.places(tag_arrays.in_clip(middles, self._to_clip))
        counts = np.array([len(face) for face in faces])
        self._write(counts[is_shown], at[is_shown], _CENTRED, colour)

    def draw_problem(self, bm, problem):
        """Of a mesh_check.Problem; not the faces of mere warnings, which may be all there are."""
        if problem.kind == "mesh" or (problem.kind == "face" and problem.severity == "warning"):
            return
        elements = [e for e in selection.found(bm, problem.kind, problem.elements) if not e.hide]
        colour, scale = COLOURS["problem"], self._scale
        if problem.kind == "vertex":
            at, is_shown = tag_arrays.places(self._clip_of(elements))
            corners = tag_arrays.outlines(
                "ring", at[is_shown], _PROBLEM_RADIUS * scale, self._viewport
            )
            self._draw_with_halo(colour, _PROBLEM_WIDTH, corners)
            return
        edges = elements
        if problem.kind == "face":
            edges = [edge for face in elements for edge in face.edges]
        clip = self._clip_of([vertex for edge in edges for vertex in edge.verts])
        found = tag_arrays.segments(clip, np.arange(len(clip)))
        found = tag_arrays.rails(found, _PROBLEM_DISTANCE * scale, self._viewport)
        self._draw_lines(colour, _PROBLEM_WIDTH, found.reshape(-1, 3))

    def _clip_of(self, vertices):
        points = np.array([vertex.co for vertex in vertices]).reshape(-1, 3)
        return tag_arrays.in_clip(points * self._metres_per_unit, self._to_clip)

    def _write(self, numbers, at, shift, colour):
        height, shift = _DIGIT_HEIGHT * self._scale, np.array(shift) * self._scale
        corners = tag_arrays.numbers(numbers, at, height, shift, self._viewport)
        self._draw_with_halo(colour, _DIGIT_WIDTH, corners)

    def _draw_with_halo(self, colour, width, corners):
        self._draw_lines(_HALO, width + _HALO_WIDTH, corners)
        self._draw_lines(colour, width, corners)

    def _draw_lines(self, colour, width, corners):
        if len(corners):
            self.drawing.lines.append((colour, width * self._scale, corners))


def _draw_drawing(drawing):
    gpu.state.blend_set("ALPHA")
    is_depth_kept = gpu.state.depth_mask_get()
    gpu.state.depth_mask_set(False)
    with gpu.matrix.push_pop(), gpu.matrix.push_pop_projection():
        gpu.matrix.load_matrix(Matrix.Identity(4))
        gpu.matrix.load_projection_matrix(Matrix.Identity(4))
        for depth_test, alpha in (("GREATER", _BEHIND_ALPHA), ("LESS_EQUAL", 1.0)):
            gpu.state.depth_test_set(depth_test)
            for colour, corners in drawing.fills:
                _batch("UNIFORM_COLOR", "TRIS", corners, (*colour, alpha * _FILL_ALPHA))
            for colour, width, corners in drawing.lines:
                _batch("POLYLINE_UNIFORM_COLOR", "LINES", corners, (*colour, alpha), width)
    gpu.state.depth_mask_set(is_depth_kept)
    gpu.state.depth_test_set("NONE")
    gpu.state.blend_set("NONE")


def _batch(shader_name, form, corners, colour, width=None):
    shader = blender_versions.builtin_shader(shader_name)
    points = GPUVertBuf(shader.format_calc(), len(corners))
    points.attr_fill("pos", corners.astype(np.float32))
    shader.bind()
    shader.uniform_float("color", colour)
    if width is not None:
        shader.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
        shader.uniform_float("lineWidth", width)
    GPUBatch(type=form, buf=points).draw(shader)


_handler = Handler(_draw, "POST_VIEW")
register, unregister = _handler.register, _handler.unregister
