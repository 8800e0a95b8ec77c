# SPDX-License-Identifier: GPL-3.0-or-later
"""Ghosts behind the lines of a hull, in one colour: the lines of the hull that it is compared with,
and its own before a preview of shape fields."""

from ..bridge.blender import preferences
from ..features.fields import before
from ..features.variants import ghosts
from .lines import WIDTHS, Pen, batch_of, depth_test, seen_then_hidden
from .view import Handler, hulls_in_view

_WIDTH = 0.8  # of theirs
_LAYER = 0.5  # of to_view: the hull's own lines are nearer


def _draw():
    for shown in hulls_in_view():
        groups = _groups_of(shown)
        if not groups:
            continue
        if shown.hull.hull.lines.in_front:
            with depth_test("NONE"):
                _draw_groups(shown, groups, 1.0)
        else:
            for alpha in seen_then_hidden():
                _draw_groups(shown, groups, alpha)


def _groups_of(shown):
    settings, groups = shown.hull.hull, []
    if settings.variants.show_ghost:
        groups += shown.state.of(ghosts.Ghost).groups.values()
    if settings.fields.is_previewed and settings.fields.show_before:
        groups += shown.state.of(before.Before).lines.groups.values()
    return groups


def _draw_groups(shown, groups, alpha):
    pen = Pen(shown, _LAYER)
    colour = (*preferences.colour("ghost", "ghost", shown.is_on_light), alpha)
    for group in groups:
        pen.draw(group, batch_of(group, pen.shader), _WIDTH * WIDTHS.get(group.kind, 1.0), colour)


_handler = Handler(_draw, "POST_VIEW")
register, unregister = _handler.register, _handler.unregister
