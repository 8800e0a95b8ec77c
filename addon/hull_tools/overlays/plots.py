# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots over the 3D view: cards in a corner, one beside or above the other.

features.analyses has which plots are on, laid out, and says where they are; drawing reads it. A
card goes to the graphics card once.
"""

import weakref

import bpy
import gpu

from ..features.analyses import live_analyses
from . import plot_arrays, plot_cards
from .view import Handler

_cards = weakref.WeakKeyDictionary()  # by plot_layout.Card: plot_cards.Card


def _draw():
    context = bpy.context
    if context.area is None or context.region is None:
        return
    now = live_analyses.plots()
    places = live_analyses.places(context.area, context.region)
    viewport = (context.region.width, context.region.height)
    blend = gpu.state.blend_get()
    for one, place in zip(now.shown, places):
        card = _card_of(place.card)
        card.draw(place.corner, place.dots, viewport)
        if not one.is_current:
            card.draw_veil(place.corner, place.dots)
    gpu.state.blend_set(blend)


def _card_of(laid_out):
    if laid_out not in _cards:
        _cards[laid_out] = plot_cards.Card(plot_arrays.arrays_of(laid_out))
    return _cards[laid_out]


_handler = Handler(_draw, "POST_PIXEL")
register = _handler.register


def unregister():
    _handler.unregister()
    _cards.clear()
