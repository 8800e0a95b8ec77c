# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull's control mesh in perspective, from ahead and from astern, below: creases bold, what is
hidden faded, irregular points marked."""

import math

import numpy as np

from . import paper

WIDTH, MARGIN, FOOT = 270.0, 8.0, 9.0
# Where the eye is, from the bow to starboard, and above the hull.
BEARINGS_DEG, ELEVATION_DEG = (-42.0, -138.0), -14.0
# From the hull's middle to the eye, over the hull's length.
DISTANCE = 2.2
# Pieces that an edge is seen or hidden by.
PIECES = 32
THIN, BOLD = 0.22, 0.75
SEEN, HIDDEN = (0.08, 0.08, 0.10), (0.80, 0.81, 0.83)
CREASE, HIDDEN_CREASE = (0.70, 0.10, 0.06), (0.93, 0.80, 0.78)
IRREGULAR = (0.05, 0.35, 0.65)


def draw(data, stem):
    """Writes `stem`.pdf and .png of a HullData's control mesh, both sides of a half hull."""
    mesh = _Mesh(data)
    cameras = [_Camera(mesh.points, math.radians(bearing)) for bearing in BEARINGS_DEG]
    heights = [camera.fit(mesh.points) for camera in cameras]

    def paint(context):
        context.save()
        for camera, height in zip(cameras, heights):
            _paint_view(context, mesh, camera)
            context.translate(0.0, height)
        context.restore()
        _paint_legend(context, mesh, data, sum(heights) + FOOT - 4.0)

    paper.draw(stem, WIDTH, sum(heights) + FOOT, paint)


def _paint_view(context, mesh, camera):
    flat = camera.page(mesh.points)
    hidden = _hidden_pieces(mesh, camera)
    _paint_faces(context, mesh, camera, flat)
    for creased in (False, True):
        for is_hidden in (True, False):
            _paint_edges(context, mesh, camera, hidden, creased, is_hidden)
    _paint_points(context, mesh, flat, ~_hidden_points(mesh, camera))


class _Mesh:
    """Points, faces and edges with the other side's; creases and irregular points."""

    def __init__(self, data):
        count = len(data.points)
        self.points, self.faces = np.asarray(data.points, dtype=float), [*map(list, data.faces)]
        creases = {tuple(sorted(pair)) for pair in data.creases}
        irregular = _irregular(data.faces, count)
        if data.half:
            # Points on the centre plane are those of both sides.
            size = np.ptp(self.points, axis=0).max()
            on_centre = np.abs(self.points[:, 1]) < 1e-9 * size
            image = np.where(on_centre, np.arange(count), np.arange(count) + count)
            self.points = np.concatenate([self.points, self.points * (1.0, -1.0, 1.0)])
            self.faces += [[int(image[v]) for v in reversed(face)] for face in data.faces]
            creases |= {tuple(sorted((int(image[a]), int(image[b])))) for a, b in creases}
            irregular |= {int(image[v]) for v in irregular}
        self.faces_of_edge = {}
        for number, face in enumerate(self.faces):
            for a, b in zip(face, face[1:] + face[:1]):
                self.faces_of_edge.setdefault((min(a, b), max(a, b)), []).append(number)
        self.edges = sorted(self.faces_of_edge)
        self.is_crease = [edge in creases for edge in self.edges]
        self.irregular = irregular
        self.used = sorted({v for face in self.faces for v in face})


def _irregular(faces, count):
    """Inner points without four edges, and border points with more than three."""
    edges = {}
    for face in faces:
        for a, b in zip(face, face[1:] + face[:1]):
            key = (min(a, b), max(a, b))
            edges[key] = edges.get(key, 0) + 1
    valence, on_border = np.zeros(count, dtype=int), np.zeros(count, dtype=bool)
    for (a, b), number in edges.items():
        valence[[a, b]] += 1
        on_border[[a, b]] |= number == 1
    return set(np.flatnonzero(np.where(on_border, valence > 3, valence != 4)).tolist())


class _Camera:
    """Looks at points from a bearing, counted from ahead to port, in rad."""

    def __init__(self, points, bearing):
        elevation = math.radians(ELEVATION_DEG)
        out = np.array([math.cos(bearing), math.sin(bearing), math.tan(elevation)])
        self.back = out / np.linalg.norm(out)
        self.right = np.array([-math.sin(bearing), math.cos(bearing), 0.0])
        self.up = np.cross(self.back, self.right)
        low, high = points.min(axis=0), points.max(axis=0)
        self.size = float((high - low).max())
        self.eye = 0.5 * (low + high) + DISTANCE * self.size * self.back

    def fit(self, points):
        """Has page() fill the page's width with the points; the height of that, in mm."""
        flat = self._flat(points)
        self.low = flat.min(axis=0)
        width, height = np.ptp(flat, axis=0)
        self.scale = (WIDTH - 2 * MARGIN) / width
        return height * self.scale + 2 * MARGIN

    def page(self, points):
        """Places (n, 2) on the page in mm, y downwards."""
        return MARGIN + (self._flat(points) - self.low) * self.scale

    def _flat(self, points):
        away = np.asarray(points) - self.eye
        depth = -away @ self.back
        return np.stack([away @ self.right, -away @ self.up], axis=1) / depth[:, None]


