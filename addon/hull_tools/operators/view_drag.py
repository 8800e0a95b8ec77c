# SPDX-License-Identifier: GPL-3.0-or-later
"""What operators have in common that follow the mouse in a 3D view until they are done."""

import numpy as np

from ..bridge.blender import units
from ..features.modelling import pull_lines

DONE = ("RET", "NUMPAD_ENTER", "SPACE")
# What goes on to Blender meanwhile: turning and moving the view. Undo and clicks on other objects
# would take the hull away below the mouse.
_OF_THE_VIEW = ("MIDDLEMOUSE", "WHEEL", "NUMPAD", "TRACKPAD", "NDOF", "TIMER", "MOUSEMOVE")


class ViewDrag:
    """Subclasses: begin(context), which may refuse with a ValueError and has changed nothing then;
    modal(); take_back(context), which makes all as it was before; leave(context), which forgets
    what they hold. help_text: of the status bar."""

    help_text = ""

    def invoke(self, context, event):
        if context.region_data is None:
            return self.execute(context)
        return self.reporting(self._begin, context)

    def _begin(self, context):
        self.begin(context)
        self._area, self._view_number = context.area, 0
        context.window.cursor_modal_set("CROSSHAIR")
        context.workspace.status_text_set(self.help_text)
        context.window_manager.modal_handler_add(self)
        self._say(None)
        return {"RUNNING_MODAL"}

    def cancel(self, context):
        """Blender ends the operator, as when another file is loaded."""
        self._give_up(context)

    def _give_up(self, context):
        """What modal() returns once all is as it was before."""
        self.take_back(context)
        self._leave(context)
        return {"CANCELLED"}

    def _leave(self, context):
        self.leave(context)
        context.window.cursor_modal_restore()
        context.workspace.status_text_set(None)
        self._say(None)

    def _say(self, text):
        """Puts a text into the view's header, Blender's own with None; the view is drawn anew, and
        no other one: redraw() has all of them drawn, which is too much for each step of a mouse."""
        self._area.header_text_set(text)
        self._area.tag_redraw()

    def _rest(self, event):
        """What modal() returns for an event that is not the operator's."""
        is_of_view = event.type.startswith(_OF_THE_VIEW)
        return {"PASS_THROUGH"} if is_of_view else {"RUNNING_MODAL"}

    def _windows(self):
        """The area's regions that show the model: four of them in a quad view."""
        return [region for region in self._area.regions if region.type == "WINDOW"]

    def _take_view(self, event):
        """From now on the view is the one below the mouse, or the last one that was."""
        for number, region in enumerate(self._windows()):
            x, y = event.mouse_x - region.x, event.mouse_y - region.y
            if 0 <= x < region.width and 0 <= y < region.height:
                self._view_number = number

    def _region(self):
        return self._windows()[self._view_number]

    def _view(self):
        """Its RegionView3D. Those of a quad view are listed in the order of their regions."""
        space = self._area.spaces.active
        four = space.region_quadviews
        return four[self._view_number] if len(four) else space.region_3d

    def _mouse(self, event):
        """(2,) in the region, pixels."""
        region = self._region()
        return np.array([event.mouse_x - region.x, event.mouse_y - region.y], dtype=np.float64)

    def _eye_on(self, hull, scene):
        """The pull_lines.Eye of the view on a hull."""
        return pull_lines.eye_of(hull, units.metres_per_unit(scene), self._view(), self._region())
