# SPDX-License-Identifier: GPL-3.0-or-later
"""Knuckles along the ship: to the stem, fading, chines; and what is above them."""

import numpy as np

from .form import SAME


def knuckle_to_stem(form, least=5.0, abaft=0.9):
    """A knuckle above the water from the deck edge, at the break of the forecastle abaft that part
    of the length, to the stem, the uppermost of several; the side above it steeper. The largest
    angle is `least` degrees or more."""
    given = form.given
    found = [
        knuckle
        for knuckle in form.knuckles
        if knuckle.points[:, 2].min() > given.draft
        and knuckle.points[:, 0].min() < abaft * given.length_pp
        and _ends_at_stem(form, knuckle)
    ]
    assert found, "no knuckle runs to the stem above the water"
    knuckle = max(found, key=lambda knuckle: knuckle.points[:, 2].max())
    deck_edge = {vertex for edge in form.data.deck_edge for vertex in edge}
    ends = zip(knuckle.curve.vertices[[0, -1]], knuckle.points[[0, -1], 0])
    assert min(ends, key=lambda end: end[1])[0] in deck_edge, "it does not begin at the deck edge"
    assert knuckle.angles.max() > least, f"its angle is {knuckle.angles.max():.1f} degrees at most"
    at = knuckle.points[knuckle.angles.argmax()]
    above, below = (_lean(form, at, side) for side in (1.0, -1.0))
    assert above < below, f"the side above leans out by {above:.1f}, below by {below:.1f} degrees"


def _ends_at_stem(form, knuckle):
    ends = knuckle.points[[0, -1]]
    return (form.on_centre(ends) & (ends[:, 0] > 0.95 * form.given.length_pp)).any()


def _lean(form, place, side):
    """Degrees by which the station leans out just above (side 1) or below (-1) a place on it."""
    x, _, z = place
    heights = z + side * np.array([0.005, 0.02]) * form.given.depth
    breadths = form.breadths(x, heights)
    return np.degrees(np.arctan(np.diff(breadths)[0] / np.diff(heights)[0]))


def fading(form, aft):
    """A knuckle that lies in the plane of the side over part of its length, and that fades at its
    after or forward end: a dart, to which its angle falls evenly over a fiftieth of the length."""
    given = form.given
    found = []
    for knuckle in form.knuckles:
        for first, step in zip((0, -1), (1, -1)):
            points, angles = knuckle.points[::step], knuckle.angles[::step]
            above_bilge = points[:, 2].min() > 0.2 * given.draft
            is_end = (points[0, 0] < points[-1, 0]) == aft
            if knuckle.fades[first] and is_end and above_bilge and _along_side(form, points):
                found.append((points, angles))
    assert len(found) == 1, f"{len(found)} knuckles of the side fade there"
    ((points, angles),) = found
    # From the end to the first place where the angle falls again: all that rises evenly.
    falling = np.flatnonzero(np.diff(angles) < 0.0)
    peak = falling[0] if len(falling) else len(angles) - 1
    assert angles[0] < 0.1, f"{angles[0]:.3f} degrees at its end {points[0]}"
    assert angles[peak] > 2.0, f"{angles[peak]:.1f} degrees at most near {points[0]}"
    length = np.linalg.norm(points[peak] - points[0])
    assert length > 0.02 * given.length_pp, f"fades within {length:.1f} m at {points[0]}"
    return points[0]


def _along_side(form, points):
    """Whether a tenth of the ship's length or more is in the plane of the largest half breadth."""
    inside = points[0.5 * form.given.beam - points[:, 1] < SAME * form.size]
    return len(inside) and np.ptp(inside[:, 0]) > 0.1 * form.given.length_pp


def fading_before_stem(form):
    """A knuckle of the side that leaves its plane forward, and fades before the stem."""
    end = fading(form, aft=False)
    assert end[1] > 0.1 * form.given.beam, f"it runs on to the stem, {end}"
    assert 0.5 * form.given.beam - end[1] > 0.01 * form.given.beam, f"it ends in the side, {end}"


def fading_to_water(form):
    """A knuckle of the side that fades aft, within it, no farther from the water than a third of
    the draft."""
    end = fading(form, aft=True)
    assert 0.5 * form.given.beam - end[1] < 1e-3 * form.given.beam, f"not in the side, {end}"
    away = abs(end[2] - form.given.draft)
    assert away < form.given.draft / 3.0, f"it ends {away:.2f} m from the water"


