# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines of equal value on a surface of triangles; arrays only."""

import numpy as np

from ...bridge import native

# Where the lines of a field's intensity are, from its base outwards; 0 is its extent.
INTENSITIES = (0.75, 0.5, 0.25, 0.0)
# So finely a field's intensity is looked up between its base and its extent.
_STEPS = 401


def distances_of(intensities, falloff):
    """(k,) distances from a base, as parts of the extent, at which a field of this falloff has
    these intensities (k,), from 0 to 1."""
    kind, away = native.require(), np.linspace(0.0, 1.0, _STEPS)
    field = kind.ShapeField.at_point((0, 0, 0), (1, 0, 0), extent=1.0, falloff=falloff)
    places = np.column_stack([away, np.zeros((_STEPS, 2))])
    found = kind.ShapeFields([field]).at(places)[0][:, 0]
    return np.interp(intensities, found[::-1], away[::-1])


def from_a_rim(distances):
    """Distances (k,) from the rim of a region, where those from a point, a curve or a plane are
    these: delta² (2 - delta) takes the place of delta there."""
    away = np.linspace(0.0, 1.0, _STEPS)
    return np.interp(distances, away**2 * (2.0 - away), away)


def triangles_of(quads):
    """(2 k, 3) points of the triangles of quadrilaterals (k, 4)."""
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def segments(points, triangles, values, level):
    """(m, 2, 3) segments in which values (n,) at points (n, 3), linear between them, have a level
    on triangles (t, 3) of these points."""
    is_above = values >= level
    counts = is_above[triangles].sum(axis=1)
    cut = triangles[(counts == 1) | (counts == 2)]
    above = is_above[cut]
    # The corner that is alone on its side of the level: both its edges are cut.
    odd = (above == (above.sum(axis=1) == 1)[:, None]).argmax(axis=1)
    rows = np.arange(len(cut))
    alone = cut[rows, odd]
    ends = [_crossings(points, values, level, alone, cut[rows, (odd + i) % 3]) for i in (1, 2)]
    return np.stack(ends, axis=1)


def _crossings(points, values, level, starts, ends):
    parts = (level - values[starts]) / (values[ends] - values[starts])
    return points[starts] + parts[:, None] * (points[ends] - points[starts])
