# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls without a feature, for checks to be seen to fail.

SPOILS: a vessel, a feature of it, and a function of its HullData that gives one without it.
"""

from dataclasses import replace

import numpy as np


def moved(move):
    """Moves control points: move(x, y, z, particulars) gives their new coordinates."""

    def spoil(data):
        x, y, z = np.array(data.points, dtype=float).T
        return replace(data, points=np.stack(move(x, y, z, data.particulars), axis=-1))

    return spoil


def without_creases(inside):
    """Takes the tags off creases both of whose points are inside(x, y, z, particulars)."""

    def spoil(data):
        chosen = inside(*np.array(data.points, dtype=float).T, data.particulars)
        kept = [edge for edge in data.creases if not chosen[list(edge)].all()]
        assert len(kept) < len(data.creases)
        return replace(data, creases=kept)

    return spoil


def creased(inside):
    """Makes a crease of every edge between the points that are inside(x, y, z, particulars)."""

    def spoil(data):
        chosen = inside(*np.array(data.points, dtype=float).T, data.particulars)
        edges = {
            tuple(sorted(edge)) for face in data.faces for edge in zip(face, [*face[1:], face[0]])
        }
        had = {tuple(edge) for edge in data.creases}
        added = {edge for edge in edges if chosen[list(edge)].all()}
        assert added - had
        return replace(data, creases=sorted(added | had))

    return spoil


def as_one_layer(data):
    """All faces in the layer of the first: nothing tells bodies or transoms apart."""
    return replace(data, face_layers=[data.face_layers[0]] * len(data.face_layers))


# Moves of points.


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


# Choices of points.


def upper(x, y, z, given):
    return z > 0.5 * given.draft


def in_base_plane(x, y, z, given):
    return (z == 0.0) & (y > 0.02 * given.beam)


def foremost(x, y, z, given):
    return x > 0.98 * given.length_pp


def aftmost(x, y, z, given):
    return x < 0.02 * given.length_pp


def amidships(x, y, z, given):
    return np.abs(x - 0.5 * given.length_pp) < 0.15 * given.length_pp


SPOILS = [
    ("container_ship", "bulbous bow", moved(plumb_forebody)),
    ("container_ship", "bulbous bow", creased(foremost)),
    ("container_ship", "stern bulb", moved(full_stern)),
    ("container_ship", "flat bottom", moved(waved)),
    ("container_ship", "flat side", moved(waved)),
    ("container_ship", "flat-side knuckle", without_creases(upper)),
    ("container_ship", "transom", moved(bulged_ends)),
    ("container_ship", "transom", without_creases(upper)),
    ("container_ship", "flat bar", moved(tapered)),
    ("bulk_carrier", "displacement bulb", moved(plumb_forebody)),
    ("bulk_carrier", "stern bulb", moved(full_stern)),
    ("bulk_carrier", "parallel middle body", moved(tapered)),
    ("bulk_carrier", "flat bottom", without_creases(in_base_plane)),
    ("bulk_carrier", "FULL", moved(slender)),
    ("bulk_carrier", "BLUNT BOW", moved(tapered_bow)),
    ("bulk_carrier", "flat side", moved(waved)),
    ("bulk_carrier", "transom", moved(bulged_ends)),
    ("bulk_carrier", "flat bar", moved(tapered)),
    ("roro", "bulbous bow", moved(plumb_forebody)),
    ("roro", "skeg", moved(level_stern)),
    ("roro", "pram-type stern", moved(humped_stern)),
    ("roro", "forecastle knuckle", without_creases(upper)),
    ("roro", "flat-side knuckle", without_creases(upper)),
    ("roro", "BUOYANCY AFT", moved(forward)),
    ("roro", "flat bottom", moved(waved)),
    ("roro", "transom", without_creases(aftmost)),
    ("research_vessel", "complex stem contour", moved(straight_stem)),
    ("research_vessel", "tunnelled stern", moved(level_stern)),
    ("research_vessel", "tumblehome", moved(flared)),
    ("research_vessel", "forecastle knuckle", moved(narrowed)),
    ("research_vessel", "flat side in three parts", moved(off_centre)),
    ("research_vessel", "flat side in three parts", without_creases(upper)),
    ("research_vessel", "flat bottom", moved(waved)),
    ("research_vessel", "transom", moved(bulged_ends)),
    ("barge", "flat bottom and side", moved(waved)),
    ("barge", "transoms", without_creases(foremost)),
    ("barge", "knuckle of the run", without_creases(lambda x, y, z, given: x > 0.0)),
    ("barge", "swim bow", creased(lambda x, y, z, given: (x > 60) & (x < 70))),
    ("barge", "MOSTLY FLAT", moved(twisted)),
    ("naval_vessel", "sonar dome", moved(flat_bottomed)),
    ("naval_vessel", "tumblehome", moved(flared)),
    ("naval_vessel", "raked stem", moved(plumb_stem)),
    ("naval_vessel", "FINE", moved(fuller)),
    ("naval_vessel", "four sections at the forward shoulder", moved(forward)),
    ("naval_vessel", "transom", without_creases(aftmost)),
    ("sailing_yacht", "canoe body", as_one_layer),
    ("sailing_yacht", "fin keel with bulb", moved(without_bulb)),
    ("sailing_yacht", "fin keel with bulb", moved(parted_bodies)),
    ("sailing_yacht", "spade rudder", moved(thick_aft)),
    ("planing_boat", "chine flat", without_creases(amidships)),
    ("planing_boat", "spray rail", moved(rising_outwards)),
    ("planing_boat", "deadrise", moved(shallow)),
    ("planing_boat", "raked transom", without_creases(aftmost)),
    ("planing_boat", "fine bow", moved(full_bow)),
    ("catamaran", "demihull off the centre plane", moved(off_centre)),
    ("catamaran", "round bilge", creased(amidships)),
    ("catamaran", "sharp stem", without_creases(foremost)),
    ("catamaran", "transom stern", moved(bulged_ends)),
    ("coaster", "pram stern", moved(humped_stern)),
    ("coaster", "round bilge", moved(shallow)),
    ("coaster", "flared bow", moved(narrowed)),
    ("coaster", "flat bottom and side", moved(waved)),
    ("coaster", "transom", moved(bulged_ends)),
]
