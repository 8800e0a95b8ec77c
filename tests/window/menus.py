# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's menus by mouse and keys: File › Import and Export, where the add-on's entries are the
last ones, and the Add menu of the view."""

from types import SimpleNamespace

import bpy
from addon_under_test import part

# Of the word File, from the window's upper left corner, in points.
_PLACE_OF_FILE = (46, 13)


def file_menu(window, menu, text):
    """File › Import or Export, and the add-on's entry of a text: by a click on File, the menu's
    first letter, and arrows up from below. To be used by `yield from`."""
    scale = bpy.context.preferences.system.ui_scale
    right, down = (scale * part_of for part_of in _PLACE_OF_FILE)
    window.move_to(right, window.window.height - down)
    yield
    window.click()
    yield
    window.press(menu[0].upper())
    yield
    entries = _entries(menu)
    for _ in entries[entries.index(text) :]:
        window.press("UP_ARROW")
        yield
    window.press("RET")
    yield


def _entries(menu):
    """The texts of the add-on's entries of a menu, from above."""
    noted = []
    layout = SimpleNamespace(
        operator=lambda idname, text="": noted.append(text),
        operator_menu_enum=lambda idname, name, text="": noted.append(text),
    )
    name = {"Import": "import_hull", "Export": "export_hull"}[menu]
    draw = getattr(part(f"operators.{name}"), f"draw_{menu.lower()}_menu")
    draw(SimpleNamespace(layout=layout), bpy.context)
    return noted


# From below in Add › Mesh, where the add-on's menus are the last ones.
_FROM_BELOW = {"hull.add_appendage": 1, "hull.add_hull": 2}


def add_to_scene(window, operator, kind):
    """Shift A over the view, Mesh, Ship Hull or Ship Appendage, and there what it adds: by arrows.
    To be used by `yield from`."""
    module, _, name = operator.partition(".")
    kinds = getattr(getattr(bpy.ops, module), name).get_rna_type().properties["kind"].enum_items
    window.move_to_middle()
    window.press("A", shift=True)
    yield
    window.press("M")
    yield
    steps = ["UP_ARROW"] * _FROM_BELOW[operator] + ["RIGHT_ARROW"]
    for key in [*steps, *["DOWN_ARROW"] * kinds.find(kind), "RET"]:
        window.press(key)
        yield
