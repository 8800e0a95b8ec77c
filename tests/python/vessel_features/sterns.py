# SPDX-License-Identifier: GPL-3.0-or-later
"""Stern bulbs, skegs, prams, tunnels."""

import numpy as np

from .bows import rise_of_bottom


def stern_bulb(form):
    """A boss before the propeller, and before it sections with a bulb about the shaft, a waist
    above that, and a wide counter."""
    given = form.given
    low = np.linspace(0.02, 0.6, 100) * given.draft
    contour = form.stern(low)
    boss = np.nanargmin(contour)
    x, shaft = contour[boss], low[boss]
    aperture = np.nanmax(form.stern(np.linspace(shaft, 0.8 * given.draft, 60)))
    assert aperture - x > 0.01 * given.length_pp, f"no aperture above the boss at {x:.1f} m"
    heights = np.linspace(0.02, 1.2, 240) * given.draft
    breadths = form.breadths(x + 0.02 * given.length_pp, heights)
    above = np.flatnonzero((heights > shaft) & (heights < given.draft))
    waist = above[np.nanargmin(breadths[above])]
    bulb = np.nanargmax(breadths[:waist])
    assert abs(heights[bulb] - shaft) < 0.2 * given.draft, f"widest at {heights[bulb]:.1f} m"
    assert breadths[waist] < 0.7 * breadths[bulb], "no waist above the stern bulb"
    assert breadths[-1] > 2.0 * breadths[bulb], "no counter above the stern bulb"


def skeg(form):
    """A thin body in the centre plane, from a wide bottom down to the base line."""
    given = form.given
    for part in (0.08, 0.11, 0.14):
        x = part * given.length_pp
        offsets = np.linspace(1e-4, 0.125, 200) * given.beam
        bottom = form.bottoms(x, offsets)
        depth = bottom[-1] - bottom[0]
        assert depth > 0.3 * given.draft, f"the skeg is {depth:.2f} m deep at x = {x:.1f} m"
        breadth = np.interp(bottom[0] + 0.5 * depth, bottom, offsets)
        assert breadth < 0.06 * given.beam, f"half breadth {breadth:.2f} m at x = {x:.1f} m"
    keel = form.bottoms(0.2 * given.length_pp, 1e-4 * given.beam)[0]
    assert keel < 0.05 * given.draft, "the skeg does not come down to the base line"


def pram(form, length):
    """Over that part of the length the bottom beside the centre plane rises straight, or nearly, to
    a transom near the water, and is level across."""
    given = form.given
    x = form.low[0] + np.linspace(1e-3, length, 25) * given.length_pp
    across = np.array([0.35, 0.5, 0.65]) * 0.5 * given.beam
    heights = np.array([form.bottoms(x, offset) for offset in across])
    assert (np.diff(heights, axis=1) < 0.0).all(), "the bottom does not rise aft"
    chords = np.linspace(heights[:, 0], heights[:, -1], len(x), axis=1)
    sag = np.abs(heights - chords).max()
    assert sag < 0.02 * length * given.length_pp, f"{sag:.2f} m from a straight rise"
    rise = np.degrees(np.arctan2(heights[:, 0] - heights[:, -1], x[-1] - x[0])).min()
    assert rise > 3.0, f"the bottom rises by {rise:.1f} degrees"
    assert np.ptp(heights, axis=0).max() < 0.15 * given.draft, "the bottom is not level across"
    assert (
        0.6 * given.draft < heights[:, 0].min() < 1.2 * given.draft
    ), "the transom is not at the water"


def tunnel(form):
    """The bottom has a ridge off the centre plane aft, and falls again to a lip outside of it."""
    given = form.given
    offsets = np.linspace(0.01, 0.95, 200) * 0.5 * given.beam
    for part in (0.0, 0.04, 0.08):
        heights = form.bottoms(part * given.length_pp, offsets)
        inside = offsets < 0.6 * offsets[-1]
        roof = np.nanargmax(np.where(inside, heights, -np.inf))
        lip = roof + np.nanargmin(heights[roof:])
        depth = heights[roof] - max(heights[lip], heights[0])
        assert (
            offsets[lip] - offsets[roof] > 0.05 * given.beam and depth > 0.04 * given.draft
        ), f"the tunnel is {depth:.2f} m deep at x = {part:.2f} of the length"


def steady_deadrise(form, least, out_to):
    """Aft, the bottom rises outwards from the keel by the same angle all along, of that many
    degrees, to that part of the half breadth."""
    places = (part * form.given.length_pp for part in (0.1, 0.2, 0.3, 0.4))
    found = [rise_of_bottom(form, x, out_to) for x in places]
    means, spreads = np.transpose(found)
    assert least < means.min() and means.max() < 25.0, f"deadrise {means} degrees"
    assert np.ptp(means) < 2.0 and spreads.max() < 1.0, f"deadrise {means}, spread {spreads}"
