# SPDX-License-Identifier: GPL-3.0-or-later
"""The hull's lines: its sections by planes of several kinds, knuckles and borders, rims of flats.

A kind that is switched off costs nothing, and only what has changed is computed anew, all planes of
it in one go.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import NamedTuple

import numpy as np

from ...bridge import limits, native
from ...bridge.blender.units import as_typed
from .line_places import line_places

# In the order in which they are drawn: what is most important last.
KINDS = ("station", "waterline", "buttock", "diagonal", "plane", "draft", "flat", "feature")

# The switch of each in Object.hull.lines.
SWITCHES = {
    "station": "show_stations",
    "waterline": "show_waterlines",
    "buttock": "show_buttocks",
    "diagonal": "show_diagonals",
    "plane": "show_planes",
    "draft": "show_design_waterline",
    "flat": "show_flats",
    "feature": "show_features",
}

# Of the hull's size: how far chords depart from the curve.
_CHORD_TOLERANCE = 1e-5
_STEPS_AN_OCTAVE = 4
_SAMPLES_PER_EDGE = 16
# Flats smaller than this part of the size squared are not what is called one.
_SMALLEST_FLAT = 1e-4

_TO_STARBOARD = np.array([1.0, -1.0, 1.0])


class Cut(NamedTuple):
    """A plane as (normal, offset) to cut the surface by.

    side: 1 or -1 where only what is to port or starboard of the centre plane counts, else 0. flip:
    whether what is found stands for its mirror image. is_image: whether this is the other side's
    part of a line that another Cut stands for.
    """

    plane: tuple
    side: int = 0
    flip: bool = False
    is_image: bool = False


@dataclass(frozen=True, eq=False)
class Section:
    """A Cut and the hull_native.SectionCurve that it gave."""

    cut: Cut
    curves: list

    @cached_property
    def polylines(self):
        """Polylines (k, 3) in m."""
        return [part for curve in self.curves for part in self.parts(curve.points, curve.points)]

    def parts(self, points, values):
        """The stretches of `values` (k, 3), each belonging to one of a curve's points, of which
        the cut wants to know."""
        values = flipped(self.cut, values)
        if not self.cut.side:
            return [values]
        wanted = kept_by(self.cut, points)
        ends = np.flatnonzero(np.diff(wanted)) + 1
        kept = np.split(values, ends)[0 if wanted[0] else 1 :: 2]
        return [part for part in kept if len(part) > 1]


@dataclass(frozen=True, eq=False)
class Group:
    """All lines of one kind, in m. is_mirrored: whether their mirror images belong to it too.

    key: the surface's, whether it is a half, and the cuts. tolerance: m, of the sections."""

    kind: str
    key: tuple
    is_mirrored: bool
    sections: tuple = ()
    features: tuple = ()
    tolerance: float = 0.0

    @cached_property
    def polylines(self):
        return [line for one in self.sections for line in one.polylines] + list(self.features)

    @property
    def cut_count(self):
        """How many of the planes meet the hull."""
        return sum(1 for section in self.sections if section.curves and not section.cut.is_image)


def kept_by(cut, points):
    """(k,) which points (k, 3) a cut wants to know of."""
    return points[:, 1] * cut.side >= 0.0


def flipped(cut, values):
    """Values (..., 3) found by a cut, to where they stand for."""
    return values * _TO_STARBOARD if cut.flip else values


def wanted_cuts(settings, points, metres_per_unit):
    """The Cuts that an Object.hull wants shown, as tuples by kind; only what is switched on.

    points: the control points (n, 3) in m. ValueError as line_places.
    """
    kinds = [kind for kind in KINDS if getattr(settings.lines, SWITCHES[kind])]
    return cuts_of_kinds(settings, points, metres_per_unit, kinds)


def cuts_of_kinds(settings, points, metres_per_unit, kinds):
    """The Cuts of some KINDS, shown or not, as tuples by kind; ValueError as line_places."""
    if not kinds:
        return {}
    places = line_places(settings, metres_per_unit)
    stations, waterlines, buttocks = places.positions(points)
    draft = as_typed(settings.draft) * metres_per_unit
    sides = (1.0,) if settings.half else (1.0, -1.0)
    cuts = {
        "station": [_across(0, x) for x in stations],
        "waterline": [_across(2, z) for z in waterlines],
        "buttock": [_across(1, side * y, side < 0.0) for y in buttocks for side in sides],
        "diagonal": _diagonals(places.diagonals, settings.half),
        "plane": _planes(settings.lines.planes, settings.half, metres_per_unit),
        "draft": [_across(2, draft)] if draft > 0.0 else [],
        "flat": [],
        "feature": [] if settings.half else [_across(1, 0.0)],
    }
    return {kind: tuple(cuts[kind]) for kind in kinds}


