# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull's control mesh in perspective, from ahead and from astern, below: creases bold, what is
hidden faded, irregular points marked."""

import numpy as np

from .._core import tolerances
from .._drawing import FigureSheet, text_width
from .._production import places_covered
from .figure_views import LIGHT_VIEWS, MARGIN, WIDTH, FigureView
from .hidden_lines import Sight

_FOOT = 9.0
_THIN, _BOLD = 0.22, 0.75
_BLACK = (0.0, 0.0, 0.0)
_SEEN, _HIDDEN = (0.08, 0.08, 0.10), (0.80, 0.81, 0.83)
_CREASE, _HIDDEN_CREASE = (0.70, 0.10, 0.06), (0.93, 0.80, 0.78)
_IRREGULAR = (0.05, 0.35, 0.65)
_WORDS = 3.0
# Of the drawing's size: how far lines are moved towards the eye from the faces that they are of.
_IN_FRONT = 1e-6
_TURN = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)
_ROUND = np.stack([np.cos(_TURN), np.sin(_TURN)], axis=1)


def mesh_sheet(mesh, mirrored, title):
    """The FigureSheet of a ControlMesh, both sides of a half hull."""
    whole = _WholeMesh(mesh, mirrored)
    used = whole.points[whole.used]
    views = [FigureView(used, name) for name in LIGHT_VIEWS]
    heights = [view.height for view in views]
    sheet = FigureSheet(title, WIDTH, sum(heights) + _FOOT)
    for view, top in zip(views, np.cumsum([0.0, *heights])):
        _draw_view(sheet, whole, view, np.array([0.0, top]))
    _draw_legend(sheet, whole, mesh, mirrored, sum(heights) + _FOOT - 5.1)
    return sheet


def write_mesh_figure(mesh, path, *, mirrored, title=""):
    """Draws a ControlMesh in perspective, from ahead and from astern: creases bold, hidden edges
    faded, irregular points marked. The path ends in .pdf, .svg or .png; the file is complete, or
    one of the same name is untouched. mirrored: the mesh is one side of a hull. ValueError for
    another ending, OSError if the file can't be written."""
    mesh_sheet(mesh, mirrored, title).write(path)


class _WholeMesh:
    """Points, faces and edges with the other side's; creases and irregular points."""

    def __init__(self, mesh, mirrored):
        count, self.points = mesh.vertex_count, mesh.points
        ends = np.cumsum(mesh.face_sizes)[:-1]
        self.faces = [face.tolist() for face in np.split(mesh.face_vertices, ends)]
        borders = {tuple(sorted(pair)) for pair in np.asarray(mesh.border_edges).tolist()}
        creases = {tuple(sorted(pair)) for pair in np.asarray(mesh.creases).tolist()} - borders
        irregular = _irregular(mesh)
        if mirrored:
            # Points on the centre plane are those of both sides.
            near = tolerances.ON_CENTRE_PLANE * mesh.size
            on_centre = np.abs(self.points[:, 1]) <= near
            image = np.where(on_centre, np.arange(count), np.arange(count) + count)
            self.points = np.concatenate([self.points, self.points * (1.0, -1.0, 1.0)])
            self.faces += [[int(image[v]) for v in reversed(face)] for face in self.faces]
            creases |= {tuple(sorted((int(image[a]), int(image[b])))) for a, b in creases}
            irregular |= {int(image[v]) for v in irregular}
        pairs = {tuple(sorted(pair)) for face in self.faces for pair in zip(face, _next(face))}
        self.edges = sorted(pairs)
        self.is_crease = [edge in creases for edge in self.edges]
        self.irregular = irregular
        self.used = sorted({v for face in self.faces for v in face})
        self.triangles = np.array(
            [(face[0], b, c) for face in self.faces for b, c in zip(face[1:], face[2:])]
        )


def _irregular(mesh):
    """Inner points without four edges, and border points with more than three."""
    valences, on_border = mesh.vertex_valences, np.zeros(mesh.vertex_count, dtype=bool)
    on_border[np.asarray(mesh.border_edges, dtype=int).ravel()] = True
    return set(np.flatnonzero(np.where(on_border, valences > 3, valences != 4)).tolist())


def _next(face):
    return face[1:] + face[:1]


class _Faces:
    """What hides lines: faces as triangles, as the eye sees them."""

    def __init__(self, points, triangles):
        self._points, self._triangles = points, triangles

    def covers(self, places):
        return places_covered(self._points, self._triangles, places)


def _draw_view(sheet, whole, view, corner):
    seen = view.eye.seen(whole.points)
    size = np.ptp(seen[whole.used][:, :2], axis=0).max()
    faces = _Faces(seen, whole.triangles)
    flat = view.flat(seen) + corner
    _draw_faces(sheet, whole, view, flat)
    pieces = list(Sight(faces, size, _IN_FRONT * size).pieces(seen[np.array(whole.edges)]))
    for creased in (False, True):
        for is_hidden in (True, False):
            colour = ((_SEEN, _HIDDEN), (_CREASE, _HIDDEN_CREASE))[creased][is_hidden]
            for own, is_crease in zip(pieces, whole.is_crease):
                for is_seen, piece in own if is_crease == creased else ():
                    if is_seen != is_hidden:
                        width = _BOLD if creased else _THIN
                        sheet.line(view.flat(piece) + corner, width, colour)
    hidden = faces.covers(seen + (0.0, 0.0, _IN_FRONT * size))
    for number in whole.used:
        if not hidden[number]:
            colour, radius = ((_SEEN, 0.45), (_IRREGULAR, 0.95))[number in whole.irregular]
            sheet.patch(flat[number] + radius * _ROUND, colour)


def _draw_faces(sheet, whole, view, flat):
    """Pale, the further ones first."""
    centres = np.array([whole.points[face].mean(axis=0) for face in whole.faces])
    for number in np.argsort(centres @ view.axes[2], kind="stable"):
        face = whole.faces[number]
        corners = whole.points[face]
        normal = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
        facing = normal @ (view.eye_position - centres[number])
        light = abs(normal @ (0.5, -0.6, 0.7)) / max(np.linalg.norm(normal) * 1.05, 1e-30)
        shade = 0.90 + 0.09 * light if facing > 0.0 else 0.88
        sheet.area(flat[face], (shade, shade, min(shade + 0.01, 1.0)))


def _draw_legend(sheet, whole, mesh, mirrored, middle):
    count = f"{mesh.vertex_count} control points" + (" to one side" if mirrored else "")
    sheet.text((MARGIN, middle), f"{count}, {mesh.face_count} faces", _WORDS, _BLACK, 0.0)
    right = WIDTH - MARGIN
    sheet.text((right, middle), "irregular point", _WORDS, _BLACK, 1.0)
    dot = right - text_width("irregular point", _WORDS) - 3.0
    sheet.patch(np.array([dot, middle]) + 0.95 * _ROUND, _IRREGULAR)
    if any(whole.is_crease):
        sheet.text((dot - 8.0, middle), "crease", _WORDS, _BLACK, 1.0)
        start = dot - 8.0 - text_width("crease", _WORDS) - 2.0
        sheet.line([(start - 9.0, middle), (start, middle)], _BOLD, _CREASE)
