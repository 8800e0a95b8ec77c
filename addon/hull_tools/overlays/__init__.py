# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn over the 3D view. Each overlay has a headless half that makes arrays, and a half
that draws them with the graphics card."""

from ..features.analyses import live_analyses
from . import legend, lines, marks, net, plots, pulls, spots, status, tags

_PARTS = (net, lines, marks, tags, legend, spots, pulls)


def _view(shown, settings):
    placement = None
    if settings is not None:
        placement = plots.Placement.sized(settings.corner, settings.size)
    outdated = {index for index, one in enumerate(shown) if not one.is_current}
    plots.show([one.plot for one in shown], placement, outdated)


def register():
    for part in _PARTS:
        part.register()
    plots.register()
    status.register()  # over the plots
    live_analyses.plot_viewers.append(_view)


def unregister():
    live_analyses.plot_viewers.remove(_view)
    status.unregister()
    plots.unregister()
    for part in reversed(_PARTS):
        part.unregister()
