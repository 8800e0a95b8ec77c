# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of a hull, from ahead and from astern, below: with paint, sections and waterlines, and
as a mirror of light lines. Each dot has the exact surface's normal, linear within small facets."""

import numpy as np

from .._drawing import FigureSheet, seen_values
from .._production import closed_model
from .figure_views import LIGHT_BANDS, LIGHT_VIEWS, WIDTH, FigureView
from .view_drawings import view_drawing

# Each dot of a picture is the mean of so many by so many.
_DOTS_PER_MM, _FINER = 8.0, 2
# Of facets in all, and along the sides of a cell.
_MOST_FACETS, _MOST_DIVISIONS = 400000, 24
# Of the hull's size: how far what closes it, and what hides lines, may be from the surface's edge.
_TOLERANCE = 1e-4
# Dots that are coloured together.
_AT_ONCE = 400000
# sRGB of what is around the hull and of the lights; the rest reflects so much of red, green, blue.
_AROUND, _LIGHT, _DARK = (0.81, 0.82, 0.83), (0.97, 0.98, 0.98), (0.20, 0.25, 0.30)
_BOTTOM, _STRIPE, _SIDES, _DECK = (
    np.array(colour)
    for colour in ((0.30, 0.055, 0.04), (0.85, 0.85, 0.83), (0.36, 0.43, 0.50), (0.35, 0.36, 0.36))
)
# Of the length: how wide the stripe above the water is.
_STRIPE_WIDTH = 0.006
_LINE, _LINE_WIDTH = (0.05, 0.06, 0.09, 0.65), 0.16


class SeenHull:
    """A FigureForm as each of its views shows it, dot by dot; progress: called with the share done.

    views: FigureView; sights: of each the dots that show the hull (n,), numbered row by row, and
    there places, normals, and 1 on what closes the hull (n, 7)."""

    def __init__(self, form, progress=None):
        tell = progress or (lambda share: None)
        self.form = form
        model = closed_model(
            form.body,
            _TOLERANCE * form.surface.mesh.size,
            progress=lambda share: tell(0.3 * share),
        )
        self.views = [FigureView(model.points, name) for name in LIGHT_VIEWS]
        points, values, triangles = _joined(_facets(form), _closings(model))
        self.sights = []
        for view in self.views:
            tell(0.4 + 0.3 * len(self.sights))
            places = view.dots(points, _FINER * _DOTS_PER_MM)
            width, height = _size_in_dots(view)
            self.sights.append(seen_values(places, values, triangles, width=width, height=height))

    def draw(self, colours, lines=(), progress=None):
        """The FigureSheet with both views; colours(SeenPlaces) → sRGB (n, 3); lines: polylines as
        the eye of each view has seen them."""
        tell = progress or (lambda share: None)
        heights = [view.height for view in self.views]
        sheet = FigureSheet(self.form.title, WIDTH, sum(heights))
        for k, (view, top) in enumerate(zip(self.views, np.cumsum([0.0, *heights]))):
            corner = np.array([0.0, top])
            dots = _dots(view, self.sights[k], colours, lambda share: tell(0.5 * (k + share)))
            sheet.picture(corner, (WIDTH, view.height), dots)
            for piece in lines[k] if lines else ():
                sheet.line(view.flat(piece) + corner, _LINE_WIDTH, _LINE)
        return sheet


def _size_in_dots(view):
    """(columns, rows) before means are taken."""
    return tuple(int(round(side * _DOTS_PER_MM)) * _FINER for side in (WIDTH, view.height))


def _dots(view, sight, colours, tell):
    """(rows, columns, 3) of what a view sees, 0 to 255."""
    columns, rows = _size_in_dots(view)
    fine = np.empty((rows * columns, 3), dtype=np.uint8)
    fine[:] = _in_bytes(np.array(_AROUND))
    dots, values = sight
    for begin in range(0, len(dots), _AT_ONCE):
        tell(begin / len(dots))
        part = slice(begin, begin + _AT_ONCE)
        fine[dots[part]] = _in_bytes(colours(SeenPlaces(values[part], view.eye_position)))
    shape = rows // _FINER, _FINER, columns // _FINER, _FINER, 3
    means = fine.reshape(shape).mean(axis=(1, 3), dtype=np.float32)
    return np.round(means).astype(np.uint8)


def _in_bytes(colours):
    return np.round(255.0 * np.clip(colours, 0.0, 1.0)).astype(np.uint8)


class SeenPlaces:
    """Of each of n dots on the hull: places and normals, towards the eye, (n, 3); from_eye (n, 3),
    unit; closing (n,), whether it is of what closes the hull."""

    def __init__(self, values, eye):
        values = values.astype(float)
        self.places, self.closing = values[:, :3], values[:, 6] > 0.5
        self.from_eye = _unit(self.places - eye)
        turned = np.einsum("ij,ij->i", values[:, 3:6], self.from_eye) > 0.0
        self.normals = _unit(np.where(turned[:, None], -1.0, 1.0) * values[:, 3:6])


