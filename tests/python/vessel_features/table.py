# SPDX-License-Identifier: GPL-3.0-or-later
"""Which check holds which feature of which vessel.

CHECKS: by vessel, by the feature's name in FEATURES of its source, a function of a Form that
asserts it. Names in capitals: what vessels of the kind have that is not on the list.
"""

from . import bodies, bows, flats, knuckles, proportions, sterns, transoms

CHECKS = {
    "container_ship": {
        "bulbous bow": lambda form: bows.bow_bulb(form, bar=0.22),
        "stern bulb": sterns.stern_bulb,
        "flat bottom": lambda form: flats.flat_bottom_in_knuckle(form, along=0.5, outwards=0.75),
        "flat side": lambda form: flats.flat_side(form, along=0.6, low=0.2, high=1.0),
        "flat-side knuckle": knuckles.fading_before_stem,
        "transom": transoms.transom,
        "flat bar": lambda form: flats.flat_bar(form, half_width=0.22),
    },
    "bulk_carrier": {
        "displacement bulb": lambda form: bows.bow_bulb(form, bar=0.25),
        "stern bulb": sterns.stern_bulb,
        "parallel middle body": lambda form: flats.parallel_middle_body(form, 0.465, 0.655),
        "flat bottom": lambda form: flats.flat_bottom_in_knuckle(form, along=0.6, outwards=0.85),
        "flat side": lambda form: flats.flat_side(form, along=0.25, low=0.1, high=1.0),
        "transom": transoms.transom,
        "flat bar": lambda form: flats.flat_bar(form, half_width=0.25),
        "FULL": lambda form: proportions.block(form, 0.78, 0.86),
        "BLUNT BOW": bows.blunt,
    },
    "roro": {
        "bulbous bow": bows.bow_bulb,
        "skeg": sterns.skeg,
        "pram-type stern": lambda form: sterns.pram(form, length=0.12),
        "forecastle knuckle": knuckles.knuckle_to_stem,
        "flat-side knuckle": knuckles.fading_to_water,
        "flat bottom": lambda form: flats.flat_bottom(form, along=0.15, outwards=0.4),
        "transom": transoms.transom,
        "BUOYANCY AFT": proportions.buoyancy_aft,
    },
    "research_vessel": {
        "complex stem contour": bows.forefoot_under_spoon,
        "tunnelled stern": sterns.tunnel,
        "tumblehome": lambda form: knuckles.tumblehome(form, (0.0, 0.1, 0.3, 0.5, 0.6)),
        "forecastle knuckle": knuckles.knuckle_to_stem,
        "flat side in three parts": lambda form: flats.sides_of_three_planes(form, along=0.1),
        "flat bottom": lambda form: flats.flat_bottom(form, along=0.15, outwards=0.5),
        "transom": transoms.transom,
    },
    "barge": {
        "flat bottom and side": lambda form: (
            flats.flat_bottom(form, along=0.5, outwards=0.65),
            flats.flat_side(form, along=0.6, low=0.45, high=1.0),
        ),
        "knuckle of the run": lambda form: knuckles.across_ship(form, 9.5),
        "swim bow": lambda form: bows.swim_bow(form, first=0.65),
        "transoms": lambda form: (
            transoms.transom(form, "Transoms"),
            transoms.transom(form, "Transoms", forward=True),
        ),
        "MOSTLY FLAT": lambda form: flats.mostly_flat(form, 0.5),
    },
    "naval_vessel": {
        "sonar dome": bows.sonar_dome,
        "tumblehome": lambda form: (
            knuckles.along_ship(form, least=5.0, over=0.9),
            knuckles.tumblehome(form, (0.05, 0.2, 0.4, 0.6, 0.75)),
        ),
        "raked stem": bows.raked_stem,
        "four sections at the forward shoulder": lambda form: proportions.sections_at_shoulder(
            form, 95.0, 127.0, 4
        ),
        "transom": lambda form: (transoms.transom(form), transoms.transom_in_water(form)),
        "FINE": lambda form: proportions.block(form, 0.4, 0.55),
    },
    "sailing_yacht": {
        "canoe body": bodies.canoe_body,
        "fin keel with bulb": bodies.fin_keel_with_bulb,
        "spade rudder": bodies.spade_rudder,
    },
    "planing_boat": {
        "chine flat": lambda form: knuckles.level_strip(form, 1, width=0.12),
        "spray rail": lambda form: knuckles.level_strip(form, 0, width=0.06),
        "deadrise": lambda form: sterns.steady_deadrise(form, least=15.0, out_to=0.35),
        "fine bow": bows.fine_bow,
        "raked transom": lambda form: transoms.transom(form, rake=15.0),
    },
    "catamaran": {
        "demihull off the centre plane": lambda form: bodies.demihull(form, centre=4.05),
        "round bilge": lambda form: knuckles.smooth_between(form, (0.0, 0.95)),
        "sharp stem": lambda form: knuckles.sharp_stem(form, centre=4.05),
        "transom stern": lambda form: (transoms.transom(form), transoms.transom_in_water(form)),
    },
    "coaster": {
        "pram stern": lambda form: sterns.pram(form, length=0.25),
        "flat bottom and side": lambda form: (
            flats.flat_bottom(form, along=0.3, outwards=0.6),
            flats.flat_side(form, along=0.25, low=0.3, high=1.0),
        ),
        "round bilge": lambda form: flats.round_bilge(form, 1.6, 45.0),
        "flared bow": bows.flared_bow,
        "transom": transoms.transom,
    },
}
