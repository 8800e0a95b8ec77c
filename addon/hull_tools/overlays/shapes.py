# SPDX-License-Identifier: GPL-3.0-or-later
"""What several overlays draw in the picture, in dots of its region: rings, discs, lines, areas, and
words on paper."""

import blf
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from ..bridge.blender import blender_versions
from ..bridge.blender.palette import INK, PAPER

_FONT = 0  # Blender's own
_CORNERS = ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0))


def ring(centre, radius, count=32):
    """Corners (2 count, 3) of the segments of a ring."""
    angles = np.linspace(0.0, 2.0 * np.pi, count + 1)
    circle = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(count + 1)])
    corners = np.array([*centre, 0.0]) + radius * circle
    return np.repeat(corners, 2, axis=0)[1:-1].astype(np.float32)


def discs(centres, radius, count=16):
    """Corners (3 count k, 3) of the triangles of discs at centres (k, 2)."""
    angles = np.linspace(0.0, 2.0 * np.pi, count + 1)
    rim = radius * np.column_stack([np.cos(angles), np.sin(angles)])
    fan = np.stack([np.zeros((count, 2)), rim[:-1], rim[1:]], axis=1).reshape(-1, 2)
    corners = (np.asarray(centres)[:, None, :] + fan[None]).reshape(-1, 2)
    return np.column_stack([corners, np.zeros(len(corners))]).astype(np.float32)


def draw_segments(corners, *colours_and_widths):
    """Draws segments, of which these are the corners (n, 3), once for each pair (colour, width)."""
    shader = blender_versions.builtin_shader("POLYLINE_UNIFORM_COLOR")
    shader.bind()
    shader.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
    batch = batch_for_shader(shader, "LINES", {"pos": corners})
    for colour, width in colours_and_widths:
        shader.uniform_float("lineWidth", width)
        shader.uniform_float("color", colour)
        batch.draw(shader)


def draw_triangles(corners, colour, form="TRIS"):
    """Fills triangles of which these are the corners (n, 3); form: "TRI_STRIP" where they share
    sides."""
    shader = blender_versions.builtin_shader("UNIFORM_COLOR")
    shader.bind()
    shader.uniform_float("color", colour)
    batch_for_shader(shader, form, {"pos": corners}).draw(shader)


def draw_card(left, low, width, height, colour=PAPER):
    """Fills a rectangle."""
    corners = [(left + u * width, low + v * height, 0.0) for u, v in _CORNERS]
    draw_triangles(corners, colour, "TRI_STRIP")


def measure(text, size):
    """(width, height) of a text."""
    blf.size(_FONT, size)
    return blf.dimensions(_FONT, text)


def draw_text(text, left, low, size, colour=INK):
    blf.size(_FONT, size)
    blf.color(_FONT, *colour)
    blf.position(_FONT, left, low, 0.0)
    blf.draw(_FONT, text)


def draw_words(text, left, low, size, margin):
    """Draws a text on paper that reaches so far beyond it."""
    width, height = measure(text, size)
    draw_card(left - margin, low - margin, width + 2.0 * margin, height + 2.0 * margin)
    draw_text(text, left, low, size)
