# SPDX-License-Identifier: GPL-3.0-or-later
"""Hydrostatics of a floating body, with the names and units of the panel and of the table."""

from dataclasses import dataclass
from operator import attrgetter
from types import SimpleNamespace

from ...bridge import native

# Volumes from depths and from breadths that differ by more than this part are no rounding.
_CLOSED_TOLERANCE = 1e-6
_CLOSING = (
    "Join its borders there or close it with faces: Select › Creases › Borders shows them; a "
    "whole hull whose sides are alike, and meet at stem or stern, is closed across by Make Half"
)


@dataclass(frozen=True)
class Quantity:
    """A number of hydrostatics: where it is in hull_native.Hydrostatics, and how it is named.

    name: of the value in HydrostaticValues. title: in tables. unit: as units.format_value takes it.
    """

    group: str
    name: str
    label: str
    title: str
    unit: str
    path: str


def _quantities():
    for group, rows in _GROUPS.items():
        for name, label, title, unit, path in rows:
            yield Quantity(group, name, label, title, unit, path or name)


_COEFFICIENTS = (
    ("block", "Cb", "Cb"),
    ("prismatic", "Cp", "Cp"),
    ("midship", "Cm", "Cm"),
    ("waterplane", "Cwp", "Cwp"),
    ("vertical_prismatic", "Cvp", "Cvp"),
)


def _coefficients(of, what):
    return tuple(
        (f"{of}_{name}", label, f"{title} {what}", "", f"{of}.{name}")
        for name, label, title in _COEFFICIENTS
    )


# name, label in the panel, title in tables, unit, path in hull_native.Hydrostatics if it is not
# the name.
_GROUPS = {
    "Displacement": (
        ("displaced_volume", "Volume ∇", "displaced volume", "m3", ""),
        ("displacement_t", "Displacement Δ", "displacement", "t", ""),
        ("wetted_surface", "Wetted area", "wetted surface", "m2", ""),
        ("tpc", "TPC", "TPC", "t/cm", ""),
        ("mtc", "MTC", "MTC (with BMl)", "t m/cm", ""),
    ),
    "Centres": (
        ("lcb", "LCB", "LCB from AP", "m", ""),
        ("lcb_percent", "LCB of Lpp", "LCB forward of midship", "%", ""),
        ("tcb", "TCB", "TCB to port", "m", ""),
        ("kb", "KB", "KB", "m", ""),
        ("lateral_area", "Lateral area", "lateral area", "m2", ""),
        ("lateral_x", "– centre x", "lateral area's centre from AP", "m", ""),
        ("lateral_z", "– centre z", "lateral area's centre above base", "m", ""),
        ("wind_area", "Wind area", "wind area", "m2", ""),
        ("wind_x", "– centre x", "wind area's centre from AP", "m", ""),
        ("wind_z", "– centre z", "wind area's centre above base", "m", ""),
    ),
    "Waterplane": (
        ("waterplane_area", "Area", "waterplane area", "m2", ""),
        ("lcf", "LCF", "LCF from AP", "m", ""),
        ("lcf_percent", "LCF of Lpp", "LCF forward of midship", "%", ""),
        ("tcf", "TCF", "TCF to port", "m", ""),
        ("inertia_transverse", "I transv.", "waterplane I transverse", "m4",
         "waterplane_inertia_transverse"),
        ("inertia_longitudinal", "I longit.", "waterplane I longitudinal", "m4",
         "waterplane_inertia_longitudinal"),
        ("half_angle_of_entrance", "Entrance ½", "half angle of entrance", "deg", ""),
        ("entrance_chord_angle", "Entr. chord", "entrance chord angle", "deg", ""),
    ),
    "Stability": (
        ("bmt", "BMt", "BMt", "m", "bm_transverse"),
        ("bml", "BMl", "BMl", "m", "bm_longitudinal"),
        ("kmt", "KMt", "KMt", "m", "km_transverse"),
        ("kml", "KMl", "KMl", "m", "km_longitudinal"),
    ),
    "Actual dimensions": (
        ("waterline_length", "Lwl", "Lwl", "m", ""),
        ("waterline_beam", "Bwl", "Bwl", "m", ""),
        ("immersed_length", "Length", "immersed length", "m", ""),
        ("immersed_beam", "Beam", "immersed beam", "m", ""),
        ("immersed_draft", "Draft", "immersed draft", "m", ""),
        ("midship_area", "Midship area", "midship section area", "m2", "midship_section.area"),
        ("largest_area", "Largest area", "largest section area", "m2", "largest_section.area"),
        ("largest_x", "Largest at x", "largest section from AP", "m",
         "largest_section.position"),
    ),
    "Coefficients, project": _coefficients("project", "on project dimensions"),
    "Coefficients, actual": _coefficients("immersed", "on immersed dimensions"),
}  # fmt: skip

