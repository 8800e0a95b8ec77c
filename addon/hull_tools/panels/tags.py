# SPDX-License-Identifier: GPL-3.0-or-later
"""What edges, points and faces are to the surface: tagged, selected and shown in edit mode."""

import bpy

from ..bridge.objects import hull_objects
from ..features.hull import hull_state, tags
from .shared import HullTab

# Of a switch what of tags.Tags it shows.
_SHOWN = {
    "show_knuckle": ("edges", ("knuckle",)),
    "show_border": ("edges", ("border",)),
    "show_deck_edge": ("edges", ("deck_edge",)),
    "show_corners": ("points", ("corner", "automatic_corner")),
    "show_darts": ("points", ("dart",)),
    "show_irregular": ("points", ("irregular",)),
}
_SWITCHES = (*_SHOWN, "show_odd_faces", "show_flats", "show_locked", "show_kept",
             "show_problems")  # fmt: skip


class HULL_PT_tags(HullTab, bpy.types.Panel):
    """Creases and corners, in edit mode of any mesh; the deck edge of a hull"""

    bl_label = "Edges and Points"
    bl_context = "mesh_edit"

    def draw(self, context):
        column = self.layout.column(align=True)
        row = column.row(align=True)
        row.operator("hull.tag_crease")
        row.operator("hull.tag_smooth")
        row = column.row(align=True)
        row.operator("hull.tag_corner")
        row.operator("hull.tag_automatic")
        column.operator("hull.tag_by_angle")
        if hull_objects.hull_of(context.object) is None:
            return
        row = self.layout.row(align=True)
        row.operator("hull.mark_deck_edge", text="Deck Edge", icon="MARKER")
        row.operator("hull.select_deck_edge", text="", icon="RESTRICT_SELECT_OFF")
        row.operator("hull.clear_deck_edge", text="", icon="X")
        self._draw_keeping()

    def _draw_keeping(self):
        self.layout.label(text="Keep points in their")
        column = self.layout.column(align=True)
        row = column.row(align=True)
        for plane in ("STATION", "WATERLINE", "BUTTOCK"):
            row.operator("hull.keep_points", text=plane.capitalize()).plane = plane
        column.operator("hull.keep_all_points").plane = "STATION"
        row = column.row(align=True)
        row.operator("hull.free_points", text="Free")
        row.operator("hull.select_kept", text="", icon="RESTRICT_SELECT_OFF")
        row = self.layout.row(align=True)
        row.operator_menu_enum("hull.tie_points", "kind", text="Tie", icon="CONSTRAINT")
        row.operator("hull.untie_points")
        row.operator("hull.select_tied", text="", icon="RESTRICT_SELECT_OFF")


class TagSubpanel(HullTab):
    bl_parent_id = "HULL_PT_tags"
    bl_context = "mesh_edit"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        return hull_objects.hull_of(context.object) is not None


class HULL_PT_select(TagSubpanel, bpy.types.Panel):
    bl_label = "Select"

    def draw(self, context):
        column = self.layout.column(align=True)
        column.operator_menu_enum("hull.select_creases", "kind", text="Creases")
        column.operator("hull.select_chains", text="Whole Chain")
        column.operator_menu_enum("hull.select_points", "kind", text="Points")
        column.operator("hull.select_odd_faces", text="Not Quads")
        column.operator("hull.select_problems", text="Problems")


class HULL_PT_point_groups(TagSubpanel, bpy.types.Panel):
    """Points that go by a name: Blender's vertex groups"""

    bl_label = "Groups"

    def draw(self, context):
        hull = hull_objects.hull_of(context.object)
        row = self.layout.row()
        row.template_list(
            "MESH_UL_vgroups", "", hull, "vertex_groups", hull.vertex_groups, "active_index", rows=3
        )
        column = row.column(align=True)
        column.operator("object.vertex_group_add", text="", icon="ADD")
        column.operator("object.vertex_group_remove", text="", icon="REMOVE").all = False
        if not hull.vertex_groups:
            return
        row = self.layout.row(align=True)
        row.operator("object.vertex_group_assign", text="Add")
        row.operator("object.vertex_group_remove_from", text="Take Out")
        row = self.layout.row(align=True)
        row.operator("object.vertex_group_select", text="Select")
        row.operator("object.vertex_group_deselect", text="Deselect")


class HULL_PT_shown_tags(TagSubpanel, bpy.types.Panel):
    """What is drawn over the control mesh"""

    bl_label = "Shown Tags"

    def draw_header(self, context):
        self.layout.prop(hull_objects.hull_of(context.object).hull.tags, "show", text="")

    def draw(self, context):
        hull = hull_objects.hull_of(context.object)
        counts = _counts(hull)
        column = self.layout.column(align=True)
        column.active = hull.hull.tags.show
        for name in _SWITCHES:
            row = column.row(align=True)
            row.prop(hull.hull.tags, name)
            if name in counts:
                count = row.row()
                count.alignment = "RIGHT"
                count.label(text=str(counts[name]))


def _counts(hull):
    """How many there are of what switches show, by the switch; of the last good mesh."""
    state = hull_state.state_of(hull)
    if state is None or state.ship.surface is None:
        return {}
    known = tags.of_state(state)
    counts = {
        name: sum(len(getattr(known, where)[kind]) for kind in kinds)
        for name, (where, kinds) in _SHOWN.items()
    }
    counts["show_odd_faces"] = len(known.odd_faces)
    counts["show_problems"] = len(state.ship.check.problems)
    return counts


CLASSES = (HULL_PT_tags, HULL_PT_select, HULL_PT_point_groups, HULL_PT_shown_tags)
