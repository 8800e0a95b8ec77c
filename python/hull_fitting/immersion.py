# SPDX-License-Identifier: GPL-3.0-or-later
"""Displacement and wetted surface of a half hull of triangles, both sides counted."""

import numpy as np

from .beside import normals_of
from .half_meshes import clipped


def immersed(points, triangles, outline, draft):
    """(∇ m³, wetted surface m²) of the whole hull below z = draft. triangles (m, 3): the shell of
    the port half, counter-clockwise from outside; the ends of the outline that are flat are closed,
    and counted in the surface where they have faces."""
    volume = area = 0.0
    origin = np.array([outline.low[0], 0.0, draft])
    parts = [(points, triangles, True)]
    for name, line in (("aft", outline.aft), ("forward", outline.forward)):
        if line is not None:
            parts.append((*_fan(line, name), name in outline.ends))
    for corners, faces, is_wetted in parts:
        below, faces = clipped(corners, faces, 2, draft, keep_above=False)
        a, b, c = (below[faces] - origin).transpose(1, 0, 2)
        volume += float(np.einsum("ij,ij->i", np.cross(a, b), c).sum()) / 3.0
        if is_wetted:
            area += 2.0 * float(normals_of(below, faces)[1].sum()) if len(faces) else 0.0
    return volume, area


def _fan(line, name):
    """(points, triangles) of a flat end between its border, upwards, and the centre plane."""
    centre = line[-1] * [1.0, 0.0, 1.0]
    centre[0] = line[0, 0] + _slope(line) * (centre[2] - line[0, 2])
    number = len(line)
    first = np.arange(number - 1)
    fan = np.stack([first, first + 1, np.full(number - 1, number)], axis=1)
    return np.vstack([line, centre]), fan if name == "forward" else fan[:, ::-1]


def _slope(line):
    """dx/dz of an end that leans."""
    heights = line[:, 2] - line[0, 2]
    return float(heights @ (line[:, 0] - line[0, 0])) / max(float(heights @ heights), 1e-300)
