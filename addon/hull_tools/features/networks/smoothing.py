# SPDX-License-Identifier: GPL-3.0-or-later
"""A curve of a network smoothed within a mean deviation M (Dierckx 1993; Koelman 1999, 5.2.3): its
points move onto the smooth curve, and what is tied to them moves along."""

from dataclasses import dataclass

import numpy as np

from ...bridge import native
from ...bridge.objects import bezier_curves, networks
from . import crossings, network_state, planes

_LEAST_POINTS = 5


@dataclass(frozen=True)
class Smoothed:
    """In m: the mean deviation that was allowed and that came out, the largest move; before,
    after: the jumps of the third derivative, root mean square."""

    allowed: float
    mean: float
    largest: float
    before: float
    after: float


def smooth_all(objects, scene, deviation):
    """Smooths curve objects one after the other: all of them, or none; see smooth()."""
    for obj in objects:
        _checked(obj, scene, deviation)
    return [smooth(obj, scene, deviation) for obj in objects]


def smooth(obj, scene, deviation):
    """Smooths a curve object of a network within a mean deviation in m, between its ends and
    knuckles, which stay; returns Smoothed. Points of other curves in the same places follow."""
    network, state, known, runs = _checked(obj, scene, deviation)
    weights, points = bezier_curves.read(obj).weights, known.points * state.scale
    moved = points.copy()
    for first, last in zip(runs, runs[1:]):
        if last - first + 1 >= _LEAST_POINTS:
            run = slice(first, last + 1)
            moved[run] = _smoothed(points[run], weights[run], deviation)
    plane = planes.plane_of(obj.hull.curve)
    if plane is not None:
        moved = planes.onto(moved, [(plane[0], plane[1] * state.scale)])
    crossings.write_points(obj, moved / state.scale, known.knuckles)
    network_state.follow(network, scene)
    now = network_state.state_of(network).curves[obj.name].points * state.scale
    return _report(points, now, deviation, runs)


def _checked(obj, scene, deviation):
    """(network, its NetworkState, the KnownCurve, numbers of its ends and knuckles) of a curve
    object; ValueError where it cannot be smoothed."""
    network = networks.network_of(obj)
    if network is None or obj.type != "CURVE":
        raise ValueError("Select a curve of a network first")
    reason = networks.locked(network)
    if reason:
        raise ValueError(reason)
    if not 0.0 <= deviation < 1e6:
        raise ValueError(f"The mean deviation is {1e3 * deviation:g} mm: give one from 0 on")
    if obj.hull.curve.shape != "FREE":
        raise ValueError(f'"{obj.name}" is exact by its shape, and not smoothed: make it free')
    state = network_state.follow(network, scene)
    known = state.curves.get(obj.name)
    if known is None:
        raise ValueError(f'"{obj.name}" is no curve of the network as it is: see its problems')
    runs = [0, *known.knuckles, len(known.points) - 1]
    if all(last - first + 1 < _LEAST_POINTS for first, last in zip(runs, runs[1:])):
        raise ValueError(
            f'"{obj.name}" has fewer than {_LEAST_POINTS} points between its ends and knuckles: '
            "there is nothing to smooth"
        )
    for first, last in zip(runs, runs[1:]):
        if last - first + 1 >= _LEAST_POINTS:
            t = _parameters(known.points[first : last + 1])
            if not np.diff(t).min() > 0.0:
                raise ValueError(f'"{obj.name}" has two points in one place: delete one of them')
    return network, state, known, runs


def _parameters(points):
    return np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])


def _smoothed(points, weights, deviation):
    t = _parameters(points)
    # The ends are met, as other curves may be tied to them.
    curve = native.require().smooth_curve(
        points, deviation, parameters=t, weights=weights,
        start=points[:1], end=points[-1:], knots_at_points=True,
    )  # fmt: skip
    found = curve.evaluate(t)
    found[[0, -1]] = points[[0, -1]]
    return found


def _report(before, after, deviation, runs):
    moves = np.linalg.norm(after - before, axis=1)
    return Smoothed(
        deviation,
        float(np.sqrt(np.mean(moves**2))),
        float(moves.max()),
        _unfairness(before, runs),
        _unfairness(after, runs),
    )


def _unfairness(points, runs):
    """Root mean square jump of the third derivative at the points of the interpolating cubic."""
    jumps = [np.zeros((1, 3))]
    for first, last in zip(runs, runs[1:]):
        own = points[first : last + 1]
        if len(own) >= _LEAST_POINTS:
            t = _parameters(own)
            curve = native.require().smooth_curve(own, 0.0, parameters=t)
            thirds = curve.evaluate(0.5 * (t[1:] + t[:-1]), 3)
            jumps.append(np.diff(thirds, axis=0)[1:-1])
    every = np.concatenate(jumps)
    return float(np.sqrt((every**2).sum(axis=1).mean()))
