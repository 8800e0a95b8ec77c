# SPDX-License-Identifier: GPL-3.0-or-later
"""A bulb made of the plain bow of a new round-bilge hull by three bases: the profile, a waterline
that ends at the bulb's tip, the lowest waterline. Lengths in m."""

from dataclasses import dataclass

import hull_native as hn
import numpy as np
from hull_io import new_hulls

from . import centre_line, follow, profile_number, waterline

KIND = "ROUND_BILGE"
LENGTH, BEAM, DRAFT, DEPTH = 100.0, 16.5, 6.2, 9.0
SECTIONS, POINTS, SUBDIVIDED = 18, 12, 2

# Heights of the first three points of the wanted profile's control polygon, on the stem, and the
# others (x, z): top, tip and bottom of the bulb, and the keel.
STEM_HEIGHTS = (7.2, 6.6, 6.0)
POLYGON = (
    (99.55, 5.1),
    (100.6, 4.35),
    (102.6, 3.75),
    (104.0, 2.8),
    (103.7, 1.5),
    (102.0, 0.68),
    (98.9, 0.42),
    (94.3, 0.17),
    (90.0, 0.0),
    (86.0, 0.0),
    (82.0, 0.0),
)
# The first base is upright, beside the stem: that bends so sharply at its foot that fields around
# it fold the bow. Its shifts follow from the wanted profile at these heights, what is left of them
# is brought about around the profile itself.
BASE_X, BASE_TOP, BASE_FOOT = 99.3, 6.4, -1.0
HEIGHTS = (6.4, 6.1, 5.8, 5.4, 5.0, 4.5, 4.0, 3.5, 3.0, 2.5, 2.0, 1.5, 1.0, 0.7)
EXTENT, FALLOFF = 16.0, 0.6
# It reaches TOP_EXTENT at its top, all of EXTENT from FULL_REACH down: shifts, which begin within a
# metre of height, would bend the flare far abaft, and lines of light that leave the fields there.
TOP_EXTENT, FULL_REACH = 9.0, 2.0
LEFT_EXTENT = 5.0
# The part of the profile that fields are based on.
AFT_END = 70.0
# Heights of the waterline through the tip, of one that is protected and of the lowest one; where
# the bulb runs out; points (x, y) of the fuller waterline.
TIP_Z, ABOVE_Z, LOW_Z, LOW_SHIFT = 2.2, 6.2, 1.0, 0.3
AFT_OF_BULB = 88.0
TIP_WATERLINE = (
    (103.60, 0.17),
    (103.15, 0.42),
    (102.5, 0.68),
    (101.7, 0.91),
    (100.6, 1.15),
    (99.2, 1.36),
    (97.7, 1.56),
)


def plain_bow():
    """The HullData of the new hull."""
    return new_hulls.new_hull(KIND, LENGTH, BEAM, DRAFT, DEPTH, SECTIONS, POINTS)


def fore_profile(surface):
    """Points (n, 3) from the deck at the stem down and aft along the keel."""
    line = centre_line(surface)
    return line[(line[:, 0] > AFT_END)]


def wanted_profile(surface):
    """(hull_native.FieldCurve with the bulb; its part that is not the plain bow's (n, 3))."""
    line = fore_profile(surface)
    stem = line[line[:, 2] > 4.0][::-1]
    polygon = [(np.interp(z, stem[:, 2], stem[:, 0]), z) for z in STEM_HEIGHTS]
    bulb = _cubic(np.array(polygon + list(POLYGON)))
    bulb = np.stack([bulb[:, 0], 0.0 * bulb[:, 0], bulb[:, 1]], axis=-1)
    above = line[line[:, 2] > bulb[0, 2] + 0.3]
    abaft = line[(line[:, 0] < bulb[-1, 0] - 0.5) & (line[:, 2] < 1.0)]
    return hn.FieldCurve(np.concatenate([above, bulb, abaft])), bulb


def _cubic(polygon, samples=12):
    """Points of the uniform cubic B-spline of a polygon."""
    t = (np.arange(samples) / samples)[:, None]
    weights = (
        (1 - t) ** 3,
        3 * t**3 - 6 * t**2 + 4,
        -3 * t**3 + 3 * t**2 + 3 * t + 1,
        t**3,
    )
    return (
        np.concatenate(
            [
                sum(w * polygon[i + j] for j, w in enumerate(weights))
                for i in range(len(polygon) - 3)
            ]
        )
        / 6.0
    )


