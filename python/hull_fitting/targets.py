# SPDX-License-Identifier: GPL-3.0-or-later
"""What a surface is fitted to of a shell of triangles."""

import numpy as np

from .beside import NetworkTargets, normals_of, spread_points

# Places spread by area, and corners of triangles, which are close where the surface is curved.
_SPREAD, _CORNERS = 5000, 3000


def shell_targets(mesh):
    """NetworkTargets of a HalfMesh, all of them to be heeded: places by area, and corners."""
    places, normals = spread_points(mesh.points, mesh.triangles, _SPREAD)
    corners, at_corners = _corners(mesh)
    points = np.concatenate([places, corners])
    return NetworkTargets(
        points,
        np.concatenate([normals, at_corners]),
        np.ones(len(points)),
        np.ones(len(points), dtype=bool),
    )


def _corners(mesh):
    """(points, normals) of some corners, without those where the surface has an edge."""
    normals, areas = normals_of(mesh.points, mesh.triangles)
    sums, wholes = np.zeros_like(mesh.points), np.zeros(len(mesh.points))
    for side in range(3):
        np.add.at(sums, mesh.triangles[:, side], areas[:, None] * normals)
        np.add.at(wholes, mesh.triangles[:, side], areas)
    lengths = np.linalg.norm(sums, axis=1)
    # Where normals agree, their sum is as long as the areas' is.
    smooth = np.flatnonzero((wholes > 0.0) & (lengths > 0.95 * wholes))
    chosen = smooth[:: max(1, -(-len(smooth) // _CORNERS))]
    return mesh.points[chosen], sums[chosen] / lengths[chosen, None]
