# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn over the 3D view. Each overlay has a headless half that makes arrays, and a half
that draws them with the graphics card."""

from . import (
    area_handles,
    fields,
    ghost,
    legend,
    lines,
    marks,
    morph_pairs,
    net,
    networks,
    plots,
    pulls,
    seams,
    spots,
    status,
    tags,
)

_PARTS = (
    *(net, ghost, lines, seams, networks, marks, tags),
    *(legend, spots, pulls, fields, morph_pairs),
)


def register():
    for part in _PARTS:
        part.register()
    plots.register()
    area_handles.register()  # over the plots
    status.register()


def unregister():
    status.unregister()
    area_handles.unregister()
    plots.unregister()
    for part in reversed(_PARTS):
        part.unregister()
