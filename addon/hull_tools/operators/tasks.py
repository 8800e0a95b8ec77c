# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators whose work takes seconds: in the window Blender stays at work, and Esc cancels."""

import bpy

from ..bridge.background import jobs
from ..features.conversion import conversions, patches
from .shared import HullReader

_LOOK_SECONDS = 0.1


class TaskOperator(HullReader):
    """Subclasses begin a task of features.conversion.conversions, and tell what came of it:
    begin(hull, scene) → task, and outcome(result of the task, scene) → (text, whether it warns).

    What comes of it is of the scene that it was begun in, and its units: it is taken when that is
    shown. What is run by a script, or without a window, is done when the operator returns; so is
    what Blender repeats, or does again with other settings.
    """

    bl_options = {"REGISTER"}
    _is_in_window = False
    _goes_on = False
    _task = None

    def invoke(self, context, event):
        self._is_in_window = not bpy.app.background
        return self.execute(context)

    def execute(self, context):
        # Blender repeats an operator that it has listed, as the same instance. Were that modal once
        # more, it would be listed twice, which ends Blender.
        self._goes_on, self._is_in_window = self._is_in_window, False
        return super().execute(context)

    def run_on(self, hull, context):
        self._task = self.begin(hull, context.scene)
        if not self._goes_on:
            return self._finish(context)
        manager, self._scene_name = context.window_manager, context.scene.name
        self._timer = manager.event_timer_add(_LOOK_SECONDS, window=context.window)
        manager.progress_begin(0.0, 100.0)
        manager.modal_handler_add(self)
        self._show_progress(context)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            self._task.cancel()
            return {"RUNNING_MODAL"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        is_gone = self._scene_name not in bpy.data.scenes
        if is_gone:
            self._task.cancel()
        if not self._task.is_done() or not (is_gone or context.scene.name == self._scene_name):
            self._show_progress(context)
            return {"PASS_THROUGH"}
        self._leave(context)
        return self.reporting(self._finish, context)

    def cancel(self, context):
        """Blender ends the operator: another file is loaded, or its dialog was left by Esc."""
        if self._task is None:
            return
        self._task.cancel()
        self._leave(context)

    def _finish(self, context):
        try:
            text, warns = self.outcome(self._task.result(), context.scene)
        except jobs.Cancelled:
            self.tell("INFO", f"{self.bl_label}: cancelled, all is as it was")
            return {"CANCELLED"}
        finally:
            conversions.take_finished()
        self.tell("WARNING" if warns else "INFO", text)
        if context.mode == "OBJECT":
            self.show(context)
        return {"FINISHED"}

    def show(self, context):
        """Makes a new object the active one. Not while another one is edited, as somebody may have
        begun to do meanwhile: Blender would go on holding its mesh for being edited."""

    def _show_progress(self, context):
        percent = 100.0 * self._task.share
        context.window_manager.progress_update(percent)
        text = f"{self._task.text}: {percent:.0f} %    Esc: cancel"
        if context.scene.name != self._scene_name:
            text += f'    It ends when the scene "{self._scene_name}" is shown'
        context.workspace.status_text_set(text)

    def _leave(self, context):
        manager = context.window_manager
        manager.event_timer_remove(self._timer)
        manager.progress_end()
        context.workspace.status_text_set(None)


class PatchOperator(TaskOperator):
    """What it makes are patches, and how good they are is told. Subclasses also:
    converted(result of the task) → (its patches.Converted, text before the summary)."""

    def run_on(self, hull, context):
        self._asked = patches.asked_of(hull.hull.export)
        return super().run_on(hull, context)

    def outcome(self, result, scene):
        converted, text = self.converted(result)
        summary, warns = patches.summary(converted, self._asked)
        return text + summary, warns
