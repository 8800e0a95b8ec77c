# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls that were kept under a name, and the hull that this one is compared with."""

import bpy

from ..bridge.objects import hull_objects
from ..features.hull import hull_state
from ..features.variants import ghosts, kept_hulls
from .shared import HullPanel, choice_below, label_wrapped, text_field


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
            row.operator("hull.go_back_to_variant", icon="LOOP_BACK")
            row.operator("hull.duplicate_variant", icon="DUPLICATE")


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


CLASSES = (HULL_UL_variants, HULL_PT_variants, HULL_PT_comparison)
