# SPDX-License-Identifier: GPL-3.0-or-later
"""The hull itself: how to begin, its particulars, the check of its mesh."""

import bpy

from ..bridge import native
from ..bridge.objects import hull_objects
from ..features.dimensions import dimensions
from ..features.hull import hull_state
from ..properties.shared import metric_field
from .conversion import draw_task
from .doubts import draw_doubts, draw_mending
from .shared import HullPanel, HullTab, label_value, label_wrapped


class HULL_PT_hull(HullTab, bpy.types.Panel):
    bl_label = "Hull"

    def draw(self, context):
        layout = self.layout
        if native.hull_native is None:
            label_wrapped(layout, context, native.missing_reason, icon="ERROR")
        hull = hull_objects.hull_of(context.object)
        if hull is None:
            self._draw_beginnings(layout)
        else:
            self._draw_status(context, hull)
            self._draw_particulars(layout, hull.hull)
            self._draw_others(layout)

    def _draw_beginnings(self, layout):
        layout.menu("HULL_MT_add", text="New Hull", icon="MOD_OCEAN")
        layout.operator("hull.make_hull", icon="MESH_DATA")
        layout.operator("hull.hull_from_mesh", icon="MOD_SHRINKWRAP")
        layout.operator("hull.import_hull", icon="IMPORT")
        layout.operator("hull.hull_from_file", icon="FILEBROWSER")
        layout.operator_menu_enum("hull.load_sample", "name", icon="FILE_3D")

    def _draw_others(self, layout):
        """The ways to another hull, beside the one at hand."""
        column = layout.column(align=True)
        row = column.row(align=True)
        row.menu("HULL_MT_add", text="New")
        row.operator("hull.import_hull", text="Import")
        column.operator("hull.hull_from_file", text="From File")
        column.operator_menu_enum("hull.load_sample", "name", text="Sample")

    def _draw_status(self, context, hull):
        layout = self.layout
        layout.label(text=hull.name, icon="MESH_DATA")
        state = hull_state.state_of(hull)
        if state is None:
            layout.operator("hull.update", icon="FILE_REFRESH")
            return
        if state.status:
            label_wrapped(layout, context, state.status, icon="ERROR")
        if hull_objects.is_turned(hull):
            button = layout.operator("object.transform_apply", text="Apply", icon="CHECKMARK")
            button.location = False
        self._draw_scale(context, hull)
        draw_doubts(layout, context, state)
        for remark in (*state.remarks, *([state.keeping.held] if state.keeping.held else [])):
            label_wrapped(layout, context, remark, icon="INFO")

    def _draw_scale(self, context, hull):
        """That Blender scaled the hull, and the button that lets all else follow."""
        factors, scale = dimensions.unapplied(hull), dimensions.noticed(hull)
        if factors is None and scale is None:
            return
        box = self.layout.box()
        text = dimensions.text_of(factors or scale.factors)
        label_wrapped(box, context, f"{text}: particulars, drafts and the like may follow", "INFO")
        box.operator("hull.follow_scale", icon="FULLSCREEN_ENTER")

    def _draw_particulars(self, layout, settings):
        column = layout.column(align=True)
        for name in ("length_pp", "beam", "depth", "draft"):
            column.prop(settings, name)
        if not draw_task(layout, settings.id_data):
            layout.operator("hull.set_dimensions", text="Scale to Dimensions …")
        metric_field(layout, settings, "water_density")
        row = layout.row(align=True)
        row.prop(settings, "half")
        row.operator("hull.make_whole" if settings.half else "hull.make_half")
        if settings.half:
            layout.prop(settings, "keep_centre")


class HULL_PT_check(HullPanel, bpy.types.Panel):
    bl_label = "Mesh Check"

    def draw(self, context):
        layout = self.layout
        state = hull_state.state_of(hull_objects.hull_of(context.object))
        if state is None:
            return
        check = state.ship.check
        column = layout.column(align=True)
        column.scale_y = 0.8
        label_value(column, "Points", str(check.vertex_count))
        label_value(column, "Faces", str(check.face_count))
        if not check.errors:
            label_value(column, "Edges", str(check.edge_count))
            label_value(column, "Irregular", str(check.irregular_count))
        if not check.problems:
            layout.label(text="No problems", icon="CHECKMARK")
        for index, problem in enumerate(check.problems):
            icon = "ERROR" if problem.severity == "error" else "INFO"
            box = layout.box()
            label_wrapped(box, context, problem.message, icon)
            if problem.elements:
                box.operator("hull.select_problem").index = index
            draw_mending(box, problem)
        layout.operator("hull.turn_outwards")


def _draw_in_object_menu(self, context):
    hull = hull_objects.hull_of(context.object)
    if hull is None:
        return
    self.layout.separator()
    self.layout.operator("hull.set_dimensions")
    self.layout.operator("hull.make_whole" if hull.hull.half else "hull.make_half")
    self.layout.operator("hull.turn_outwards")


def _draw_in_normals_menu(self, context):
    if hull_objects.hull_of(context.object) is not None:
        self.layout.separator()
        self.layout.operator("hull.turn_outwards")


CLASSES = (HULL_PT_hull, HULL_PT_check)

DRAWN_IN = {
    "VIEW3D_MT_object": _draw_in_object_menu,
    "VIEW3D_MT_edit_mesh_normals": _draw_in_normals_menu,
}
