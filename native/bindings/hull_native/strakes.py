# SPDX-License-Identifier: GPL-3.0-or-later
"""A first division of a half hull's shell: seams at girths from the deck edge, staggered butts."""

import numpy as np

from ._core import plane_across
from ._production import HullCurves

# A strake beside the centre line has this part of the others' breadth at least, where the girth is
# largest.
_LAST_STRAKE = 0.4
# Of the breadth of strakes.
_SHORTEST_BUTT = 0.4
MOST_STRAKES, MOST_BUTTS = 60, 400


def deck_edge(curves):
    """The SurfaceCurve of the border along the ship that lies highest, of HullCurves."""
    borders = curves.borders()
    if not borders:
        raise ValueError("The hull has no border along a deck: give its seams yourself.")
    longest = max(np.ptp(c.points[:, 0]) for c in borders)
    long = [c for c in borders if np.ptp(c.points[:, 0]) > 0.8 * longest]
    return max(long, key=lambda c: c.points[:, 2].mean())


def shell_seams(surface, *, strake, plate_length, tolerance=None):
    """(HullCurves, list of SurfaceCurve): seams and butts of a half hull's shell.

    Seams run at multiples of `strake` (m) from the deck edge, measured along frames, down to the
    centre line, and along knuckles. Butts are `plate_length` (m) apart, those of neighbouring
    strakes by half of that. Seams are named from the keel up: A, B, C …. tolerance: as HullCurves.
    ValueError for lengths that are not above 0, or so small that there are too many seams.
    """
    for name, value in (("strake", strake), ("plate_length", plate_length)):
        if not (np.isfinite(value) and value > 0.0):
            raise ValueError(f"{name} must be a length above 0 m, not {value:g}.")
    curves = HullCurves(surface, tolerance)
    knuckles = curves.knuckles()
    rows = girth_rows(curves, strake)
    if len(rows) > MOST_STRAKES:
        raise ValueError(
            f"Strakes of {strake:g} m are more than {MOST_STRAKES}: make them broader."
        )
    for k, row in enumerate(rows[::-1]):
        for curve in row:
            curve.name = f"Seam {_letters(k)}"
    seams = [curve for row in rows for curve in row] + knuckles
    return curves, seams + _butts(curves, seams, surface, strake, plate_length)


def length_of_curve(curve):
    """Of a SurfaceCurve by its chords, m."""
    return float(np.linalg.norm(np.diff(curve.points, axis=0), axis=1).sum())


def _letters(k):
    """A … Z, AA …"""
    text = ""
    k += 1
    while k:
        k, rest = divmod(k - 1, 26)
        text = chr(65 + rest) + text
    return text


def girth_rows(curves, strake):
    """Rows of curves of HullCurves at multiples of a girth from the deck edge down, as long as the
    shell below has room; one more than MOST_STRAKES where there are more."""
    deck, towards, rows = deck_edge(curves), (0.0, 0.0, -1.0), []
    for k in range(1, MOST_STRAKES + 2):
        try:
            row = curves.at_girth(deck, k * strake, towards=towards, name=f"Seam {k}")
            curves.at_girth(deck, (k + _LAST_STRAKE) * strake, towards=towards)
        except ValueError:
            break
        rows.append(row)
    return rows


def staggered_butts(curves, seams, ends, apart, shortest):
    """Curves across the ship between its ends (low, high), so far apart, those of neighbouring
    strakes by half of that; pieces that are no longer than `shortest` are left out."""
    low, high = ends
    made = []
    for row, share in enumerate((0.5, 1.0)):
        for k in range(int((high - low) / apart) + 1):
            at = low + (k + share) * apart
            # No narrow plates at the ends.
            if not low + 0.3 * apart < at < high - 0.3 * apart:
                continue
            for curve in curves.in_plane(plane_across("x", at), f"Butt {at:.2f}"):
                pieces = curves.pieces(curve, seams)
                pieces.sort(key=lambda c: -c.points[:, 2].max())
                made += [p for p in pieces[row::2] if length_of_curve(p) > shortest]
    return made


def _butts(curves, seams, surface, strake, plate_length):
    x = np.asarray(surface.mesh.points)[:, 0]
    low, high = float(x.min()), float(x.max())
    if int((high - low) / plate_length) > MOST_BUTTS:
        raise ValueError(f"Plates of {plate_length:g} m are too many: make them longer.")
    # Not across the tips of strakes.
    return staggered_butts(curves, seams, (low, high), plate_length, _SHORTEST_BUTT * strake)
