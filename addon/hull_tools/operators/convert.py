# SPDX-License-Identifier: GPL-3.0-or-later
"""Conversion to patches, and its report: where they are worst, as text, in files."""

import bpy
from bpy.props import EnumProperty, StringProperty

from ..bridge.blender import redraw
from ..bridge.objects import hull_objects
from ..features.conversion import conversions, worst_spots
from ..features.exchange import exports
from .export_hull import ExportHull
from .shared import HullReader
from .tasks import PatchOperator


class HULL_OT_convert(bpy.types.Operator, PatchOperator):
    """Convert the surface to B-spline patches and measure how far they are from it. No file is
    written; files are made of these patches until the hull or the settings change"""

    bl_idname = "hull.convert"
    bl_label = "Convert"

    def begin(self, hull, scene):
        return conversions.begin(hull, scene)

    def converted(self, converted):
        return converted, ""


def _task_runs(cls, context):
    hull = hull_objects.hull_of(context.object)
    return hull is not None and conversions.running(hull) is not None


class HULL_OT_cancel_task(bpy.types.Operator, HullReader):
    """Cancel what is under way: conversion or file. All stays as it was"""

    bl_idname = "hull.cancel_task"
    bl_label = "Cancel"
    bl_options = {"REGISTER"}

    needs = (_task_runs,)

    def run_on(self, hull, context):
        conversions.running(hull).cancel()


def _spot_items():
    spots = ((kind, name, text) for kind, (name, text) in worst_spots.KINDS.items())
    return (*spots, ("NONE", "None", "Take the mark away"))


class HULL_OT_show_worst_spot(bpy.types.Operator, HullReader):
    """Mark where the patches are worst, set the 3D cursor there and bring it into view"""

    bl_idname = "hull.show_worst_spot"
    bl_label = "Show Worst Spot"

    kind: EnumProperty(name="Worst", description="What is worst there", items=_spot_items())

    def run_on(self, hull, context):
        kind = "" if self.kind == "NONE" else self.kind
        worst_spots.show(hull, context.scene, kind)
        if kind and context.region_data is not None:
            worst_spots.look_at(hull, context.scene, context.region_data)
        redraw.redraw()


class HULL_OT_copy_report(bpy.types.Operator, HullReader):
    """Copy the report of the conversion as text"""

    bl_idname = "hull.copy_report"
    bl_label = "Copy Report"
    bl_options = {"REGISTER"}

    def run_on(self, hull, context):
        context.window_manager.clipboard = conversions.report_of(hull).text()
        self.tell("INFO", "Report copied")


class HULL_OT_export_report(bpy.types.Operator, ExportHull):
    """Write the report of the conversion as text, or as JSON if the file's name ends so"""

    bl_idname = "hull.export_report"
    bl_label = "Save Report"

    filename_ext = ".txt"
    check_extension = None
    filter_glob: StringProperty(default="*.txt;*.json", options={"HIDDEN"})

    def name_part(self):
        return "-patches"

    def write(self, hull, scene):
        exports.export_report(hull, self.filepath)
        return "Report written"


CLASSES = (
    HULL_OT_convert,
    HULL_OT_cancel_task,
    HULL_OT_show_worst_spot,
    HULL_OT_copy_report,
    HULL_OT_export_report,
)
