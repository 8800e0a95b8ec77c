# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls without a feature, for checks to be seen to fail.

SPOILS: a vessel, a feature of it, and a function of its HullData that gives one without it.
"""

from dataclasses import replace

import numpy as np

from . import choices, moves


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


SPOILS = [
    ("container_ship", "bulbous bow", moved(moves.plumb_forebody)),
    ("container_ship", "bulbous bow", creased(choices.foremost)),
    ("container_ship", "stern bulb", moved(moves.full_stern)),
    ("container_ship", "flat bottom", moved(moves.waved)),
    ("container_ship", "flat side", moved(moves.waved)),
    ("container_ship", "flat-side knuckle", without_creases(choices.upper)),
    ("container_ship", "transom", moved(moves.bulged_ends)),
    ("container_ship", "transom", without_creases(choices.upper)),
    ("container_ship", "flat bar", moved(moves.tapered)),
    ("bulk_carrier", "displacement bulb", moved(moves.plumb_forebody)),
    ("bulk_carrier", "stern bulb", moved(moves.full_stern)),
    ("bulk_carrier", "parallel middle body", moved(moves.tapered)),
    ("bulk_carrier", "flat bottom", without_creases(choices.in_base_plane)),
    ("bulk_carrier", "FULL", moved(moves.slender)),
    ("bulk_carrier", "BLUNT BOW", moved(moves.tapered_bow)),
    ("bulk_carrier", "flat side", moved(moves.waved)),
    ("bulk_carrier", "transom", moved(moves.bulged_ends)),
    ("bulk_carrier", "flat bar", moved(moves.tapered)),
    ("roro", "bulbous bow", moved(moves.plumb_forebody)),
    ("roro", "skeg", moved(moves.level_stern)),
    ("roro", "pram-type stern", moved(moves.humped_stern)),
    ("roro", "forecastle knuckle", without_creases(choices.upper)),
    ("roro", "flat-side knuckle", without_creases(choices.upper)),
    ("roro", "BUOYANCY AFT", moved(moves.forward)),
    ("roro", "flat bottom", moved(moves.waved)),
    ("roro", "transom", without_creases(choices.aftmost)),
    ("research_vessel", "complex stem contour", moved(moves.straight_stem)),
    ("research_vessel", "tunnelled stern", moved(moves.level_stern)),
    ("research_vessel", "tumblehome", moved(moves.flared)),
    ("research_vessel", "forecastle knuckle", moved(moves.narrowed)),
    ("research_vessel", "flat side in three parts", moved(moves.off_centre)),
    ("research_vessel", "flat side in three parts", without_creases(choices.upper)),
    ("research_vessel", "flat bottom", moved(moves.waved)),
    ("research_vessel", "transom", moved(moves.bulged_ends)),
    ("barge", "flat bottom and side", moved(moves.waved)),
    ("barge", "transoms", without_creases(choices.foremost)),
    ("barge", "knuckle of the run", without_creases(lambda x, y, z, given: x > 0.0)),
    ("barge", "swim bow", creased(lambda x, y, z, given: (x > 60) & (x < 70))),
    ("barge", "MOSTLY FLAT", moved(moves.twisted)),
    ("naval_vessel", "sonar dome", moved(moves.flat_bottomed)),
    ("naval_vessel", "tumblehome", moved(moves.flared)),
    ("naval_vessel", "raked stem", moved(moves.plumb_stem)),
    ("naval_vessel", "FINE", moved(moves.fuller)),
    ("naval_vessel", "four sections at the forward shoulder", moved(moves.forward)),
    ("naval_vessel", "transom", without_creases(choices.aftmost)),
    ("sailing_yacht", "canoe body", as_one_layer),
    ("sailing_yacht", "fin keel with bulb", moved(moves.without_bulb)),
    ("sailing_yacht", "fin keel with bulb", moved(moves.parted_bodies)),
    ("sailing_yacht", "spade rudder", moved(moves.thick_aft)),
    ("planing_boat", "chine flat", without_creases(choices.amidships)),
    ("planing_boat", "spray rail", moved(moves.rising_outwards)),
    ("planing_boat", "deadrise", moved(moves.shallow)),
    ("planing_boat", "raked transom", without_creases(choices.aftmost)),
    ("planing_boat", "fine bow", moved(moves.full_bow)),
    ("catamaran", "demihull off the centre plane", moved(moves.off_centre)),
    ("catamaran", "round bilge", creased(choices.amidships)),
    ("catamaran", "sharp stem", without_creases(choices.foremost)),
    ("catamaran", "transom stern", moved(moves.bulged_ends)),
    ("coaster", "pram stern", moved(moves.humped_stern)),
    ("coaster", "round bilge", moved(moves.shallow)),
    ("coaster", "flared bow", moved(moves.narrowed)),
    ("coaster", "flat bottom and side", moved(moves.waved)),
    ("coaster", "transom", moved(moves.bulged_ends)),
]
