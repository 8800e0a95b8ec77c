# SPDX-License-Identifier: GPL-3.0-or-later
"""What is loaded in Stability: what is typed, the weights, or a load case; all analyses go by it,
and every load case has its levers and criteria. The box is 10 × 4 × 3 m."""

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, part
from test_panels import Drawn, context

DENSITY = 1.025
SHELL = 124.0 * 0.0785 * 2.0  # t of 20 mm steel


def result_of(hull, name="righting_levers"):
    return part("features.analyses").result_of(hull, bpy.context.scene, name)


def add_case(hull, name, mass_t, lcg=5.0, tcg=0.0, vcg=1.0, with_weights=False):
    assert bpy.ops.hull.add_load_case() == {"FINISHED"}
    case = hull.hull.loading.load_cases[-1]
    case.name, case.mass_t, case.with_weights = name, mass_t, with_weights
    case.lcg, case.tcg, case.vcg = lcg, tcg, vcg
    return case


@pytest.fixture
def box():
    hull = add_hull()
    settings = hull.hull
    settings.draft, settings.length_pp, settings.beam, settings.depth = 1.5, 10.0, 4.0, 3.0
    settings.loading.kg = 1.0
    settings.wind.source = "HULL"
    bpy.context.view_layer.update()
    return hull


def typed(hull, mass_t, lcg, kg):
    loading = hull.hull.loading
    loading.loaded, loading.use_displacement, loading.use_lcb = "TYPED", False, False
    loading.mass_t, loading.lcg, loading.kg = mass_t, lcg, kg


def load_case(hull, name):
    hull.hull.loading.loaded, hull.hull.loading.loaded_case = "CASE", name


def numbers_of(hull):
    """Levers, criteria and cross curves, as numbers."""
    levers, judged = result_of(hull), result_of(hull, "criteria")
    curves = result_of(hull, "cross_curves")
    return [
        levers.levers.levers, levers.levers.gm, [c.value for c in judged.criteria],
        judged.weather.wind_lever, judged.weather.steady_lever, curves.curves.displacements_t,
        curves.curves.levers, curves.load.mass_t,
    ]  # fmt: skip


def same(one, other, **how):
    for a, b in zip(one, other):
        np.testing.assert_allclose(np.array(a, float), np.array(b, float), **how)


def test_a_load_case_is_as_if_it_were_typed(box):
    add_case(box, "other", 30.0)
    add_case(box, "cargo", 70.0, 5.2, 0.0, 0.9)
    typed(box, 70.0, 5.2, 0.9)
    wanted = numbers_of(box)
    box.hull.loading.mass_t, box.hull.loading.kg = 33.0, 2.0
    load_case(box, "cargo")
    assert result_of(box).load.mass_t == 70.0
    same(numbers_of(box), wanted, rtol=1e-12, atol=1e-12)


def test_the_weights_are_as_if_their_sum_were_typed(box):
    box.hull.weights.thickness = 0.02
    bpy.ops.hull.add_weight()
    item = box.hull.weights.items[0]
    item.mass_t, item.lcg, item.vcg = 30.0, 5.0, 0.4
    box.hull.loading.loaded = "WEIGHTS"
    load = result_of(box).load
    assert load.mass_t == pytest.approx(SHELL + 30.0, rel=1e-7)
    # GM of a box: T/2 + B²/12T − KG.
    draft = load.mass_t / (40.0 * DENSITY)
    gm = draft / 2 + 16.0 / (12.0 * draft) - load.kg
    assert result_of(box).levers.gm == pytest.approx(gm, rel=1e-6)
    item.lcg = 5.5
    load = result_of(box).load
    assert load.lcg == pytest.approx((SHELL * 5.0 + 30.0 * 5.5) / (SHELL + 30.0), rel=1e-7)
    found = numbers_of(box)
    typed(box, load.mass_t, load.lcg, load.kg)
    same(numbers_of(box), found, rtol=1e-5, atol=1e-6)


