# SPDX-License-Identifier: GPL-3.0-or-later
"""Enabling and disabling the add-on, again and again, leaves nothing behind."""

from types import SimpleNamespace

import addon_utils
import bpy
import pytest
from addon_under_test import add_hull, mesh_points, module_name, part, state_of

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
    assert sum(disabled["handlers"].values()) == sum(enabled["handlers"].values()) - 15
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


def test_hulls_that_are_open_when_the_addon_is_enabled_are_shown(addon, monkeypatch):
    name = add_hull().name
    addon_utils.disable(addon)
    bpy.data.objects[name].data.vertices[0].co.x -= 1.0
    # As with a window: without one no timer runs, and none is begun.
    app = SimpleNamespace(background=False, timers=bpy.app.timers, handlers=bpy.app.handlers)
    for name_of_module in ("bridge.background.timers", "handlers"):
        monkeypatch.setattr(part(name_of_module), "bpy", SimpleNamespace(app=app))
    addon_utils.enable(addon, default_set=True)
    beginning = part("handlers")._beginning()
    assert beginning.is_running()
    assert state_of(bpy.data.objects[name]) is None
    beginning._called()  # the window's event loop calls it
    beginning.stop()
    hull = bpy.data.objects[name]
    assert state_of(hull).ship.surface is not None
    assert mesh_points(hull.hull.surface_object)[:, 0].min() == -1.0


def test_every_operator_that_changes_the_hull_is_undone():
    changing = part("operators.shared").HullOperator
    faults = [
        cls.__name__
        for cls in bpy.types.Operator.__subclasses__()
        if issubclass(cls, changing) and not {"REGISTER", "UNDO"} <= set(cls.bl_options)
    ]
    assert not faults


def test_it_is_disabled_where_another_addon_has_cleared_handlers(addon):
    bpy.app.handlers.undo_post.clear()
    addon_utils.disable(addon)
    assert not traces()["types"]
    assert addon_utils.enable(addon) is not None
