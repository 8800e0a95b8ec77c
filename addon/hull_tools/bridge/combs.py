# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature combs of the hull's lines, their inflections and extrema of curvature.

Combs are of lines in the same places as those that are shown, whether these are switched on or not.
What is off is not computed.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from . import lines, native
from .units import as_typed

# The switch of each kind of lines.KINDS in Object.hull.fairness.
SWITCHES = {
    "station": "comb_stations",
    "waterline": "comb_waterlines",
    "buttock": "comb_buttocks",
    "diagonal": "comb_diagonals",
    "plane": "comb_planes",
    "feature": "comb_features",
}

MARKS = ("inflection", "maximum", "minimum")

# At a factor of 1 nearly all teeth are shorter than this part of the hull's size.
_HEIGHT = 0.05

# Over the hull's size: a curvature that is none.
_STRAIGHT = 1e-3


@dataclass(frozen=True, eq=False)
class CombGroup:
    """hull_native.CurveFairness of all lines of one kind; pairs (lines.Cut or None, curves).

    scale: m of tooth for a curvature of 1/m, before the factor of the settings. straight: a
    curvature in 1/m that is none.
    """

    kind: str
    key: tuple
    is_mirrored: bool
    sections: tuple
    scale: float
    straight: float

    @cached_property
    def curves(self):
        return [curve for _, curves in self.sections for curve in curves]

    def segments(self, scale):
        """(segments (n, 2, 3), how many of them at the start are teeth), in m; scale in m²."""
        teeth, outlines = [], []
        for cut, curve in self._cut_curves():
            found = curve.comb(scale=scale)
            count = len(curve.points)
            own_teeth, outline = found[:count], found[count:]
            if cut is not None:
                kept = lines.kept_by(cut, curve.points)
                firsts = np.delete(np.arange(count), curve.starts[1:] - 1)
                if len(outline) == len(firsts):
                    outline = outline[kept[firsts] & kept[firsts + 1]]
                own_teeth, outline = (
                    lines.flipped(cut, part) for part in (own_teeth[kept], outline)
                )
            teeth.append(own_teeth)
            outlines.append(outline)
        if not teeth:
            return np.empty((0, 2, 3)), 0
        return np.concatenate(teeth + outlines), sum(map(len, teeth))

    @cached_property
    def marks(self):
        """Points (n, 3) in m by MARKS: inflections, where the curve bends most and least."""
        return _marks(self._cut_curves(), self.straight)

    @cached_property
    def mark_counts(self):
        """How many there are of each of MARKS, those of the other side's images left out."""
        own = ((cut, one) for cut, one in self._cut_curves() if cut is None or not cut.is_image)
        return {name: len(points) for name, points in _marks(own, self.straight).items()}

    def _cut_curves(self):
        return ((cut, curve) for cut, curves in self.sections for curve in curves)


def _marks(cut_curves, straight):
    """straight: 1/m, a curvature that is none."""
    found = {name: [] for name in MARKS}
    for cut, curve in cut_curves:
        marks = curve.marks
        if not len(marks):
            continue
        points = marks.points
        kept = np.ones(len(points), dtype=bool)
        if cut is not None:
            kept, points = lines.kept_by(cut, points), lines.flipped(cut, points)
        is_inflection = np.array(marks.kinds) == "inflection"
        # What is straight to rounding bends to neither side.
        peaks = marks.peaks & (np.abs(marks.values) > straight)
        found["inflection"].append(points[kept & is_inflection])
        found["maximum"].append(points[kept & ~is_inflection & peaks])
        found["minimum"].append(points[kept & ~is_inflection & ~peaks])
    return {name: np.concatenate([np.empty((0, 3)), *parts]) for name, parts in found.items()}


def combs(known, surface, settings, geometry_key, metres_per_unit):
    """CombGroup by kind that an Object.hull wants; `known` ones are taken that are the same still.

    The scale of a kind is chosen when it is switched on, or when the mesh's faces change; then it
    stays, so that combs can be compared while points move.
    """
    fairness = settings.fairness
    kinds = [kind for kind, switch in SWITCHES.items() if getattr(fairness, switch)]
    if not kinds:
        return {}
    size = lines.size_of(surface)
    step = as_typed(fairness.comb_step) * metres_per_unit or None
    cuts = lines.cuts_of_kinds(settings, surface.mesh.points, metres_per_unit, kinds)
    groups = {}
    for kind in kinds:
        key = (geometry_key, settings.half, cuts[kind], step)
        before = known.get(kind)
        if before is not None and before.key == key:
            groups[kind] = before
            continue
        sections = _judged(surface, kind, cuts[kind], step)
        if before is not None and before.scale > 0.0 and before.key[0][0] == geometry_key[0]:
            scale = before.scale
        else:
            scale = _handy_scale([curve for _, curves in sections for curve in curves], size)
        is_mirrored = settings.half and kind != "plane"
        groups[kind] = CombGroup(kind, key, is_mirrored, sections, scale, _STRAIGHT / size)
    return groups


def _handy_scale(curves, size):
    """A scale for teeth of a handy length; what is straight to rounding gets none that show."""
    if not curves:
        return 0.0
    height = _HEIGHT * size
    scale = native.require().suggested_comb_scale(curves, height=height)
    return min(scale, height * size / _STRAIGHT)


def _judged(surface, kind, cuts, step):
    hull_native = native.require()
    sections = []
    if cuts:
        found = hull_native.section_fairness(
            surface,
            np.array([cut.plane for cut in cuts]),
            step=step,
            flat_tolerance=lines.flat_tolerance(surface),
        )
        sections += zip(cuts, found)
    if kind == "feature":
        sections.append((None, hull_native.feature_fairness(surface, step=step)))
    return tuple(sections)
