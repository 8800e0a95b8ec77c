# SPDX-License-Identifier: GPL-3.0-or-later
"""The legend of a colour scale as arrays for the graphics card. Millimetres from the lower left
corner of its card, y up."""

from dataclasses import dataclass

import numpy as np

from ..features.lines.line_places import handy_spacing

HEIGHT_MM = 62.0
_MARGIN, _BAR_WIDTH, _TITLE_ROOM, _LINE = 2.5, 4.5, 9.0, 3.6
_TICK_LENGTH, _TICK_WIDTH, _TEXT_GAP = 1.2, 0.25, 1.0
_HALF_LETTER = 0.9
_STEPS = 128
# Of numbers in other units than the scale's: about how many; of each sign on a logarithmic one.
_PARTS, _DECADES = 8, 3
_LEAST_APART = 0.05  # of the bar: ticks nearer to 0 are left out

_CORNERS = (0, 1, 2, 0, 2, 3)


@dataclass(frozen=True)
class LegendArrays:
    """bar: triangles (points (n, 3), colours (n, 4)). labels: pairs of height
    in mm and text."""

    title: str
    unit: str
    bar: tuple
    labels: tuple

    def card_width_mm(self, title_mm, widest_number_mm):
        """For texts of these widths."""
        beside_bar = _BAR_WIDTH + _TICK_LENGTH + _TEXT_GAP + widest_number_mm
        return max(beside_bar, title_mm) + 2.0 * _MARGIN

    def card(self, width_mm, colour):
        """The paper below it all, as bar."""
        return _rectangles([(0.0, 0.0, width_mm, HEIGHT_MM)], [(colour, colour)])

    def ticks(self, colour):
        left = _MARGIN + _BAR_WIDTH
        half = 0.5 * _TICK_WIDTH
        places = [(left, y - half, left + _TICK_LENGTH, y + half) for y, _ in self.labels]
        return _rectangles(places, [(colour, colour)] * len(places))

    def placed_texts(self):
        """((x, y), text) of title and numbers: lower left corners."""
        top = HEIGHT_MM - _MARGIN - 2.0 * _HALF_LETTER
        yield (_MARGIN, top), self.title
        yield (_MARGIN, top - _LINE), self.unit
        left = _MARGIN + _BAR_WIDTH + _TICK_LENGTH + _TEXT_GAP
        for y, text in self.labels:
            yield (left, y - _HALF_LETTER), text


def arrays_of(scale, title, sizes):
    """LegendArrays of a hull_native.ColourScale, its numbers in units as units.Shown.plot_sizes()
    has them."""
    low, high = _MARGIN, HEIGHT_MM - _MARGIN - _TITLE_ROOM
    edges = np.linspace(low, high, _STEPS + 1)
    shades = [(*colour, 1.0) for colour in scale.legend_colours(_STEPS + 1)]
    right = _MARGIN + _BAR_WIDTH
    places = [(_MARGIN, a, right, b) for a, b in zip(edges[:-1], edges[1:])]
    positions, texts, unit = _ticks(scale, sizes)
    labels = tuple(
        (float(low + position * (high - low)), text) for position, text in zip(positions, texts)
    )
    bar = _rectangles(places, list(zip(shades[:-1], shades[1:])))
    return LegendArrays(title, unit, bar, labels)


def _ticks(scale, sizes):
    """(positions from 0 to 1, texts, unit) of round numbers of a scale."""
    if scale.unit not in sizes:
        return scale.tick_positions, scale.tick_labels, scale.unit
    size, symbol = sizes[scale.unit]
    if scale.unit == "mm":  # of a scale of distances in m
        size *= 1e-3
    low, high = scale.low / size, scale.high / size
    values = _round_numbers(scale, low, high)
    positions = scale.normalised(values * size)
    apart = (values == 0.0) | (np.abs(positions - scale.normalised(np.zeros(1))) > _LEAST_APART)
    return positions[apart], [f"{value:.3g}" for value in values[apart]], symbol


def _round_numbers(scale, low, high):
    """Rising, from low to high, about as many as a scale has in its own unit."""
    if scale.mapping == "linear":
        step = handy_spacing(high - low, _PARTS)
        return step * np.arange(np.ceil(low / step - 1e-9), np.floor(high / step + 1e-9) + 1.0)
    decades = np.floor(np.log10(high)) - np.arange(_DECADES)
    return np.concatenate([-(10.0**decades), [0.0], 10.0 ** decades[::-1]])


def _rectangles(places, shades):
    """Two triangles each of (left, low, right, high), coloured from below to above."""
    points, colours = [], []
    for (left, low, right, high), (below, above) in zip(places, shades):
        corners = ((left, low, 0.0), (right, low, 0.0), (right, high, 0.0), (left, high, 0.0))
        own = (below, below, above, above)
        points += [corners[i] for i in _CORNERS]
        colours += [own[i] for i in _CORNERS]
    return points, colours
