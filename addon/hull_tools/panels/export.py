# SPDX-License-Identifier: GPL-3.0-or-later
"""The hull's way out: files, and the patches that go into those of CAD systems."""

import bpy

from ..bridge.objects import appendages, hull_objects
from ..features.conversion import conversions
from ..features.exchange import cad_files
from .conversion import draw_choice, draw_report, draw_spots, draw_task
from .doubts import draw_mending
from .shared import HullPanel, label_wrapped, text_field


class HULL_PT_export(HullPanel, bpy.types.Panel):
    bl_label = "Export"

    def draw(self, context):
        column = self.layout.column(align=True)
        column.operator("hull.export_step", icon="EXPORT")
        column.operator("hull.export_iges", icon="EXPORT")
        column.operator("hull.export_lines", icon="EXPORT")
        column.operator("hull.export_hull", icon="EXPORT")
        column.operator("hull.export_freeship", icon="EXPORT")
        column.operator("hull.export_sections", icon="EXPORT")
        column.operator("hull.export_model", icon="EXPORT")
        column.operator("hull.export_panels", icon="EXPORT")
        column.operator("hull.export_parts", icon="EXPORT")
        column.operator("hull.export_plates", icon="EXPORT")
        problem = cad_files.problem_of(hull_objects.hull_of(context.object))
        if problem is not None:
            box = self.layout.box()
            label_wrapped(box, context, problem.message, icon="ERROR")
            box.operator("hull.select_cad_problem")
            draw_mending(box, problem)


class HULL_PT_patches(HullPanel, bpy.types.Panel):
    """The surface as B-spline patches, and how far they are from it"""

    bl_label = "CAD Patches"
    bl_parent_id = "HULL_PT_export"

    def draw(self, context):
        layout, hull = self.layout, hull_objects.hull_of(context.object)
        draw_choice(layout, hull.hull.export)
        if not draw_task(layout, hull):
            layout.operator("hull.convert", icon="MESH_GRID")
        is_current = draw_report(layout, context, hull)
        outcome, _ = conversions.last_outcome(hull)
        if outcome is None or outcome.converted is None:
            return
        draw_spots(layout, hull)
        row = layout.row(align=True)
        row.active = is_current
        row.operator("hull.copy_report", text="Copy", icon="COPYDOWN")
        row.operator("hull.export_report", text="Save", icon="EXPORT")


class HULL_PT_cad_file(HullPanel, bpy.types.Panel):
    """What STEP and IGES files hold"""

    bl_label = "CAD File"
    bl_parent_id = "HULL_PT_export"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        _draw_file(self.layout, hull_objects.hull_of(context.object), is_step=True)


def _draw_file(layout, hull, is_step):
    settings = hull.hull.export
    column = layout.column(align=True)
    text_field(column, settings, "extent")
    if cad_files.leaves_appendages_out(hull) and appendages.of_hull(hull):
        column.label(text="Closed solids have appendages", icon="INFO")
    column.prop(settings, "unit")
    if is_step:
        column.prop(settings, "schema")
    column = layout.column(align=True)
    column.prop(settings, "with_sections")
    column.prop(settings, "with_features")


class _DialogPanel:
    """Beside the file dialog of STEP and IGES files."""

    bl_space_type = "FILE_BROWSER"
    bl_region_type = "TOOL_PROPS"
    bl_parent_id = "FILE_PT_operator"

    @classmethod
    def poll(cls, context):
        operator = context.space_data.active_operator
        return (
            operator is not None
            and operator.bl_idname in ("HULL_OT_export_step", "HULL_OT_export_iges")
            and hull_objects.hull_of(context.object) is not None
        )


class HULL_PT_dialog_report(_DialogPanel, bpy.types.Panel):
    bl_label = "Patches and Surface"

    def draw(self, context):
        hull = hull_objects.hull_of(context.object)
        draw_task(self.layout, hull)
        draw_report(self.layout, context, hull)


class HULL_PT_dialog_file(_DialogPanel, bpy.types.Panel):
    bl_label = "File"

    def draw(self, context):
        is_step = context.space_data.active_operator.bl_idname == "HULL_OT_export_step"
        _draw_file(self.layout, hull_objects.hull_of(context.object), is_step)


class HULL_PT_dialog_patches(_DialogPanel, bpy.types.Panel):
    bl_label = "Patches"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        draw_choice(self.layout, hull_objects.hull_of(context.object).hull.export)


CLASSES = (
    HULL_PT_export,
    HULL_PT_patches,
    HULL_PT_cad_file,
    HULL_PT_dialog_report,
    HULL_PT_dialog_file,
    HULL_PT_dialog_patches,
)
