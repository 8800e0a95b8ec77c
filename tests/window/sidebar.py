# SPDX-License-Identifier: GPL-3.0-or-later
"""Buttons and fields of the sidebar, found as a person finds them: by moving the mouse over them.

Blender tells nobody where they are; but what is under the mouse it copies, a button as its operator
and a field as the path of its value.
"""

import bpy
from addon_under_test import part

# A button is some twenty dots high.
_STEP = 12
# Where along a row the mouse goes down: fields, and the buttons beside a list.
ROWS, BESIDE_LIST = 0.25, 0.786


def hull_panels():
    """The classes of all panels of the tab, those of all parts included."""
    classes = part("panels")._CLASSES
    return [cls for cls in classes if getattr(cls, "bl_category", "") == "Hull"]


def show_panels(window, *names):
    """Leaves these panels of the tab alone in it, unfolded: HULL_PT_... without the beginning."""
    classes = hull_panels()
    for cls in reversed(classes):
        if cls.is_registered:
            bpy.utils.unregister_class(cls)
    for cls in classes:
        if cls.__name__.removeprefix("HULL_PT_") in names:
            options, cls.bl_options = getattr(cls, "bl_options", set()), set()
            bpy.utils.register_class(cls)
            cls.bl_options = options
    window.area.tag_redraw()


def show_all_panels():
    for cls in reversed(hull_panels()):
        if cls.is_registered:
            bpy.utils.unregister_class(cls)
    for cls in hull_panels():
        bpy.utils.register_class(cls)


def put_back_panels():
    """Registers what show_panels has left out, for who disables the add-on."""
    if not all(cls.is_registered for cls in hull_panels()):
        show_all_panels()


def to(window, what, across=ROWS, begin=0):
    """Moves the mouse down the sidebar until it is over a button, by its operator's name
    ("hull.solve_targets"), or over a field, by its property's ("draft"). To be used by
    `yield from`."""
    region, passed = window.region("UI"), []
    for down in range(begin + _STEP // 2, region.height, _STEP):
        window.move_to(region.x + across * region.width, region.y + region.height - down)
        yield
        passed.append(_under_mouse(window, region))
        if passed[-1] == what:
            return
    raise LookupError(f"no {what} in the sidebar, only {passed}")


def press(window, what, across=ROWS, **modifiers):
    """Clicks a button of the sidebar."""
    yield from to(window, what, across)
    window.click(**modifiers)
    yield


def type_in(window, what, text):
    """Types into a field of the sidebar, in place of what it has."""
    yield from to(window, what)
    window.press("RET")
    window.press("A", ctrl=True)
    window.write(text)
    window.press("RET")
    yield


def type_in_dialog(window, *places_and_texts, keys=("RET",)):
    """Types into fields of the dialog that has just opened, their places told from the mouse, and
    accepts it; keys: what is pressed to end it, and at once after that."""
    yield
    for (right, up), text in places_and_texts:
        window.move_by(right, up)
        window.click()
        yield
        window.press("A", ctrl=True)
        window.write(text)
        window.press("RET")
        window.move_by(-right, -up)
        yield
    for key in keys:
        window.press(key)
    yield


def choose(window, what, is_chosen):
    """Turns the wheel over a choice until is_chosen()."""
    yield from to(window, what, across=0.7)
    for _ in range(60):
        if is_chosen():
            return
        window.hold("WHEELDOWNMOUSE", ctrl=True)  # a wheel is not let go: that were another turn
        yield
    raise LookupError(f"{what} has no such choice")


def _under_mouse(window, region):
    """The operator's name or the property's of what the mouse is over, "" for none."""
    manager, copy = bpy.context.window_manager, bpy.ops.ui
    with bpy.context.temp_override(window=window.window, area=window.area, region=region):
        if copy.copy_python_command_button.poll():
            copy.copy_python_command_button()
            return manager.clipboard.removeprefix("bpy.ops.").partition("(")[0]
        if copy.copy_data_path_button.poll():
            copy.copy_data_path_button()
            return manager.clipboard.rpartition(".")[2]
    return ""