def _triangles(mesh):
    """(corners (n, 3, 3), face of each (n,))."""
    corners, faces = [], []
    for number, face in enumerate(mesh.faces):
        for b, c in zip(face[1:], face[2:]):
            corners.append(mesh.points[[face[0], b, c]])
            faces.append(number)
    return np.array(corners), np.array(faces)


def _covered(places, skipped, mesh, camera):
    """Whether each of places (n, 3) is behind a face; skipped: for each face which places are
    those of its own corners and edges (n,)."""
    rays = camera.eye - places
    covered = np.zeros(len(places), dtype=bool)
    for (a, b, c), face in zip(*_triangles(mesh)):
        one, other = b - a, c - a
        across = np.cross(rays, other)
        det = across @ one
        with np.errstate(divide="ignore", invalid="ignore"):
            from_a = places - a
            u = np.einsum("ij,ij->i", from_a, across) / det
            along = np.cross(from_a, one)
            v = np.einsum("ij,ij->i", rays, along) / det
            t = along @ other / det
            hit = (u >= 0.0) & (v >= 0.0) & (u + v <= 1.0) & (t > 1e-6)
        covered |= hit & ~skipped(face)
    return covered


def _hidden_pieces(mesh, camera):
    """Whether each piece of each edge (n, PIECES) is hidden."""
    ends = mesh.points[np.array(mesh.edges)]
    at = ((np.arange(PIECES) + 0.5) / PIECES)[None, :, None]
    places = (ends[:, None, 0] * (1.0 - at) + ends[:, None, 1] * at).reshape(-1, 3)

    def skipped(face):
        own = np.array([face in mesh.faces_of_edge[edge] for edge in mesh.edges])
        return np.repeat(own, PIECES)

    return _covered(places, skipped, mesh, camera).reshape(-1, PIECES)


def _hidden_points(mesh, camera):
    def skipped(face):
        own = np.zeros(len(mesh.points), dtype=bool)
        own[mesh.faces[face]] = True
        return own

    return _covered(mesh.points, skipped, mesh, camera)


def _paint_faces(context, mesh, camera, flat):
    """Pale, the further ones first."""
    centres = [mesh.points[face].mean(axis=0) for face in mesh.faces]
    order = sorted(range(len(centres)), key=lambda i: (centres[i] - camera.eye) @ camera.back)
    for number in order:
        face = mesh.faces[number]
        corners = mesh.points[face]
        normal = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
        facing = normal @ (camera.eye - centres[number])
        light = abs(normal @ (0.5, -0.6, 0.7)) / max(np.linalg.norm(normal) * 1.05, 1e-30)
        shade = 0.90 + 0.09 * light if facing > 0.0 else 0.88
        context.set_source_rgb(shade, shade, min(shade + 0.01, 1.0))
        context.move_to(*flat[face[0]])
        for corner in face[1:]:
            context.line_to(*flat[corner])
        context.close_path()
        context.fill_preserve()
        context.set_line_width(0.05)
        context.stroke()


def _paint_edges(context, mesh, camera, hidden, creased, is_hidden):
    colour = ((SEEN, HIDDEN), (CREASE, HIDDEN_CREASE))[creased][is_hidden]
    for number, edge in enumerate(mesh.edges):
        if mesh.is_crease[number] != creased:
            continue
        start, end = mesh.points[list(edge)]
        for part in _runs(hidden[number] == is_hidden):
            ends = camera.page([start + at / PIECES * (end - start) for at in part])
            paper.line(context, ends, BOLD if creased else THIN, colour)


def _runs(flags):
    """(first, last + 1) of each run of true ones."""
    steps = np.diff(np.concatenate([[0], flags.astype(int), [0]]))
    return zip(np.flatnonzero(steps > 0), np.flatnonzero(steps < 0))


def _paint_points(context, mesh, flat, seen):
    for number in mesh.used:
        if seen[number]:
            colour, radius = (IRREGULAR, 0.95) if number in mesh.irregular else (SEEN, 0.45)
            _dot(context, flat[number], radius, colour)


def _dot(context, at, radius, colour):
    context.set_source_rgb(*colour)
    context.arc(*at, radius, 0.0, 2.0 * math.pi)
    context.fill()


def _paint_legend(context, mesh, data, base):
    count = f"{len(data.points)} control points" + (" to one side" if data.half else "")
    paper.text(context, (MARGIN, base), f"{count}, {len(data.faces)} faces", align=0.0)
    right, middle = WIDTH - MARGIN, base - 1.1
    paper.text(context, (right, base), "irregular point", align=1.0)
    dot = right - paper.text_width(context, "irregular point") - 3.0
    _dot(context, (dot, middle), 0.95, IRREGULAR)
    if any(mesh.is_crease):
        paper.text(context, (dot - 8.0, base), "crease", align=1.0)
        start = dot - 8.0 - paper.text_width(context, "crease") - 2.0
        paper.line(context, [(start - 9.0, middle), (start, middle)], BOLD, CREASE)
