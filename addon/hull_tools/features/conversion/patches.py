# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull's surface as B-spline patches, how far they are from it, and what to say of that."""

from dataclasses import dataclass
from math import radians, sqrt

from ...bridge import native
from ...bridge.blender import units
from ..flotation.afloat import as_typed_angle
from . import file_sizes

AUTOMATIC, EXACT, PER_CELL = "AUTOMATIC", "EXACT", "PER_CELL"

# Options that ask for patches of a certain kind.
_FOR_OTHER_SYSTEMS = ("matched_knots", "most_control_points", "bezier")

# Of the time that conversion and measuring take together.
_SHARE_OF_CONVERSION = 0.2

# Seam angle that goes with a tolerance of a millionth, and with the root of others.
_USUAL_ANGLE, _USUAL_TOLERANCE = radians(0.02), 1e-6
# Measured values this much above what was asked for are rounding.
_ROUNDING = 1.0 + 1e-6
# Of the length: gaps below are those between numbers of double precision.
_NO_GAP = 1e-12


@dataclass(frozen=True)
class Choice:
    """A way of conversion: AUTOMATIC, EXACT or PER_CELL, with those of its options that are not as
    usual."""

    conversion: str
    options: tuple


@dataclass(frozen=True)
class Asked:
    """What patches are judged by: tolerance as a part of the hull's length, seam_angle in rad."""

    tolerance: float
    seam_angle: float


@dataclass(frozen=True, eq=False)
class Converted:
    """patches: hull_native.PatchSet; quality: the hull_native.QualityReport of their distances;
    cell_count: of the surface; is_exact: whether they are exact patches and not one a cell;
    spared_control_points: how many exact ones would have, where AUTOMATIC did not take them."""

    patches: object
    quality: object
    cell_count: int
    is_exact: bool
    spared_control_points: int = 0


def choice_of(settings):
    """The Choice of an Object.hull.export; what its conversion does not ask for is left out."""
    if settings.conversion == PER_CELL:
        return Choice(PER_CELL, (("control_points", settings.control_points),))
    options = {
        "tolerance": units.as_typed(settings.tolerance),
        "seam_angle": as_typed_angle(settings.seam_angle),
        "matched_knots": settings.matched_knots,
        "most_control_points": settings.most_control_points,
        "bezier": settings.bezier,
    }
    # Who asks for patches of a certain kind has a system that needs them.
    is_free = not any(options[name] for name in _FOR_OTHER_SYSTEMS)
    conversion = AUTOMATIC if settings.conversion == AUTOMATIC and is_free else EXACT
    return Choice(conversion, tuple((name, value) for name, value in options.items() if value))


def convert(surface, choice, progress):
    """The Converted of a hull_native.LimitSurface. For any thread.

    AUTOMATIC takes exact patches, or one a cell where exact ones make a file that is too large
    (file_sizes).

    progress: a function of the share that is done; what it raises ends the work.
    """
    found, is_exact, spared = _patches(
        surface, choice, lambda share: progress(_SHARE_OF_CONVERSION * share)
    )
    rest = 1.0 - _SHARE_OF_CONVERSION
    quality = native.require().measure_quality(
        surface, found, progress=lambda share: progress(_SHARE_OF_CONVERSION + rest * share)
    )
    return Converted(found, quality, surface.cell_count, is_exact, spared)


def _patches(surface, choice, progress):
    """(hull_native.PatchSet, and the others that a Converted has)."""
    hull_native, options = native.require(), dict(choice.options)
    if choice.conversion == PER_CELL:
        return hull_native.fit_per_cell(surface, **options), False, 0
    exact = hull_native.exact_patches(surface, **options, progress=progress)
    count = sum(exact.control_points(number)[..., 0].size for number in range(exact.patch_count))
    if choice.conversion == EXACT or not file_sizes.are_cells_better(count, surface.cell_count):
        return exact, True, 0
    return hull_native.fit_per_cell(surface), False, count


def asked_of(settings):
    """The Asked of an Object.hull.export."""
    tolerance = units.as_typed(settings.tolerance)
    usual_angle = _USUAL_ANGLE * sqrt(tolerance / _USUAL_TOLERANCE)
    return Asked(tolerance, as_typed_angle(settings.seam_angle) or usual_angle)


def warnings(quality, asked):
    """Sentences about what was Asked for and a quality report does not show."""
    found = []
    tolerance = asked.tolerance * quality.length
    if quality.largest_distance > _ROUNDING * tolerance:
        found.append(f"The distance is above the tolerance of {units.format_mm(tolerance)}")
    if quality.largest_seam_angle > _ROUNDING * asked.seam_angle:
        found.append(f"The seam angle is above {units.format_small_angle(asked.seam_angle)}")
    if quality.largest_gap > _NO_GAP * quality.length:
        found.append("There are gaps between the patches")
    return found


def summary(converted, asked):
    """(one sentence for people, whether it warns) about a Converted."""
    quality = converted.quality
    distance = units.format_mm(quality.largest_distance)
    text = (
        f"{quality.patch_count} patches{_spared(converted)}, distance {distance}, "
        f"seam angle {units.format_small_angle(quality.largest_seam_angle)}"
    )
    missed = warnings(quality, asked)
    return ". ".join([text, *missed]), bool(missed)


def _spared(converted):
    """Why there is a patch for each cell, though nobody asked for that."""
    if not converted.spared_control_points:
        return ""
    return f", one a cell for {converted.spared_control_points} control points of exact ones"


def rows(converted):
    """Pairs (name, value with its unit) of a Converted, for people."""
    quality = converted.quality
    patch_count = f"{quality.patch_count}, least {quality.theoretical_patch_count}"
    return (
        ("Conversion", "exact" if converted.is_exact else "one a cell"),
        ("Distance", units.format_mm(quality.largest_distance)),
        ("Of length", f"{quality.largest_distance_per_length:.2g}"),
        ("RMS", units.format_mm(quality.rms_distance)),
        ("Seam angle", units.format_small_angle(quality.largest_seam_angle)),
        ("Curvature Δ", units.format_jump(quality.largest_curvature_jump)),
        ("Gaps", _gap(quality)),
        ("Exact", _percent(quality.exact_share)),
        ("Patches", patch_count),
        ("Control points", str(quality.control_point_count)),
    )


def _gap(quality):
    is_none = quality.largest_gap <= _NO_GAP * quality.length
    return "none" if is_none else units.format_mm(quality.largest_gap)


def _percent(share):
    """No share but the whole is told as 100 %."""
    return "100 %" if share > 1.0 - 1e-9 else f"{min(100.0 * share, 99.9999):.6g} %"
