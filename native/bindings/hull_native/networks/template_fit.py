# SPDX-License-Identifier: GPL-3.0-or-later
"""A control mesh that lies near a network fitted to it as it is."""

import numpy as np

from .._core import LimitSurface, crease_curves, fit_surface, tolerances
from ..polylines import foot_on, lengths_along, points_at
from .network_targets import network_targets
from .sampling import on_spline

# Stiffness of the moves, step by step, and whether patches count. Where the layout can meet the
# curves, patches, which are between them as the network's are, would hold it off.
_STAGES = ((1e-3, True), (1e-4, True), (1e-5, False), (1e-6, False), (1e-7, False))
_STEPS = 30
# Places on an edge of the network: edges are long, where few curves cross.
_ON_EDGE = 16
# Parts of a chain's control edges, and of a spline's spans.
_PARTS = 6
# A chain that is as long as this part of a curve is all of it.
_WHOLE = 0.8


def fit_template(network, layout, progress=None):
    """The LimitSurface with the faces, creases and corners of a LimitSurface on a network.

    Creases and borders go along those of the network that they are nearest to. Points in the centre
    plane stay there. progress: a callable that takes the share done; what it raises ends it.
    """
    mesh = layout.mesh
    points = np.array(mesh.points)
    curves = _lines_of_chains(network, layout)
    targets = network_targets(network, _ON_EDGE)
    central = np.flatnonzero(np.abs(points[:, 1]) < tolerances.ON_CENTRE_PLANE * mesh.size)
    surface = layout
    for stage, (stiffness, with_patches) in enumerate(_STAGES):
        chosen = slice(None) if with_patches else targets.on_curves
        found = fit_surface(
            surface,
            targets.points[chosen],
            weights=targets.weights[chosen],
            curves=curves,
            held_points=central,
            held_normals=np.tile([0.0, 1.0, 0.0], (len(central), 1)),
            stiffness=stiffness,
            fairness=0.0,
            most_steps=_STEPS,
            draw_border=True,
            progress=_share(progress, stage),
        )
        surface = LimitSurface(mesh.with_points(found.points), layout.scheme)
    return surface


def _share(progress, stage):
    if progress is None:
        return None
    return lambda share: progress((stage + share) / len(_STAGES))


def _lines_of_chains(network, layout):
    """Of each crease and border of the layout the stretch of a curve of the network, as
    fit_surface() takes it."""
    borders, creases = [], []
    for curve, (border, crease, _) in enumerate(network.roles):
        if border:
            borders.append(network_curve_points(network, curve))
        elif crease or network.curves[curve].kind == "knuckle":
            creases.append(network_curve_points(network, curve))
    curves = []
    for number, chain in enumerate(crease_curves(layout)):
        lines = borders if chain.kind == "border" else creases
        if not lines or chain.closed:
            continue
        at = np.linspace(0.0, chain.edge_count, _PARTS * chain.edge_count + 1)
        places = np.asarray(chain.evaluate(at, 0)[0])
        line = min(lines, key=lambda line: _apart(places, line))
        stretch, is_whole = _stretch(line, places)
        curves.append((stretch, number, is_whole))
    return curves


def _apart(places, line):
    """Mean distance of a chain from a line, m; and back where it is as long."""
    lengths = lengths_along(line)
    there = np.mean([foot_on(line, lengths, place)[1] for place in places])
    if lengths_along(places)[-1] < _WHOLE * lengths[-1]:
        return there
    own = lengths_along(places)
    return there + np.mean([foot_on(places, own, place)[1] for place in line])


def _stretch(line, places):
    lengths = lengths_along(line)
    if lengths_along(places)[-1] > _WHOLE * lengths[-1]:
        return line, True
    feet = [foot_on(line, lengths, place)[0] for place in places]
    return points_at(line, lengths, np.linspace(min(feet), max(feet), len(places))), False


def network_curve_points(network, curve):
    """(n, 3) m: places on a curve of a network from end to end, its pieces one after the other;
    beyond the last curve that it meets, too."""
    parts = []
    for degree, knots, points, weights in network.pieces(curve):
        spans = np.unique(knots)
        shares = np.arange(_PARTS) / _PARTS
        at = np.append((spans[:-1, None] + shares * np.diff(spans)[:, None]).ravel(), spans[-1])
        part = on_spline(degree, np.asarray(knots), points, weights, at)
        parts.append(part if not parts else part[1:])
    return np.concatenate(parts)
