# SPDX-License-Identifier: GPL-3.0-or-later
"""What of a hull's settings follows when the hull is scaled: Object.hull, by hull_io.scaling."""

from ....hull_io import scaling
from ..constraints import flats
from ..hull import appendage_data

# Groups that Object.hull has as HullData has them.
_AS_IN_FILES = ("lines.", "resistance.", "weights.", "wind.", "targets.", "area_target.base.")

# How each number and text of Object.hull follows, by its place, as CHANGES names it; what is in
# metres whatever the scene's units, as lists of positions, too.
FOLLOWING = {
    **{place: how for place, how in scaling.FOLLOWING.items() if place.startswith(_AS_IN_FILES)},
    "length_pp": "x",
    "beam": "y",
    "draft": "at z, or 0",
    "depth": "at z, or 0",
    "trim_m": "z",
    "fairness.comb_step": "x",
    "loading.mass_t": "volume",
    "loading.kg": "at z, or 0",
    "loading.lcg": "at x",
    "loading.least_t": "volume",
    "loading.greatest_t": "volume",
    "loading.downflooding_points.position": "point",
    "fairness.accepted.point": "point",
    "loading.load_cases.mass_t": "volume",
    "loading.load_cases.lcg": "at x",
    "loading.load_cases.tcg": "at y",
    "loading.load_cases.vcg": "at z",
    "table.draft_from": "at z, or 0",
    "table.draft_to": "at z, or 0",
    "table.draft_step": "z",
    "studio.boot_top_height": "z",
    "transform.kept_aft": "x",
    "transform.kept_fore": "x",
    "transform.kept_fade": "x",
    "plates.rules.value": "seam",
    "area_target.area_points.x": "at x",
    "area_target.area_points.area": "section",
    "fields.fields.place": "point",
    "fields.fields.extent": "x",
    "fields.fields.shift": "vector",
    "fields.fields.extent_end": "x",
    "fields.fields.shift_end": "vector",
}
# Planes of flats: their normals and offsets go together.
PLANES = frozenset(("flats.normal", "flats.offset"))
# What stays: no lengths of the hull, or of what it is compared with. Trims of tables are asked for
# as such; the reach of a fit is measured from its target, which stays; a roll period is measured.
STAYING = frozenset(
    """source water_density heel lines.width fairness.comb_factor fairness.colour_limit
    fairness.line_direction fairness.light_direction fairness.reflection_spacing
    fairness.isophote_direction fairness.isophote_spacing fairness.eye_direction
    fairness.accepted.line fairness.accepted.mark
    developables.warp developables.distance plates.thickness
    plates.ranges.spacing layers.thickness layers.density weights.thickness weights.density
    loading.loaded_case loading.heel_greatest loading.heel_step
    wind.pressure wind.roll_period
    resistance.speed_from resistance.speed_to resistance.speed_step resistance.form_factor
    resistance.appendage_factor resistance.deadrise resistance.shaft_angle resistance.heel
    resistance.open_water_efficiency resistance.shaft_efficiency resistance.roughness_um
    resistance.wave_speed_kn resistance.holtrop.lcb_percent resistance.holtrop.midship
    resistance.holtrop.waterplane resistance.holtrop.entrance_angle_deg
    resistance.delft.prismatic resistance.delft.midship resistance.delft.keel_thickness
    resistance.delft.rudder_thickness resistance.blade_area_ratio resistance.pitch_ratio
    resistance.thruster_coefficient
    table.trims plots.size plan.width plan.height plan.scale plan.drawn plan.date plan.number
    export.tolerance
    model.scale model.tolerance model.wall model.machine_x model.machine_y model.machine_z
    model.dowel model.layer panel_mesh.grading panel_mesh.part_tolerance
    export.tolerance_mm export.seam_angle export.progress studio.topside studio.boot_top
    studio.antifouling fit.edge_angle fit.fairness fit.stiffness fit.reach
      transform.kept_group
      targets.rows.value targets.rows.tolerance targets.rows.speed_kn
      targets.length_change targets.beam_change
      targets.draft_change targets.stiffness area_target.source fields.fields.colour
      fields.fields.falloff fields.fields.falloff_end""".split()
)
# Groups of which all stays: hulls as they were, curves of networks and appendages, which
# are no hulls, and families. A morph has factors of its own by
# which it is scaled; one that is scaled otherwise is told to be of no family any longer.
STAYING_GROUPS = frozenset(("variants", "morph", "curve", "appendage"))
# What is in metres whatever the scene's unit is.
_IN_METRES = frozenset(
    """lines.stations lines.waterlines lines.buttocks lines.diagonals plates.rules.value""".split()
)


def follow(obj, scale, metric):
    """Gives a hull's settings what a hull_io.scale.Scale in Blender's units makes of them;
    metric: the same Scale in metres."""
    restore_guesses = _guesses(obj.hull.loading)
    for path, change in FOLLOWING.items():
        own = metric if path in _IN_METRES else scale
        _follow(obj.hull, path.split("."), change, own)
    restore_guesses()
    for entry in obj.hull.flats:
        normal, offset = scale.plane(*_plane(entry))
        flats.store_plane(obj, entry.region, (*normal, offset))
    appendage_data.follow(obj, scale)


def _guesses(loading):
    """A function that says again which VCGs are guesses: one that is set is taken for given."""
    is_guess, cases = loading.kg_is_guess, [case.vcg_is_guess for case in loading.load_cases]

    def restore():
        loading.kg_is_guess = is_guess
        for case, case_is_guess in zip(loading.load_cases, cases):
            case.vcg_is_guess = case_is_guess

    return restore


def _plane(entry):
    plane = flats.plane_of(entry)
    return plane[:3], plane[3]


def follow_entry(entry, place, scale):
    """Gives one entry of a list, whose settings FOLLOWING has after such a place, what a Scale in
    Blender's units makes of them."""
    for path, change in FOLLOWING.items():
        if path.startswith(place):
            _follow(entry, path[len(place) :].split("."), change, scale)


def _follow(group, names, change, scale):
    name, *rest = names
    if rest:
        part = getattr(group, name)
        is_list = group.bl_rna.properties[name].type == "COLLECTION"
        for each in part if is_list else (part,):
            _follow(each, rest, change, scale)
        return
    value = getattr(group, name)
    is_vector = not isinstance(value, str) and hasattr(value, "__len__")
    value = tuple(value) if is_vector else value
    changed = scaling.CHANGES[change](scale, group, value)
    if changed != value:
        setattr(group, name, changed)
