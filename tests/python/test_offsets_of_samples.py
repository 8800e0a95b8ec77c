# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of offsets: each point lies on the exact surface, wherever points of the stations are."""

import hull_native as hn
import numpy as np
import pytest
from production_hulls import SAMPLES, body_of

STATIONS, WATERLINES, BUTTOCKS = 60, 60, 20


def between(values, count):
    """Positions that are none of the hull's own."""
    low, high = values.min(), values.max()
    return np.linspace(low, high, count + 2)[1:-1] + 1e-3 * (high - low) / count


@pytest.mark.parametrize("name", SAMPLES)
def test_offsets_are_of_the_surface(name):
    """To 1e-7 of the size, the chords' tolerance. Where a station runs flat, its points within a
    ten-millionth of a waterline are further from where it crosses than that."""
    surface = body_of(name)[0].surface
    points, tree = surface.mesh.points, hn.SurfaceTree(surface)
    x, y, z = (
        between(np.maximum(points[:, axis], 0.0) if axis == 1 else points[:, axis], count)
        for axis, count in enumerate((STATIONS, BUTTOCKS, WATERLINES))
    )
    table = hn.offset_table(surface, stations=x, waterlines=z, buttocks=y)
    half_breadths = np.reshape(table.half_breadths, (STATIONS, WATERLINES))
    heights = np.reshape(table.heights, (STATIONS, BUTTOCKS))
    for found, others, axis in ((half_breadths, z, 1), (heights, y, 2)):
        at = np.stack(np.broadcast_arrays(x[:, None], found, others), axis=-1)
        if axis == 2:
            at = at[..., [0, 2, 1]]
        # A half-breadth of none is the centre line's, at the stem and below the keel.
        is_there = np.isfinite(found) & (found > 0.0) if axis == 1 else np.isfinite(found)
        at = at[is_there]
        off = np.linalg.norm(tree.closest_points(at).points - at, axis=1)
        assert len(at) > 300 and off.max() < 1e-7 * surface.mesh.size
