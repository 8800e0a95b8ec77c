# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.targets: numbers that the hull is to have, and what may be changed for them."""

import bpy
from bpy.props import BoolProperty, CollectionProperty, EnumProperty, FloatProperty, IntProperty

from ..bridge import limits
from ..features.targets import quantities, rows
from .outline_settings import KeptOutline
from .shared import length

_SENSES = (
    ("equal", "=", "Equal to the value, by the tolerance more or less"),
    ("at least", "≥", "At least the value"),
    ("at most", "≤", "At most the value"),
)


def _free(name, what):
    return BoolProperty(
        name=name,
        description=f"{what}, within the limits below; the particulars follow",
    )


def _change(name, what):
    return FloatProperty(
        name=name,
        description=f"By how much {what} may become less or more, in percent",
        default=5.0,
        min=0.0,
        max=limits.GREATEST_DIMENSION_CHANGE,
        precision=2,
        subtype="PERCENTAGE",
    )


def _of_another_quantity(row, context):
    """One quantity's number means nothing for another: it begins with its present one."""
    rows.take_present(row, row.id_data, context.scene)


class HullTarget(bpy.types.PropertyGroup):
    """A row: the names of its settings are those of hull_native.FormTarget where they are there."""

    use: BoolProperty(name="On", description="The row counts", default=True)
    quantity: EnumProperty(
        name="Quantity",
        description="What of the hull, as it lies in the water, is to have a value",
        items=quantities.ITEMS,
        update=_of_another_quantity,
    )
    station: length("Station x", "Where the section is whose area is wanted", minimum=None)
    speed_kn: FloatProperty(
        name="Speed kn",
        description="At which the wave resistance is wanted, in knots",
        default=12.0,
        min=0.1,
        max=limits.FASTEST,
        precision=2,
        step=10,
        update=_of_another_quantity,
    )
    sense: EnumProperty(name="Sense", description="How the value is meant", items=_SENSES)
    value: FloatProperty(
        name="Wanted",
        description="In metres, square and cubic metres, tonnes, kN or percent, as the present "
        "value",
        precision=5,
        step=1,
    )
    tolerance: FloatProperty(
        name="Tolerance",
        description="By how much the value may be missed, in its own unit; 0: exact",
        min=0.0,
        precision=5,
        step=1,
    )


class HullTargets(KeptOutline, bpy.types.PropertyGroup):
    """Nothing here changes what is shown of the hull."""

    rows: CollectionProperty(type=HullTarget)
    active_row: IntProperty(name="Row", description="The row that is edited", min=0)
    moving: EnumProperty(
        name="Points",
        description="Which control points may move",
        items=(
            ("ALL", "All", "All that are free: not locked, and within their flats"),
            ("SELECTED", "Selected", "Those that are selected in edit mode"),
            ("NONE", "None", "None: dimensions alone"),
        ),
    )
    free_length: _free("Length", "The hull may become longer or shorter")
    length_change: _change("± %", "the length")
    free_beam: _free("Beam", "The hull may become wider or narrower")
    beam_change: _change("± %", "the beam")
    free_draft: _free("Draft", "Draft and depth may become more or less")
    draft_change: _change("± %", "draft and depth")
    stiffness: FloatProperty(
        name="Fairness",
        description="What bending of the surface costs beside its shift, as a part of the hull's "
        "length over which a change is spread; 0: nothing",
        default=0.05,
        min=0.0,
        max=limits.GREATEST_TARGET_STIFFNESS,
        precision=3,
        step=1,
    )


CLASSES = (HullTarget, HullTargets)
