# SPDX-License-Identifier: GPL-3.0-or-later
"""Discs of triangles for the tests of morphing, and what is measured on them."""

from fractions import Fraction

import hull_native as hn
import numpy as np

SQUARE = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
# None of its sides along an axis: places on them are rounded.
KITE = [(0.05, -0.1), (1.1, 0.2), (0.9, 1.3), (-0.2, 0.7)]


def grid(columns, rows, random=None):
    """(points, triangles, corners) of the unit square, its cells cut by one diagonal or the other,
    its inner points moved at random."""
    x, y = np.meshgrid(np.linspace(0, 1, columns + 1), np.linspace(0, 1, rows + 1))
    points = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    if random is not None:
        inner = ((points[:, :2] > 0) & (points[:, :2] < 1)).all(axis=1)
        points[inner, :2] += random.uniform(-0.3, 0.3, (inner.sum(), 2)) / (columns, rows)
    triangles = []
    for a in (j * (columns + 1) + i for j in range(rows) for i in range(columns)):
        b, c, d = a + 1, a + columns + 2, a + columns + 1
        if random is not None and random.random() < 0.5:
            triangles += [(a, b, d), (b, c, d)]
        else:
            triangles += [(a, b, c), (a, c, d)]
    count = len(points)
    return points, np.array(triangles), [0, columns, count - 1, count - 1 - columns]


def in_polygon(points, polygon):
    """The unit square laid onto a polygon of four corners, straight along each side."""
    a, b, c, d = np.asarray(polygon)
    x, y = points[:, 0, None], points[:, 1, None]
    laid = (1 - x) * (1 - y) * a + x * (1 - y) * b + x * y * c + (1 - x) * y * d
    return np.column_stack([laid, np.zeros(len(points))])


def bent(points, waves):
    points = points.copy()
    points[:, 2] = 0.3 * np.sin(waves * points[:, 0]) * np.cos(2 * points[:, 1])
    return points


def random_disc(random, border, inner):
    """(points, triangles, corners): any triangulation of a polygon with points put into it and
    edges turned at random, and any places in space: only the way in which triangles hang together
    means anything."""
    triangles, low, high = [], 0, border - 1
    while high - low > 1:
        triangles.append((low, low + 1, high))
        low += 1
        if high - low > 1:
            triangles.append((low, high - 1, high))
            high -= 1
    for point in range(border, border + inner):
        which = random.integers(len(triangles))
        a, b, c = triangles[which]
        triangles[which] = (a, b, point)
        triangles += [(b, c, point), (c, a, point)]
    _turn_edges(triangles, 4 * (border + inner), random)
    points = random.uniform(-1, 1, (border + inner, 3)) * (1.0, 0.2, 0.1)
    corners = np.sort(random.choice(border, random.integers(3, min(border, 8) + 1), replace=False))
    return points, np.array(triangles), list(np.roll(corners, random.integers(len(corners))))


def _sides(triangle):
    return [(triangle[k], triangle[(k + 1) % 3]) for k in range(3)]


def _turn_edges(triangles, count, random):
    at = {side: t for t, triangle in enumerate(triangles) for side in _sides(triangle)}
    for _ in range(count):
        one = random.integers(len(triangles))
        a, b, c = np.roll(triangles[one], random.integers(3)).tolist()
        other = at.get((b, a))
        if other is None:
            continue
        (d,) = set(triangles[other]) - {a, b}
        if (c, d) in at or (d, c) in at:
            continue
        del at[a, b], at[b, a]
        triangles[one], triangles[other] = (c, a, d), (d, b, c)
        at |= {side: t for t in (one, other) for side in _sides(triangles[t])}


def exact_area(p, q, r):
    """Twice the area of a triangle in the plane, by Fractions or whatever may become ones."""
    (px, py), (qx, qy), (rx, ry) = ([Fraction(number) for number in place] for place in (p, q, r))
    return (qx - px) * (ry - py) - (qy - py) * (rx - px)


def area(points, triangles):
    a, b, c = points[triangles].transpose(1, 0, 2)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


def volume(points, triangles):
    """Between the surface and the centre plane, as hulls are closed."""
    a, b, c = points[triangles].transpose(1, 0, 2)
    return ((a + b + c)[:, 1] * np.cross(b - a, c - a)[:, 1]).sum() / 6


def euler(triangles):
    edges = np.sort(np.concatenate([triangles[:, k] for k in ([0, 1], [1, 2], [2, 0])]), axis=1)
    points, edge_count = len(np.unique(triangles)), len(np.unique(edges, axis=0))
    return points - edge_count + len(triangles)


def mapped(points, triangles, corners, polygon, **options):
    return hn.DiscMap(hn.TriangleDisc(points, triangles), corners, polygon, **options)


def star(*border):
    """A point in the middle of the unit square joined with border points, exactly there by uniform
    weights of as many as a power of two."""
    points = [(*place, 0.0) for place in border] + [(0.5, 0.5, 0.2)]
    count = len(border)
    triangles = [(k, (k + 1) % count, count) for k in range(count)]
    corners = [border.index(corner) for corner in SQUARE]
    map_ = mapped(points, triangles, corners, SQUARE, weights="uniform")
    assert np.array_equal(map_.places[count], (0.5, 0.5))
    return map_
