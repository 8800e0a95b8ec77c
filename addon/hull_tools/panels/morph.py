# SPDX-License-Identifier: GPL-3.0-or-later
"""The hull as a member of a family: its parents with their weights, and which lines are paired."""

import bpy

from ..bridge.objects import hull_objects
from ..features.morphing import making, members, pairs, parents
from .conversion import draw_task
from .shared import HullPanel, draw_entries, label_value, label_wrapped, text_field
from .targets import draw_free, draw_targets


class HULL_UL_parents(bpy.types.UIList):
    def draw_item(self, context, layout, data, item, icon, active_data, active_property, index):
        layout.prop(item, "weight", text=item.name, slider=True)


class HULL_UL_pairs(bpy.types.UIList):
    def draw_item(self, context, layout, data, item, icon, active_data, active_property, index):
        row = layout.row(align=True)
        colour = row.row()
        colour.scale_x = 0.3
        colour.prop(item, "colour", text="")
        row.label(text=item.name, icon="PINNED" if item.is_given else "NONE")


class HULL_PT_morph(HullPanel, bpy.types.Panel):
    """A hull between two others or more"""

    bl_label = "Morph"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        hull = hull_objects.hull_of(context.object)
        if parents.is_member(hull):
            _draw_member(self.layout, context, hull)
        else:
            _draw_making(self.layout, context, hull)


def _draw_making(layout, context, hull):
    settings = hull.hull.morph
    chosen = making.selected_parents(context.object, context.selected_objects)
    column = layout.column(align=True)
    column.label(text="Parents: the selected hulls")
    for other in chosen:
        column.label(text=other.name, icon="OUTLINER_OB_MESH")
    text_field(layout, settings, "layout_hull")
    column = layout.column(align=True)
    column.prop(settings, "tolerance")
    column.prop(settings, "most_subdivisions")
    if not draw_task(layout, hull):
        layout.operator("hull.make_morph", icon="MOD_SMOOTH")


def _draw_member(layout, context, hull):
    morph, member = hull.hull.morph, members.told(hull)
    if not member.is_of_family:
        label_wrapped(layout, context, members.NOT_OF_FAMILY, icon="ERROR")
        layout.operator("hull.back_to_family", icon="LOOP_BACK")
    column = layout.column()
    column.enabled = member.is_of_family and hull.mode == "OBJECT"
    column.template_list("HULL_UL_parents", "", morph, "parents", morph, "active_parent", rows=2)
    column.operator("hull.set_weights", text="Equal Weights")
    if member.problem:
        label_wrapped(layout, context, member.problem, icon="ERROR")
    layout.prop(morph, "follows_particulars")
    if any(factor != 1.0 for factor in morph.factors):
        layout.column().prop(morph, "factors")
    _draw_fits(layout, context, morph)
    lost, other = parents.gone(morph), parents.changed(morph)
    if lost:
        told = ", ".join(lost)
        label_wrapped(layout, context, f"Deleted, and kept here as fitted: {told}", icon="INFO")
    if other:
        told = ", ".join(other)
        label_wrapped(layout, context, f"Changed since it was fitted: {told}", icon="ERROR")
    if not draw_task(layout, hull) and (other or morph.has_other_pairs):
        layout.operator("hull.pair_again", icon="FILE_REFRESH")
    layout.operator("hull.leave_family", icon="UNLINKED")


def _draw_fits(layout, context, morph):
    column = layout.column(align=True)
    column.scale_y = 0.8
    label_value(column, "Layout", morph.layout_name)
    entry = _chosen(morph)
    if entry is not None:
        label_wrapped(column, context, f"{entry.name}: {entry.fit}")
        if entry.shortfall:
            label_wrapped(column, context, entry.shortfall, icon="ERROR")


def _chosen(morph):
    index = morph.active_parent
    return morph.parents[index] if 0 <= index < len(morph.parents) else None


