# SPDX-License-Identifier: GPL-3.0-or-later
"""Which ranges of a hull keep their shape while it is brought to other dimensions.

The bilge of its largest section, its bulb, the heights of its knuckles. Lengths are in metres.
"""

from dataclasses import dataclass
from math import inf, pi

import numpy as np

from .._core import crease_curves, hydrostatics, point_weights, section

# The bilge ends where the section bends less than this part of what it does at most there.
_BENT = 0.05
# A bilge turns by this at least, rad.
_LEAST_TURN = pi / 3.0
# Of the half beam: a bilge that begins nearer to the centre plane has no bottom beside it.
_LEAST_BOTTOM = 0.05
# Of Lpp: what reaches no further forward of the perpendicular is no bulb.
_LEAST_BULB = 0.005
# Of the length: a shorter crease is no knuckle line.
_LEAST_KNUCKLE = 0.1
# Of the mesh's size: nearer to the deck edge, or to the centre plane, a crease lies in it.
_NEAR = 1e-3
# Of the mesh's size: a crease with less of the hull's side above it is the deck edge.
_LEAST_SIDE = 1e-2
# Of what a bilge's arc turns: its radius is measured between, where no fairing of its ends counts.
_MIDDLE_HALF = (0.25, 0.75)
# Of the length, half beam or depth: control points that leave less to be changed are not kept all.
_FREE = 0.25
# Divisions of a cell's side where a bulb is sought.
_GRID = 8


@dataclass(frozen=True)
class Bilge:
    """At the station x: radius, the mean over the middle half of what the arc turns; inner: y of
    its lower end, where the bottom ends; upper: z of its upper one, where the side begins; shaped:
    the least y and the greatest z of the control points that shape it. half_beam: of the section.
    All in m."""

    x: float
    radius: float
    inner: float
    upper: float
    shaped: tuple
    half_beam: float


def kept_ranges(
    body, *, draft, length_pp=None, depth=None, bilge=False, bulb=False, knuckles=False
):
    """([(from, to)] along x, along y, along z), in m, of what is to be kept of a HullBody; ends may
    be infinite. ValueError, in a sentence, for what the hull does not have."""
    if (bilge or bulb) and not draft > 0.0:
        raise ValueError("Give the hull a draft first: bilge and bulb are looked for below it")
    along = ([], [], [])
    if bilge:
        found, top = bilge_of(body, draft), depth or body.surface.mesh.points[:, 2].max()
        inner, upper = found.shaped
        along[1].append((inner if inner > _FREE * found.half_beam else found.inner, inf))
        along[2].append((-inf, upper if upper < (1.0 - _FREE) * top else found.upper))
    if bulb:
        along[0].append((bulb_begin(body.surface, draft, length_pp), inf))
    if knuckles:
        along[2].append((-inf, knuckle_height(body.surface, depth)))
    return along


def bilge_of(body, draft, x=None):
    """The Bilge of the section at x, m, by default the largest one below the draft; ValueError
    where it has none."""
    if x is None:
        found = hydrostatics(body, draft=draft)
        if not found.displaced_volume > 0.0:
            raise ValueError(
                f"Nothing is under water at a draft of {draft:.3f} m: there is no bilge below it"
            )
        x = float(found.largest_section.position)
    name = f"The section at x {x:.2f} m"
    runs, curves = [], section(body.surface, "x", x)
    if not curves:
        raise ValueError(f"The hull has no section at x {x:.2f} m: choose a place within it")
    half_beam = max(float(curve.points[:, 1].max()) for curve in curves)
    for curve in curves:
        for stretch in curve.stretches:
            runs += _bends(curve, stretch)
    if not runs:
        raise ValueError(f"{name} has no bilge arc: there is no bilge radius " "to keep")
    _, radius, arc, cells, uv = max(runs, key=lambda run: run[0])
    inner = float(arc[:, 0].min())
    upper = float(arc[:, 1].max())
    below = np.concatenate([curve.points[curve.points[:, 2] <= upper, 1] for curve in curves])
    if not below.min() < _LEAST_BOTTOM * half_beam < inner:
        raise ValueError(
            f"{name} has no bottom between the centre plane and a "
            "bilge arc: there is nothing beside the bilge that could become wider"
        )
    points = _shaping(body.surface, cells, uv)
    shaped = float(points[:, 1].min()), float(points[:, 2].max())
    return Bilge(x, radius, inner, upper, shaped, half_beam)


