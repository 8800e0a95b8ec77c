# SPDX-License-Identifier: GPL-3.0-or-later
"""Bulbs, domes and stems."""

import numpy as np

from .form import SAME

# Samples of the contour over the height.
_COUNT = 240


def bow_bulb(form, bar=0.0):
    """A bulb under the water: the stem runs forward below it and back above it; the sections there
    are wide below and have a waist above. Smooth: no knuckle on it but along a bar of this half
    width."""
    draft = form.given.draft
    heights = form.low[2] + np.linspace(1e-6, 1.3 * draft - form.low[2], _COUNT)
    stem = form.stem(heights)
    nose = np.nanargmax(np.where(heights < draft, stem, -np.inf))
    notch = nose + np.nanargmin(stem[nose:])
    length = stem[nose] - stem[notch]
    ahead = stem[nose] - form.stem([draft])[0]
    assert min(length, ahead) > 0.1 * draft, f"nose {length:.2f} m before notch, {ahead:.2f} water"
    breadths = form.breadths(stem[notch] - 0.1 * length, heights)
    # Below the notch's height: the bulb; about it, the waist.
    bulb = np.nanmax(breadths[: (nose + notch) // 2])
    waist = np.nanmin(breadths[(nose + notch) // 2 :])
    assert waist < 0.5 * bulb, f"waist {waist:.2f} m above a bulb of {bulb:.2f} m half breadth"
    for knuckle in form.knuckles:
        x, y, z = knuckle.points[knuckle.angles > 1.0].T
        on_bulb = (x > stem[notch]) & (z < heights[notch]) & (y > bar + SAME * form.size)
        assert not on_bulb.any(), f"a knuckle on the bulb at {knuckle.points[0]}"


def sonar_dome(form):
    """A bulb without a knuckle that is also below the keel; an irregular point ends it."""
    bow_bulb(form)
    given = form.given
    assert form.low[2] < -0.2 * given.draft, f"lowest point at {form.low[2]:.2f} m"
    x = np.linspace(0.05, 0.55, 11) * given.length_pp
    keel = form.bottoms(x, 1e-6 * given.beam)
    assert keel.min() > -1e-3 * given.draft, "the keel is below the base line amidships, too"
    assert len(irregular_points(form, forward_of=0.9 * given.length_pp)) >= 1


def irregular_points(form, forward_of):
    """Points within the surface where three faces meet, forward of x."""
    mesh = form.mesh
    inner = np.setdiff1d(np.flatnonzero(mesh.vertex_valences == 3), mesh.border_edges)
    return inner[mesh.points[inner, 0] > forward_of]


def raked_stem(form, least=25.0):
    """From the water to the deck the stem leans forward by that many degrees, nearly straight."""
    low, high = form.given.draft, 0.98 * form.high[2]
    heights = np.linspace(low, high, 25)
    stem = form.stem(heights)
    chord = np.linspace(stem[0], stem[-1], len(stem))
    lean = np.degrees(np.arctan2(stem[-1] - stem[0], high - low))
    assert (np.diff(stem) > 0.0).all() and lean > least, f"leans by {lean:.1f} degrees"
    assert np.abs(stem - chord).max() < 0.05 * np.hypot(high - low, stem[-1] - stem[0])


def forefoot_under_spoon(form):
    """A stem that is steep low down and leans far forward below the water; two irregular points."""
    draft = form.given.draft
    heights = np.linspace(0.15, 1.0, 35) * draft
    lean = np.degrees(np.arctan(np.gradient(form.stem(heights), heights)))
    steep = np.nanargmin(lean)
    assert heights[steep] < 0.6 * draft and lean[steep] < 45.0, f"steepest {lean[steep]:.0f}"
    assert lean[steep:].max() > 60.0, f"spoon leans by {lean[steep:].max():.0f} degrees only"
    assert len(irregular_points(form, forward_of=0.8 * form.given.length_pp)) >= 2


def blunt(form):
    """At the water the ship has more than half its breadth but a twentieth of its length abaft the
    forward perpendicular."""
    given = form.given
    breadth = form.breadths(0.95 * given.length_pp, given.draft)[0] / (0.5 * given.beam)
    assert breadth > 0.5, f"{breadth:.2f} of the half beam"


def flared_bow(form, least=10.0):
    """Forward, sections lean outwards from the water to the deck, by that many degrees."""
    for part in (0.85, 0.9, 0.95):
        station = form.breadths(part * form.given.length_pp, _topsides(form))
        breadths = station[~np.isnan(station)]
        heights = _topsides(form)[~np.isnan(station)]
        lean = np.degrees(np.arctan2(breadths[-1] - breadths[0], heights[-1] - heights[0]))
        assert (np.diff(breadths) > 0.0).all() and lean > least, f"{lean:.1f} degrees at {part}"


def _topsides(form):
    return np.linspace(form.given.draft, form.high[2], 40)


def fine_bow(form):
    """The bottom draws in: steeper forward than aft; a sharp waterline at the stem."""
    length = form.given.length_pp
    aft, forward = (rise_of_bottom(form, part * length)[0] for part in (0.2, 0.75))
    assert forward > 1.5 * aft, f"{aft:.1f} degrees aft, {forward:.1f} forward"
    angle = np.degrees(form.afloat.entrance_chord_angle)
    assert angle < 35.0, f"half angle of entrance {angle:.1f} degrees"


def rise_of_bottom(form, x, out_to=0.5):
    """Degrees by which a station's bottom rises outwards, to a part of the half breadth: mean,
    spread."""
    offsets = np.linspace(0.05, out_to, 10) * 0.5 * form.given.beam
    heights = form.bottoms(x, offsets)
    angles = np.degrees(np.arctan(np.diff(heights) / np.diff(offsets)))
    return angles.mean(), np.ptp(angles)


def swim_bow(form, first):
    """From that part of the length on, the bottom rises smoothly to the bow's transom."""
    given = form.given
    x = np.linspace(first * given.length_pp, form.high[0] - 1e-6 * form.size, 60)
    bottom = form.bottoms(x, 0.05 * given.beam)
    assert abs(bottom[0]) < SAME * form.size and (np.diff(bottom) > -SAME * form.size).all()
    assert bottom[-1] > 0.5 * given.draft, f"the bottom rises to {bottom[-1]:.2f} m"
    for knuckle in form.knuckles:
        inside = (knuckle.points[:, 0] > x[0]) & (knuckle.points[:, 0] < x[-1])
        assert not inside.any(), "a knuckle across the bow's bottom"