def test_a_load_case_with_the_weights(box):
    box.hull.weights.thickness = 0.02
    add_case(box, "cargo", 30.0, 5.0, 0.0, 0.5, with_weights=True)
    load_case(box, "cargo")
    assert result_of(box).load.mass_t == pytest.approx(SHELL + 30.0, rel=1e-7)
    box.hull.weights.thickness = 0.01
    assert result_of(box).load.mass_t == pytest.approx(SHELL / 2 + 30.0, rel=1e-7)


def told(hull, name="righting_levers"):
    with pytest.raises(ValueError) as error:
        result_of(hull, name)
    return str(error.value)


@pytest.mark.parametrize("name", ["righting_levers", "criteria", "cross_curves"])
def test_what_is_missing_is_told(box, name):
    box.hull.loading.loaded = "WEIGHTS"
    assert told(box, name) == (
        "Sum of the weights: nothing is loaded, give plating or a list under Weights"
    )
    load_case(box, "")
    assert told(box, name) == "Choose the load case that is loaded"
    load_case(box, "cargo")
    assert 'no load case "cargo"' in told(box, name)
    case = add_case(box, "cargo", 0.0)
    assert told(box, name) == "cargo: nothing is loaded, give it a mass"
    case.mass_t = 500.0
    assert "500 t" in told(box, name)
    case.mass_t = 60.0
    assert result_of(box, name) is not None
    typed(box, 0.0, 5.0, 1.0)
    assert told(box, name) == "Give the mass of ship and load first"
    box.hull.loading.use_displacement, box.hull.draft = True, -1.0
    bpy.context.view_layer.update()
    assert "Nothing is under water" in told(box, name)


def test_load_cases_do_not_need_what_is_loaded(box):
    add_case(box, "cargo", 60.0)
    load_case(box, "gone")
    (found,) = result_of(box, "load_cases")
    assert found.stability is not None


def test_a_list_is_looked_at_on_its_own_side(box):
    levers = []
    for tcg in (0.1, -0.1, 0.0):
        box.hull.loading.load_cases.clear()
        add_case(box, "list", 60.0, tcg=tcg)
        load_case(box, "list")
        result = result_of(box)
        levers.append(result.levers.levers)
        side = {0.1: "to port", -0.1: "to starboard"}.get(tcg)
        assert any("centre of gravity" in text for text in result.remarks()) == bool(side)
        assert not side or side in " ".join(result.remarks())
    np.testing.assert_allclose(levers[0], levers[1], atol=1e-12)
    upright = levers[2] - 0.1 * np.cos(result.levers.heels)
    np.testing.assert_allclose(levers[0], upright, atol=1e-9)


def test_every_load_case_has_its_levers_and_criteria(box):
    add_case(box, "light", 50.0, vcg=0.8)
    add_case(box, "top-heavy", 60.0, vcg=2.6)
    add_case(box, "sinks", 500.0)
    add_case(box, "nothing", 0.0)
    found = result_of(box, "load_cases")
    module = part("features.stability.load_cases")
    header, rows = module.header(found), list(module.rows(found))
    assert {len(row) for row in rows} == {len(header)}
    for case, row in zip(found[:2], rows):
        load_case(box, case.case.name)
        levers, judged = result_of(box).levers, result_of(box, "criteria")
        told_of = dict(zip(header, row))
        assert told_of["greatest GZ [m]"] == levers.greatest_lever
        assert told_of["heel of greatest GZ [deg]"] == pytest.approx(
            np.degrees(levers.greatest_lever_heel)
        )
        assert told_of["area 0 to 40 deg [m rad]"] == levers.areas[1]
        outcomes = {paragraph: outcome for paragraph, outcome, _ in judged.outcomes()}
        for paragraph in ("2.2", "2.3"):
            assert told_of[f"2008 IS Code Part A {paragraph}"] == outcomes[paragraph]
        assert case.stability.outcome() == ("fail" if "fail" in outcomes.values() else "pass")
    assert [case.stability is None for case in found] == [False, False, True, True]
    assert found[0].stability.outcome() == "pass" and found[1].stability.outcome() == "fail"
    assert "500 t" in rows[2][-1]


