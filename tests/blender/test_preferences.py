# SPDX-License-Identifier: GPL-3.0-or-later
"""What is chosen in the add-on's preferences: hulls made later have it, drawing reads it."""

import bpy
import pytest
from addon_under_test import DEPTH, add_hull, module_name, part


@pytest.fixture
def chosen():
    chosen = bpy.context.preferences.addons[module_name()].preferences
    yield chosen
    for name in chosen.bl_rna.properties.keys():
        chosen.property_unset(name)


def test_all_has_its_default(chosen):
    preferences = part("bridge.blender.preferences")
    for name, value in preferences.DEFAULTS.items():
        assert preferences.value(name) == pytest.approx(value), name
    for group, (_, inks) in part("bridge.blender.palette").GROUPS.items():
        on_light, on_dark = (preferences.colours(group, light) for light in (True, False))
        for kind, ink in inks.items():
            assert on_light[kind] == pytest.approx(ink.on_light)
            assert on_dark[kind] == pytest.approx(ink.on_dark or ink.on_light)


def test_new_hulls_get_what_is_chosen(chosen):
    old = add_hull("old")
    chosen.samples, chosen.station_count, chosen.line_width = 7, 12, 2.5
    chosen.water_density, chosen.waterline_count, chosen.buttock_count = 1.0, 3, 0
    new = add_hull("new").hull
    assert (new.samples, new.lines.station_count, new.lines.width) == (7, 12, 2.5)
    assert new.water_density == 1.0
    assert new.lines.waterline_spacing == pytest.approx(DEPTH / 3)
    assert new.lines.buttock_spacing == 0.0
    assert (old.hull.samples, old.hull.lines.station_count, old.hull.lines.width) == (4, 20, 1.5)
    assert old.hull.water_density == pytest.approx(1.025)


def test_files_go_before_preferences(chosen, tmp_path):
    add_hull().hull.lines.station_count = 8
    path = str(tmp_path / "box.hull.json")
    assert bpy.ops.hull.export_hull(filepath=path) == {"FINISHED"}
    chosen.station_count, chosen.water_density = 30, 1.01
    assert bpy.ops.hull.import_hull(filepath=path) == {"FINISHED"}
    settings = bpy.context.object.hull
    assert settings.lines.station_count == 8
    assert settings.water_density == pytest.approx(1.025)


def test_colours_are_drawn_as_they_are_chosen(chosen, monkeypatch):
    preferences = part("bridge.blender.preferences")
    drawn = []
    monkeypatch.setattr(part("bridge.blender.redraw"), "redraw", lambda *kinds: drawn.append(kinds))
    chosen.lines_station_on_light = (1.0, 0.5, 0.25)
    assert drawn == [()]
    assert preferences.colour("lines", "station", True) == pytest.approx((1.0, 0.5, 0.25))
    assert preferences.colour("lines", "station", False) == pytest.approx((0.96, 0.96, 0.96))


def test_the_addon_works_without_an_entry_in_the_preferences(monkeypatch):
    preferences = part("bridge.blender.preferences")
    monkeypatch.setattr(preferences, "ADDON", "no such add-on")
    assert preferences.value("samples") == 4
    assert preferences.colour("lines", "draft", False) == (0.30, 0.84, 1.00)
    assert preferences.colour("combs", "station", False) == (0.85, 0.20, 0.58)
    assert add_hull().hull.samples == 4


def test_new_hulls_lie_in_the_sea_of_the_core():
    default = part("bridge.blender.preferences").DEFAULTS["water_density"]
    assert default == part("bridge.native").require().SEA_WATER_DENSITY