def _unit(vectors):
    squares = np.einsum("ij,ij->i", vectors, vectors)
    return vectors / np.sqrt(np.maximum(squares, 1e-60))[:, None]


def _facets(form):
    """Of the shell, both sides."""
    surface = form.surface
    divisions = int(np.sqrt(_MOST_FACETS / surface.cell_count))
    shown = surface.tessellate(min(max(divisions, 2), _MOST_DIVISIONS))
    corners = shown.normal_indices
    point_of = np.zeros(len(shown.normals), dtype=int)
    point_of[corners.ravel()] = shown.quads.ravel()
    points, normals = shown.points[point_of], shown.normals
    triangles = np.vstack([corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]])
    one = points, np.column_stack([points, normals, np.zeros(len(points))]), triangles
    if not form.body.mirrored:
        return one
    image = np.array([1.0, -1.0, 1.0])
    return _joined(one, (points * image, one[1] * [*image, *image, 1.0], triangles))


def _closings(model):
    corners = model.points[model.triangles[model.cells < 0]]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    points = corners.reshape(-1, 3)
    values = np.column_stack([points, np.repeat(_unit(normals), 3, axis=0), np.ones(len(points))])
    return points, values, np.arange(len(points)).reshape(-1, 3)


def _joined(one, other):
    return (
        np.vstack([one[0], other[0]]),
        np.vstack([one[1], other[1]]),
        np.vstack([one[2], other[2] + len(one[0])]),
    )


def rendering_sheet(seen, progress=None):
    """A SeenHull with paint, sections and waterlines."""
    tell = progress or (lambda share: None)
    lines = [
        _lines_of(seen, view, lambda share, k=k: tell(0.25 * (k + share)))
        for k, view in enumerate(seen.views)
    ]
    form = seen.form
    return seen.draw(_paint(form), lines, progress=lambda share: tell(0.5 + 0.5 * share))


def _lines_of(seen, view, progress):
    form = seen.form
    drawing = view_drawing(
        form.body,
        axes=view.axes,
        distance=view.distance,
        stations=[x for name, x in form.stations() if "½" not in name],
        waterlines=form.waterlines(),
        tolerance=_TOLERANCE * form.surface.mesh.size,
        progress=progress,
    )
    return [line / 1000.0 for _, line in drawing.lines]


def _paint(form):
    draft = form.given_draft
    stripe = _STRIPE_WIDTH * form.lpp

    def colours(seen):
        z = seen.places[:, 2:]
        base = np.broadcast_to(_SIDES, seen.places.shape)
        if draft is not None:
            base = np.where(z < draft + stripe, _STRIPE, base)
            base = np.where(z < draft, _BOTTOM, base)
        base = np.where(seen.closing[:, None], _DECK, base)
        return _srgb(base * _light_on(seen)[:, None] + _shine(seen)[:, None])

    return colours


# Towards the lamps, right, up and towards the eye of what the ship shows, from its own directions.
_LAMPS = (((0.25, -0.75, 0.60), 0.42), ((-0.85, -0.45, -0.25), 0.22), ((0.90, -0.40, -0.15), 0.22))
_SKY, _GROUND, _AT_EYE = 0.42, 0.16, 0.38


def _light_on(seen):
    up = seen.normals[:, 2]
    light = _GROUND + (_SKY - _GROUND) * 0.5 * (1.0 + up)
    light = light - _AT_EYE * np.einsum("ij,ij->i", seen.from_eye, seen.normals)
    for towards, strength in _LAMPS:
        lamp = np.array(towards) / np.linalg.norm(towards)
        light = light + strength * np.maximum(seen.normals @ lamp, 0.0)
    return light


def _shine(seen):
    """What a smooth paint mirrors of the first lamp."""
    lamp = np.array(_LAMPS[0][0]) / np.linalg.norm(_LAMPS[0][0])
    return 0.06 * np.maximum(_mirrored(seen) @ lamp, 0.0) ** 24


def _mirrored(seen):
    """Unit directions (n, 3) of what a mirror shows."""
    along = np.einsum("ij,ij->i", seen.from_eye, seen.normals)[:, None]
    return seen.from_eye - 2.0 * along * seen.normals


def _srgb(linear):
    linear = np.clip(linear, 0.0, 1.0)
    return np.where(linear < 0.0031308, 12.92 * linear, 1.055 * linear ** (1.0 / 2.4) - 0.055)


def reflection_sheet(seen, progress=None):
    """A SeenHull as a mirror of light lines along the ship: LIGHT_BANDS pairs, light and dark, by
    the angle around its length of what is mirrored."""
    return seen.draw(_bands, progress=progress)


def _bands(seen):
    towards = _mirrored(seen)
    turns = np.arctan2(towards[:, 2], towards[:, 1]) * LIGHT_BANDS / (2.0 * np.pi)
    is_light = turns - np.floor(turns) > 0.5
    return np.where(is_light[:, None], _LIGHT, _DARK)
