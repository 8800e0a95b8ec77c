# SPDX-License-Identifier: GPL-3.0-or-later
"""The shells of sample hulls with their seams and butts."""

import hull_native as hn
import numpy as np
from production_hulls import body_of


def named(curves, name):
    for curve in curves:
        curve.name = name
    return curves


def longest(pieces):
    return max(pieces, key=lambda c: np.linalg.norm(np.diff(c.points, axis=0), axis=1).sum())


def deck_edge(curves):
    """The border that reaches from end to end above all others."""
    borders = curves.borders()
    length = max(np.ptp(c.points[:, 0]) for c in borders)
    long = [c for c in borders if np.ptp(c.points[:, 0]) > 0.8 * length]
    return max(long, key=lambda c: c.points[:, 2].mean())


def staggered(curves, seams, butts):
    """Butts at x of two rows, in strakes between seams in turn, from above."""
    made = []
    for row, positions in enumerate(butts):
        for x in positions:
            for curve in curves.in_plane(hn.plane_across("x", x), f"Butt {x:g}"):
                pieces = curves.pieces(curve, seams)
                pieces.sort(key=lambda c: -c.points[:, 2].max())
                made += pieces[row::2]
    return made


def coaster_shell(tolerance=1e-3):
    """(surface, curves): four strakes below the deck edge at girths from it, keel strake and
    bottom, ten butts, the transom."""
    _, body = body_of("coaster")
    surface = body.surface
    curves = hn.HullCurves(surface, tolerance)
    deck = deck_edge(curves)
    seams = []
    for k, girth in enumerate((2.4, 4.8, 7.6)):
        seams += curves.at_girth(deck, girth, towards=(0, 0, -1), name=f"Seam {chr(68 - k)}")
    knuckles = named(curves.knuckles(), "Transom")
    keel = curves.in_plane(hn.plane_across("y", 1.5), "Seam A")
    seams += [longest(curves.pieces(c, seams + knuckles)) for c in keel][:1]
    butts = ((5.0, 19.0, 33.0, 47.0, 61.0, 75.0), (12.0, 26.0, 40.0, 54.0, 68.0))
    return surface, seams + knuckles + staggered(curves, seams + knuckles, butts)


def planing_boat_shell(tolerance=1e-4):
    """(surface, curves): the knuckles, and two butts."""
    _, body = body_of("planing_boat")
    surface = body.surface
    curves = hn.HullCurves(surface, tolerance)
    seams = curves.knuckles()
    for x in (4.0, 8.0):
        seams += curves.in_plane(hn.plane_across("x", x), f"Butt {x:g}")
    return surface, seams
