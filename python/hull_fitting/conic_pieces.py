# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines through few points that turn much from one to the next: conics between them that keep what
is hollow hollow and what is full full, where a spline would swing out."""

import numpy as np

# A conic's fullness, as the weight of its middle point, where nothing tells it and one tangent is
# far longer than the other (where they are alike it is an arc), and its limits: 1 is a parabola,
# above a hyperbola, closer to the corner of its tangents.
_WEIGHT, _LEAST, _MOST = 1.3, 0.8, 4.0
# Cosine of the turn at a free end up to which it is that of an arc.
_MOST_TURN = np.cos(np.radians(50.0))


def tangents_at(points, start=None, end=None):
    """(n, 3) unit tangents of a line through points (n, 3), by the parabola through each three
    (Bessel; de Boor 1978, chapter IV). start, end: given ones."""
    ways = np.diff(points, axis=0)
    lengths = np.maximum(np.linalg.norm(ways, axis=1), 1e-300)[:, None]
    units = ways / lengths
    inner = units[:-1] * lengths[1:] + units[1:] * lengths[:-1]
    inner = _unit(inner)
    if len(points) == 2:
        first = last = units[0]
    else:
        first, last = _at_end(units[0], inner[0]), _at_end(units[-1], inner[-1])
    first = first if start is None else _along(start, units[0])
    last = last if end is None else _along(end, units[-1])
    return np.vstack([first, inner, last])


def _at_end(unit, next_way):
    """As an arc would begin; where that turned much, along the chord."""
    cosine = unit @ next_way
    return unit if cosine < _MOST_TURN else _unit(2.0 * cosine * unit - next_way)


def between(a, b, at_a, at_b, shares, bends=(0.0, 0.0)):
    """Places (k, 3) at shares (k,) of the conic from a to b with these unit tangents; of a cubic
    where these do not come together between them. bends: the curvatures, 1/m, with which the line
    goes on beyond a and b, 0 where they are not known: the conic is as full as has these, in the
    mean."""
    chord = b - a
    corner = _corner(a, b, at_a, at_b)
    s = np.asarray(shares)[:, None]
    if corner is None:
        length = np.linalg.norm(chord)
        p, q = a + length / 3.0 * at_a, b - length / 3.0 * at_b
        r = 1.0 - s
        return r**3 * a + 3.0 * r * r * s * p + 3.0 * r * s * s * q + s**3 * b
    weight = _weight(a, b, corner, bends)
    first, middle, last = (1.0 - s) ** 2, 2.0 * weight * s * (1.0 - s), s**2
    return (first * a + middle * corner + last * b) / (first + middle + last)


def _corner(a, b, at_a, at_b):
    """Where the tangents come nearest to one another; None unless that is ahead of a and behind
    b."""
    chord = b - a
    c = at_a @ at_b
    square = 1.0 - c * c
    if square < 1e-8:
        return None
    p, q = chord @ at_a, chord @ at_b
    ahead, behind = (p - c * q) / square, (q - c * p) / square
    if ahead <= 0.0 or behind <= 0.0:
        return None
    return 0.5 * (a + ahead * at_a + b - behind * at_b)


def _weight(a, b, corner, bends):
    """Of the middle point w: the curvature at an end is A / (w² d³), A the area of the triangle and
    d the end's distance from the corner (Farin 2002, section 12.7)."""
    area = 0.5 * np.linalg.norm(np.cross(corner - a, b - a))
    found = [
        np.clip(np.sqrt(area / (np.linalg.norm(end - corner) ** 3 * bend)), _LEAST, _MOST)
        for end, bend in zip((a, b), bends)
        if bend > 0.0
    ]
    if found:
        return float(np.exp(np.mean(np.log(found))))
    sides = np.linalg.norm([corner - a, b - corner], axis=1)
    cosine = (corner - a) @ (b - corner) / max(np.prod(sides), 1e-300)
    alike = sides.min() / sides.max()
    # Of an arc: the cosine of half its turn.
    return float(alike * np.sqrt(max(0.0, 0.5 * (1.0 + cosine))) + (1.0 - alike) * _WEIGHT)


def bend_of(points):
    """1/m: of the circle through three points; 0 of fewer, and of points on a line."""
    if len(points) < 3:
        return 0.0
    a, b, c = points[:3]
    sides = [np.linalg.norm(q - p) for p, q in ((a, b), (b, c), (a, c))]
    return 2.0 * float(np.linalg.norm(np.cross(b - a, c - a))) / max(np.prod(sides), 1e-300)


def _unit(ways):
    return ways / np.maximum(np.linalg.norm(ways, axis=-1, keepdims=True), 1e-300)


def _along(way, unit):
    way = np.asarray(way, dtype=float)
    way = way / np.linalg.norm(way)
    return way if way @ unit >= 0.0 else -way
