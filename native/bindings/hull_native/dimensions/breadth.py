# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls brought to wanted numbers without becoming wider than they are. Lengths are in metres."""

import numpy as np

from .._core import FormTarget, LimitSurface, reach_targets
from .mapped_surface import surface_ends

# Divisions of a cell's side where the widest places are looked for, and of what is left around them
# at each look.
_GRID, _CLOSER, _LOOKS = 6, 2, 14
# Of the half breadth: by so much the surface may be wider, as single precision rounds points.
_WIDER = 1e-7
# Rounds of which the targets were met, and of which not all were: those take long, and what is
# reached is not wanted so anyway.
_MOST_ROUNDS, _MOST_IN_VAIN = 20, 4
# A breadth is rather kept than a number met.
_WEIGHT = 100.0


def widest_places(surface, beyond):
    """(cells (k,), uv (k, 2), y (k,)) where the surface lies farther than `beyond` from the centre
    plane and not less far than around, in each cell."""
    y = np.abs(surface.evaluate_grid(_GRID)[0][..., 1]).reshape(-1, _GRID + 1, _GRID + 1)
    around = np.pad(y, ((0, 0), (1, 1), (1, 1)), constant_values=-np.inf)
    least = np.full(y.shape, np.inf)
    for i in range(3):
        for j in range(3):
            part = around[:, i : i + _GRID + 1, j : j + _GRID + 1]
            least = np.minimum(least, y - part)
    # A peak between places of the grid is higher than they by an eighth of what bends there, each
    # way: by less than all of it, where the surface bends as between others.
    bent = sum(np.abs(np.diff(y, 2, axis=axis)).max(axis=(1, 2)) for axis in (1, 2))
    cells, i, j = np.nonzero((least >= 0.0) & (y > beyond - bent[:, None, None]))
    uv = np.stack([i, j], axis=1) / _GRID
    half = 1.0 / _GRID
    for _ in range(_LOOKS):
        uv, half = _closer(surface, cells, uv, half), half / _CLOSER
    found = surface.evaluate(cells, uv)[0][:, 1] if len(cells) else np.empty(0)
    wide = np.abs(found) > beyond
    return cells[wide], uv[wide], found[wide]


def _closer(surface, cells, uv, half):
    """The widest places of grids that reach so far around uv (k, 2)."""
    if not len(cells):
        return uv
    steps = np.linspace(-half, half, 2 * _CLOSER + 1)
    offsets = np.stack(np.meshgrid(steps, steps, indexing="ij"), axis=-1).reshape(-1, 2)
    tried = np.clip(uv[:, None] + offsets, 0.0, 1.0)
    count = len(offsets)
    points = surface.evaluate(np.repeat(cells, count), tried.reshape(-1, 2))[0]
    best = np.abs(points[:, 1]).reshape(-1, count).argmax(axis=1)
    return tried[np.arange(len(cells)), best]


def half_breadth(surface):
    """The greatest distance of a surface from the centre plane."""
    low, high = surface_ends(surface)
    return float(max(-low[1], high[1]))


def reach_within_breadth(surface, targets, *, progress=None, **options):
    """(TargetsReached, whether the breadth binds): reach_targets() of moves by which the surface
    nowhere becomes wider than it is at its widest, before dimensions are scaled.

    Places where it would are bounded, and it is solved anew, until there are none. What is reached
    has their rows after those of the targets.
    """
    limit = half_breadth(surface)
    targets, bounds = list(targets), []
    changed = LimitSurface(surface.mesh, surface.scheme)
    in_vain = 0
    for step in range(_MOST_ROUNDS):
        reached = reach_targets(
            surface, [*targets, *bounds], progress=_part(progress, step), **options
        )
        changed.set_points((surface.mesh.points + reached.moves) / reached.scale)
        places = widest_places(changed, (1.0 + _WIDER) * limit)
        in_vain += reached.status != "met"
        if not len(places[0]) or in_vain == _MOST_IN_VAIN:
            break
        bounds += [_bound(limit, *place) for place in zip(*places)]
    binds = np.abs(reached.prices[len(targets) :]) > 0.0
    return reached, bool(binds.any())


def _part(progress, step):
    if progress is None:
        return None
    left = 0.5**step
    return lambda share: progress(1.0 - left * (1.0 - 0.5 * share))


def _bound(limit, cell, uv, y):
    return FormTarget(
        "coordinate",
        limit,
        sense="at most",
        place=(int(cell), *map(float, uv)),
        direction=(0.0, float(np.sign(y)), 0.0),
        weight=_WEIGHT,
    )
