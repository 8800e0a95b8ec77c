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
    dots, and to draw it takes longer than all else where the processor draws. A sidebar needs the
    whole breadth, and has the tab Hull 160 dots below its upper end."""
    if has_sidebar:
        _halve("HORIZONTAL", 0.4)
    else:
        _halve("HORIZONTAL", 0.5)
        _halve("VERTICAL", 0.5)


def _halve(direction, factor):
    with in_view():
        bpy.ops.screen.area_split(direction=direction, factor=factor)
    views = [area for area in Window().window.screen.areas if area.type == "VIEW_3D"]
    min(views, key=lambda area: area.width * area.height).type = "TEXT_EDITOR"


def open_sidebar():
    """What is to be done, one after the other with Blender's own work between, until the sidebar
    shows the panels."""
    window = Window()
    window.open_sidebar()
    return window.actions
