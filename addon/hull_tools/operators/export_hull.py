# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull's drawings and tables for others; and what all its exports have in common."""

import bpy
from bpy.props import StringProperty
from bpy_extras.io_utils import ExportHelper

from ..bridge import exports, hull_objects
from .shared import has_hull, native_is_there, reporting_errors


class ExportHull(ExportHelper):
    @classmethod
    def poll(cls, context):
        return native_is_there(cls) and has_hull(cls, context)

    def invoke(self, context, event):
        if not self.properties.is_property_set("filepath"):
            folder = bpy.path.abspath("//")
            name = bpy.path.clean_name(hull_objects.hull_of(context.object).name)
            self.filepath = bpy.path.ensure_ext(folder + name, self.filename_ext)
        return super().invoke(context, event)


class HULL_OT_export_lines(bpy.types.Operator, ExportHull):
    """Draw body plan, profile and half-breadth plan as SVG, PDF or PNG"""

    bl_idname = "hull.export_lines"
    bl_label = "Export Lines Plan"
    bl_options = {"REGISTER"}

    filename_ext = ".svg"
    check_extension = None
    filter_glob: StringProperty(default="*.svg;*.pdf;*.png", options={"HIDDEN"})

    @reporting_errors
    def execute(self, context):
        hull = hull_objects.hull_of(context.object)
        exports.export_lines_drawing(hull, context.scene, self.filepath)
        self.report({"INFO"}, "Lines plan written")
        return {"FINISHED"}


class HULL_OT_export_hydrostatics(bpy.types.Operator, ExportHull):
    """Write a table of hydrostatics over drafts up to the hull's as CSV"""

    bl_idname = "hull.export_hydrostatics"
    bl_label = "Export Hydrostatics"
    bl_options = {"REGISTER"}

    filename_ext = ".csv"
    filter_glob: StringProperty(default="*.csv", options={"HIDDEN"})

    @reporting_errors
    def execute(self, context):
        hull = hull_objects.hull_of(context.object)
        exports.export_hydrostatics(hull, context.scene, self.filepath)
        self.report({"INFO"}, "Table of hydrostatics written")
        return {"FINISHED"}


def draw_export_menu(self, context):
    layout = self.layout
    layout.operator("hull.export_step", text="Hull surface (.step)")
    layout.operator(HULL_OT_export_lines.bl_idname, text="Hull lines plan (.svg, .pdf, .png)")
    layout.operator(HULL_OT_export_hydrostatics.bl_idname, text="Hull hydrostatics (.csv)")


CLASSES = (HULL_OT_export_lines, HULL_OT_export_hydrostatics)
