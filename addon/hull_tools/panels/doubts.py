# SPDX-License-Identifier: GPL-3.0-or-later
"""What can't be true of a hull, and what helps, as boxes in the panels of the hull and its mesh."""

from ..features.hull import remedies
from .shared import label_wrapped

# The buttons of mesh problems, by the kind of their remedy.
_MENDING = {
    "SPLIT": ("hull.split", "hull.set_aside"),
    "PORT": ("hull.mirror_to_port",),
    "CENTRE": ("hull.put_on_centre_plane",),
    "JOIN": ("hull.join_centre_line",),
    "POINTS": ("hull.join_points",),
    "TURN": ("hull.turn_outwards",),
}

_COUNTING = {"WHOLE": "Count as Whole", "HALF": "Count as Half"}


def draw_doubts(layout, context, state):
    """A box for each doubt of a HullState."""
    for doubt in () if state.status else state.plausible.doubts:
        box = layout.box()
        label_wrapped(box, context, doubt.message, icon="ERROR")
        if doubt.remedy == "TAKE":
            box.operator("hull.take_from_surface").names = set(doubt.takes)
        elif doubt.remedy == "KEEL":
            box.operator("hull.put_keel_on_base_line")
        elif doubt.remedy:
            button = box.operator("hull.count_sides", text=_COUNTING[doubt.remedy])
            button.sides = doubt.remedy


def draw_mending(layout, problem):
    """The buttons that mend a problem of the mesh check."""
    _draw_buttons(layout, problem.remedy)


def draw_volume_mending(layout, hull, state):
    """The buttons that help where the hull of a HullState has no volume, or a doubtful one."""
    for kind in remedies.of_volume(hull, state):
        if kind == "BORDERS":
            layout.operator("hull.select_creases", text="Select Borders").kind = "BORDER"
        elif kind == "MAKE_HALF":  # of sides that reach across by noise, too
            layout.operator("hull.make_half").cut = True
        else:
            _draw_buttons(layout, kind)


def _draw_buttons(layout, remedy):
    row = layout.row(align=True)
    for name in _MENDING.get(remedy, ()):
        row.operator(name)
