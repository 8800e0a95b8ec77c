# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn over the 3D view. Each overlay has a headless half that makes arrays, and a half
that draws them with the graphics card."""

from ..bridge import live_analyses
from . import plots


def _view(shown, corner):
    plots.show(shown, plots.Placement(corner=corner))


def register():
    plots.register()
    live_analyses.plot_viewers.append(_view)


def unregister():
    live_analyses.plot_viewers.remove(_view)
    plots.unregister()
