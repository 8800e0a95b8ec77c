# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces whose plates are known: a spherical cap, cylinders and cones of any profile, and hulls
with the seams of their shells."""

import hull_native as hn
import numpy as np
from transformation_hulls import grid_mesh


def through(values):
    """Control points of the uniform cubic spline with free ends through values (n, …)."""
    n = len(values)
    matrix = np.diag(np.full(n, 4.0)) + np.diag(np.ones(n - 1), 1) + np.diag(np.ones(n - 1), -1)
    matrix[0], matrix[-1] = 0.0, 0.0
    matrix[0, 0] = matrix[-1, -1] = 6.0
    return np.linalg.solve(matrix / 6.0, values.reshape(n, -1)).reshape(values.shape)


def grid_surface(points):
    """The LimitSurface of control points (m, n, 3), normals along d/di x d/dj."""
    return hn.LimitSurface(grid_mesh(points.swapaxes(0, 1)))


def sphere(radius=10.0, half=0.7, parts=28):
    """Around the north pole of a sphere, off it by 1e-8 of the radius."""
    a = np.linspace(-half, half, parts + 1)
    x, y = np.meshgrid(a, a, indexing="ij")
    points = np.stack([x, y, np.ones_like(x)], axis=-1)
    points *= radius / np.linalg.norm(points, axis=-1, keepdims=True)
    points = through(points)
    return grid_surface(through(points.swapaxes(0, 1)).swapaxes(0, 1))


def cylinder(parts=8, length=6.0, rows=4):
    """Of a wavy profile in (y, z), along x."""
    t = np.linspace(0.0, 1.0, parts + 1)
    profile = np.stack([0.0 * t, 5.0 * t, np.sin(3.0 * t) + 0.4 * t**2], axis=1)
    x = np.linspace(0.0, length, rows + 1)
    points = profile[None] + x[:, None, None] * [1.0, 0.0, 0.0]
    return grid_surface(points)


def cone(parts=8, rows=4):
    """The cone from a profile to an apex, between a quarter and all of the way."""
    apex = np.array([12.0, 2.0, 3.0])
    t = np.linspace(0.0, 1.0, parts + 1)
    profile = np.stack([0.5 * t, 5.0 * t, np.sin(3.0 * t)], axis=1)
    v = np.linspace(0.0, 0.75, rows + 1)
    return grid_surface(profile[None] + v[:, None, None] * (apex - profile[None]))


def one(curves):
    """The only curve of a list."""
    (curve,) = curves
    return curve
