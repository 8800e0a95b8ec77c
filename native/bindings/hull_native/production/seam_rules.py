# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams and butts of half a hull's shell by rules, which are made anew on any hull."""

from dataclasses import dataclass
from math import isfinite

import numpy as np

from .._core import plane_across
from .._production import HullCurves
from .knuckle_ends import closing_butts
from .plate_openings import opening_seams, openings_of, without_parts_inside
from .strakes import MOST_BUTTS, MOST_STRAKES, DeckEdges, girth_rows, is_central, staggered_butts

# What a rule makes, and what its number is.
KINDS = {
    "strakes": "seams at multiples of a girth from the deck edge",
    "from_deck": "a seam at a girth from the deck edge",
    "from_centre": "a seam at a girth from the centre line",
    "waterline": "a seam at a height",
    "buttock": "a seam at a distance from the centre plane",
    "station": "a butt all around at a place along the ship",
    "butts": "butts so far apart, staggered from strake to strake",
    "projected": "a seam by a line projected across the ship",
    "openings": "a seam around each opening at a distance",
}
_PLANES = {"waterline": "z", "buttock": "y", "station": "x"}
_SHORTEST_BUTT = 0.05  # m


@dataclass(frozen=True)
class SeamRule:
    """kind: of KINDS. value: its number, m. line: points (k, 3), m, of "projected"."""

    kind: str
    value: float = 0.0
    line: object = None

    def __post_init__(self):
        if self.kind not in KINDS:
            raise ValueError(f'There are no seams by "{self.kind}", but by {", ".join(KINDS)}.')
        if not isfinite(self.value):
            raise ValueError(f"The number of {self} must be a length in m.")
        if self.kind == "openings" and self.value < 0.0:
            raise ValueError(f"The number of {self} must be 0 m or more.")
        if self.kind not in (*_PLANES, "projected", "openings") and self.value <= 0.0:
            raise ValueError(f"The number of {self} must be above 0 m.")
        if self.kind == "projected" and (self.line is None or np.shape(self.line)[-1:] != (3,)):
            raise ValueError(f"For {self} give a line of points.")

    def __str__(self):
        number = "" if self.kind == "projected" else f", {self.value:g} m"
        return f'the rule "{KINDS[self.kind]}{number}"'


def seams_by_rules(surface, rules, *, knuckles=True, tolerance=None, appendages=()):
    """(HullCurves, list of SurfaceCurve): the seams and butts of half a hull by SeamRules, for
    plates(). knuckles: seams along these, too, and a butt across each that fades out in the shell.
    Butts end on seams. appendages: Appendages, the cylinders among which make openings; seams
    around these interrupt all others but those along knuckles.

    ValueError, naming the rule, where one meets nothing of the hull or makes too many seams.
    """
    rules = list(rules)
    curves = HullCurves(surface, tolerance)
    along_knuckles = [*curves.knuckles()] if knuckles else []
    seams = []
    for rule in rules:
        if rule.kind not in ("butts", "strakes", "openings"):
            seams += _one(curves, rule)
        elif rule.kind == "strakes":
            seams += _strakes(curves, rule)
    long = along_knuckles + seams
    butts = [b for rule in rules if rule.kind == "butts" for b in _butts(curves, long, rule)]
    closing = closing_butts(surface, curves, long) if knuckles else []
    others, around = seams + butts, []
    for rule in (rule for rule in rules if rule.kind == "openings"):
        openings = openings_of(appendages)
        rings = opening_seams(curves, openings, rule.value)
        if not rings:
            raise ValueError(
                f"Nothing of the hull is met by {rule}: no tunnel or tube opens the shell."
            )
        others = without_parts_inside(curves, others, rings, openings, rule.value)
        around += rings
    return curves, along_knuckles + others + around + closing


def _one(curves, rule):
    name = {"station": "Butt", "projected": "Line"}.get(rule.kind, "Seam") + f" {rule.value:g}"
    try:
        if rule.kind in _PLANES:
            return curves.in_plane(plane_across(_PLANES[rule.kind], rule.value), name)
        if rule.kind == "from_deck":
            return DeckEdges(curves).at_girth(rule.value, f"D {rule.value:g}")
        if rule.kind == "from_centre":
            base, towards = centre_line(curves), (0.0, 1.0, 0.0)
            return curves.at_girth(base, rule.value, towards=towards, name=f"K {rule.value:g}")
        return curves.projected(rule.line, direction=(0.0, -1.0, 0.0), name="Line")
    except ValueError as error:
        raise ValueError(f"Nothing of the hull is met by {rule}: {error}") from error


def centre_line(curves):
    """The SurfaceCurve of the border in the centre plane that runs lowest along the ship."""
    central = [c for c in curves.borders() if is_central(c)]
    if not central:
        raise ValueError("The hull has no border in the centre plane: is it half a hull?")
    longest = max(np.ptp(c.points[:, 0]) for c in central)
    return min(
        (c for c in central if np.ptp(c.points[:, 0]) > 0.5 * longest),
        key=lambda c: c.points[:, 2].min(),
    )


def _strakes(curves, rule):
    rows = girth_rows(curves, rule.value)
    if not rows:
        raise ValueError(f"The shell is narrower than {rule}: take a smaller one.")
    if len(rows) > MOST_STRAKES:
        raise ValueError(f"More than {MOST_STRAKES} seams follow from {rule}: take a larger one.")
    return [curve for row in rows for curve in row]


def _butts(curves, seams, rule):
    ends = [c.points[:, 0] for c in curves.borders()]
    low, high = min(x.min() for x in ends), max(x.max() for x in ends)
    if int((high - low) / rule.value) > MOST_BUTTS:
        raise ValueError(f"More than {MOST_BUTTS} butts follow from {rule}: take a larger one.")
    return staggered_butts(curves, seams, (low, high), rule.value, _SHORTEST_BUTT)
