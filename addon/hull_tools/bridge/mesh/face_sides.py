# SPDX-License-Identifier: GPL-3.0-or-later
"""Sides of faces whose corners stand one after the other: one for each corner, to the next."""

import numpy as np


def next_corners(face_sizes):
    """(c,) of each corner of all faces the number of the next one of its face."""
    ends = np.cumsum(face_sizes)
    following = np.arange(1, np.sum(face_sizes, dtype=np.int64) + 1)
    following[ends - 1] = ends - face_sizes
    return following


def ends_of_sides(face_sizes, face_vertices):
    """(c, 2) of each side of all faces the points at its ends, in the sense of its face."""
    return np.stack([face_vertices, face_vertices[next_corners(face_sizes)]], axis=1)
