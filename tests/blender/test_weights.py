# SPDX-License-Identifier: GPL-3.0-or-later
"""Weights: the shell's plating by layers, a list, and both in load cases; kept in files, copies and
undo. The box is 10 × 4 × 3 m, open above: sides and ends 84 m², bottom 40 m²."""

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, hull_io, part, sample
from test_panels import Drawn, context

SIDE, BOTTOM, END = 30.0, 40.0, 12.0
AREA = 2 * SIDE + BOTTOM + 2 * END
VCG = (2 * SIDE + 2 * END) * 1.5 / AREA


def result_of(hull, name="weights"):
    return part("features.analyses").result_of(hull, bpy.context.scene, name)


@pytest.fixture
def box():
    hull = add_hull()
    hull.hull.draft = 2.0
    hull.hull.length_pp = 10.0
    return hull


def test_the_shell_of_a_box(box):
    weights = box.hull.weights
    weights.thickness, weights.density = 0.01, 7.85
    (shell,) = result_of(box).parts
    assert shell.area == pytest.approx(AREA, rel=1e-10)
    assert shell.mass_t == pytest.approx(AREA * 0.0785, rel=1e-10)
    np.testing.assert_allclose(shell.centre, (5.0, 0.0, VCG), rtol=1e-10, atol=1e-12)


def test_without_thickness_the_shell_has_no_weight(box):
    assert result_of(box).parts == () and result_of(box).total.mass_t == 0.0


def layered(box):
    """The bottom in a layer of its own, of aluminium twice as thick."""
    for name in ("Side", "Bottom"):
        material = bpy.data.materials.new(name)
        box.data.materials.append(material)
        entry = box.hull.layers.add()
        entry.name, entry.material = name, material
    box.data.polygons[1].material_index = 1
    box.hull.weights.thickness = 0.01
    bottom = box.hull.layers[1]
    bottom.thickness, bottom.density = 0.02, 2.7
    return bottom


@pytest.mark.parametrize("system", ["METRIC", "IMPERIAL"])
def test_freeship_files_keep_the_weight(box, tmp_path, system):
    """The plating of the shell, and that of a layer, are both of layers there: she weighs the
    same."""
    layered(box)
    bpy.context.scene.unit_settings.system = system
    before = result_of(box).total
    assert bpy.ops.hull.export_freeship(filepath=str(tmp_path / "box.fbm")) == {"FINISHED"}
    assert bpy.ops.hull.import_hull(filepath=str(tmp_path / "box.fbm")) == {"FINISHED"}
    again = result_of(bpy.context.object)
    assert len(again.parts) == 2 and bpy.context.object is not box
    assert again.total.mass_t == pytest.approx(before.mass_t, rel=3e-6) and before.mass_t > 6.0
    np.testing.assert_allclose(again.total.centre, before.centre, rtol=3e-6, atol=1e-9)


def test_layers_have_plating_of_their_own(box):
    layered(box)
    bottom, rest = result_of(box).parts
    assert (bottom.name, rest.name) == ("Bottom", "Shell")
    assert bottom.mass_t == pytest.approx(BOTTOM * 0.02 * 2.7, rel=1e-9)
    assert rest.mass_t == pytest.approx((AREA - BOTTOM) * 0.01 * 7.85, rel=1e-9)
    np.testing.assert_allclose(bottom.centre, (5.0, 0.0, 0.0), atol=1e-9)
    np.testing.assert_allclose(rest.centre, (5.0, 0.0, 1.5), atol=1e-9)


def test_a_layer_set_aside_is_no_shell(box):
    layered(box)
    box.hull.layers[1].in_hydrostatics = False
    (rest,) = result_of(box).parts
    assert rest.area == pytest.approx(AREA - BOTTOM, rel=1e-9)


def test_the_list_and_the_sum(box):
    box.hull.weights.thickness = 0.01
    assert bpy.ops.hull.add_weight() == {"FINISHED"}
    (item,) = box.hull.weights.items
    item.name, item.mass_t, item.lcg, item.tcg, item.vcg = "Engine", 5.0, 2.0, 0.1, 1.0
    total, shell = result_of(box).total, AREA * 0.0785
    mass = shell + 5.0
    assert total.mass_t == pytest.approx(mass, rel=1e-7)
    wanted = [(shell * 5.0 + 5.0 * 2.0) / mass, 0.5 / mass, (shell * VCG + 5.0) / mass]
    np.testing.assert_allclose(total.centre, wanted, rtol=1e-6)
    module = part("features.stability.weights")
    rows = list(module.rows(result_of(box)))
    assert [row[0] for row in rows] == ["Shell", "Engine", "Ship"]
    assert len(module.header(None)) == len(rows[0])
    assert bpy.ops.hull.remove_weight() == {"FINISHED"} and not box.hull.weights.items


