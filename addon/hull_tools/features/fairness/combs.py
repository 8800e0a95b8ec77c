# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature combs of the hull's lines, their inflections and extrema of curvature.

Combs are of lines in the same places as those that are shown, whether these are switched on or not.
What is off is not computed.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...bridge import limits, native
from ...bridge.blender.units import as_typed
from ..lines import lines

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
HEIGHT = 0.05

# Over the hull's size: a curvature that is none.
STRAIGHT = 1e-3

# Of what no plane cuts.
_ALL = lines.Cut(())
# Of the hull's size: the distance of teeth that is not given.
_STEP = 1.0 / 200.0


@dataclass(frozen=True, eq=False)
class Judged:
    """hull_native.CurveFairness of the section by a lines.Cut, or of knuckles and borders: then
    `cut` is None."""

    cut: object
    curves: list


@dataclass(frozen=True, eq=False)
class CombGroup:
    """All Judged lines of one kind.

    scale: m of tooth for a curvature of 1/m, before the factor of the settings. rules: what
    section_fairness was told beside the planes.
    """

    kind: str
    key: tuple
    is_mirrored: bool
    sections: tuple
    scale: float
    rules: dict

    @cached_property
    def curves(self):
        return _curves_of(self.sections)

    @cached_property
    def _teeth(self):
        """(points (n, 3) in m, curvature vectors (n, 3) in 1/m, pairs (m, 2) of points that follow
        one another), of all that the cuts want to know."""
        return native.require().comb_arrays(self.curves, **_seen(self.sections))

    def comb(self, scale):
        """(points (n, 3), ends of their teeth (n, 3), pairs (m, 2) of ends that a line joins), in
        m; scale in m²."""
        points, bends, pairs = self._teeth
        return points, points - scale * bends, pairs

    def segments(self, scale):
        """(segments (n, 2, 3), how many of them at the start are teeth), in m; scale in m²."""
        points, tips, pairs = self.comb(scale)
        return np.concatenate([np.stack([points, tips], axis=1), tips[pairs]]), len(points)

    @cached_property
    def marks(self):
        """Points (n, 3) in m by MARKS: inflections, where the curve bends most and least."""
        return self._marks_of(self.sections)

    @cached_property
    def mark_counts(self):
        """How many there are of each of MARKS, those of the other side's images left out."""
        own = [one for one in self.sections if one.cut is None or not one.cut.is_image]
        marks = self.marks if len(own) == len(self.sections) else self._marks_of(own)
        return {name: len(points) for name, points in marks.items()}

    def _marks_of(self, sections):
        found = native.require().comb_marks(
            _curves_of(sections), straight=self.rules["noise"], **_seen(sections)
        )
        return dict(zip(MARKS, found))


def _curves_of(sections):
    return [curve for section in sections for curve in section.curves]


def _seen(sections):
    """What comb_arrays is told of the curves of Judged: which of their points are wanted, and
    whether they stand for their mirror images."""
    cuts = [section.cut or _ALL for section in sections for _ in section.curves]
    return {"sides": [cut.side for cut in cuts], "flips": [cut.flip for cut in cuts]}


def combs(known, surface, settings, moved, metres_per_unit, shown=()):
    """CombGroup by kind that an Object.hull wants; `known` ones are taken that are the same still,
    and of the others the sections that are. moved: the moves.Moves of the surface. shown:
    lines.Group of the surface as it is, whose sections need not be cut again.

    The scale of a kind is chosen when it is switched on, or when the mesh's faces change; then it
    stays, so that combs can be compared while points move.
    """
    fairness = settings.fairness
    kinds = [kind for kind, switch in SWITCHES.items() if getattr(fairness, switch)]
    if not kinds:
        return {}
    size = lines.size_of(surface)
    rules = _rules(surface, as_typed(fairness.comb_step) * metres_per_unit)
    cuts = lines.cuts_of_kinds(settings, surface.mesh.points, metres_per_unit, kinds)
    cut_already = {one.cut: one.curves for group in shown for one in group.sections}
    groups = {}
    for kind in kinds:
        key = (moved.after, settings.half, cuts[kind], tuple(rules.values()))
        before = known.get(kind)
        if before is not None and before.key == key:
            groups[kind] = before
            continue
        sections = _judged(surface, kind, cuts[kind], rules, before, moved, cut_already)
        if before is not None and before.scale > 0.0 and before.key[0][0] == moved.after[0]:
            scale = before.scale
        else:
            scale = _handy_scale([curve for one in sections for curve in one.curves], size)
        is_mirrored = settings.half and kind != "plane"
        groups[kind] = CombGroup(kind, key, is_mirrored, sections, scale, rules)
    return groups


def _rules(surface, step):
    """Arguments of section_fairness; they stay while points move a little."""
    size = lines.steady_size(surface)
    if step:
        least = limits.LEAST_TOOTH_DISTANCE * size
        limits.within(step, "Distance of the combs' teeth in m", least, limits.LONGEST)
    return {
        "step": step or _STEP * size,
        "noise": STRAIGHT / size,
        "chord_tolerance": lines.chord_tolerance(surface),
        "flat_tolerance": lines.flat_tolerance(surface),
    }


def _handy_scale(curves, size):
    """A scale for teeth of a handy length; what is straight to rounding gets none that show."""
    if not curves:
        return 0.0
    height = HEIGHT * size
    scale = native.require().suggested_comb_scale(curves, height=height)
    return min(scale, height * size / STRAIGHT)


def _judged(surface, kind, cuts, rules, before, moved, cut_already):
    judged = _judgements_that_stay(before, rules, moved)
    new = [cut for cut in cuts if cut not in judged]
    own = [cut for cut in new if cut not in cut_already]
    if own:
        planes = np.array([cut.plane for cut in own])
        sections = moved.sections(
            surface, planes, rules["chord_tolerance"], rules["flat_tolerance"]
        )
        cut_already.update(zip(own, sections))
    if new:
        planes = np.array([cut.plane for cut in new])
        found = moved.fairness(planes, [cut_already[cut] for cut in new], **_noise(rules))
        judged.update((cut, Judged(cut, one)) for cut, one in zip(new, found))
    sections = [judged[cut] for cut in cuts]
    if kind == "feature":
        found = native.require().feature_fairness(surface, **_noise(rules))
        sections.append(Judged(None, found))
    return tuple(sections)


def _noise(rules):
    """What of the rules tells how to judge what is cut."""
    return {name: rules[name] for name in ("step", "noise")}


def _judgements_that_stay(before, rules, moved):
    """Judged by Cut of a CombGroup of before, or None, that a move left as they are."""
    if before is None or before.rules != rules:
        return {}
    sections = [one for one in before.sections if one.cut is not None]
    planes = [one.cut.plane for one in sections]
    stay = moved.kept(before.key[0], planes, rules["flat_tolerance"])
    return {one.cut: one for one, is_same in zip(sections, stay) if is_same}