def between_planes(form, angle, within):
    """A knuckle of one angle amidships, between two planes of the side."""
    middle = 0.5 * form.given.length_pp
    for knuckle in form.knuckles:
        x = knuckle.points[:, 0]
        if x.min() < middle < x.max() and knuckle.points[:, 2].min() > 0.2 * form.given.draft:
            at = np.abs(x - middle).argmin()
            if abs(knuckle.angles[at] - angle) < within:
                return
    raise AssertionError(f"no knuckle of {angle:.1f} degrees amidships")


def tumblehome(form, stations, least=3.0):
    """Above the widest place of a station, or the end of its upright side, the half breadth falls
    up to the deck, by that many degrees."""
    given = form.given
    for part in stations:
        heights = np.linspace(given.draft, form.high[2], 400)
        breadths = form.breadths(part * given.length_pp, heights)
        heights, breadths = heights[~np.isnan(breadths)], breadths[~np.isnan(breadths)]
        widest = len(breadths) - 1 - np.argmax(breadths[::-1] > breadths.max() - SAME * form.size)
        rise, fall = heights[-1] - heights[widest], breadths[widest] - breadths[-1]
        assert rise > 0.1 * given.depth, f"widest {rise:.2f} m below the deck at {part}"
        assert (np.diff(breadths[widest:]) < 0.0).all(), f"no steady tumblehome at {part}"
        lean = np.degrees(np.arctan2(fall, rise))
        assert lean > least, f"leans in by {lean:.1f} degrees at {part}"


def along_ship(form, least=20.0, over=0.6):
    """A knuckle from the transom to the stem, of that many degrees from aft over a part of the
    length. Those found."""
    found = [
        knuckle
        for knuckle in form.knuckles
        if _ends_at_stem(form, knuckle) and knuckle.points[:, 0].min() < 0.05 * form.given.length_pp
    ]
    assert found, "no knuckle runs from the transom to the stem"
    for knuckle in found:
        aft = knuckle.points[:, 0] < over * form.given.length_pp
        assert knuckle.angles[aft].min() > least, f"{knuckle.angles[aft].min():.1f} degrees aft"
    return found


def level_strip(form, number, width):
    """A strip between two knuckles from the transom to the stem, level across, that wide aft, where
    it has a knuckle of 10 degrees at least on either side; its number from the keel."""
    found = sorted(along_ship(form, least=10.0), key=lambda knuckle: knuckle.points[:, 1].max())
    assert len(found) > 2 * number + 1, f"{len(found)} knuckles along the ship"
    inner, outer = (
        knuckle.points[np.argsort(knuckle.points[:, 0])]
        for knuckle in found[2 * number : 2 * number + 2]
    )
    across = outer - inner
    assert np.abs(across[:, 2]).max() < SAME * form.size, "the strip is not level"
    assert abs(across[0, 1] - width) < 0.05 * width, f"{across[0, 1]:.3f} m wide aft"


def across_ship(form, x, least=3.0):
    """A knuckle in the plane of a station, from the centre plane to the deck edge."""
    found = [
        knuckle
        for knuckle in form.knuckles
        if np.abs(knuckle.points[:, 0] - x).max() < SAME * form.size
    ]
    assert len(found) == 1, f"{len(found)} knuckles at x = {x} m"
    (knuckle,) = found
    assert form.on_centre(knuckle.points).any(), "the knuckle does not come to the centre plane"
    # The deck is further up.
    assert knuckle.points[:, 2].max() > 0.95 * form.given.depth, "it does not run up to the deck"
    bottom = knuckle.angles[knuckle.points[:, 1] < 0.25 * form.given.beam]
    assert bottom.min() > least, f"{bottom.min():.1f} degrees in the bottom"


def smooth_between(form, ends):
    """No knuckle but those at the ends: abaft and forward of those parts of the length."""
    for knuckle in form.knuckles:
        x = knuckle.points[:, 0] / form.given.length_pp
        assert (x <= ends[0]).all() or (x >= ends[1]).all(), f"a knuckle at {knuckle.points[0]}"


def sharp_stem(form, centre=0.0, least=60.0):
    """A knuckle in the plane of the stem from the deck to the forefoot, where it fades."""
    found = [
        knuckle
        for knuckle in form.knuckles
        if np.abs(knuckle.points[:, 1] - centre).max() < SAME * form.size
        and knuckle.points[:, 2].max() > form.given.depth
    ]
    assert len(found) == 1, f"{len(found)} knuckles along the stem"
    (knuckle,) = found
    assert sum(knuckle.fades) == 1, "the stem's edge does not fade at the forefoot"
    wet = np.abs(knuckle.points[:, 2] - form.given.draft).argmin()
    assert knuckle.angles[wet] > least, f"{knuckle.angles[wet]:.0f} degrees at the water"