def test_the_panels_say_what_is_loaded(box):
    add_case(box, "cargo", 60.0)
    for name in ("righting_levers", "load_cases"):
        part("features.analyses").outcome_of(box, bpy.context.scene, name)
    drawn = Drawn(part("panels.stability").HULL_PT_stability)
    drawn.draw(context())
    assert "property mass_t" not in drawn.layout.noted and "property kg" in drawn.layout.noted
    load_case(box, "cargo")
    drawn = Drawn(part("panels.stability").HULL_PT_stability)
    drawn.draw(context())
    assert "property loaded_case" in drawn.layout.noted
    assert "property kg" not in drawn.layout.noted
    cases = Drawn(part("panels.load_cases").HULL_PT_load_cases)
    cases.draw(context())
    assert "IS Code 2.2" in cases.layout.noted and "Greatest GZ" in cases.layout.noted


def test_files_keep_what_is_loaded(box, tmp_path):
    add_case(box, "Ladung „voll“", 60.0)
    load_case(box, "Ladung „voll“")
    wanted = result_of(box).levers.levers
    path = str(tmp_path / "box.hull.json")
    assert bpy.ops.hull.export_hull(filepath=path) == {"FINISHED"}
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "box.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "box.blend"))
    again = bpy.context.object
    assert again.hull.loading.loaded == "CASE"
    np.testing.assert_allclose(result_of(again).levers.levers, wanted, atol=1e-12)
    assert bpy.ops.hull.import_hull(filepath=path) == {"FINISHED"}
    read = bpy.context.object
    assert read is not again and read.hull.loading.loaded_case == "Ladung „voll“"
    np.testing.assert_allclose(result_of(read).levers.levers, wanted, atol=1e-12)
    again.hull.loading.loaded = "WEIGHTS"


def test_wind_and_lateral_areas_of_the_box(box):
    values = part("features.hull.hull_state").state_of(box).hydrostatics.values
    assert (values.lateral_area, values.lateral_x, values.lateral_z) == pytest.approx(
        (15.0, 5.0, 0.75)
    )
    assert (values.wind_area, values.wind_x, values.wind_z) == pytest.approx((15.0, 5.0, 2.25))
    module = part("features.curves_of_form.hydrostatic_table")
    result = result_of(box, "hydrostatic_table")
    header, rows = module.header(result), list(module.rows(result))
    column = header.index("wind area [m2]")
    assert [row[column] for row in rows] == pytest.approx([10 * (3 - row[0]) for row in rows])


def test_new_entries_have_names_of_their_own(box):
    """A case is loaded by its name."""
    for add, remove, entries in (
        ("add_load_case", "remove_load_case", box.hull.loading.load_cases),
        ("add_downflooding_point", "remove_downflooding_point",
         box.hull.loading.downflooding_points),
        ("add_wind_area", "remove_wind_area", box.hull.wind.areas),
        ("add_weight", "remove_weight", box.hull.weights.items),
    ):  # fmt: skip
        for _ in range(3):
            getattr(bpy.ops.hull, add)()
        before = [entry.name for entry in entries]
        settings = box.hull.loading if "load" in add or "down" in add else None
        settings = settings or (box.hull.wind if "wind" in add else box.hull.weights)
        for name in ("active_load_case", "active_downflooding_point", "active_area", "active_item"):
            if hasattr(settings, name):
                setattr(settings, name, 0)
        getattr(bpy.ops.hull, remove)()
        getattr(bpy.ops.hull, add)()
        names = [entry.name for entry in entries]
        assert names[:2] == before[1:] and len(set(names)) == 3, names
