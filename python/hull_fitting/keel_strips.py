# SPDX-License-Identifier: GPL-3.0-or-later
"""Shells that end a little beside the centre plane, as at the sides of a bar keel, closed to it."""

import numpy as np

from .borders import border_edges, joined_lines
from .half_meshes import HalfMesh
from .polyline_parts import parts_between_turns

# Of the length: a border is along the ship; seams are no wider, and lines go on over such gaps. Of
# the half-breadth: it is beside the centre plane.
_LONG, _SEAM, _GAP, _BESIDE = 0.5, 3e-4, 5e-3, 0.04


def closed_to_centre(mesh):
    """(the HalfMesh with a strip from a border beside the centre plane to that, where none is in
    it; how far that is beside it, m, 0 where there is no strip)."""
    central, others = border_edges(mesh.points, mesh.triangles, _SEAM * mesh.length)
    if len(central) and np.ptp(mesh.points[central][:, :, 0]) > _LONG * mesh.length:
        return mesh, 0.0
    lines = joined_lines(mesh.points, np.concatenate([central, others]), _GAP * mesh.length)
    parts = [part for line in lines for part in parts_between_turns(line)]
    widest, least = _BESIDE * mesh.points[:, 1].max(), _LONG * mesh.length
    parts = [part for part in parts if part[:, 1].max() < widest and np.ptp(part[:, 0]) > least]
    if not parts:
        return mesh, 0.0
    keel = min(parts, key=lambda part: part[:, 2].mean())
    return _with_strip(mesh, keel), float(keel[:, 1].max())


def _with_strip(mesh, line):
    """Points of the line are the mesh's own: the strip hangs together with it."""
    own = np.array([np.flatnonzero((mesh.points == place).all(axis=1))[0] for place in line])
    inner = np.where(line[:, 1] == 0.0, own, len(mesh.points) + np.arange(len(line)))
    a, b, c, d = own[:-1], own[1:], inner[1:], inner[:-1]
    strip = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    following = np.roll(strip, -1, axis=1)
    strip = strip[(strip != following).all(axis=1)]
    if _is_along(mesh.triangles, own[0], own[1]):
        strip = strip[:, ::-1]
    points = np.concatenate([mesh.points, line * [1.0, 0.0, 1.0]])
    return HalfMesh(points, np.concatenate([mesh.triangles, strip]), mesh.length)


def _is_along(triangles, a, b):
    """Whether the triangle at the border's edge from a to b runs that way round."""
    return bool(((triangles == a) & (np.roll(triangles, -1, axis=1) == b)).any())