def test_load_cases_have_the_ships_weights(box):
    """The box floats at the draft of both masses: 41 t a metre."""
    box.hull.weights.thickness, shell = 0.01, AREA * 0.0785
    bpy.ops.hull.add_load_case()
    case = box.hull.loading.load_cases[0]
    case.mass_t, case.lcg, case.tcg, case.vcg, case.with_weights = 41.0, 5.0, 0.0, 0.2, True
    (found,) = result_of(box, "load_cases")
    assert found.case.mass_t == pytest.approx(41.0 + shell, rel=1e-7)
    assert found.case.centre[2] == pytest.approx(
        (41.0 * 0.2 + shell * VCG) / (41.0 + shell), rel=1e-6
    )
    assert found.draft_mean == pytest.approx((41.0 + shell) / 41.0, rel=1e-6)
    box.hull.weights.thickness = 0.02
    (found,) = result_of(box, "load_cases")
    assert found.draft_mean == pytest.approx((41.0 + 2 * shell) / 41.0, rel=1e-6)
    case.with_weights = False
    (found,) = result_of(box, "load_cases")
    assert found.draft_mean == pytest.approx(1.0, rel=1e-6)


def test_hull_files_and_copies_keep_them(box, tmp_path):
    layered(box)
    bpy.ops.hull.add_weight()
    box.hull.weights.items[0].mass_t = 3.0
    bpy.ops.hull.add_load_case()
    box.hull.loading.load_cases[0].with_weights = True
    path = str(tmp_path / "box.hull.json")
    bpy.ops.hull.export_hull(filepath=path)
    data = hull_io().read_hull(path)
    assert data.layers[1].thickness == pytest.approx(0.02)
    assert data.load_cases[0].with_weights and data.weights.items[0].mass_t == 3.0
    wanted = result_of(box)
    bpy.ops.hull.import_hull(filepath=path)
    again = bpy.context.object
    assert again is not box
    assert result_of(again).total.mass_t == pytest.approx(wanted.total.mass_t, rel=1e-9)
    bpy.ops.object.duplicate()
    copy = bpy.context.object
    assert copy is not again
    assert result_of(copy).total.mass_t == pytest.approx(wanted.total.mass_t, rel=1e-9)


def test_scaling_takes_the_list_along(box):
    bpy.ops.hull.add_weight()
    item = box.hull.weights.items[0]
    item.mass_t, item.lcg = 2.0, 4.0
    box.hull.weights.thickness = 0.01
    following = part("features.dimensions.following")
    scale = hull_io("scaling").Scale((2.0, 1.0, 1.0))
    following.follow(box, scale, scale)
    assert (item.mass_t, item.lcg) == (4.0, 8.0)
    assert box.hull.weights.thickness == pytest.approx(0.01)


def test_thickness_that_no_ship_has_is_told(box):
    box.hull.weights.thickness = 11.0
    with pytest.raises(ValueError, match="Shell: thickness in m"):
        result_of(box)


def test_the_panel_shows_the_sum():
    hull = sample("coaster")
    hull.hull.weights.thickness = 0.01
    part("features.analyses").outcome_of(hull, bpy.context.scene, "weights")
    drawn = Drawn(part("panels.weights").HULL_PT_weights)
    drawn.draw(context())


def test_wind_area_of_a_barge_is_its_freeboard(box):
    """10 m by 1 m above the water, its centre half a metre up; below it 10 m by 2 m."""
    box.hull.wind.source = "HULL"
    box.hull.loading.kg = 1.0
    weather = result_of(box, "criteria").weather
    assert weather.wind_area == pytest.approx(10.0, rel=1e-9)
    assert weather.wind_lever == pytest.approx(2.5 - 1.0, rel=1e-9)


def test_entered_wind_areas_count_in_a_load_cases_weather_criterion(box):
    """The case floats at 1 m: 20 m² of freeboard, and a house of 12 m² with its centre at 4 m."""
    bpy.ops.hull.add_load_case()
    loading = box.hull.loading
    case = loading.load_cases[0]
    case.name, case.mass_t, case.lcg, case.tcg, case.vcg = "light", 41.0, 5.0, 0.0, 1.0
    loading.loaded, loading.loaded_case = "CASE", "light"
    box.hull.wind.source = "HULL"
    alone = result_of(box, "criteria").weather
    assert alone.wind_area == pytest.approx(20.0, rel=1e-6)
    assert bpy.ops.hull.add_wind_area() == {"FINISHED"}
    house = box.hull.wind.areas[0]
    house.area, house.z = 12.0, 4.0
    weather = result_of(box, "criteria").weather
    assert weather.wind_area == pytest.approx(32.0, rel=1e-6)
    centre = (20.0 * 2.0 + 12.0 * 4.0) / 32.0
    assert weather.wind_lever == pytest.approx(centre - 0.5, rel=1e-6)
    share = weather.wind_area * weather.wind_lever / (alone.wind_area * alone.wind_lever)
    assert weather.steady_lever == pytest.approx(share * alone.steady_lever, rel=1e-6)