GROUP_NOTES = {
    "Centres": "x from AP, y to port, z from base; % forward of midship",
    "Actual dimensions": "Of the waterline (wl) and of all that is immersed",
    "Coefficients, project": "On Lpp, beam, draft and the section at Lpp/2",
    "Coefficients, actual": "On immersed length, beam, draft and the largest section",
}

QUANTITIES = tuple(_quantities())
_ALL_OF = attrgetter(*(quantity.path for quantity in QUANTITIES))  # hull_native.Hydrostatics
# What a hull is told by at a glance: names of quantities, and labels.
KEY_FIGURES = (
    ("project_block", "Cb"),
    ("project_prismatic", "Cp"),
    ("project_midship", "Cm"),
    ("project_waterplane", "Cwp"),
    ("lcf", "LCF"),
)
GROUPS = tuple(_GROUPS)


class HydrostaticValues(SimpleNamespace):
    """draft, draft_aft, draft_forward and trim_m (m), heel (rad), and the values of QUANTITIES, in
    metres, radians and tonnes, by their names; both sides. What is undefined is None. remark: a
    sentence, or ""."""


def at(ship, where):
    """HydrostaticValues of a ship.Ship that lies as an Afloat says; ValueError as `computed`."""
    return described(ship.hydrostatics(where), where)


def computed(body, where, kept_stations=None):
    """The hull_native.Hydrostatics of a hull_native.HullBody, of which stations may be kept.

    ValueError when nothing is under water or the shell is open there, when the body floods, or
    faces are turned.
    """
    found = native.require().hydrostatics(
        body, **where.position(), **where.project(), kept_stations=kept_stations
    )
    if found.displaced_volume <= 0.0:
        raise ValueError(why_no_volume(found, where.draft))
    return found


def why_no_volume(found, draft):
    """Why the hull_native.Hydrostatics at a draft (m) have no volume, in a sentence."""
    if found.displaced_volume < 0.0 < found.immersed_draft:
        return f"{_open_shell(found)}. {_CLOSING}"
    return f"Nothing is under water at a draft of {draft:.3f} m"


def described(found, where):
    """HydrostaticValues of hull_native.Hydrostatics."""
    has_length = where.length_pp > 0.0
    values = {
        quantity.name: None if _is_undefined(quantity, value, has_length) else value
        for quantity, value in zip(QUANTITIES, _ALL_OF(found))
    }
    return HydrostaticValues(
        draft=where.draft,
        draft_aft=where.draft + 0.5 * where.trim_m,
        draft_forward=where.draft - 0.5 * where.trim_m,
        trim_m=where.trim_m,
        heel=where.heel,
        remark=_remark(found, where),
        **values,
    )


def _is_undefined(quantity, value, has_length):
    """Whether a number of hull_native.Hydrostatics stands for none."""
    if quantity.unit in ("", "deg") and value == 0.0:
        return True
    return not has_length and (quantity.unit == "%" or quantity.name in ("mtc", "midship_area"))


def _remark(found, where):
    """Whether the shell is open in a way that no closing rule covers; known of upright ones."""
    if where.heel != 0.0 or where.trim_m != 0.0:
        return ""
    volume, other = found.displaced_volume, found.volume_from_breadths
    if abs(volume - other) <= _CLOSED_TOLERANCE * volume:
        return ""
    return f"{_open_shell(found)}, from breadths {other:.6g} m³. {_CLOSING}"


def _open_shell(found):
    return (
        "The shell is not closed below the water: from depths the volume is "
        f"{found.displaced_volume:.6g} m³"
    )
