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


@pytest.mark.parametrize("off", [-9e-7, -1e-8, 0.0, 9e-7])
def test_a_step_has_its_outer_edge(off):
    """A waterline at the height of a spray rail's flat, as far as positions tell."""
    surface = body_of("planing_boat")[0].surface
    size = surface.mesh.size
    (curve,) = hn.section(surface, "x", 2.28)
    y, z = curve.points[:, 1:].T
    flat = np.flatnonzero(np.abs(np.diff(z)) < 1e-12 * size)
    flat = flat[np.abs(z[flat] - z[flat[0]]) < 1e-12 * size]  # of the lowest rail
    outer = y[flat + 1].max()
    assert outer - y[flat].min() > 0.05
    table = hn.offset_table(
        surface, stations=[2.28], waterlines=[z[flat[0]] + off * size], buttocks=[]
    )
    # Beyond it the bottom goes on at an angle.
    assert table.half_breadths[0] == pytest.approx(outer, abs=5e-6 * size)
