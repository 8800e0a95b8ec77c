# SPDX-License-Identifier: GPL-3.0-or-later
"""How the depths of marks change with a hull's control points, to first order: by the exact second
derivatives along the lines (hull_native.BendSums) of what each mark's lines.Lever tells."""

import numpy as np

from .native import hull_native as hn

# Of a unit normal's part across a line in its plane: with less the plane hardly cuts the surface.
_HARDLY_CUT = 1e-3
_NO_AREA = 1e-300
_LEAST_SAMPLES = 3


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
        across /= np.maximum(np.linalg.norm(across, axis=1), _NO_AREA)[:, None]
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
    normals /= np.maximum(np.linalg.norm(normals, axis=1), _NO_AREA)[:, None]
    chords = np.gradient(lever.points, axis=0)
    if lever.is_cut:
        along = np.cross(np.cross(*lever.frame), normals)
        along *= np.where(np.sum(along * chords, axis=1) < 0.0, -1.0, 1.0)[:, None]
    else:
        along = chords - np.sum(chords * normals, axis=1)[:, None] * normals
    along /= np.maximum(np.linalg.norm(along, axis=1), _NO_AREA)[:, None]
    metric = np.stack([xu, xv], axis=1) @ np.stack([xu, xv], axis=2)
    parts = np.stack([np.sum(along * xu, axis=1), np.sum(along * xv, axis=1)], axis=1)
    # Where there is no area there is nothing to tell, and nothing counts.
    a, b = (np.linalg.pinv(metric) @ parts[:, :, None])[:, :, 0].T[:, :, None]
    return along, a * a * xuu + 2.0 * a * b * xuv + b * b * xvv, normals


def feature_bends(sums, surface, step, width, least_bend):
    """([conditions of moves], [what each costs]) by which the bends of creases and borders change,
    as the surface's do in hull_native.FairRegion's `before`: the integral over strips of the
    surface, `width`, m, of squared changes of bend, in proportion to bends above least_bend, 1/m.
    step: m, of the places along them."""
    tree, rows, costs = hn.SurfaceTree(surface), [], []
    for curve in hn.feature_fairness(surface, step=step, marks=False):
        points = np.asarray(curve.points)
        if len(points) < _LEAST_SAMPLES:
            continue
        near = tree.closest_points(points)
        along = np.gradient(points, axis=0)
        lengths = np.linalg.norm(along, axis=1)
        along /= np.maximum(lengths, _NO_AREA)[:, None]
        shares = least_bend**2 / (np.asarray(curve.curvatures) ** 2 + least_bend**2)
        own = width * lengths * shares
        for index, outs in enumerate(_across(along)):
            at = slice(index, index + 1)
            for out in outs:
                place = near.cells[at], near.uv[at], along[at], out[None]
                row = sums.sum(surface.mesh.points, *place, is_cut=False)
                if len(row[0]):
                    rows.append(row)
                    costs.append(float(own[index]))
    return rows, costs


def _across(along):
    """Two unit vectors (n, 2, 3) across each of unit vectors (n, 3), and across one another."""
    axes = np.eye(3)[np.abs(along).argmin(axis=1)]
    one = np.cross(along, axes)
    one /= np.maximum(np.linalg.norm(one, axis=1), _NO_AREA)[:, None]
    return np.stack([one, np.cross(along, one)], axis=1)
