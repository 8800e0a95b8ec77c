# SPDX-License-Identifier: GPL-3.0-or-later
"""Boxes beside one another or through one another, as points and faces."""

FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def points_and_faces(ends):
    """Of boxes between corners (low, high), eight points each; faces counter-clockwise seen from
    outside."""
    points, faces = [], []
    for low, high in ends:
        first = len(points)
        points += [
            (x, y, z)
            for z in (low[2], high[2])
            for y in (low[1], high[1])
            for x in (low[0], high[0])
        ]
        faces += [tuple(first + i for i in face) for face in FACES]
    return points, faces
