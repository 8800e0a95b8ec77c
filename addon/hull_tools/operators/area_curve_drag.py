# SPDX-License-Identifier: GPL-3.0-or-later
"""The target area curve dragged by its handles in the plot over the view."""

import bpy
from bpy.props import BoolProperty, StringProperty

from ..bridge import limits
from ..bridge.objects import hull_objects
from ..features.area_curves import handles, sources, stored
from .shared import HullOperator
from .view_drag import DONE, ViewDrag

_HELP = (
    "Drag: a handle   Shift: its area alone   Ctrl click: add a handle   X: remove one   "
    "Enter: done   Esc: cancel"
)
_USUAL_HANDLES = 11


class HULL_OT_drag_area_curve(bpy.types.Operator, ViewDrag, HullOperator):
    """Drag the target's handles in the plot of sectional areas over the view. Without a target the
    present curve is taken first"""

    bl_idname = "hull.drag_area_curve"
    bl_label = "Drag Handles"

    help_text = _HELP

    points: StringProperty(
        name="Points",
        description="x in Blender's units and area in m² of each handle, with semicolons between: "
        "0 0; 40 70; 80 0",
        options={"SKIP_SAVE"},
    )
    takes_present: BoolProperty(
        name="Of the present curve",
        description="Without a target the points move the present curve, which is taken first",
        options={"HIDDEN", "SKIP_SAVE"},
    )

    def run_on(self, hull, context):
        is_new = self.takes_present and not stored.is_there(hull)
        if is_new:  # as it was when the handles were dragged, which Blender does again here
            sources.take_present(hull, context.scene, _USUAL_HANDLES)
        try:
            handles.write_text(hull, self.points)
        except ValueError:
            if is_new:
                stored.clear(hull)
            raise
        if is_new:
            hull.hull.plots.sectional_areas = True

    def begin(self, context):
        hull = hull_objects.hull_of(context.object)
        self._is_new = not stored.is_there(hull)
        if self._is_new:
            sources.take_present(hull, context.scene, _USUAL_HANDLES)
        self._drag = handles.Drag(hull, context.scene)
        self._held = handles.held(hull)

    def modal(self, context, event):
        if event.type in ("ESC", "RIGHTMOUSE") and event.value == "PRESS":
            return self._give_up(context)
        if event.type in DONE and event.value == "PRESS":
            self._drag.set_frame(None)
            self.points = handles.text_of(self._drag.obj)
            self.takes_present = self._is_new
            has_changed = self._is_new or self._drag.has_changed
            self._leave(context)
            return {"FINISHED"} if has_changed else {"CANCELLED"}
        if not self._held.is_dragged:
            self._take_view(event)
        shown = handles.diagram(self._drag.obj, context.scene, self._area, self._region())
        if shown is not None and self._work(context, event, shown):
            return {"RUNNING_MODAL"}
        return self._rest(event)

    def take_back(self, context):
        self._drag.cancel()
        if self._is_new:
            stored.clear(self._drag.obj)

    def _work(self, context, event, shown):
        """Whether the event was one for the plot."""
        mouse = self._mouse(event)
        if event.type == "MOUSEMOVE":
            if self._held.is_dragged:
                self._move(shown, mouse, event.shift)
            else:
                self._look(context, shown, mouse)
        elif event.type == "LEFTMOUSE" and event.value == "RELEASE" and self._held.is_dragged:
            self._held.is_dragged = False
            self._drag.set_frame(None)
        elif event.type == "LEFTMOUSE" and event.value == "PRESS" and shown.has(mouse):
            self._look(context, shown, mouse)
            if event.ctrl and self._held.index is None:
                self._add(context, shown, mouse)
            if self._held.index is not None:
                self._held.is_dragged = True
                self._drag.set_frame(shown.frame)
        elif event.type in ("X", "DEL") and event.value == "PRESS":
            self._remove(context)
        elif not self._held.is_dragged:
            return False
        self._tell(context)
        return self._held.is_dragged or shown.has(mouse)

    def _look(self, context, shown, mouse):
        reach = handles.NEAR * context.preferences.system.ui_scale
        points = handles.points_of(self._drag.obj, self._drag.scene)
        self._held.index = handles.nearest(shown, points, mouse, reach)

    def _move(self, shown, mouse, is_upright):
        x, area = shown.point(mouse)
        index = self._held.index
        if is_upright:
            x = handles.points_of(self._drag.obj, self._drag.scene)[index, 0]
        self._drag.move(index, (x, area))

    def _add(self, context, shown, mouse):
        count = len(self._drag.obj.hull.area_target.area_points)
        if count < limits.MOST_AREA_HANDLES:
            self._held.index = handles.add_handle(
                self._drag.obj, context.scene, float(shown.point(mouse)[0])
            )

    def _remove(self, context):
        if self._held.index is None:
            return
        try:
            handles.remove_handle(self._drag.obj, self._held.index)
        except ValueError as error:
            self.tell("WARNING", str(error))
        else:
            self._held.index, self._held.is_dragged = None, False

    def _tell(self, context):
        obj, index, scene = self._drag.obj, self._held.index, context.scene
        text = ""
        if index is not None:
            point = handles.points_of(obj, scene)[index]
            text = handles.words(point, scene, handles.present_area(obj, scene, point[0]))
        self._held.text = text
        self._say(text or _HELP)

    def leave(self, context):
        self._held.index, self._held.is_dragged, self._held.text = None, False, ""


CLASSES = (HULL_OT_drag_area_curve,)
