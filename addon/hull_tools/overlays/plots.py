# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots over the 3D view: cards in a corner, one beside or above the other.

`follow` reads which plots are on and where, and has their arrays made where something changed.
"""

from dataclasses import dataclass

import bpy
import gpu

from ..bridge.blender import preferences
from ..features.analyses import live_analyses
from . import plot_arrays, plot_cards

# At a user interface scale of 1 a text of 2.5 mm has 11 dots, as Blender's own.
DOTS_PER_MM = 4.4

_GAP = 12.0  # dots between cards and to the region's border, at a scale of 1
_TEXTS = 56.0  # dots that Blender's own texts take at the top on the left, at a scale of 1

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


class _Shown:
    """What is on now, with the cards made of it at the first drawing."""

    def __init__(self):
        self.plots = []
        self.names = ()
        self.placement = Placement()
        self.outdated = frozenset()
        self.arrays = []
        self.cards = None


_shown = _Shown()
_handler = None


def show(plots, placement=None, outdated=(), names=()):
    """Shows these hull_native.Plot, and no others; an empty list shows none.

    names: the analyses that they are of, if it is to be noted where they are. outdated: indices of
    those that a newer one is computed for; they are drawn pale. Nothing is done when they and their
    places are what is shown already. ValueError when one cannot be laid out on a card of that size;
    what was shown then stays.
    """
    plots, placement = list(plots), placement or Placement()
    outdated, _shown.names = frozenset(outdated), tuple(names)
    if plots == _shown.plots and placement == _shown.placement:
        _shown.outdated = outdated
        return
    arrays = [
        plot_arrays.arrays_of(plot, placement.width_mm, placement.height_mm) for plot in plots
    ]
    _shown.plots, _shown.placement, _shown.arrays = plots, placement, arrays
    _shown.outdated = outdated
    _shown.cards = None


def follow():
    """Shows what features.analyses has to show now."""
    now = live_analyses.plots()
    outdated = {index for index, one in enumerate(now.shown) if not one.is_current}
    placement = Placement.sized(now.corner, now.size)
    show([one.plot for one in now.shown], placement, outdated, [one.name for one in now.shown])


def hide():
    show([])


def shown_arrays():
    """The PlotArrays being drawn, in order."""
    return tuple(_shown.arrays)


def shown_outdated():
    """Indices of those of them that are drawn pale."""
    return _shown.outdated


def card_places(sizes, corner, room, gap):
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


def free_room(area, region):
    """(left, bottom, width, height) of the region that toolbar, sidebar and header leave free."""
    left, right = 0, region.width
    bottom, top = 0, region.height
    for other in area.regions:
        if other.width <= 1 or other.height <= 1 or other.type == "WINDOW":
            continue
        x, y = other.x - region.x, other.y - region.y
        overlaps = x < region.width and x + other.width > 0 and y < region.height
        if not overlaps or y + other.height <= 0:
            continue
        if other.type in {"TOOLS", "UI"}:
            if x > region.width / 2:
                right = min(right, x)
            else:
                left = max(left, x + other.width)
        elif other.type in {"HEADER", "TOOL_HEADER"}:
            if y > region.height / 2:
                top = min(top, y)
            else:
                bottom = max(bottom, y + other.height)
    return left, bottom, right - left, top - bottom


def below_texts(room, context):
    """A `free_room` without what Blender's own texts at its top take, where they are shown."""
    left, bottom, width, height = room
    if context.space_data.overlay.show_text:
        height = max(height - _TEXTS * context.preferences.system.ui_scale, 0.0)
    return left, bottom, width, height


def _draw():
    follow()
    context = bpy.context
    if context.area is None or context.region is None:
        return
    if not _shown.arrays or not context.space_data.overlay.show_overlays:
        live_analyses.note_diagrams(context.area, {})
        return
    if _shown.cards is None:
        _shown.cards = [plot_cards.Card(arrays) for arrays in _shown.arrays]
    scale = context.preferences.system.ui_scale
    dots = DOTS_PER_MM * scale * preferences.value("plot_size")
    sizes = [(one.width_mm * dots, one.height_mm * dots) for one in _shown.arrays]
    room = free_room(context.area, context.region)
    if _shown.placement.corner == "TOP_LEFT":
        room = below_texts(room, context)
    places, factor = card_places(sizes, _shown.placement.corner, room, _GAP * scale)
    _note_diagrams(context.area, places, dots * factor)
    viewport = (context.region.width, context.region.height)
    blend = gpu.state.blend_get()
    for index, (card, place) in enumerate(zip(_shown.cards, places)):
        card.draw(place, dots * factor, viewport)
        if index in _shown.outdated:
            card.draw_veil(place, dots * factor)
    gpu.state.blend_set(blend)


def _note_diagrams(area, places, dots):
    noted = {}
    for name, arrays, (x, y) in zip(_shown.names, _shown.arrays, places):
        left, top, right, bottom = arrays.diagram
        high = y + arrays.height_mm * dots
        axes = x + left * dots, high - bottom * dots, x + right * dots, high - top * dots
        noted[name] = axes, (x, y, x + arrays.width_mm * dots, high)
    live_analyses.note_diagrams(area, noted)


def register():
    global _handler
    if not bpy.app.background:
        _handler = bpy.types.SpaceView3D.draw_handler_add(_draw, (), "WINDOW", "POST_PIXEL")


def unregister():
    global _handler
    hide()
    if _handler is not None:
        bpy.types.SpaceView3D.draw_handler_remove(_handler, "WINDOW")
        _handler = None
