# SPDX-License-Identifier: GPL-3.0-or-later
"""The card of one plot on the graphics card: paper, areas, lines and texts."""

from contextlib import contextmanager
from functools import lru_cache

import blf
import bpy
import gpu
import numpy as np

from ..bridge.blender import blender_versions
from ..bridge.blender.palette import PAPER
from . import buffers

_VEIL = (*PAPER[:3], 0.6)
_BORDER = (0.35, 0.35, 0.35, 1.0)
_NOTE, _NOTE_MM = "computing …", 2.5  # over a pale card
_LEAST_LINE = 1.0  # dots: thinner lines would fade
_BLANK_MARGIN_MM = 0.25  # as on paper
_FONT = 0  # Blender's own


class Card:
    """One plot_arrays.PlotArrays on the graphics card."""

    def __init__(self, arrays):
        self._arrays = arrays
        self._fill = blender_versions.builtin_shader("SMOOTH_COLOR")
        self._line = blender_versions.builtin_shader("POLYLINE_SMOOTH_COLOR")
        sheet = _rectangle(0.0, 0.0, arrays.width_mm, arrays.height_mm)
        self._beneath = self._filled((sheet, PAPER), _of(arrays.areas))
        knockouts = [label for label in arrays.labels if label["knockout"]]
        blanks = np.array([_blank(label) for label in knockouts]).reshape(-1, 2)
        self._above = self._filled(_of(arrays.patches), (blanks, (*PAPER[:3], 1.0)))
        self._veil = self._filled((sheet, _VEIL))
        border = sheet[[0, 1, 1, 2, 2, 5, 5, 0]]
        self._segments = [
            (one.width_mm, self._lined(one.points, one.colours)) for one in arrays.segments
        ]
        self._segments.append((0.0, self._lined(border, _BORDER)))

    def draw(self, place, dots, viewport):
        """With the lower left corner at a place (x, y) in the region, dots a millimetre; viewport:
        (width, height) of the region in dots."""
        with self._on_page(place, dots):
            self._draw_filled(self._beneath)
            self._line.bind()
            self._line.uniform_float("viewportSize", viewport)
            for width, batch in self._segments:
                if batch is not None:
                    self._line.uniform_float("lineWidth", max(width * dots, _LEAST_LINE))
                    batch.draw(self._line)
            self._draw_filled(self._above)
        labels = self._arrays.labels
        ratio = _typeface_ratio(labels, dots)
        for label in labels:
            _draw_label(label, self._arrays.height_mm, place, dots, ratio)

    def draw_veil(self, place, dots):
        """Makes the card pale and says why, in its upper right corner."""
        with self._on_page(place, dots):
            self._draw_filled(self._veil)
        blf.size(_FONT, _NOTE_MM * dots)
        width = _text_width(_NOTE, _NOTE_MM * dots)
        right = place[0] + self._arrays.width_mm * dots
        top = place[1] + self._arrays.height_mm * dots
        blf.color(_FONT, *_BORDER)
        blf.position(_FONT, right - width - _NOTE_MM * dots, top - 2.0 * _NOTE_MM * dots, 0.0)
        blf.draw(_FONT, _NOTE)

    @contextmanager
    def _on_page(self, place, dots):
        """Draws in page millimetres, y down, in place of the dots of the region."""
        gpu.state.blend_set("ALPHA")  # texts leave it off
        with gpu.matrix.push_pop():
            gpu.matrix.translate((place[0], place[1] + self._arrays.height_mm * dots))
            gpu.matrix.scale((dots, -dots))
            yield

    def _draw_filled(self, batch):
        if batch is not None:
            batch.draw(self._fill)

    def _filled(self, *parts):
        """Triangles of several parts, each (points (n, 2), colour (4,) or colours (n, 4))."""
        return _batch(self._fill, "TRIS", parts)

    def _lined(self, points, colours):
        return _batch(self._line, "LINES", [(points, colours)])


def _batch(shader, form, parts):
    """Parts, each (points (n, 2), colour (4,) or colours (n, 4)), to draw one after the other."""
    points = np.zeros((sum(len(own) for own, _ in parts), 3), dtype=np.float32)
    shades = np.empty((len(points), 4), dtype=np.float32)
    begin = 0
    for own, colour in parts:
        end = begin + len(own)
        points[begin:end, :2], shades[begin:end] = own, colour
        begin = end
    return buffers.batch(shader, form, pos=points, color=shades)


def _of(triangles):
    return triangles.points, triangles.colours


def _rectangle(left, top, right, low):
    """The corners (6, 2) of two triangles."""
    return np.array(
        [(left, top), (right, top), (right, low), (left, top), (right, low), (left, low)]
    )


def _blank(label):
    """Two triangles that blank the paper beneath a text turned by a multiple of 90 degrees."""
    (x, y), (half_x, half_y) = label["centre"], label["half"]
    if abs(label["angle"]) > 0.1:
        half_x, half_y = half_y, half_x
    half_x, half_y = half_x + _BLANK_MARGIN_MM, half_y + _BLANK_MARGIN_MM
    return _rectangle(x - half_x, y - half_y, x + half_x, y + half_y)


def _text_width(text, size):
    """In dots, of a text of that size; it is measured once."""
    return _measured(text, size, bpy.context.preferences.view.font_path_ui)


@lru_cache(maxsize=4096)
def _measured(text, size, font):
    """font: the file of the typeface, which the user may choose."""
    blf.size(_FONT, size)
    return blf.dimensions(_FONT, text)[0]


def _typeface_ratio(labels, dots):
    """By what Blender's typeface must be larger to be as wide as the paper's, all in all."""
    own = sum(_text_width(label["text"], label["size"] * dots) for label in labels)
    wanted = sum(2.0 * label["half"][0] * dots for label in labels)
    return min(max(wanted / own, 0.8), 1.2) if own > 0.0 else 1.0


def _draw_label(label, height_mm, place, dots, ratio):
    (x, y), (half_x, half_y) = label["centre"], label["half"]
    size, room = label["size"] * dots * ratio, 2.0 * half_x * dots
    width = _text_width(label["text"], size)
    if width > room > 0.0:
        size, width = size * room / width, room
    blf.size(_FONT, size)
    # A bold text is wider on paper: it begins where it does there.
    begin = -0.5 * (room if label["bold"] else width)
    base = -(half_y - label["descent"]) * dots
    centre = (place[0] + x * dots, place[1] + (height_mm - y) * dots)
    blf.color(_FONT, *label["colour"])
    upwards = abs(label["angle"]) > 0.1
    if upwards:
        blf.enable(_FONT, blf.ROTATION)
        blf.rotation(_FONT, -label["angle"])
    # Once more beside itself, a text is bold: Blender's interface has no such typeface.
    for shift in (0.0, 0.5) if label["bold"] else (0.0,):
        along, above = begin + shift, base
        at = (-above, along) if upwards else (along, above)
        blf.position(_FONT, centre[0] + at[0], centre[1] + at[1], 0.0)
        blf.draw(_FONT, label["text"])
    blf.disable(_FONT, blf.ROTATION)
