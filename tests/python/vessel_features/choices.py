# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of a ship: which control points are in them, by x, y, z (n,) in m and the particulars."""

import numpy as np


def upper(x, y, z, given):
    return z > 0.5 * given.draft


def in_base_plane(x, y, z, given):
    return (z == 0.0) & (y > 0.02 * given.beam)


def foremost(x, y, z, given):
    return x > 0.98 * given.length_pp


def aftmost(x, y, z, given):
    return x < 0.02 * given.length_pp


def amidships(x, y, z, given):
    return np.abs(x - 0.5 * given.length_pp) < 0.15 * given.length_pp
