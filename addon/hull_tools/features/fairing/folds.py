# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces that moves of control points would turn over."""

import numpy as np

# Of the sides of a cell: where normals are looked at, beside its corners and in the middle.
_PLACES = (0.1, 0.5, 0.9)


def refuse(surface, moved):
    """ValueError, with the place, where hull_native.LimitSurface `moved`, of which control points
    alone differ from `surface`, has its normal turned by more than a right angle."""
    uv = np.stack(np.meshgrid(_PLACES, _PLACES), axis=-1).reshape(-1, 2)
    cells = np.repeat(np.arange(surface.cell_count), len(uv))
    uv = np.tile(uv, (surface.cell_count, 1))
    turned = (surface.normals(cells, uv) * moved.normals(cells, uv)).sum(axis=1) < 0.0
    if not turned.any():
        return
    first = np.flatnonzero(turned)[:1]
    ((x, y, z),) = surface.evaluate(cells[first], uv[first])[0]
    raise ValueError(
        f"The surface would be turned over at ({x:.2f}, {y:.2f}, {z:.2f}) m: give a smaller "
        "deviation"
    )