class MemberPanel(HullPanel):
    """A panel that is there when the hull is of a family."""

    bl_parent_id = "HULL_PT_morph"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        hull = hull_objects.hull_of(context.object)
        return hull is not None and parents.is_member(hull)


class HULL_PT_morph_pairs(MemberPanel, bpy.types.Panel):
    """Which lines of the parents are one line in the family"""

    bl_label = "Paired Lines"

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        morph = hull.hull.morph
        entry = _chosen(morph)
        if entry is None or not entry.features:
            label_wrapped(layout, context, "Choose a parent whose layout is another", icon="INFO")
            return
        layout.prop(morph, "show_pairs")
        row = layout.row()
        row.template_list("HULL_UL_pairs", "", entry, "pairs", entry, "active_pair", rows=4)
        row.column(align=True).operator("hull.remove_pair", text="", icon="REMOVE")
        _draw_alone(layout, context, morph, entry)
        column = layout.column(align=True)
        column.label(text="Pair by hand:")
        column.prop_search(morph, "feature", morph, "features", text="Layout")
        column.prop_search(entry, "feature", entry, "features", text="Parent")
        column.operator("hull.add_pair", icon="ADD")
        if morph.has_other_pairs:
            label_wrapped(layout, context, "Corrected: counts when it is fitted again", icon="INFO")
        row = layout.row(align=True)
        row.operator("hull.pair_again", icon="FILE_REFRESH")
        row.operator("hull.forget_pairs", text="", icon="X")


def _draw_alone(layout, context, morph, entry):
    own, other = pairs.alone(morph, entry)
    for whose, names in (("Layout", own), (entry.name, other)):
        if names:
            label_wrapped(layout, context, f"Alone in {whose}: {', '.join(names)}")
    if len(entry.apart):
        told = ", ".join(pair.name for pair in entry.apart)
        label_wrapped(layout, context, f"Held apart: {told}")


class HULL_UL_local(bpy.types.UIList):
    def draw_item(self, context, layout, data, item, icon, active_data, active_property, index):
        layout.label(text=f"{item.field}: {item.parent}")


class HULL_PT_morph_local(MemberPanel, bpy.types.Panel):
    """Parents that count alone around shape fields of this hull"""

    bl_label = "Local Parents"

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        morph = hull.hull.morph
        row = draw_entries(layout, morph, "local", "active_local", "local_parent")
        if row is not None:
            column = layout.column(align=True)
            column.prop_search(row, "field", hull.hull.fields, "fields", text="Around")
            column.prop_search(row, "parent", morph, "parents", text="Is")


class HULL_PT_morph_targets(MemberPanel, bpy.types.Panel):
    """Weights with which the hull has wanted numbers, those of the panel Targets"""

    bl_label = "Weights for Targets"

    def draw(self, context):
        hull = hull_objects.hull_of(context.object)
        draw_targets(self.layout, context, hull, draw_free, "hull.find_weights")


class HULL_PT_morph_series(MemberPanel, bpy.types.Panel):
    """Members from one parent to another in equal steps"""

    bl_label = "Series"

    def draw(self, context):
        layout = self.layout
        morph = hull_objects.hull_of(context.object).hull.morph
        column = layout.column(align=True)
        for name in ("series_from", "series_to"):
            column.prop(morph, name)
            number = getattr(morph, name) - 1
            if number < len(morph.parents):
                label_value(column, "", morph.parents[number].name)
        layout.prop(morph, "steps")
        layout.operator("hull.export_series_table", icon="EXPORT")
        text_field(layout, morph, "series_format")
        layout.operator("hull.export_series", icon="EXPORT")


CLASSES = (
    HULL_UL_parents,
    HULL_UL_pairs,
    HULL_UL_local,
    HULL_PT_morph,
    HULL_PT_morph_pairs,
    HULL_PT_morph_local,
    HULL_PT_morph_targets,
    HULL_PT_morph_series,
)
