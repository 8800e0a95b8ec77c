# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections of what a hull was fitted to and of the hull, at the same stations."""

from dataclasses import dataclass

import numpy as np

from .beside import hull_native as hn

# Parts of a face's side in which the hull is cut, and stations.
_PARTS, STATIONS = 12, 11


@dataclass(frozen=True)
class StationOverlay:
    """x: m; source, hull: (k, 2, 2) pieces of the sections of the port half, (y, z), m; rms and
    largest: m, of the source's section from the hull's surface, with the place (3,) of that."""

    x: float
    source: np.ndarray
    hull: np.ndarray
    rms: float
    largest: float
    place: tuple


def station_overlays(shell, fitted, count=STATIONS):
    """StationOverlays evenly from 1 % to 99 % of the length, from aft."""
    mesh = shell.mesh
    facets = fitted.surface.tessellate(_PARTS)
    quads = facets.quads
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    tree = hn.SurfaceTree(fitted.surface)
    low, high = fitted.outline.low[0], fitted.outline.high[0]
    found = []
    for x in low + (high - low) * np.linspace(0.01, 0.99, count):
        source = cut_across(mesh.points, mesh.triangles, float(x))
        own = cut_across(np.asarray(facets.points), triangles, float(x))
        places = np.concatenate([source[:, 0], source.mean(axis=1), source[:, 1]])
        distances = np.asarray(tree.closest_points(places).distances)
        weights = np.tile(np.linalg.norm(source[:, 1] - source[:, 0], axis=1), 3)
        most = int(np.argmax(distances))
        rms = float(np.sqrt(np.average(distances**2, weights=weights)))
        found.append(
            StationOverlay(
                float(x), source[:, :, 1:], own[:, :, 1:], rms, float(distances[most]),
                tuple(places[most].tolist()),
            )  # fmt: skip
        )
    return found


def cut_across(points, triangles, x):
    """(k, 2, 3) pieces in which triangles cross the plane at x."""
    corners = points[triangles]
    ahead = corners[:, :, 0] > x
    count = ahead.sum(axis=1)
    crossing = (count > 0) & (count < 3)
    corners, ahead = corners[crossing], ahead[crossing]
    following, next_ahead = np.roll(corners, -1, axis=1), np.roll(ahead, -1, axis=1)
    off, next_off = corners[:, :, 0] - x, following[:, :, 0] - x
    crosses = ahead != next_ahead
    shares = np.where(crosses, off / np.where(crosses, off - next_off, 1.0), 0.0)
    places = corners + shares[:, :, None] * (following - corners)
    return places[crosses].reshape(-1, 2, 3)
