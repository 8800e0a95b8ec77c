# SPDX-License-Identifier: GPL-3.0-or-later
"""A new section through the surface of a network: exact on the patches, with points where it meets
the curves."""

from collections import defaultdict

import numpy as np

# Of the network's size: ends of a patch's line that are nearer are one.
_SAME = 1e-7
# Parts of a patch's side, across which the section is looked for.
_PARTS = 12
_HALVINGS = 44


def chains(native_network, normal, offset, scale):
    """Lines (points (n, 3), Blender's units, numbers of those on curves of the network) in which a
    plane cuts the patches of a hull_native.CurveNetwork; the longest first."""
    segments = []
    for region in range(native_network.region_count):
        try:
            patch = native_network.patch(region)
        except ValueError:  # it is among the problems
            continue
        segments += _cut(patch, normal, offset * scale)
    joined = _joined(segments, _size(native_network))
    found = [(np.array(points) / scale, knots) for points, knots in joined if len(points) > 1]
    return sorted(found, key=lambda one: -_length(one[0]))


def _size(native_network):
    nodes = np.asarray(native_network.nodes)
    return float(np.ptp(nodes, axis=0).max()) if len(nodes) else 1.0


def _length(points):
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


def _cut(patch, normal, offset):
    """Lines of points (n, 3), m, from border to border of a patch."""
    places, triangles = patch.grid(_PARTS)
    heights = patch.evaluate(places)[0] @ normal - offset
    above = heights >= 0.0
    edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    crossed = np.unique(edges[above[edges[:, 0]] != above[edges[:, 1]]], axis=0)
    if not len(crossed):
        return []
    points = _on_plane(patch, places[crossed[:, 0]], places[crossed[:, 1]], normal, offset)
    numbers = {tuple(edge): i for i, edge in enumerate(crossed.tolist())}
    links = defaultdict(list)
    for triangle in triangles.tolist():
        pairs = [tuple(sorted((triangle[i], triangle[(i + 1) % 3]))) for i in range(3)]
        ends = [numbers[pair] for pair in pairs if pair in numbers]
        if len(ends) == 2:
            links[ends[0]].append(ends[1])
            links[ends[1]].append(ends[0])
    return [points[walk] for walk in _walks(links)]


def _on_plane(patch, starts, ends, normal, offset):
    """(n, 3): where the surface over lines of the patch's domain meets the plane, by halving."""
    is_above = patch.evaluate(starts)[0] @ normal >= offset
    low, high = np.zeros(len(starts)), np.ones(len(starts))
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        places = starts + middle[:, None] * (ends - starts)
        is_first = (patch.evaluate(places)[0] @ normal >= offset) == is_above
        low, high = np.where(is_first, middle, low), np.where(is_first, high, middle)
    return patch.evaluate(starts + (0.5 * (low + high))[:, None] * (ends - starts))[0]


def _walks(links):
    """Runs of numbers along links, each from an end to an end, or around."""
    left = set(links)
    ends = [one for one in links if len(links[one]) == 1]
    for start in [*ends, *links]:
        if start not in left:
            continue
        walk = [start]
        left.discard(start)
        while True:
            following = [one for one in links[walk[-1]] if one in left]
            if not following:
                break
            walk.append(following[0])
            left.discard(following[0])
        yield walk


def _joined(segments, size):
    """Pairs (points, numbers of those at which segments met or ended), end to end."""
    left, found = list(segments), []
    while left:
        line = list(left.pop())
        knots = [0, len(line) - 1]
        for at_end in (True, False):
            while True:
                near = _next(left, line[-1] if at_end else line[0], size)
                if near is None:
                    break
                number, is_turned = near
                segment = left.pop(number)
                segment = segment[::-1] if is_turned else segment
                if at_end:
                    line += list(segment[1:])
                    knots.append(len(line) - 1)
                else:
                    line = list(segment[::-1][:-1]) + line
                    knots = [0] + [k + len(segment) - 1 for k in knots]
        found.append((line, sorted(set(knots))))
    return found


def _next(segments, place, size):
    """(number of a segment that goes on from a place, whether from its end)."""
    for number, segment in enumerate(segments):
        for is_turned, end in ((False, segment[0]), (True, segment[-1])):
            if np.abs(end - place).max() <= _SAME * size:
                return number, is_turned
    return None
