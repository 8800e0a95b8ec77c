# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn over the 3D view. Each overlay has a headless half that makes arrays, and a half
that draws them with the graphics card."""

from . import plots


def register():
    plots.register()


def unregister():
    plots.unregister()
