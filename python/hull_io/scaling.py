# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls brought to other main dimensions: x, y and z multiplied by a factor each.

The surface of a mesh that is scaled is the scaled surface, exactly: displaced volume grows by the
product of the three factors, and centres move as points do. What belongs to a hull follows, by
FOLLOWING: particulars and trim, loads (masses in proportion to the volume), openings, wind areas,
flats, lines, the places of what is wanted. What is in STAYING stays: counts, the density, heel,
pressure and period, values that are wanted, and variants, which are hulls as they were.
"""

from copy import deepcopy
from math import isfinite

import numpy as np

from .scale import Scale

# How each length of a HullData follows, by its place; see Scale.
FOLLOWING = {
    "points": "point",
    "particulars.length_pp": "x",
    "particulars.beam": "y",
    "particulars.draft": "at z, or 0",
    "particulars.depth": "at z, or 0",
    "flats.normal": "plane",
    "afloat.trim_m": "z",
    "load.mass_t": "volume",
    "load.kg": "at z, or 0",
    "load.lcg": "at x",
    "load_cases.mass_t": "volume",
    "load_cases.lcg": "at x",
    "load_cases.tcg": "at y",
    "load_cases.vcg": "at z",
    "resistance.appendage_area": "profile",
    "resistance.propeller_diameter": "z",
    "resistance.chine_beam": "y",
    "resistance.thrust_arm": "z",
    "resistance.thruster_diameter": "z",
    "resistance.planing_mass_t": "volume",
    "resistance.planing_lcg": "x",
    "resistance.holtrop.length": "x",
    "resistance.holtrop.beam": "y",
    "resistance.holtrop.draft_forward": "at z, or 0",
    "resistance.holtrop.draft_aft": "at z, or 0",
    "resistance.holtrop.displaced_volume": "volume",
    "resistance.holtrop.wetted_surface": "surface",
    "resistance.holtrop.bulb_area": "section",
    "resistance.holtrop.bulb_height": "at z, or 0",
    "resistance.holtrop.transom_area": "section",
    "resistance.delft.length": "x",
    "resistance.delft.beam": "y",
    "resistance.delft.draft": "z",
    "resistance.delft.volume": "volume",
    "resistance.delft.waterplane_area": "plan",
    "resistance.delft.wetted_surface": "surface",
    "resistance.delft.lcb": "x",
    "resistance.delft.lcf": "x",
    "resistance.delft.keel_wetted_surface": "profile",
    "resistance.delft.keel_chord": "x",
    "resistance.delft.keel_volume": "volume",
    "resistance.delft.keel_total_draft": "z",
    "resistance.delft.keel_centre": "z",
    "resistance.delft.rudder_wetted_surface": "profile",
    "resistance.delft.rudder_chord": "x",
    "resistance.michell.length": "x",
    "resistance.michell.wetted_surface": "surface",
    "weights.items.mass_t": "volume",
    "weights.items.lcg": "at x",
    "weights.items.tcg": "at y",
    "weights.items.vcg": "at z",
    "downflooding_points.position": "point",
    "wind.areas.area": "profile",
    "wind.areas.z": "at z",
    "wind.lever": "z",
    "wind.keel_area": "profile",
    "lines.waterline_spacing": "z",
    "lines.buttock_spacing": "y",
    "lines.frame_spacing": "x",
    "lines.stations": "stations",
    "lines.waterlines": "list z",
    "lines.buttocks": "list y",
    "lines.diagonals": "diagonals",
    "lines.planes.normal": "normal",
    "lines.planes.point": "point",
    "targets.rows.station": "at x",
    "area_target.base.x": "at x",
    "area_target.base.area": "section",
    "area_target.points.x": "at x",
    "area_target.points.area": "section",
    "ties.distance": "vector",
    "appendages.sizes": "sizes",  # before what they go by
    "appendages.start": "point",
    "appendages.end": "point",
    "appendages.chord_direction": "vector",
    "appendages.thickness_direction": "vector",
    "plating.rules.value": "seam",
    "plating.rules.line": "points",
    "fields.place": "point",
    "fields.extent": "x",
    "fields.shift": "vector",
    "fields.line": "points",
    "fields.becomes": "points",
    "fields.end.extent": "x",
    "fields.end.shift": "vector",
}  # an offset of a flat goes with its normal

# What stays: no lengths, or not the hull's.
STAYING = frozenset(
    """name faces creases corners half layers.name layers.in_hydrostatics layers.colour face_layers
    layers.thickness layers.density weights.thickness weights.density weights.items.name
    load_cases.with_weights load_cases.vcg_is_guess
    resistance.method resistance.speeds_kn resistance.form_factor
    resistance.stern resistance.appendage_factor resistance.twin_screw resistance.zeros
    resistance.hulls resistance.open_stern resistance.blade_area_ratio resistance.pitch_ratio
    resistance.thruster_coefficient resistance.deadrise_deg
    resistance.shaft_angle_deg resistance.heel_deg resistance.open_water_efficiency
    resistance.shaft_efficiency resistance.roughness_um resistance.wave_speed_kn
    resistance.holtrop.lcb_percent resistance.holtrop.midship resistance.holtrop.waterplane
    resistance.holtrop.entrance_angle_deg resistance.delft.prismatic resistance.delft.midship
    resistance.delft.keel_thickness resistance.delft.rudder_thickness
    particulars.water_density scheme deck_edge shown_rows curves.name curves.shown curves.edges
    flats.faces flats.offset developables.faces developables.warp developables.distance
    developables.keep locked kept.stations kept.buttocks kept.waterlines ties.kind ties.point
    ties.to ties.share groups.name groups.points afloat.heel_deg afloat.deck_closed load.free_trim
    load.kg_is_guess load.loaded load.case
    load_cases.name downflooding_points.name wind.hull_profile wind.areas.name wind.pressure
    wind.sharp_bilges wind.roll_period lines.shown lines.station_count lines.stations_in
    lines.planes.name lines.planes.shown targets.rows.quantity targets.rows.value targets.rows.sense
    targets.rows.tolerance targets.rows.on targets.rows.speed_kn targets.moving targets.staying
    targets.length
    targets.beam targets.draft targets.fairness area_target.source variants units source
    fields.name fields.role fields.on fields.colour fields.base fields.axis fields.closed
    fields.falloff fields.axes fields.faces fields.end.falloff
    fields.along_surface
    appendages.name appendages.shape appendages.section appendages.thicknesses appendages.on
    appendages.cut appendages.mirrored
    plating.rules.kind plating.rules.on plating.along_knuckles plating.across_centre
    plating.thickness plating.first_frame plating.ranges.last plating.ranges.spacing
    plating.numbered_from plating.in_roman plating.mark_waterlines plating.mark_buttocks
    notes""".split()
)


# Seams at places go along; girths and lengths of plates are the yard's.
_SEAMS = {"station": 0, "buttock": 1, "waterline": 2}

# By the names that FOLLOWING has: (Scale, what holds the value, the value) → the new value. What is
# counted from the mesh's zero is "at" a place, and is shifted too, but for a 0 that stands for what
# is not given.
CHANGES = {
    "point": lambda scale, holder, value: _like(value, scale.points(value)),
    "points": lambda scale, holder, value: [_like(one, scale.points(one)) for one in value],
    "vector": lambda scale, holder, value: _like(value, np.multiply(scale.factors, value)),
    "normal": lambda scale, holder, value: _like(value, scale.normal(value)),
    "x": lambda scale, holder, value: scale.length(0, value),
    "y": lambda scale, holder, value: scale.length(1, value),
    "z": lambda scale, holder, value: scale.length(2, value),
    "at x": lambda scale, holder, value: scale.place(0, value),
    "at y": lambda scale, holder, value: scale.place(1, value),
    "at z": lambda scale, holder, value: scale.place(2, value),
    "at z, or 0": lambda scale, holder, value: scale.place(2, value) if value else value,
    "volume": lambda scale, holder, value: scale.volume(value),
    "profile": lambda scale, holder, value: scale.profile(value),
    "section": lambda scale, holder, value: scale.section(value),
    "plan": lambda scale, holder, value: scale.plan(value),
    "surface": lambda scale, holder, value: scale.surface(value),
    "list y": lambda scale, holder, value: scale.listed(1, value),
    "list z": lambda scale, holder, value: scale.listed(2, value),
    "diagonals": lambda scale, holder, value: scale.diagonals(value),
    "seam": lambda scale, holder, value: (
        scale.place(_SEAMS[holder.kind], value) if holder.kind in _SEAMS else value
    ),
    "sizes": lambda scale, holder, value: scale.sizes(holder),
    "stations": lambda scale, holder, value: (
        scale.listed(0, value) if holder.stations_in.lower() == "metres" else value
    ),
}


def _like(value, array):
    return array if isinstance(value, np.ndarray) else tuple(array.tolist())


def scaled(data, factors):
    """A new HullData: this one with x, y and z multiplied by factors (3,), and with it all that
    belongs to the hull."""
    return follow(data, Scale(tuple(map(float, factors))))


def follow(data, scale):
    """A new HullData: all that belongs to this one as a Scale takes it."""
    made = deepcopy(data)
    for path, change in FOLLOWING.items():
        _follow(made, path.split("."), change, scale)
    return made


def _follow(holder, names, change, scale):
    name, *rest = names
    value = getattr(holder, name)
    if rest:
        for part in value if isinstance(value, list) else [value]:
            if part is not None:
                _follow(part, rest, change, scale)
    elif change == "plane":
        normal, holder.offset = scale.plane(value, holder.offset)
        holder.normal = tuple(normal.tolist())
    elif value is not None:
        setattr(holder, name, CHANGES[change](scale, holder, value))


def factors(present, length=None, beam=None, draft=None, depth=None):
    """(3,) by what a hull is to be scaled to have these dimensions; None of one that follows.

    present: has length_pp, beam, draft and depth, as the hull has them now. Heights go by the depth
    where one is given, else by the draft. ValueError for a dimension of which there is no present
    one, or that is not above zero.
    """
    return (
        _factor("Lpp", present.length_pp, length),
        _factor("beam", present.beam, beam),
        _factor("draft", present.draft, draft)
        if depth is None
        else _factor("depth", present.depth, depth),
    )


def _factor(name, present, wanted):
    if wanted is None:
        return 1.0
    if not (isfinite(wanted) and wanted > 0.0):
        raise ValueError(f"A {name} of {wanted:.6g} m cannot be: give one above zero")
    if not present > 0.0:
        raise ValueError(f"The hull has no {name} that it could be scaled by: give it one first")
    return wanted / present


def to_dimensions(data, *, length_pp=None, beam=None, draft=None, depth=None):
    """A new HullData: this one scaled to main dimensions in m, and with it all that belongs to the
    hull; what is None follows, or stays. With a depth heights go by that, and a draft is where the
    hull floats; else they go by the draft. ValueError as factors and Scale."""
    if draft is not None:
        _factor("draft", 1.0, draft)
    made = scaled(data, factors(data.particulars, length_pp, beam, draft, depth))
    given = {"length_pp": length_pp, "beam": beam, "draft": draft, "depth": depth}
    for name, value in given.items():
        if value is not None:
            setattr(made.particulars, name, float(value))
    return made
