# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's window as a person has it: keys, mouse, and where things of the 3D view are in it.

Nothing happens at once: what is pressed and moved is put down in `actions`, and done when the test
yields, one action at a time, with Blender's own handling and drawing after each.
"""

import math

import bpy
from addon_under_test import make_active
from bpy_extras.view3d_utils import location_3d_to_region_2d
from mathutils import Euler, Vector

# The view from off the bow, as the angles of its turn; and those of the numpad.
OFF_THE_BOW = (68.0, 0.0, 48.0)
FROM_PORT, FROM_AHEAD, FROM_ABOVE = (90.0, 0.0, 180.0), (90.0, 0.0, 90.0), (0.0, 0.0, 0.0)

# A drag is one for Blender when it is longer than some pixels: the mouse moves in so many steps.
_DRAG_STEPS = 4
# Of the tab Hull below Item, Tool and View, in points from the sidebar's upper right corner.
_PLACE_OF_TAB = (10, 158)
_KEYS_OF_LETTERS = {
    **dict(zip("0123456789", "ZERO ONE TWO THREE FOUR FIVE SIX SEVEN EIGHT NINE".split())),
    **{letter: letter.upper() for letter in "abcdefghijklmnopqrstuvwxyz"},
    ".": "PERIOD",
    "-": "MINUS",
    "/": "SLASH",
    "*": "NUMPAD_ASTERIX",
    "+": "PLUS",
    "=": "EQUAL",
    " ": "SPACE",
}


class Window:
    """The first window of Blender, whatever file it shows."""

    def __init__(self):
        self.actions = []
        self.cursor = (0, 0)

    @property
    def window(self):
        return bpy.context.window_manager.windows[0]

    # Keys and mouse

    def press(self, key, text="", **modifiers):
        """Presses a key of bpy's names and lets it go, with ctrl, shift or alt held if so said."""
        self._event(key, "PRESS", text, **modifiers)
        self._event(key, "RELEASE", **modifiers)

    def write(self, text):
        """Presses the keys of a text, one after the other."""
        for letter in text:
            self.press(_KEYS_OF_LETTERS[letter.lower()], letter, shift=letter.isupper())

    def move_to(self, x, y):
        """Moves the mouse to a place in the window, in pixels from its lower left."""

        def move():
            self.cursor = (round(x), round(y))
            self._simulate("MOUSEMOVE", "NOTHING")

        self.actions.append(move)

    def move_by(self, right, up):
        """Moves the mouse from where it will be, in some steps."""
        for _ in range(_DRAG_STEPS):
            self.actions.append(lambda: self._step(right / _DRAG_STEPS, up / _DRAG_STEPS))

    def _step(self, right, up):
        self.cursor = (round(self.cursor[0] + right), round(self.cursor[1] + up))
        self._simulate("MOUSEMOVE", "NOTHING")

    def click(self, button="LEFTMOUSE", **modifiers):
        self.press(button, **modifiers)

    def drag(self, right, up, button="LEFTMOUSE", **modifiers):
        """Presses the button, moves the mouse, lets go."""
        self._event(button, "PRESS", **modifiers)
        self.move_by(right, up)
        self._event(button, "RELEASE", **modifiers)

    def hold(self, key, **modifiers):
        """Presses a key and does not let it go: `let_go` does."""
        self._event(key, "PRESS", **modifiers)

    def let_go(self, key, **modifiers):
        self._event(key, "RELEASE", **modifiers)

    def pie(self, key, right, up, **modifiers):
        """Opens a pie menu by its key, and clicks where the mouse comes to."""
        self.press(key, **modifiers)
        self.move_by(right, up)
        self.click()

    def undo(self):
        self.press("Z", ctrl=True)

    def redo(self):
        self.press("Z", ctrl=True, shift=True)

    def search(self, words):
        """Runs what the search of operators (F3) finds first."""
        self.press("F3")
        self.write(words)
        self.press("RET")

    def accept_file(self, path=None):
        """Accepts the file dialog that opens, with the path put in where one is given; by a key.

        `bpy.ops.file.execute` in a context of the dialog's area would close that area, and Blender
        ends where it then reads its freed memory.
        """
        yield
        browser = next(each for each in self.window.screen.areas if each.type == "FILE_BROWSER")
        if path is not None:
            params = browser.spaces.active.params
            params.directory, params.filename = str(path.parent).encode(), path.name
        self.move_to(browser.x + browser.width / 2, browser.y + browser.height / 2)
        self.press("RET")
        yield

    def _event(self, key, value, text="", **modifiers):
        self.actions.append(lambda: self._simulate(key, value, text, **modifiers))

    def _simulate(self, key, value, text="", **modifiers):
        x, y = self.cursor
        extra = {"unicode": text} if text else {}
        self.window.event_simulate(key, value, x=x, y=y, **extra, **modifiers)

    # The 3D view

    @property
    def area(self):
        areas = [area for area in self.window.screen.areas if area.type == "VIEW_3D"]
        return max(areas, key=lambda area: area.width * area.height)

    @property
    def space(self):
        return self.area.spaces.active

    def region(self, kind="WINDOW"):
        return next(region for region in self.area.regions if region.type == kind)

    def in_view(self):
        """The context in which operators work in the 3D view; to be used by `with`."""
        return bpy.context.temp_override(
            window=self.window, area=self.area, region=self.region("WINDOW")
        )

    def look(self, obj, angles_deg=OFF_THE_BOW, is_perspective=False):
        """Shows an object, whole, from an angle, and puts the mouse in the middle of the view."""
        region_3d = self.space.region_3d
        self.space.clip_end = 1000.0 * max(obj.dimensions)
        region_3d.view_rotation = Euler(map(math.radians, angles_deg)).to_quaternion()
        region_3d.view_perspective = "PERSP" if is_perspective else "ORTHO"
        mode = obj.mode
        with self.in_view():
            if mode != "OBJECT":
                bpy.ops.object.mode_set(mode="OBJECT")
            make_active(obj)
            bpy.ops.view3d.view_selected()
            if mode != "OBJECT":
                bpy.ops.object.mode_set(mode=mode)
        self.move_to_middle()

    def move_to_middle(self):
        """Moves the mouse to the middle of the 3D view."""

        def move():
            region = self.region()
            self.cursor = (region.x + region.width // 2, region.y + region.height // 2)
            self._simulate("MOUSEMOVE", "NOTHING")

        self.actions.append(move)

    def move_to_point(self, obj, point):
        """Moves the mouse to a point given in an object's own coordinates, as it is shown then."""
        self._move_when_due(lambda: self.place_of(obj, point))

    def move_to_place(self, place):
        """Moves the mouse to a place in the world, as it is shown then."""
        self._move_when_due(lambda: self._shown_at(Vector(place)))

    def _move_when_due(self, cursor):
        def move():
            self.cursor = cursor()
            self._simulate("MOUSEMOVE", "NOTHING")

        self.actions.append(move)

    def place_of(self, obj, point):
        """Where in the window the 3D view shows a point of an object."""
        return self._shown_at(obj.matrix_world @ point)

    def _shown_at(self, place):
        region = self.region()
        dots = location_3d_to_region_2d(region, self.space.region_3d, place)
        return round(region.x + dots.x), round(region.y + dots.y)

    def open_sidebar(self):
        """Shows the sidebar's tab Hull; some object is active."""
        self.space.show_region_ui = True

        def to_tab():
            region = self.region("UI")
            if bpy.app.version >= (4, 2, 0):
                region.active_panel_category = "Hull"
            scale = bpy.context.preferences.system.ui_scale
            right, down = (scale * part for part in _PLACE_OF_TAB)
            self.cursor = (
                round(region.x + region.width - right),
                round(region.y + region.height - down),
            )
            self._simulate("MOUSEMOVE", "NOTHING")

        self.actions.append(to_tab)
        self.click()
        self.move_to_middle()

    def screenshot(self, path):
        # A file dialog may fill the window.
        with bpy.context.temp_override(window=self.window, area=self.window.screen.areas[0]):
            bpy.ops.screen.screenshot(filepath=str(path))
