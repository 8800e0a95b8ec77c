# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls that were kept under a name, and the hull that this one is compared with."""

import bpy

from ..bridge.blender.units import format_value, in_unit
from ..bridge.objects import hull_objects
from ..features.flotation import hydrostatics
from ..features.hull import hull_state
from ..features.variants import distances, ghosts, kept_hulls
from .fairness import draw_colour_limit
from .shared import (
    HullPanel,
    choice_below,
    export_buttons,
    label_value,
    label_wrapped,
    latest_result,
    text_field,
)

# By what a hull is told from another at a glance: names of quantities, and symbols.
_KEY_DIFFERENCES = (
    ("displaced_volume", "∇"),
    ("displacement_t", "Δ"),
    ("wetted_surface", "S"),
    ("waterline_length", "Lwl"),
    ("waterline_beam", "Bwl"),
    ("waterplane_area", "Aw"),
    ("project_block", "Cb"),
    ("project_prismatic", "Cp"),
    ("project_midship", "Cm"),
    ("lcb", "LCB"),
    ("lcf", "LCF"),
    ("kb", "KB"),
    ("kmt", "KMt"),
)


class HULL_UL_variants(bpy.types.UIList):
    def draw_item(self, context, layout, data, item, icon, active_data, active_property, index):
        layout.prop(item, "name", text="", emboss=False)


class HULL_PT_variants(HullPanel, bpy.types.Panel):
    bl_label = "Variants"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        variants = hull.hull.variants
        row = layout.row()
        row.template_list("HULL_UL_variants", "", variants, "kept", variants, "active", rows=3)
        column = row.column(align=True)
        column.operator("hull.keep_variant", text="", icon="ADD")
        column.operator("hull.remove_variant", text="", icon="REMOVE")
        entry = kept_hulls.chosen(hull)
        if entry is not None:
            text_field(layout, entry, "note")
            row = layout.row(align=True)
            row.operator("hull.go_back_to_variant")
            row.operator("hull.duplicate_variant")


class HULL_PT_comparison(HullPanel, bpy.types.Panel):
    """The hull beside a variant of it, or beside another hull"""

    bl_label = "Comparison"
    bl_parent_id = "HULL_PT_variants"

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        variants, state = hull.hull.variants, hull_state.state_of(hull)
        choice_below(layout, variants, "compared_with")
        if variants.compared_with == "HULL":
            layout.prop(variants, "other_hull", text="")
        choice_below(layout, variants, "afloat")
        layout.prop(variants, "show_ghost")
        status = "" if state is None else state.of(ghosts.Ghost).status
        if status:
            label_wrapped(layout, context, status, icon="INFO")


class HULL_PT_differences(HullPanel, bpy.types.Panel):
    """This hull less the other one: particulars and sectional areas"""

    bl_label = "Differences"
    bl_parent_id = "HULL_PT_variants"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        variants = hull_objects.hull_of(context.object).hull.variants
        result, place = latest_result(layout, context, "differences", "Hull less other")
        if result is not None:
            found = result.by[variants.afloat]
            if found.message:
                label_wrapped(place, context, found.message, icon="INFO")
            else:
                _draw_differences(place.column(align=True), context.scene, found)
        export_buttons(layout, "differences")
        layout.label(text="Areas by station")
        export_buttons(layout, "area_differences")


_UNITS = {quantity.name: quantity.unit for quantity in hydrostatics.QUANTITIES}


def _draw_differences(column, scene, found):
    column.scale_y = 0.8
    for name, symbol in _KEY_DIFFERENCES:
        row = found.rows[name]
        text = _signed(scene, row.difference, _UNITS[name])
        if row.percent is not None:
            text += f"  {_with_sign(f'{row.percent:.2f}', row.percent)} %"
        label_value(column, symbol, text)
    label_value(column, "Area, most", _signed(scene, found.areas.largest, "m2"))
    label_value(column, "at x", format_value(scene, found.areas.largest_at, "m"))


def _signed(scene, value, unit):
    return _with_sign(format_value(scene, value, unit), value)


def _with_sign(text, value):
    """A number as text with a plus where it is positive; what is zero but for rounding has no
    sign."""
    if value is None:
        return text
    digits = text.split(" ")[0].strip("-")
    if not digits.strip("0.°"):
        return text.lstrip("-")
    return f"+{text}" if value > 0.0 else text


class HULL_PT_distances(HullPanel, bpy.types.Panel):
    """How far this hull's surface lies from the other one's"""

    bl_label = "Distances"
    bl_parent_id = "HULL_PT_variants"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        fairness, state = hull.hull.fairness, hull_state.state_of(hull)
        choice_below(layout, fairness, "colours")
        if fairness.colours != distances.COLOURS or state is None:
            return
        draw_colour_limit(layout, context, fairness)
        shown = state.shown
        if shown.distances is None:
            text = "computing …" if shown.other is None else shown.other.status
            label_wrapped(layout, context, text or "The surface is not shown", icon="INFO")
            return
        column = layout.column(align=True)
        column.active = not state.status  # else they are of the hull as it was
        _draw_distances(column, context.scene, shown.distances)


def _draw_distances(column, scene, found):
    column.scale_y = 0.8
    for name, value, at in (
        ("Outside", found.outwards, found.outwards_at),
        ("Inside", found.inwards, found.inwards_at),
    ):
        label_value(column, name, format_value(scene, value, "m"))
        if at is not None:
            label_value(column, "at x", format_value(scene, at[0], "m"))
            # Rounded to zero a number may still have a minus.
            (y, symbol), (z, _) = (in_unit(scene, part, "m") for part in at[1:])
            y, z = round(y, 2) + 0.0, round(z, 2) + 0.0
            label_value(column, "y, z", f"{y:.2f}, {z:.2f} {symbol}")
    label_value(column, "Mean size", format_value(scene, found.mean_size, "m"))
    label_value(column, "RMS", format_value(scene, found.rms, "m"))
    label_value(column, "Beyond", f"{100.0 * (1.0 - found.share):.2f} % of area")


CLASSES = (
    HULL_UL_variants,
    HULL_PT_variants,
    HULL_PT_comparison,
    HULL_PT_differences,
    HULL_PT_distances,
)