@lru_cache(maxsize=1024)
def _across(axis, position, is_image=False):
    normal = [0.0, 0.0, 0.0]
    normal[axis] = 1.0
    return Cut((*normal, float(position)), is_image=is_image)


def _diagonals(wanted, half):
    hull_native = native.require()
    cuts = []
    for height, angle in wanted:
        x, y, z, offset = hull_native.diagonal_plane(height, angle).tolist()
        cuts.append(Cut((x, y, z, offset), side=0 if half else 1))
        if not half:
            cuts.append(Cut((x, -y, z, offset), side=-1, is_image=True))
    return cuts


def _planes(planes, half, metres_per_unit):
    """Of a half hull the other side is cut by the plane's mirror image."""
    cuts = []
    limits.at_most(len(planes), "planes", limits.MOST_LINES)
    for plane in planes:
        normal = np.array(plane.normal, dtype=np.float64)
        length = np.linalg.norm(normal)
        if not plane.is_shown or length < 1e-6:
            continue
        normal /= length
        # A normal that was typed as 0 0 1 stays so.
        offset = float(normal @ [as_typed(part) * metres_per_unit for part in plane.point])
        cuts.append(Cut((*normal.tolist(), offset)))
        if half:
            image = (*(normal * _TO_STARBOARD).tolist(), offset)
            cuts.append(Cut(image, flip=True, is_image=True))
    return cuts


def groups(known, surface, wanted, half, moved):
    """Groups by kind of the `wanted` cuts of a hull_native.LimitSurface.

    known: the groups of before, of which those are taken that are the same still, and of the others
    the sections that are. moved: the moves.Moves of the surface.
    """
    keys = {kind: (moved.after, half, cuts) for kind, cuts in wanted.items()}
    found = {
        kind: known[kind] for kind, key in keys.items() if kind in known and known[kind].key == key
    }
    missing = [kind for kind in wanted if kind not in found]
    tolerance = flat_tolerance(surface)
    stays = {}
    for kind in missing:
        stays[kind] = _sections_that_stay(known.get(kind), moved, tolerance)
    new = [cut for kind in missing for cut in wanted[kind] if cut not in stays[kind]]
    curves = iter(_curves(surface, new, moved))
    for kind in missing:
        own = stays[kind]
        found[kind] = Group(
            kind,
            keys[kind],
            half and kind != "plane",  # whose images are among the cuts
            tuple(own[cut] if cut in own else Section(cut, next(curves)) for cut in wanted[kind]),
            _other_curves(kind, surface),
            tolerance,
        )
    return {kind: found[kind] for kind in KINDS if kind in found}


def _sections_that_stay(before, moved, tolerance):
    """The Sections by Cut of a Group of before, or None, that a move left as they are."""
    if before is None or before.tolerance != tolerance:
        return {}
    planes = [section.cut.plane for section in before.sections]
    stay = moved.kept(before.key[0], planes, tolerance)
    return {one.cut: one for one, is_same in zip(before.sections, stay) if is_same}


def _curves(surface, cuts, moved):
    if not cuts:
        return []
    planes = np.array([cut.plane for cut in cuts])
    return moved.sections(surface, planes, chord_tolerance(surface), flat_tolerance(surface))


def _other_curves(kind, surface):
    """Those of a kind that no planes cut."""
    if kind == "feature":
        return _features(surface)
    return tuple(border.points(_SAMPLES_PER_EDGE) for border in flat_borders(surface, kind))


def flat_borders(surface, kind="flat"):
    """The hull_native.FlatBorders around the flats of side, bottom and transom."""
    if kind != "flat":
        return []
    size = size_of(surface)
    flats = native.require().flat_regions(surface, smallest_area=_SMALLEST_FLAT * size * size)
    return [border for flat in flats for border in flat.borders]


def _features(surface):
    found = native.require().feature_curves(surface, _SAMPLES_PER_EDGE)
    return tuple(curve.points for curve in found)


def size_of(surface):
    """The greatest extent of the faces' control points along x, y and z, in m."""
    return surface.mesh.greatest_extent


def steady_size(surface):
    """A size that stays while points move, for tolerances: that of the surface, rounded down by up
    to a fifth."""
    size = size_of(surface)
    return 2.0 ** (np.floor(_STEPS_AN_OCTAVE * np.log2(size)) / _STEPS_AN_OCTAVE) if size else 0.0


def chord_tolerance(surface):
    return _CHORD_TOLERANCE * steady_size(surface)


def flat_tolerance(surface):
    return native.require().tolerances.IN_SECTION * steady_size(surface)


def mirror_image(points):
    return points * _TO_STARBOARD


def is_off_centre(points, tolerance):
    """Whether a curve (k, 3) has a mirror image other than itself."""
    return bool(np.abs(points[:, 1]).max() > tolerance)
