# SPDX-License-Identifier: GPL-3.0-or-later
"""Paired lines of a family, over the hulls that they are of, in one colour each."""

from ..features.morphing import pair_lines
from .lines import Pen, batch_of, seen_then_hidden
from .view import Handler, hulls_in_view

_WIDTH = 2.5  # of the hull's lines
_LAYER = 2  # of to_view: nearer than the hull's own lines


def wanted(shown_hulls):
    """Pairs (HullInView, PairLine) to be drawn, of HullInViews."""
    found = []
    by_address = {shown.hull.as_pointer(): shown for shown in shown_hulls}
    for shown in shown_hulls:
        for line in shown.state.of(pair_lines.PairLines).lines:
            own = by_address.get(line.address)
            if own is not None and own.state.ship.geometry_key == line.geometry_key:
                found.append((own, line))
    return found


def _draw():
    lines = wanted(list(hulls_in_view()))
    for alpha in seen_then_hidden():
        for shown, line in lines:
            pen = Pen(shown, _LAYER)
            pen.draw(line, batch_of(line, pen.shader), _WIDTH, (*line.colour, alpha))


_handler = Handler(_draw, "POST_VIEW")
register, unregister = _handler.register, _handler.unregister
