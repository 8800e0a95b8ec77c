# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull from the Add menu, and its dimensions in the panel of the last operation."""

import bpy
from addon_under_test import part
from editing import hull_at_hand
from expect import assert_follows, edited_points
from mathutils import Vector

# From the mouse when the panel opens to its fields.
TO_TYPE, TO_LENGTH, TO_BEAM, TO_SECTIONS = (210, -35), (210, -58), (210, -79), (210, -144)
TO_USE_BLOCK, TO_BLOCK = (131, -146), (210, -146)
# From the field of the type to the first of the types below it.
TO_FIRST_TYPE = (-40, -23)


def new_hull(window, words):
    window.move_to_middle()
    window.search(words)


def type_in_panel(window, place, text):
    """Opens the panel of the last operation, types into one of its fields, and leaves it."""
    window.move_to_middle()
    window.press("F9")
    yield
    window.move_by(*place)
    window.click()
    yield
    window.press("A", ctrl=True)
    window.write(text)
    window.press("RET")
    yield
    window.move_by(0, 400)
    yield


def block_of(hull):
    found, _ = part("features.transformation.form_parameters").of_hull(hull, bpy.context.scene)
    return found.block


def the_hull():
    (hull,) = [obj for obj in bpy.data.objects if obj.hull.is_hull]
    assert hull == hull_at_hand() and len(bpy.data.meshes) == 2
    return hull


def test_panel_changes_the_hull(window):
    new_hull(window, "round bilge")
    yield
    sections = len(edited_points(the_hull()))
    yield from type_in_panel(window, TO_BEAM, "15")
    assert edited_points(the_hull())[:, 1].max() == 7.5
    yield from type_in_panel(window, TO_SECTIONS, "14")
    assert len(edited_points(the_hull())) == sections + 8
    assert edited_points(the_hull())[:, 1].max() == 7.5
    assert_follows(the_hull())
    window.undo()
    yield
    assert not [obj for obj in bpy.data.objects if obj.hull.is_hull]
    window.redo()
    yield
    assert edited_points(the_hull())[:, 1].max() == 7.5


def test_another_type_comes_with_its_dimensions(window):
    new_hull(window, "round bilge")
    yield
    yield from type_in_panel(window, TO_LENGTH, "95")
    assert the_hull().hull.length_pp == 95.0
    window.move_to_middle()
    window.press("F9")
    yield
    window.move_by(*TO_TYPE)
    window.click()
    yield
    window.move_by(*TO_FIRST_TYPE)
    window.click()
    yield
    assert the_hull().name == "Barge" and the_hull().hull.length_pp == 60.0


def test_a_type_ship_gets_the_block_coefficient_that_is_wanted(window):
    new_hull(window, "research vessel")
    yield
    before = block_of(the_hull())
    yield from type_in_panel(window, TO_BLOCK, "0.66")
    assert block_of(the_hull()) == before
    window.move_to_middle()
    window.press("F9")
    yield
    window.move_by(*TO_USE_BLOCK)
    window.click()
    yield
    assert abs(block_of(the_hull()) - 0.66) < 1e-6 < abs(before - 0.66)
    assert_follows(the_hull())


def test_refused_dimensions_keep_the_last_hull(window):
    new_hull(window, "barge")
    yield
    before = edited_points(the_hull()).copy()
    yield from type_in_panel(window, TO_BEAM, "0")
    assert (edited_points(the_hull()) == before).all()


def test_all_of_the_new_hull_is_in_view(window):
    new_hull(window, "sailing yacht")
    yield
    region = window.region()
    for corner in the_hull().bound_box:
        x, y = window.place_of(the_hull(), Vector(corner))
        assert region.x <= x <= region.x + region.width
        assert region.y <= y <= region.y + region.height


def test_a_new_hull_is_seen_in_local_view(window):
    new_hull(window, "barge")
    yield
    window.press("NUMPAD_SLASH")
    yield
    assert window.space.local_view is not None
    new_hull(window, "sailing yacht")
    yield
    hull = hull_at_hand()
    assert hull.name.startswith("Canoe") and hull.select_get()
    depsgraph = bpy.context.evaluated_depsgraph_get()
    for shown in (hull, hull.hull.surface_object):
        # Of objects themselves Blender does not keep it.
        assert shown.evaluated_get(depsgraph).local_view_get(window.space)
