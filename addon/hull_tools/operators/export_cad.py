# SPDX-License-Identifier: GPL-3.0-or-later
"""STEP and IGES files. While the file dialog is open the hull is converted, and its side says how
far the patches are from the surface before anything is written."""

import bpy
from bpy.props import StringProperty

from ..bridge.mesh import selection
from ..bridge.objects import hull_objects
from ..features.conversion import conversions
from ..features.exchange import cad_files
from .export_hull import ExportHull
from .shared import HullOperator, enter_edit_mode
from .tasks import PatchOperator


class ExportCad(PatchOperator, ExportHull):
    """Subclasses give the file_format."""

    def invoke(self, context, event):
        hull = hull_objects.hull_of(context.object)
        self._begun_before = conversions.running(hull)
        conversions.request(hull)
        self._is_in_window = not bpy.app.background
        return ExportHull.invoke(self, context, event)

    def cancel(self, context):
        if self._task is not None:
            PatchOperator.cancel(self, context)
            return
        # The dialog was closed: what began with it ends with it.
        hull = hull_objects.hull_of(context.object)
        task = None if hull is None else conversions.running(hull)
        if task is not None and task is not self._begun_before:
            task.cancel()

    def draw(self, context):
        pass  # panels of the file dialog do

    def begin(self, hull, scene):
        return cad_files.Export(hull, scene, self.filepath, self.file_format)

    def outcome(self, written, scene):
        text, warns = super().outcome(written, scene)
        warnings = [f"Warning: {one}" for one in written.report["warnings"]]
        return ". ".join([text, *warnings]), warns or bool(warnings)

    def converted(self, written):
        without = " without appendages, which are in closed solids only"
        said = without if written.without_appendages else ""
        return written.converted, f"{self.file_format} written{said}: "


class HULL_OT_export_step(bpy.types.Operator, ExportCad):
    """Write the surface as one shell or solid of B-spline faces in a STEP file"""

    bl_idname = "hull.export_step"
    bl_label = "Export STEP"

    file_format = "STEP"
    filename_ext = ".step"
    filter_glob: StringProperty(default="*.step;*.stp", options={"HIDDEN"})


class HULL_OT_export_iges(bpy.types.Operator, ExportCad):
    """Write the surface as one shell or solid of B-spline faces in an IGES file"""

    bl_idname = "hull.export_iges"
    bl_label = "Export IGES"

    file_format = "IGES"
    filename_ext = ".igs"
    filter_glob: StringProperty(default="*.igs;*.iges", options={"HIDDEN"})


class HULL_OT_select_cad_problem(bpy.types.Operator, HullOperator):
    """Select the face or the points of the control mesh because of which no file was written"""

    bl_idname = "hull.select_cad_problem"
    bl_label = "Select"

    def run_on(self, hull, context):
        problem = cad_files.problem_of(hull)
        if problem is None:
            raise ValueError("This problem is no longer there: the hull was changed, or written")
        enter_edit_mode(context, hull)
        if problem.elements:
            selection.select(context, hull, problem.kind, problem.elements, reveal=True)
        self.tell("INFO", problem.message)


CLASSES = (HULL_OT_export_step, HULL_OT_export_iges, HULL_OT_select_cad_problem)