def _bends(curve, stretch):
    """[(turn, radius, (y, z) (k, 2), cells, uv)] of the parts of a stretch of a section to port
    that bend outwards and turn as far as a bilge does."""
    points, curvatures = stretch.points[:, 1:], stretch.curvatures
    if len(points) < 3 or not curvatures.max() > 0.0:
        return []
    bent = (curvatures > _BENT * curvatures.max()) & (points[:, 0] >= 0.0)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], bent.astype(int), [0]])))
    found = []
    for begin, end in zip(edges[::2], edges[1::2]):
        part, bends = points[begin:end], curvatures[begin:end]
        steps = np.linalg.norm(np.diff(part, axis=0), axis=1)
        turned = np.concatenate([[0.0], np.cumsum(steps * 0.5 * (bends[1:] + bends[:-1]))])
        if turned[-1] >= _LEAST_TURN:
            arcs = np.concatenate([[0.0], np.cumsum(steps)])
            first, last = np.interp(np.array(_MIDDLE_HALF) * turned[-1], turned, arcs)
            share = _MIDDLE_HALF[1] - _MIDDLE_HALF[0]
            radius = float(last - first) / (share * turned[-1])
            own = slice(stretch.first + begin, stretch.first + end)
            found.append((turned[-1], radius, part, curve.cells[own], curve.uv[own]))
    return found


def _shaping(surface, cells, uv):
    """(k, 3) the control points that shape a surface at these places."""
    return surface.mesh.points[np.unique(point_weights(surface, cells, uv)[1])]


def bulb_begin(surface, draft, length_pp=None):
    """x from where the hull has a bulb, of all control points that shape what lies below the draft
    and beyond the fore perpendicular, or without Lpp the stem at the draft; from there itself where
    these reach too far aft. ValueError where there is none."""
    grid = surface.evaluate_grid(_GRID)[0].reshape(-1, 3)
    low, length = grid[:, 0].min(), np.ptp(grid[:, 0])
    begin = length_pp or max(
        (float(curve.points[:, 0].max()) for curve in section(surface, "z", draft)),
        default=low + length,
    )
    is_bulb = (grid[:, 0] > begin) & (grid[:, 2] < draft)
    if not is_bulb.any() or grid[is_bulb, 0].max() < begin + _LEAST_BULB * length:
        raise ValueError(
            f"Below the draft the hull does not reach beyond x {begin:.2f} m: there is no bulb to "
            "keep"
        )
    cells, place = np.divmod(np.flatnonzero(is_bulb), (_GRID + 1) ** 2)
    uv = np.stack(np.divmod(place, _GRID + 1), axis=1) / _GRID
    shaped = float(_shaping(surface, cells, uv)[:, 0].min())
    return shaped if shaped > low + _FREE * length else float(begin)


def knuckle_height(surface, depth=None):
    """The greatest z of the hull's knuckles, and of what shapes them: of creases along the ship
    that lie below the depth, without it below the deck, and are neither the deck edge nor in the
    centre plane. Where one ends within the surface, shaped from above that limit, its end is not
    counted. ValueError where there are none."""
    size = float(np.ptp(surface.mesh.points, axis=0).max())
    limit = (depth or float(surface.mesh.points[:, 2].max())) - _NEAR * size
    heights = []
    for curve in crease_curves(surface):
        t = np.linspace(0.0, curve.edge_count, 8 * curve.edge_count + 1)
        points = curve.evaluate(t)[0]
        own = surface.mesh.points[curve.vertices, 2]
        top = max(float(points[:, 2].max()), float(own.max()))
        if curve.kind == "crease" and top < limit and _is_knuckle(surface, points, size):
            shaped = float(_shaping(surface, *curve.left(t))[:, 2].max())
            heights.append(shaped if shaped < limit else top)
    if not heights:
        raise ValueError(
            "The hull has no knuckle that stays below its depth and its deck edge: there is no "
            "height to keep"
        )
    return max(heights)


def _is_knuckle(surface, points, size):
    if np.abs(points[:, 1]).max() < _NEAR * size or np.ptp(points[:, 0]) < _LEAST_KNUCKLE * size:
        return False
    middle = points[len(points) // 2]
    above = [
        curve.points[:, 2].max()
        for curve in section(surface, "x", middle[0])
        if (curve.points[:, 2] <= middle[2] + _NEAR * size).any()
    ]
    return bool(above) and max(above) > middle[2] + _LEAST_SIDE * size
