# SPDX-License-Identifier: GPL-3.0-or-later
"""Tagging and selecting from menus while a hull is edited: the pie, the Select menu, and what
Blender's own menus of points, edges and faces have besides."""

import bpy

from ..bridge.objects import hull_objects


class HULL_MT_pie(bpy.types.Menu):
    """What the selected edges, points and faces are to the surface"""

    bl_label = "Hull"

    def draw(self, context):
        pie = self.layout.menu_pie()
        pie.operator("hull.tag_crease")  # left
        pie.operator("hull.tag_smooth")  # right
        pie.operator("hull.tag_corner")  # below
        pie.operator("hull.tag_automatic")  # above
        if hull_objects.hull_of(context.object) is None:
            return
        pie.operator("hull.select_chains")
        pie.operator("hull.mark_deck_edge")
        pie.menu("HULL_MT_select")
        pie.menu("HULL_MT_keep")


class HULL_MT_keep(bpy.types.Menu):
    """Keep faces flat, and points in planes or where they are"""

    bl_label = "Keep"

    def draw(self, context):
        layout = self.layout
        layout.operator_menu_enum("hull.make_flat", "kind")
        layout.operator("hull.release_flat")
        layout.separator()
        _draw_keeping(layout)
        layout.separator()
        layout.operator("hull.lock_points")
        layout.operator("hull.unlock_points")
        layout.separator()
        layout.menu("HULL_MT_fields")


class HULL_MT_fields(bpy.types.Menu):
    """Shift regions of the hull smoothly, and protect others"""

    bl_label = "Shape Fields"

    def draw(self, context):
        layout = self.layout
        for role, text in (("MOVE", "Shift Here"), ("PROTECT", "Protect Here")):
            layout.operator("hull.add_field", text=text).role = role
        layout.operator_menu_enum("hull.add_field_recipe", "recipe", text="Recipes")
        layout.operator("hull.take_field_faces")
        layout.separator()
        layout.operator("hull.preview_fields")
        layout.operator("hull.apply_fields")
        layout.operator("hull.cancel_fields")


def _draw_keeping(layout):
    layout.operator_menu_enum("hull.keep_points", "plane")
    layout.operator_menu_enum("hull.keep_all_points", "plane", text="Keep All Points")
    layout.operator("hull.free_points")
    layout.operator_menu_enum("hull.tie_points", "kind")
    layout.operator("hull.untie_points")


class HULL_MT_select(bpy.types.Menu):
    """Select by what edges, points and faces are to the surface"""

    bl_label = "Select in Hull"

    def draw(self, context):
        layout = self.layout
        layout.operator_menu_enum("hull.select_creases", "kind")
        layout.operator("hull.select_chains")
        layout.operator_menu_enum("hull.select_points", "kind")
        layout.operator("hull.select_locked")
        layout.operator("hull.select_tied")
        layout.operator_menu_enum("hull.select_kept", "plane")
        layout.operator("hull.select_odd_faces")
        layout.operator("hull.select_flat")
        layout.operator("hull.select_problems")


def _draw_point_operators(layout):
    layout.operator("hull.tag_corner")
    layout.operator("hull.tag_automatic")
    layout.operator("hull.tag_smooth")
    layout.operator_menu_enum("hull.put_in_plane", "plane")
    layout.operator("hull.set_coordinates")
    layout.operator("hull.reduce_valence")
    layout.operator("hull.lock_points")
    layout.operator("hull.unlock_points")
    _draw_keeping(layout)


def _draw_edge_operators(layout):
    layout.operator("hull.tag_crease")
    layout.operator("hull.tag_smooth")
    layout.operator("hull.tag_by_angle")
    layout.operator("hull.mark_deck_edge")
    layout.operator("hull.select_chains")


def _draw_face_operators(layout):
    layout.operator_menu_enum("hull.make_flat", "kind")
    layout.operator("hull.release_flat")
    layout.operator("hull.check_flat")


_OF_MODES = (_draw_point_operators, _draw_edge_operators, _draw_face_operators)


def _is_hull(context):
    return hull_objects.hull_of(context.object) is not None


def _draw_in_context_menu(self, context):
    if not _is_hull(context):
        return
    for is_mode, draw in zip(context.tool_settings.mesh_select_mode, _OF_MODES):
        if is_mode:
            self.layout.separator()
            self.layout.label(text="Hull")
            draw(self.layout)


def _draw_in_select_menu(self, context):
    if _is_hull(context):
        self.layout.separator()
        self.layout.menu("HULL_MT_select")


def _draw_in_overlays(self, context):
    if _is_hull(context):
        self.layout.prop(hull_objects.hull_of(context.object).hull.tags, "show", text="Hull tags")


def _appended(draw):
    def draw_in_menu(self, context):
        if _is_hull(context):
            self.layout.separator()
            draw(self.layout)

    return draw_in_menu


CLASSES = (HULL_MT_pie, HULL_MT_keep, HULL_MT_fields, HULL_MT_select)

# By the name of Blender's menu or panel.
DRAWN_IN = {
    "VIEW3D_MT_edit_mesh_context_menu": _draw_in_context_menu,
    "VIEW3D_PT_overlay_edit_mesh": _draw_in_overlays,
    "VIEW3D_MT_select_edit_mesh": _draw_in_select_menu,
    "VIEW3D_MT_edit_mesh_vertices": _appended(_draw_point_operators),
    "VIEW3D_MT_edit_mesh_edges": _appended(_draw_edge_operators),
    "VIEW3D_MT_edit_mesh_faces": _appended(_draw_face_operators),
}
