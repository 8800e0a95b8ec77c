# SPDX-License-Identifier: GPL-3.0-or-later
"""What a surface is fitted to of a network: places on its curves and in its patches, and its
curves' distances from a surface."""

from dataclasses import dataclass

import numpy as np

from .._core import SurfaceTree

# Places on an edge, for a fit and for its distances; parts of a patch's sides.
_ON_EDGE, _MEASURED, _IN_PATCH = 4, 6, 3
# What a place in a patch counts for, and one on a curve, from each of its two sides. Between few
# curves patches tell little of the hull that the curves are of.
_PATCH_WEIGHT, _CURVE_WEIGHT = 2e-3, 0.5


@dataclass(frozen=True)
class NetworkTargets:
    """points and normals (n, 3), weights (n,), as fit_surface() takes them."""

    points: np.ndarray
    normals: np.ndarray
    weights: np.ndarray
    on_curves: np.ndarray  # (n,) bool


@dataclass(frozen=True)
class CurveDistance:
    """How far a curve of a network is from a surface: root mean square and largest, m, and the
    place (3,) of the largest. Parts of it that the network leaves out do not count."""

    name: str
    rms: float
    largest: float
    place: tuple


def network_targets(network, on_edge=_ON_EDGE):
    """The NetworkTargets of all regions that have a patch; on_edge: places on an edge."""
    points, normals, is_on = [], [], []
    for region in range(network.region_count):
        sides = network.sides(region)
        if not 2 <= len(sides) <= 10:
            continue
        patch = network.patch(region)
        domain = np.asarray(patch.domain)
        of_region = [(patch.grid(_IN_PATCH)[0], False)]
        # A patch of two sides has three in its domain.
        if len(domain) == len(sides):
            of_region.append((_border_places(domain, sides, on_edge), True))
        for places, on_curve in of_region:
            found = patch.evaluate(places)
            points.append(found[0])
            normals.append(found[1])
            is_on.append(np.full(len(places), on_curve))
    points, normals, is_on = (np.concatenate(part) for part in (points, normals, is_on))
    good = np.isfinite(normals).all(axis=1) & (np.linalg.norm(normals, axis=1) > 0.5)
    points, normals, is_on = points[good], normals[good], is_on[good]
    weights = np.where(is_on, _CURVE_WEIGHT, _PATCH_WEIGHT)
    return NetworkTargets(points, normals, weights, is_on)


def _border_places(domain, sides, on_edge):
    places = []
    for number, side in enumerate(sides):
        share = (np.arange(on_edge * len(side)) + 0.5) / (on_edge * len(side))
        start, end = domain[number], domain[(number + 1) % len(domain)]
        places.append((1.0 - share)[:, None] * start + share[:, None] * end)
    return np.concatenate(places)


def network_places(network):
    """Places on all edges (k, 3), m, and the curves (k,) that they are on."""
    curves = np.asarray(network.edge_curves)
    points = [network.edge_points(edge, _MEASURED) for edge in range(len(curves))]
    return np.concatenate(points), np.repeat(curves, _MEASURED + 1)


def curve_distances(network, surface):
    """The CurveDistance of each curve of a network that has edges, from a LimitSurface."""
    points, curves = network_places(network)
    distances = np.asarray(SurfaceTree(surface).closest_points(points).distances)
    found = []
    for curve in np.unique(curves):
        of_curve = np.flatnonzero(curves == curve)
        most = of_curve[np.argmax(distances[of_curve])]
        rms = float(np.sqrt(np.mean(distances[of_curve] ** 2)))
        name = network.curves[curve].name
        found.append(CurveDistance(name, rms, float(distances[most]), tuple(points[most].tolist())))
    return found
