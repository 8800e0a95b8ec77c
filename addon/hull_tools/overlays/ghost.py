# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines of the hull that a hull is compared with, behind those of the hull, in one colour."""

from ..bridge.blender import preferences
from ..features.variants import ghosts
from .lines import HIDDEN_ALPHA, WIDTHS, Pen, batch_of, depth_test
from .view import Handler, hulls_in_view

_WIDTH = 0.8  # of theirs
_LAYER = 0.5  # of to_view: the hull's own lines are nearer


def _draw():
    for shown in hulls_in_view():
        if not shown.hull.hull.variants.show_ghost:
            continue
        groups = shown.state.of(ghosts.Ghost).groups.values()
        if shown.hull.hull.lines.in_front:
            _draw_groups(shown, groups, "NONE", 1.0)
        else:
            _draw_groups(shown, groups, "GREATER", HIDDEN_ALPHA)
            _draw_groups(shown, groups, "LESS_EQUAL", 1.0)


def _draw_groups(shown, groups, depth, alpha):
    pen = Pen(shown, _LAYER)
    colour = (*preferences.colour("ghost", "ghost", shown.is_on_light), alpha)
    with depth_test(depth):
        for group in groups:
            pen.draw(
                group, batch_of(group, pen.shader), _WIDTH * WIDTHS.get(group.kind, 1.0), colour
            )


_handler = Handler(_draw, "POST_VIEW")
register, unregister = _handler.register, _handler.unregister
