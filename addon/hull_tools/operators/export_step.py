# SPDX-License-Identifier: GPL-3.0-or-later
"""STEP export. It takes seconds: in the window Blender stays at work, and Esc cancels."""

from concurrent.futures import ThreadPoolExecutor

import bpy
from bpy.props import StringProperty

from ..bridge import exports, hull_objects
from .export_hull import ExportHull
from .shared import reporting_errors

_LOOK_SECONDS = 0.1


class HULL_OT_export_step(bpy.types.Operator, ExportHull):
    """Write the hull's surface as one shell of B-spline faces in a STEP file"""

    bl_idname = "hull.export_step"
    bl_label = "Export STEP"
    bl_options = {"REGISTER"}

    filename_ext = ".step"
    filter_glob: StringProperty(default="*.step;*.stp", options={"HIDDEN"})

    _is_in_window = False

    def invoke(self, context, event):
        self._is_in_window = True
        return super().invoke(context, event)

    @reporting_errors
    def execute(self, context):
        hull = hull_objects.hull_of(context.object)
        export = exports.StepExport(hull, context.scene, self.filepath)
        if self._is_in_window:
            return self._begin(context, export)
        return self._finish(export.run())

    def _begin(self, context, export):
        self._export = export
        self._pool = ThreadPoolExecutor(1)
        self._patches = self._pool.submit(export.run)
        manager = context.window_manager
        self._timer = manager.event_timer_add(_LOOK_SECONDS, window=context.window)
        context.workspace.status_text_set("Writing the STEP file    Esc: cancel")
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC":
            self.cancel(context)
            self.report({"INFO"}, "Export cancelled: no file was written")
            return {"CANCELLED"}
        if event.type != "TIMER" or not self._patches.done():
            return {"PASS_THROUGH"}
        self._leave(context)
        return self._report_outcome(context)

    @reporting_errors
    def _report_outcome(self, context):
        return self._finish(self._patches.result())

    def cancel(self, context):
        self._export.cancel()
        self._leave(context)

    def _leave(self, context):
        context.window_manager.event_timer_remove(self._timer)
        context.workspace.status_text_set(None)
        self._pool.shutdown(wait=False)

    def _finish(self, patches):
        self.report({"INFO"}, f"STEP written: {patches.patch_count} patches")
        return {"FINISHED"}


CLASSES = (HULL_OT_export_step,)