def _intensity(delta):
    """Equation 3 for FALLOFF."""
    k = FALLOFF
    inner = (k**2 + k * delta**2 * (delta - 3.0) + delta**3) / k**2
    return np.where(delta < k, inner, (np.minimum(delta, 1.0) - 1.0) ** 3 / (k - 1.0))


def drawn_out(surface, top_extent=TOP_EXTENT):
    """The hull_native.ShapeFields that shift the stem forward to about the wanted profile."""
    heights = np.array(HEIGHTS)
    plain, (_, bulb) = fore_profile(surface)[::-1], wanted_profile(surface)
    plain = plain[plain[:, 2] < 9.0]
    at = np.interp(heights, plain[:, 2], plain[:, 0])
    ahead = np.interp(heights, bulb[::-1, 2], bulb[::-1, 0]) - at
    below = np.clip((BASE_TOP - heights) / (BASE_TOP - FULL_REACH), 0.0, 1.0)
    extents = top_extent + (EXTENT - top_extent) * below**2 * (3.0 - 2.0 * below)
    shifts = np.zeros((len(heights) + 1, 3))
    shifts[:-1, 0] = ahead / _intensity(np.abs(BASE_X - at) / extents)
    shifts[0], shifts[-1] = 0.0, shifts[-2]
    base = hn.FieldCurve([(BASE_X, 0.0, BASE_TOP), (BASE_X, 0.0, BASE_FOOT)])
    lengths = BASE_TOP - np.append(heights, BASE_FOOT)
    extents = lengths, np.append(extents, EXTENT)
    field = hn.ShapeField.along(base, (lengths, shifts), extent=extents, falloff=FALLOFF)
    return hn.ShapeFields([field], mirrored=True)


def onto_profile(surface, wanted, extent=LEFT_EXTENT):
    """The hull_native.ShapeFields that make a profile the wanted hull_native.FieldCurve."""
    base = hn.FieldCurve(fore_profile(surface))
    return hn.ShapeFields(
        [hn.ShapeField.to_curve(base, wanted, extent=extent, falloff=FALLOFF)], mirrored=True
    )


def fuller_at_tip(surface):
    """The hull_native.ShapeFields that make the waterline through the bulb's tip fuller; one
    waterline above is protected."""
    base = waterline(surface, TIP_Z)
    base = base[base[:, 0] > AFT_OF_BULB][::3]
    points = np.array([(x, y, TIP_Z) for x, y in TIP_WATERLINE])
    wanted = np.concatenate([base[:1], points, base[base[:, 0] < points[-1, 0] - 1.5]])
    above = waterline(surface, ABOVE_Z)
    return hn.ShapeFields(
        [
            hn.ShapeField.to_curve(
                hn.FieldCurve(base), hn.FieldCurve(wanted), extent=4.5, falloff=0.9
            ),
            hn.ShapeField.along(
                hn.FieldCurve(above[above[:, 0] > 85.0][::6]),
                extent=3.5,
                falloff=0.7,
                protects=True,
            ),
        ],
        mirrored=True,
    )


def fuller_below(surface):
    """The hull_native.ShapeFields that pull the lowest waterline outward by LOW_SHIFT at most."""
    base = waterline(surface, LOW_Z)
    base = hn.FieldCurve(base[(base[:, 0] > AFT_OF_BULB) & (base[:, 0] < 101.8)][::3])
    part = np.linspace(0.0, 1.0, 9)
    shifts = np.zeros((len(part), 3))
    shifts[:, 1] = LOW_SHIFT * np.sin(np.pi * part**0.7) ** 2
    field = hn.ShapeField.along(base, (part * base.length, shifts), extent=2.6, falloff=0.9)
    return hn.ShapeFields([field], mirrored=True)


@dataclass(frozen=True)
class Step:
    """fields: the hull_native.ShapeFields that a surface follows; result: hull_native.Reshaped."""

    name: str
    fields: object
    surface: object
    result: object


def steps(surface):
    """Yields the Step after Step from a plain bow to the bulb."""
    wanted, _ = wanted_profile(surface)
    for name, made, with_profile in (
        ("stem drawn out", drawn_out, True),
        ("on the wanted profile", lambda now: onto_profile(now, wanted), True),
        ("fuller at the tip", fuller_at_tip, False),
        ("fuller below", fuller_below, False),
    ):
        profile = hn.crease_curves(surface)[profile_number(surface)].vertices
        fields, kept = made(surface), () if with_profile else profile
        surface, result = follow(surface, fields, kept=kept, with_profile=with_profile)
        yield Step(name, fields, surface, result)
