# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots laid out: each on a card in millimetres, and the cards in a corner of a 3D view, one beside
or above the other.

Where they are follows from the view, the plots and what the user prefers. Who draws them and who
works in them with the mouse ask for it here, and nobody has to tell the other.
"""

from dataclasses import dataclass

from ...bridge import native
from ...bridge.blender import view_room

_MARGIN_MM = 3.0
_GAP = 12.0  # dots between cards and to the region's border, at a scale of 1

CORNERS = ("BOTTOM_LEFT", "BOTTOM_RIGHT", "TOP_LEFT", "TOP_RIGHT")


@dataclass(frozen=True)
class Placement:
    """Where the cards are: the corner that they start from, and the size of each."""

    corner: str = "BOTTOM_LEFT"
    width_mm: float = 125.0
    height_mm: float = 88.0

    @classmethod
    def sized(cls, corner, size):
        """Cards `size` times as large as the usual ones; their texts stay as large."""
        return cls(corner, size * cls.width_mm, size * cls.height_mm)

    def __post_init__(self):
        if self.corner not in CORNERS:
            raise ValueError(f"a corner is one of {', '.join(CORNERS)}, not {self.corner!r}")


@dataclass(frozen=True, eq=False)
class Card:
    """A hull_native.Plot and its hull_native.PlotSheet on a card of this size."""

    plot: object
    sheet: object
    width_mm: float
    height_mm: float


def card_of(plot, placement):
    """The Card of a plot; ValueError where it cannot be laid out on one of that size."""
    width_mm, height_mm = placement.width_mm, placement.height_mm
    sheet = native.require().lay_out_plot(
        plot, width_mm=width_mm, height_mm=height_mm, margin_mm=_MARGIN_MM
    )
    return Card(plot, sheet, width_mm, height_mm)


@dataclass(frozen=True)
class Place:
    """A Card in a region: its lower left corner, and dots a millimetre. Rectangles are (left,
    bottom, right, top), dots of the region."""

    card: Card
    corner: tuple
    dots: float

    @property
    def rectangle(self):
        """All of the card."""
        (x, y), card, dots = self.corner, self.card, self.dots
        return x, y, x + card.width_mm * dots, y + card.height_mm * dots

    @property
    def diagram(self):
        """Between the axes of the plot."""
        left, top, right, bottom = self.card.sheet.diagram
        (x, _), high, dots = self.corner, self.rectangle[3], self.dots
        return x + left * dots, high - bottom * dots, x + right * dots, high - top * dots


def places_of(cards, corner, area, region, ui_scale, factor=1.0):
    """The Place of each of some Cards in a region of a 3D view, in order; [] where the view shows
    no overlays. They and their texts are as large as the scale of the user interface has it, times
    a factor."""
    space = area.spaces.active
    if not cards or not space.overlay.show_overlays:
        return []
    dots = view_room.DOTS_PER_MM * ui_scale * factor
    sizes = [(card.width_mm * dots, card.height_mm * dots) for card in cards]
    room = view_room.free_room(area, region)
    if corner == "TOP_LEFT":
        room = view_room.below_texts(room, space, ui_scale)
    places, smaller = in_room(sizes, corner, room, _GAP * ui_scale)
    return [Place(card, place, dots * smaller) for card, place in zip(cards, places)]


def in_room(sizes, corner, room, gap):
    """Lower left corners of cards in dots, and one factor by which all are made smaller.

    sizes: (width, height) of each in dots; room: (left, bottom, width, height) of the free part of
    the region. Cards stand beside one another, in a new row where there is no more room.
    """
    left, bottom, room_width, room_height = room
    factor = 1.0
    while True:
        rows, used = _rows([(w * factor, h * factor) for w, h in sizes], room_width, gap)
        if used[0] <= room_width and used[1] <= room_height:
            break
        factor *= 0.9
        if factor < 0.2:
            break
    places = []
    y = gap
    for row in rows:
        x = gap
        for width, height in row:
            at_x = left + (room_width - x - width if corner.endswith("RIGHT") else x)
            at_y = bottom + (room_height - y - height if corner.startswith("TOP") else y)
            places.append((at_x, at_y))
            x += width + gap
        y += max(height for _, height in row) + gap
    return places, factor


def _rows(sizes, room_width, gap):
    rows, x = [], gap
    for width, height in sizes:
        if not rows or x + width + gap > room_width:
            rows.append([])
            x = gap
        rows[-1].append((width, height))
        x += width + gap
    widest = max((sum(w + gap for w, _ in row) + gap for row in rows), default=0.0)
    tall = sum(max(h for _, h in row) + gap for row in rows) + gap
    return rows, (widest, tall)
