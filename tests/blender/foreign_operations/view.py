# SPDX-License-Identifier: GPL-3.0-or-later
"""Where operators are called: in the 3D view where there is a window, in no view where not."""

from contextlib import nullcontext

import bpy
from window import Window


def in_view():
    """The context of the 3D view, to be used by `with`: a timer has none of its own. A file that is
    loaded brings another window, which has to be entered anew."""
    return nullcontext() if bpy.app.background else Window().in_view()


def make_small(has_sidebar):
    """Leaves the 3D view a part of its area: the least window that Blender makes has 640 × 480
    dots, and to draw it takes longer than all else where the processor draws."""
    for direction in ("VERTICAL",) if has_sidebar else ("VERTICAL", "HORIZONTAL"):
        with in_view():
            bpy.ops.screen.area_split(direction=direction, factor=0.5)
        views = [a for a in Window().window.screen.areas if a.type == "VIEW_3D"]
        views[-1].type = "TEXT_EDITOR"


def open_sidebar():
    """What is to be done, one after the other with Blender's own work between, until the sidebar
    shows the panels."""
    window = Window()
    window.open_sidebar()
    return window.actions
