# SPDX-License-Identifier: GPL-3.0-or-later
"""A first division of a half hull's shell: seams at girths from the deck edge, staggered butts."""

import numpy as np

from .._core import plane_across, tolerances
from .._production import HullCurves
from ..polylines import length_of
from .knuckle_ends import closing_butts

# A strake beside the centre line has this part of the others' breadth at least, where the girth is
# largest.
_LAST_STRAKE = 0.4
# Of the breadth of strakes.
_SHORTEST_BUTT = 0.4
_DOWN = (0.0, 0.0, -1.0)
MOST_STRAKES, MOST_BUTTS = 60, 400


def deck_edges(curves):
    """The SurfaceCurves of HullCurves' borders that run along the ship, off its centre plane, and
    below no other one: of a deck with corners several, two of a demihull. Where a hull has none,
    the highest one in the centre plane."""
    borders = curves.borders()
    if not borders:
        raise ValueError("The hull has no border along a deck: give its seams yourself.")
    long = [c for c in borders if np.ptp(c.points[:, 0]) > 0.5 * length_of(c.points)]
    beside = [c for c in long if not is_central(c)]
    if beside:
        return [c for c in beside if not any(_is_below(c, other) for other in beside)]
    longest = max(np.ptp(c.points[:, 0]) for c in borders)
    long = [c for c in borders if np.ptp(c.points[:, 0]) > 0.8 * longest]
    return [max(long, key=lambda c: c.points[:, 2].mean())]


def is_central(curve):
    """Whether a SurfaceCurve lies in the centre plane, by its own size."""
    return np.abs(curve.points[:, 1]).max() <= tolerances.ON_CENTRE_PLANE * _size(curve)


def _is_below(curve, other):
    """Whether most of a curve runs below another one."""
    ends = [(c.points[:, 0].min(), c.points[:, 0].max()) for c in (curve, other)]
    (low, high), (first, last) = ends
    common = min(high, last) - max(low, first)
    return common > 0.5 * (high - low) and curve.points[:, 2].max() < other.points[:, 2].min()


class DeckEdges:
    """The deck edges of HullCurves, from which girths are measured down."""

    def __init__(self, curves):
        self._curves, self._decks = curves, deck_edges(curves)
        self._middle = _middle(curves, self._decks)

    def at_girth(self, girth, name):
        """SurfaceCurves at a girth; ValueError where it is nowhere."""
        found, why = [], None
        for deck in self._decks:
            try:
                at = self._curves.at_girth(deck, girth, towards=_DOWN, name=name)
            except ValueError as error:
                why = error
                continue
            found += [piece for curve in at for piece in self._of_its_side(curve, deck)]
        if not found:
            raise ValueError(str(why or f'"{name}" is off the hull.'))
        return found

    def _of_its_side(self, curve, deck):
        """The pieces of a curve that lie on the same side of the middle line as its deck edge."""
        if self._middle is None:
            return [curve]
        y, line = self._middle
        side = np.sign(deck.points[:, 1].mean() - y)
        pieces = self._curves.pieces(curve, line)
        return [piece for piece in pieces if side * (piece.points[:, 1].mean() - y) > 0.0]


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
    butts = _butts(curves, seams, surface, strake, plate_length)
    return curves, seams + butts + closing_butts(surface, curves, seams)


def _letters(k):
    """A … Z, AA …"""
    text = ""
    k += 1
    while k:
        k, rest = divmod(k - 1, 26)
        text = chr(65 + rest) + text
    return text


def girth_rows(curves, strake):
    """Rows of curves of HullCurves at multiples of a girth from the deck edges down, as long as the
    shell below has room; one more than MOST_STRAKES where there are more."""
    decks, rows = DeckEdges(curves), []
    for k in range(1, MOST_STRAKES + 2):
        try:
            row = decks.at_girth(k * strake, f"Seam {k}")
            decks.at_girth((k + _LAST_STRAKE) * strake, "")
        except ValueError:
            break
        rows.append(row)
    return rows


def _middle(curves, decks):
    """(y, its lines) midway between the deck edges on either side of a demihull, which has no
    border in the centre plane; None of half a hull."""
    if len(decks) < 2 or any(is_central(border) for border in curves.borders()):
        return None
    y = np.mean([deck.points[:, 1].mean() for deck in decks])
    return y, curves.in_plane(plane_across("y", y), "Middle")


def _size(curve):
    return max(float(np.linalg.norm(np.ptp(curve.points, axis=0))), 1e-9)


def staggered_butts(curves, seams, ends, apart, shortest):
    """Curves across the ship between its ends (low, high), so far apart, those of neighbouring
    strakes by half of that; pieces that are no longer than `shortest` are left out, and planes
    that do not meet the hull."""
    low, high = ends
    made = []
    for row, share in enumerate((0.5, 1.0)):
        for k in range(int((high - low) / apart) + 1):
            at = low + (k + share) * apart
            # No narrow plates at the ends.
            if not low + 0.3 * apart < at < high - 0.3 * apart:
                continue
            try:
                across = curves.in_plane(plane_across("x", at), f"Butt {at:.2f}")
            except ValueError:  # control points may lie beyond the surface, as at bulbs
                continue
            for curve in across:
                pieces = curves.pieces(curve, seams)
                pieces.sort(key=lambda c: -c.points[:, 2].max())
                made += [p for p in pieces[row::2] if length_of(p.points) > shortest]
    return made


def _butts(curves, seams, surface, strake, plate_length):
    x = np.asarray(surface.mesh.points)[:, 0]
    low, high = float(x.min()), float(x.max())
    if int((high - low) / plate_length) > MOST_BUTTS:
        raise ValueError(f"Plates of {plate_length:g} m are too many: make them longer.")
    # Not across the tips of strakes.
    return staggered_butts(curves, seams, (low, high), plate_length, _SHORTEST_BUTT * strake)
