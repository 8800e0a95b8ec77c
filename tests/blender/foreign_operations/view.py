# SPDX-License-Identifier: GPL-3.0-or-later
"""Where operators are called: in the 3D view where there is a window, in no view where not."""

from contextlib import nullcontext

import bpy
from window import Window


def in_view():
    """The context of the 3D view, to be used by `with`: a timer has none of its own. A file that is
    loaded brings another window, which has to be entered anew."""
    return nullcontext() if bpy.app.background else Window().in_view()


def open_sidebar():
    """What is to be done, one after the other with Blender's own work between, until the sidebar
    shows the panels."""
    window = Window()
    window.open_sidebar()
    return window.actions
