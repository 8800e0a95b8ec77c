# SPDX-License-Identifier: GPL-3.0-or-later
"""How the depths of marks change with a hull's control points, to first order: by the exact second
derivatives along the lines (hull_native.BendSums) of what each mark's lines.Lever tells."""

import numpy as np

# Of a unit normal's part across a line in its plane: with less the plane hardly cuts the surface.
_HARDLY_CUT = 1e-3


def slopes(sums, surface, tree, lever):
    """(control points (k,), slopes (k, 3)) of the depth of a lines.Lever; sums: the
    hull_native.BendSums of the mesh, tree: the hull_native.SurfaceTree of the LimitSurface."""
    near = tree.closest_points(lever.points)
    along, bends, normals = _bends(surface, near, lever)
    flat = np.cross(*lever.frame)
    across = np.cross(flat, along)
    if lever.is_cut:
        part = np.sum(across * normals, axis=1)
        part = np.where(np.abs(part) > _HARDLY_CUT, part, np.inf)
        out = normals / part[:, None]
    else:
        # As it is seen: of the tangent and of what is across it the parts in the plane.
        seen = np.sum((along @ lever.frame.T) ** 2, axis=1)
        across /= np.linalg.norm(across, axis=1)[:, None]
        out = across / np.maximum(seen, _HARDLY_CUT)[:, None]
    curvatures = np.sum(bends * out, axis=1)
    side = 1.0 if np.sum(curvatures * lever.curvatures) >= 0.0 else -1.0
    return sums.sum(
        surface.mesh.points,
        near.cells,
        near.uv,
        along,
        (side * lever.factors)[:, None] * out,
        is_cut=lever.is_cut,
    )


def _bends(surface, near, lever):
    """Unit tangents (n, 3) of a lever's line, second derivatives along them, unit normals."""
    _, xu, xv, xuu, xuv, xvv = surface.evaluate(near.cells, near.uv, 2)
    normals = np.cross(xu, xv)
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    chords = np.gradient(lever.points, axis=0)
    if lever.is_cut:
        along = np.cross(np.cross(*lever.frame), normals)
        along *= np.where(np.sum(along * chords, axis=1) < 0.0, -1.0, 1.0)[:, None]
    else:
        along = chords - np.sum(chords * normals, axis=1)[:, None] * normals
    along /= np.linalg.norm(along, axis=1)[:, None]
    metric = np.stack([xu, xv], axis=1) @ np.stack([xu, xv], axis=2)
    parts = np.stack([np.sum(along * xu, axis=1), np.sum(along * xv, axis=1)], axis=1)
    a, b = np.linalg.solve(metric, parts[:, :, None])[:, :, 0].T[:, :, None]
    return along, a * a * xuu + 2.0 * a * b * xuv + b * b * xvv, normals
