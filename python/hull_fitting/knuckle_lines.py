# SPDX-License-Identifier: GPL-3.0-or-later
"""Knuckles of a shell of triangles: lines over which it turns by far more than beside them."""

import numpy as np

from .beside import end_to_end, foot_on, lengths_along, normals_of
from .polyline_parts import TURNS, parts_between_turns
from .triangle_edges import edge_lines, edge_table

# Turn over an edge of a knuckle, degrees at least, and so many times that over edges beside it.
_LEAST_TURN, _TIMES = 10.0, 2.5
# Of the length: lines go on over gaps that are no wider, and those that reach less far along the
# ship are none; cosine of the turn with which they do.
_GAP, _LEAST_REACH, _GOES_ON = 1e-2, 0.12, 0.9
# Of a knuckle so much runs along the ship; of the breadth: nearer to the centre plane in the mean
# it is the rim of a bar.
_ALONG, _BAR = 0.6, 0.04
# Of the length: a line goes on to where another one ends in the centre plane, over no more.
_GOES_TO_STEM = 0.05
# Of the length: lines that are no further apart are the rims of a gap between patches.
_DOUBLE = 2e-3
# Knuckles at most, the longest.
_MOST = 5


def knuckle_lines(mesh):
    """Lines (n, 3), m, along the knuckles of a HalfMesh, the longest first."""
    table = edge_table(mesh.triangles)
    inner = np.flatnonzero(table.counts == 2)
    ends, owners = table.ends[inner], table.owners[inner]
    normals, _ = normals_of(mesh.points, mesh.triangles)
    cosines = (normals[owners[:, 0]] * normals[owners[:, 1]]).sum(axis=1)
    turns = np.degrees(np.arccos(np.clip(cosines, -1.0, 1.0)))
    sides = [[] for _ in range(len(mesh.triangles))]
    for number, (a, b) in enumerate(owners.tolist()):
        sides[a].append((number, b))
        sides[b].append((number, a))
    sharp = [
        number
        for number in np.flatnonzero(turns >= _LEAST_TURN).tolist()
        if turns[number] >= _TIMES * _turn_beside(number, ends, owners, turns, sides)
    ]
    if not sharp:
        return []
    lines = [
        part for line in edge_lines(ends[sharp]) for part in parts_between_turns(mesh.points[line])
    ]
    # Few pieces are joined: of many short ones none is a knuckle.
    lines.sort(key=lambda line: -lengths_along(line)[-1])
    lines = end_to_end(lines[:60], _GAP * mesh.length, _GOES_ON)
    breadth = mesh.points[:, 1].max()
    lines = [line for line in lines if _is_knuckle(line, mesh.length, breadth)]
    lines = [line for line in lines if not _is_doubled(line, lines, _DOUBLE * mesh.length)]
    lines = _to_one_stem(lines, _GOES_TO_STEM * mesh.length)
    lines.sort(key=lambda line: -lengths_along(line)[-1])
    return lines[:_MOST]


def _is_knuckle(line, length, breadth):
    reach = abs(float(line[-1, 0] - line[0, 0]))
    whole = lengths_along(line)[-1]
    return reach > max(_LEAST_REACH * length, _ALONG * whole) and line[:, 1].mean() > _BAR * breadth


def _to_one_stem(lines, reach):
    """Both knuckles of a chine's flat come to the stem in one place, where one of them may be too
    blunt to be seen: it is drawn on to where the other one ends."""
    ends = np.array([end for line in lines for end in (line[0], line[-1])]).reshape(-1, 3)
    central = ends[ends[:, 1] == 0.0]
    found = []
    for line in lines:
        for _ in range(2):
            line = _drawn_on(line, central, reach)[::-1]
        found.append(line)
    return found


def _drawn_on(line, places, reach):
    """A line (n, 3) to the nearest of places that is ahead of its end, within reach, m."""
    way = line[-1] - line[max(0, len(line) - 4)]
    away = places - line[-1]
    apart = np.linalg.norm(away, axis=1)
    is_ahead = away @ way > TURNS * apart * np.linalg.norm(way)
    near = np.flatnonzero((apart > 0.0) & (apart < reach) & is_ahead)
    if line[-1, 1] == 0.0 or not len(near):
        return line
    return np.vstack([line, places[near[np.argmin(apart[near])]]])


def _is_doubled(line, lines, reach):
    for other in lines:
        if other is not line:
            lengths = lengths_along(other)
            if all(foot_on(other, lengths, place)[1] < reach for place in line):
                return True
    return False


def _turn_beside(number, ends, owners, turns, sides):
    """The largest turn over edges within two triangles that have no end of this one."""
    own = set(ends[number].tolist())
    found = 0.0
    for first in owners[number].tolist():
        for _, second in sides[first]:
            for other, third in sides[second]:
                if not own & set(ends[other].tolist()):
                    found = max(found, turns[other])
                for beyond, _ in sides[third]:
                    if not own & set(ends[beyond].tolist()):
                        found = max(found, turns[beyond])
    return found
