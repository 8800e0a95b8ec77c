# SPDX-License-Identifier: GPL-3.0-or-later
"""Moves of control points that take features away: functions of x, y, z (n,) in m and the
particulars, which give the new x, y, z."""

import numpy as np


def plumb_forebody(x, y, z, given):
    """Nothing below the deck is forward of a plumb stem."""
    return np.where(z < 1.3 * given.draft, np.minimum(x, 0.97 * given.length_pp), x), y, z


def full_stern(x, y, z, given):
    """Whatever is thin aft is as wide as the counter."""
    thin = (x < 0.25 * given.length_pp) & (y > 1e-3 * given.beam)
    return x, np.where(thin, np.maximum(y, 0.35 * given.beam), y), z


def level_stern(x, y, z, given):
    """Aft, each station's bottom is at one height."""
    aft = (x < 0.3 * given.length_pp) & (z < 1.1 * given.draft)
    return x, y, np.where(aft, 0.8 * given.draft, z)


def humped_stern(x, y, z, given):
    """Aft the bottom rises to a hump."""
    part = np.clip(x / (0.3 * given.length_pp), 0.0, 1.0)
    return x, y, z + 0.3 * given.draft * np.sin(np.pi * part)


def waved(x, y, z, given):
    """A plane bottom or side is bent, by a thousandth of the beam at most."""
    wave = 1e-3 * given.beam * np.abs(np.cos(x))
    return x, np.where(y > 0.499 * given.beam, y - wave, y), np.where(z == 0.0, wave, z)


def tapered(x, y, z, given):
    """Narrower forward, by a tenth."""
    return x, y * (1.0 - 0.1 * x / given.length_pp), z


def tapered_bow(x, y, z, given):
    """The bow is a wedge."""
    wedge = np.clip((given.length_pp - x) / (0.2 * given.length_pp), 0.0, 1.0)
    return x, np.minimum(y, 0.5 * given.beam * wedge), z


def full_bow(x, y, z, given):
    """Forward everything below the deck is as wide as it is amidships."""
    bow = (x > 0.6 * given.length_pp) & (y > 1e-3 * given.beam)
    return x, np.where(bow, np.maximum(y, 0.35 * given.beam), y), z


def flared(x, y, z, given):
    """Half breadths grow with the height above the water."""
    return x, y * (1.0 + np.clip(z / given.draft - 1.0, 0.0, None)), z


def narrowed(x, y, z, given):
    """Half breadths shrink with the height above the water."""
    return x, y / (1.0 + np.clip(z / given.draft - 1.0, 0.0, None)), z


def bulged_ends(x, y, z, given):
    """What is plane at the ends is round."""
    return x + 0.1 * y * y / given.beam, y, z


def flat_bottomed(x, y, z, given):
    """Nothing is below the base line."""
    return x, y, np.maximum(z, 0.0)


def plumb_stem(x, y, z, given):
    """The stem is plumb."""
    return np.minimum(x, given.length_pp), y, z


def shallow(x, y, z, given):
    """Half as high."""
    return x, y, 0.5 * z


def forward(x, y, z, given):
    """All of it is further forward."""
    return x + 0.15 * given.length_pp, y, z


def fuller(x, y, z, given):
    return x, 1.2 * y, z


def rising_outwards(x, y, z, given):
    """Nothing is level across the ship."""
    return x, y, z + 0.2 * y


def slender(x, y, z, given):
    return x, 0.8 * y, z


def straight_stem(x, y, z, given):
    """The stem is straight and steep up to the deck."""
    return np.minimum(x, 0.9 * given.length_pp + 0.3 * z), y, z


def twisted(x, y, z, given):
    """Bottom and sides are warped."""
    return x, y + 0.02 * x * z, z + 0.02 * x * y


def without_bulb(x, y, z, given):
    """The lower half is as thin as a fin."""
    return x, np.where(z < 0.5 * given.draft, np.minimum(y, 0.07), y), z


def off_centre(x, y, z, given):
    return x, y * (1.0 + 1e-3 * y), z


def parted_bodies(x, y, z, given):
    """What is below four fifths of the draft is further down."""
    return x, y, np.where(z < 0.81 * given.draft, z - 0.2 * given.draft, z)


def thick_aft(x, y, z, given):
    """Four times as wide aft below the water."""
    return x, np.where((z < given.draft) & (x < 0.2 * given.length_pp), 4.0 * y, y), z
