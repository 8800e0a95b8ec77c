# SPDX-License-Identifier: GPL-3.0-or-later
"""Enabling and disabling the add-on, again and again, leaves nothing behind."""

import addon_utils
import bpy
import pytest
from addon_under_test import add_hull, module_name

MENUS = ("TOPBAR_MT_file_import", "TOPBAR_MT_file_export")


def traces():
    """All that the add-on adds to Blender, as names and counts."""
    handlers = {
        name: len(getattr(bpy.app.handlers, name))
        for name in dir(bpy.app.handlers)
        if isinstance(getattr(bpy.app.handlers, name), list)
    }
    menus = {
        name: len(getattr(getattr(bpy.types, name).draw, "_draw_funcs", [None])) for name in MENUS
    }
    return {
        "types": {name for name in dir(bpy.types) if name.startswith("HULL_")},
        "groups": {cls.__name__ for cls in bpy.types.PropertyGroup.__subclasses__()},
        "object properties": set(bpy.types.Object.bl_rna.properties.keys()),
        "operators": {name for name in dir(bpy.ops.hull)},
        "handlers": handlers,
        "menus": menus,
    }


@pytest.fixture
def addon():
    name = module_name()
    yield name
    addon_utils.enable(name, default_set=True)


def test_the_addon_is_there():
    found = traces()
    assert {"HULL_OT_make_hull", "HULL_PT_hydrostatics"} <= found["types"]
    assert "hull" in found["object properties"]
    assert found["handlers"]["depsgraph_update_post"] >= 1


def test_enabling_twice_leaves_nothing_behind(addon):
    enabled = traces()
    addon_utils.disable(addon)
    disabled = traces()
    assert not disabled["types"] and not disabled["operators"]
    assert "hull" not in disabled["object properties"]
    assert sum(disabled["handlers"].values()) == sum(enabled["handlers"].values()) - 10
    for _ in range(2):
        assert addon_utils.enable(addon) is not None
        assert traces()["types"] == enabled["types"]
        assert traces()["handlers"] == enabled["handlers"]
        assert traces()["menus"] == enabled["menus"]
        addon_utils.disable(addon)
        assert traces() == disabled


def test_a_hull_survives_the_addon_being_off(addon):
    name = add_hull().name
    addon_utils.disable(addon)
    addon_utils.enable(addon, default_set=True)
    hull = bpy.data.objects[name]
    assert hull.hull.is_hull and hull.hull.surface_object.parent == hull
    assert bpy.ops.hull.update() == {"FINISHED"}
