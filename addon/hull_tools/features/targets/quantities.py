# SPDX-License-Identifier: GPL-3.0-or-later
"""What of a hull can be a target: how it is named, its unit, and where it is in hull_native."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Quantity:
    """identifier: of the choice. label: in rows. title: in the menu. unit: as units.format_value
    takes it. number: one of hull_native.FORM_NUMBERS, or "section_area" or "wave_resistance"."""

    identifier: str
    label: str
    title: str
    unit: str
    number: str


SECTION = "SECTION_AREA"
WAVES = "WAVE_RESISTANCE"
# KMt less the KG of the stability panel.
GM = "GM"

QUANTITIES = tuple(
    Quantity(*row)
    for row in (
        ("VOLUME", "∇", "Displaced volume ∇", "m3", "displaced_volume"),
        ("DISPLACEMENT", "Δ", "Displacement Δ", "t", "displacement_t"),
        ("LCB_PERCENT", "LCB %", "LCB forward of midship, % of Lpp", "%", "lcb_percent"),
        ("LCB", "LCB", "LCB from AP", "m", "lcb"),
        ("CB", "Cb", "Block coefficient Cb", "", "project.block"),
        ("CP", "Cp", "Prismatic coefficient Cp", "", "project.prismatic"),
        ("CM", "Cm", "Midship coefficient Cm", "", "project.midship"),
        ("CWP", "Cwp", "Waterplane coefficient Cwp", "", "project.waterplane"),
        ("CVP", "Cvp", "Vertical prismatic coefficient Cvp", "", "project.vertical_prismatic"),
        ("AWP", "Awp", "Waterplane area", "m2", "waterplane_area"),
        ("LCF_PERCENT", "LCF %", "LCF forward of midship, % of Lpp", "%", "lcf_percent"),
        ("LCF", "LCF", "LCF from AP", "m", "lcf"),
        ("KB", "KB", "Centre of buoyancy above base KB", "m", "kb"),
        (GM, "GM", "GM with the KG of the stability panel", "m", "km_transverse"),
        ("KMT", "KMt", "Transverse metacentre above base KMt", "m", "km_transverse"),
        ("BMT", "BMt", "Transverse metacentric radius BMt", "m", "bm_transverse"),
        ("KML", "KMl", "Longitudinal metacentre above base KMl", "m", "km_longitudinal"),
        ("WETTED", "Wetted", "Wetted surface", "m2", "wetted_surface"),
        ("MIDSHIP_AREA", "Am", "Midship section area", "m2", "midship_section.area"),
        (SECTION, "Section", "Area of the section at x", "m2", "section_area"),
        ("LWL", "Lwl", "Length of the waterline", "m", "waterline_length"),
        ("BWL", "Bwl", "Beam of the waterline", "m", "waterline_beam"),
        (WAVES, "Rw", "Wave resistance at a speed, by Michell's integral", "kN", "wave_resistance"),
    )
)
_BY_IDENTIFIER = {quantity.identifier: quantity for quantity in QUANTITIES}

ITEMS = tuple((quantity.identifier, quantity.label, quantity.title) for quantity in QUANTITIES)


def quantity_of(row):
    """The Quantity of a row of Object.hull.targets."""
    return _BY_IDENTIFIER[row.quantity]
