# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables and plots: operators write what the functions give; results last until a change."""

import csv
import re
from math import degrees, radians, tan

import bpy
import numpy as np
import pytest
from addon_under_test import DEPTH, HALF_BREADTH, LENGTH, add_box, add_hull, part, state_of

BEAM = 2.0 * HALF_BREADTH
DENSITY = 1.025


def afloat_box():
    """A box of 10 m × 4 m × 3 m at a draft of 1 m, KG 1.2 m."""
    hull = add_hull()
    hull.hull.draft = 1.0
    hull.hull.loading.kg = 1.2
    hull.hull.resistance.method = "MICHELL"  # a box is too full for regressions
    bpy.context.view_layer.update()
    return hull


def add_case(hull, name, mass_t, lcg=5.0, tcg=0.0, vcg=1.0):
    assert bpy.ops.hull.add_load_case() == {"FINISHED"}
    case = hull.hull.loading.load_cases[-1]
    case.name, case.mass_t, case.lcg, case.tcg, case.vcg = name, mass_t, lcg, tcg, vcg
    return case


def result_of(hull, name):
    return part("features.analyses").result_of(hull, bpy.context.scene, name)


def export(tmp_path, name):
    """Header and rows of the CSV that the operator writes."""
    path = tmp_path / f"{name}.csv"
    assert bpy.ops.hull.export_table(analysis=name, filepath=str(path)) == {"FINISHED"}
    with open(path, newline="", encoding="utf-8-sig") as stream:
        table = list(csv.reader(stream))
    return table[0], table[1:]


def numbers(rows):
    return np.array([[float(cell or "nan") for cell in row] for row in rows])


ALL = (
    "hydrostatic_table",
    "sectional_areas",
    "bonjean_curves",
    "righting_levers",
    "cross_curves",
    "criteria",
    "load_cases",
    "weights",
    "resistance_curves",
    "wave_pattern",
    "wave_spectrum",
    "offset_table",
    "knuckle_angles",
    "differences",
    "area_differences",
)
PLOTTED = (*ALL[:5], *ALL[8:11], "knuckle_angles")


def test_these_are_all():
    analyses = part("features.analyses")
    assert tuple(analyses.ANALYSES) == ALL
    assert tuple(analyses.PLOTTED) == PLOTTED
    for name, module in analyses.ANALYSES.items():
        assert module.__name__.rpartition(".")[2] == name
        assert hasattr(module, "plot") == (name in PLOTTED)
        label, description = analyses.WORDS[name]
        assert label and not description.endswith(".")
    assert tuple(analyses.WORDS) == ALL


@pytest.mark.parametrize("name", ALL)
def test_the_operator_writes_what_the_function_gives(name, tmp_path):
    hull = afloat_box()
    add_case(hull, "ballast", 30.0)
    bpy.ops.hull.keep_variant()
    header, rows = export(tmp_path, name)
    module = part("features.analyses").ANALYSES[name]
    result = result_of(hull, name)
    assert header == module.header(result)
    wanted = list(module.rows(result))
    assert len(rows) == len(wanted) > 0
    for row, values in zip(rows, wanted):
        for cell, value in zip(row, values):
            if value is None or isinstance(value, str):
                assert cell == (value or "")
            else:
                assert float(cell) == pytest.approx(value, rel=1e-9)


COUNTED = ("station", "knuckle")
UNITS = ("m", "mm", "m2", "m3", "m4", "t", "t/cm", "t m/cm", "deg", "m/rad", "m rad",
         "% of Lpp", "-", "see unit", "%", "kn", "m/s", "kN", "kW", "kN/deg")  # fmt: skip


def is_number(cell):
    try:
        float(cell)
    except ValueError:
        return False
    return True


@pytest.mark.parametrize("name", ALL)
def test_a_spreadsheet_finds_columns_of_numbers_with_units_and_columns_of_texts(name, tmp_path):
    hull = afloat_box()
    add_case(hull, "2001-02-03", 30.0)
    add_case(hull, "sinks", 1e4)
    bpy.ops.hull.keep_variant()
    header, rows = export(tmp_path, name)
    assert len(set(header)) == len(header)
    assert all(len(row) == len(header) for row in rows)
    for title, cells in zip(header, zip(*rows)):
        given = [cell for cell in cells if cell]
        unit = re.fullmatch(r"[^][]+ \[([^][]+)\]", title)
        if unit or title in COUNTED:
            assert title in COUNTED or unit[1] in UNITS, title
            assert all(map(is_number, given)), title
        else:
            assert title.isascii() and not any(map(is_number, given)), title
            # What begins with a digit may pass for a date, what begins with = is computed.
            own = title in ("load case",)
            assert own or not any(cell[0].isdigit() or cell[0] in "=+-@" for cell in given), title


@pytest.mark.parametrize("name", PLOTTED)
def test_plots_are_written_in_three_kinds(name, tmp_path):
    afloat_box()
    begins = {"pdf": b"%PDF", "svg": b"<?xml", "png": b"\x89PNG"}
    for ending, begin in begins.items():
        path = tmp_path / f"plot.{ending}"
        assert bpy.ops.hull.export_plot(analysis=name, filepath=str(path)) == {"FINISHED"}
        assert path.read_bytes().startswith(begin)


def test_curves_of_a_trim_at_which_all_is_dry_are_refused(tmp_path):
    hull = afloat_box()
    hull.hull.length_pp = LENGTH
    for vertex in hull.data.vertices:
        vertex.co.z += 2.0
    hull.data.update()
    hull.hull.table.draft_to, hull.hull.table.trims = 1.9, "0 2"
    path = str(tmp_path / "curves.svg")
    with pytest.raises(RuntimeError, match="first trim, even keel.*put another one first"):
        bpy.ops.hull.export_plot(filepath=path, analysis="hydrostatic_table")
    hull.hull.table.trims = "2 0"
    assert bpy.ops.hull.export_plot(filepath=path, analysis="hydrostatic_table") == {"FINISHED"}


def test_hydrostatics_over_drafts_and_trims(tmp_path):
    hull = afloat_box()
    table = hull.hull.table
    table.draft_from, table.draft_to, table.draft_step, table.trims = 0.5, 2.0, 0.4, "0 0,25"
    header, rows = export(tmp_path, "hydrostatic_table")
    found = numbers(rows)
    drafts = [0.5, 0.9, 1.3, 1.7, 2.0]
    assert found[:, 0] == pytest.approx(drafts * 2)
    assert found[:, header.index("trim by the stern [m]")].tolist() == [0.0] * 5 + [0.25] * 5
    volumes = LENGTH * BEAM * np.array(drafts * 2)
    assert found[:, header.index("displaced volume [m3]")] == pytest.approx(volumes, rel=1e-9)
    shift = LENGTH / 2 - found[5:, header.index("LCB from AP [m]")]
    assert shift == pytest.approx(LENGTH * 0.25 / 12.0 / np.array(drafts), rel=1e-8)


@pytest.mark.parametrize(
    "settings, message",
    [
        ({"draft_from": 2.0, "draft_to": 1.0}, "greater than its first"),
        ({"draft_step": 1e-5, "draft_to": 1.0}, "widen"),
        ({"trims": "one"}, "numbers with blanks"),
    ],
)
def test_ranges_that_make_no_sense_are_refused(settings, message):
    hull = afloat_box()
    for name, value in settings.items():
        setattr(hull.hull.table, name, value)
    with pytest.raises(RuntimeError, match=message) as caught:
        bpy.ops.hull.export_table(analysis="hydrostatic_table", filepath="/nowhere/at/all")
    assert "Traceback" not in str(caught.value)


def test_sectional_areas_of_a_box():
    hull = afloat_box()
    found = result_of(hull, "sectional_areas").areas
    assert found.areas == pytest.approx(np.full(len(found.areas), BEAM * 1.0))
    assert found.positions[[0, -1]] == pytest.approx([0.0, LENGTH], abs=1e-4)


def test_bonjean_curves_of_a_box():
    hull = afloat_box()
    hull.hull.lines.station_count = 4
    curves = result_of(hull, "bonjean_curves").curves
    assert curves.stations == pytest.approx([0.0, 2.5, 5.0, 7.5, 10.0], abs=2e-5)
    assert curves.drafts[-1] == DEPTH
    for areas in curves.areas:  # those in the planes of the transoms too
        assert areas == pytest.approx(BEAM * curves.drafts)


def test_righting_levers_of_a_box():
    hull = afloat_box()
    result = result_of(hull, "righting_levers")
    assert result.load.mass_t == pytest.approx(DENSITY * 40.0)
    assert result.load.lcg == pytest.approx(LENGTH / 2)
    gm = 0.5 + BEAM**2 / 12.0 - 1.2
    assert result.levers.gm == pytest.approx(gm)
    assert [round(degrees(heel)) for heel in result.levers.heels] == list(range(0, 95, 5))
    # The wall-sided formula holds until bilge or deck pass the water, at 26.6°.
    heel = result.levers.heels[4]
    wall_sided = np.sin(heel) * (gm + BEAM**2 / 24.0 * tan(heel) ** 2)
    assert result.levers.levers[4] == pytest.approx(wall_sided, rel=1e-9)
    assert result.areas()[0][:2] == (0.0, radians(30.0))


def test_a_given_load_counts():
    hull = afloat_box()
    loading = hull.hull.loading
    loading.use_displacement, loading.mass_t = False, DENSITY * 60.0
    result = result_of(hull, "righting_levers")
    assert result.levers.gm == pytest.approx(0.75 + BEAM**2 / 18.0 - 1.2)
    assert result.load.lcg == pytest.approx(LENGTH / 2)
    loading.mass_t = 1000.0
    with pytest.raises(ValueError, match="[Ss]inks"):
        result_of(hull, "righting_levers")
    loading.mass_t = 0.0
    with pytest.raises(ValueError, match="mass"):
        result_of(hull, "righting_levers")


def test_the_load_afloat_with_trim_keeps_that_trim():
    hull = afloat_box()
    hull.hull.trim_m = 0.4
    result = result_of(hull, "righting_levers")
    assert degrees(result.levers.trims[0]) == pytest.approx(degrees(np.arctan(0.04)), abs=1e-8)


def test_openings_flood_on_both_sides():
    hull = afloat_box()
    assert result_of(hull, "righting_levers").levers.downflooding_heel is None
    assert bpy.ops.hull.add_downflooding_point() == {"FINISHED"}
    hull.hull.loading.downflooding_points[0].position = (5.0, 2.0, 1.5)
    assert result_of(hull, "righting_levers").levers.downflooding_heel == pytest.approx(
        np.arctan(0.25), rel=1e-9
    )
    report = result_of(hull, "criteria")
    assert [one[1] for one in report.outcomes()] == ["fail", "not computed"]
    assert bpy.ops.hull.remove_downflooding_point() == {"FINISHED"}
    assert not bpy.ops.hull.remove_downflooding_point.poll()


def test_an_open_deck_floods_where_its_edge_comes_under_water():
    hull = afloat_box()
    hull.hull.deck_closed = False
    levers = result_of(hull, "righting_levers").levers
    assert levers.deck_edge_heel is not None
    assert levers.downflooding_heel == pytest.approx(levers.deck_edge_heel, rel=1e-9)
    hull.hull.deck_closed = True
    closed = result_of(hull, "righting_levers").levers
    assert closed.downflooding_heel is None
    assert closed.deck_edge_heel == pytest.approx(levers.deck_edge_heel, rel=1e-9)


def test_criteria_are_those_of_the_native_function():
    hull = afloat_box()
    report = result_of(hull, "criteria")
    wanted = (
        part("bridge.native")
        .require()
        .stability_criteria(
            state_of(hull).ship.source.new_ship().body,
            mass_t=state_of(hull).hydrostatics.values.displacement_t,
            centre_of_gravity=(state_of(hull).hydrostatics.values.lcb, 0.0, 1.2),
            water_density=DENSITY,
        )
    )
    assert [(one.name, one.limit, one.outcome) for one in report.criteria] == [
        (one.name, one.limit, one.outcome) for one in wanted.criteria
    ]
    # The load is that of the live numbers.
    values = [one.value for one in report.criteria]
    assert values == pytest.approx([one.value for one in wanted.criteria], rel=1e-9)


def test_the_weather_criterion_is_that_of_the_native_function(tmp_path):
    hull = afloat_box()
    _, rows = export(tmp_path, "criteria")
    assert [row[6] for row in rows if row[0] == "Part A 2.3"] == ["not computed"]
    wind = hull.hull.wind
    wind.source, wind.keel_area, wind.roll_period = "HULL", 0.8, 5.5
    assert bpy.ops.hull.add_wind_area() == {"FINISHED"}
    wind.areas[0].area, wind.areas[0].z = 12.0, 4.0
    found = result_of(hull, "criteria").weather
    wanted = (
        part("bridge.native")
        .require()
        .weather_criterion(
            state_of(hull).ship.source.new_ship().body,
            mass_t=state_of(hull).hydrostatics.values.displacement_t,
            centre_of_gravity=(state_of(hull).hydrostatics.values.lcb, 0.0, 1.2),
            water_density=DENSITY,
            wind_areas=[(12.0, 4.0)],
            midship=LENGTH / 2,
            beam=BEAM,
            keel_area=0.8,
            roll_period=5.5,
        )
    )
    for name in ("wind_area", "wind_lever", "steady_lever", "area_a", "area_b", "steady_heel"):
        assert getattr(found, name) == pytest.approx(getattr(wanted, name), rel=1e-7), name
    assert found.roll.angle == pytest.approx(wanted.roll.angle, rel=1e-9)
    header, rows = export(tmp_path, "criteria")
    written = {row[1]: row for row in rows}
    area_b = written["Area b, of GZ above the gust's lever, against area a"]
    assert float(area_b[header.index("limit [see unit]")]) == pytest.approx(found.area_a, rel=1e-9)
    assert float(written["Wind area A"][2]) == pytest.approx(32.0)


def test_cross_curves_give_the_righting_levers():
    hull = afloat_box()
    loading = hull.hull.loading
    load_t = DENSITY * 40.0
    loading.least_t, loading.greatest_t, loading.displacement_count = 0.5 * load_t, load_t, 2
    curves = result_of(hull, "cross_curves").curves
    levers = result_of(hull, "righting_levers").levers
    assert curves.displacements_t == pytest.approx([0.5 * load_t, load_t])
    gz = curves.levers[1] - 1.2 * np.sin(curves.heels)
    assert gz == pytest.approx(levers.levers[2::2], abs=1e-6)
    loading.least_t = 2.0 * load_t
    with pytest.raises(ValueError, match="must be more than the least"):
        result_of(hull, "cross_curves")


def test_load_cases_float_or_say_why_not():
    hull = afloat_box()
    add_case(hull, "even", DENSITY * 60.0)
    add_case(hull, "trimmed", DENSITY * 60.0, lcg=4.9)
    add_case(hull, "listing", DENSITY * 60.0, tcg=-0.02)
    add_case(hull, "too heavy", 1000.0)
    add_case(hull, "none", 0.0)
    even, trimmed, listing, heavy, none = result_of(hull, "load_cases")
    assert (even.status, even.message) == ("stable", "")
    assert even.draft_mean == pytest.approx(1.5)
    assert even.gm == pytest.approx(0.75 + BEAM**2 / 18.0 - 1.0)
    assert trimmed.draft_aft > 1.5 > trimmed.draft_forward
    assert trimmed.trim_m == pytest.approx(trimmed.draft_aft - trimmed.draft_forward)
    assert listing.heel > 0.0 and abs(even.heel) < 1e-9
    assert heavy.status == "sinks" and heavy.draft_mean is None and "1000 t" in heavy.message
    assert none.status == "refused" and "mass" in none.message


def test_a_name_beyond_ascii_is_marked_as_utf_8(tmp_path):
    hull = afloat_box()
    case = add_case(hull, "ballast", 30.0)
    path = tmp_path / "cases.csv"
    bpy.ops.hull.export_table(analysis="load_cases", filepath=str(path))
    assert path.read_bytes().isascii()
    case.name = "Überführung"
    bpy.ops.hull.export_table(analysis="load_cases", filepath=str(path))
    assert path.read_bytes().startswith(b"\xef\xbb\xbf") and "Überführung" in path.read_text()


def test_a_name_is_no_formula(tmp_path):
    hull = afloat_box()
    add_case(hull, "=1+1", 30.0)
    add_case(hull, "", 30.0)
    _, rows = export(tmp_path, "load_cases")
    assert [row[0] for row in rows] == ["'=1+1", ""]


def test_load_cases_come_and_go_by_operators():
    hull = afloat_box()
    assert not bpy.ops.hull.remove_load_case.poll()
    bpy.ops.hull.add_load_case()
    loading = hull.hull.loading
    assert loading.load_cases[0].mass_t == pytest.approx(DENSITY * 40.0)
    assert loading.load_cases[0].vcg == pytest.approx(1.2)
    bpy.ops.hull.add_load_case()
    assert loading.active_load_case == 1
    bpy.ops.hull.remove_load_case()
    assert [case.name for case in loading.load_cases] == ["Load case 1"]
    assert loading.active_load_case == 0


def test_adding_a_load_case_is_one_undo_step():
    afloat_box()
    bpy.ops.ed.undo_push(message="box")
    bpy.ops.hull.add_load_case()
    bpy.ops.ed.undo_push(message="case")
    bpy.ops.ed.undo()
    assert not bpy.data.objects["box"].hull.loading.load_cases
    bpy.ops.ed.redo()
    assert len(bpy.data.objects["box"].hull.loading.load_cases) == 1


def test_the_scene_scale_makes_metres():
    bpy.context.scene.unit_settings.scale_length = 0.5
    hull = afloat_box()
    hull.hull.draft = 2.0
    hull.hull.loading.kg = 2.4
    result = result_of(hull, "righting_levers")
    assert result.load.kg == pytest.approx(1.2)
    assert result.levers.gm == pytest.approx(0.5 + 4.0 / 12.0 - 1.2)


def test_results_last_until_what_they_depend_on_changes():
    hull = afloat_box()
    analyses, scene = part("features.analyses"), bpy.context.scene
    assert analyses.last_outcome(hull, scene, "bonjean_curves") == (None, False)
    first = analyses.outcome_of(hull, scene, "bonjean_curves")
    assert analyses.outcome_of(hull, scene, "bonjean_curves") is first
    hull.hull.heel = 0.1
    bpy.context.view_layer.update()
    assert analyses.last_outcome(hull, scene, "bonjean_curves") == (first, True)
    hull.data.vertices[0].co.x -= 1.0
    hull.data.update_tag()
    bpy.context.view_layer.update()
    assert analyses.last_outcome(hull, scene, "bonjean_curves") == (first, False)
    assert analyses.outcome_of(hull, scene, "bonjean_curves") is not first


def test_without_a_hull_there_is_nothing_to_export():
    add_box()
    for operator in (bpy.ops.hull.export_table, bpy.ops.hull.export_plot):
        assert not operator.poll()


def test_settings_survive_saving(tmp_path):
    hull = afloat_box()
    add_case(hull, "ballast", 30.0, lcg=4.0)
    bpy.ops.hull.add_downflooding_point()
    settings = hull.hull
    settings.trim_m, settings.heel, settings.deck_closed = -0.25, 0.125, False
    settings.table.trims = "-1 0"
    settings.plots.sectional_areas, settings.plots.corner = True, "TOP_RIGHT"
    path = str(tmp_path / "hull.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.wm.open_mainfile(filepath=path)
    settings = bpy.data.objects["box"].hull
    case = settings.loading.load_cases[0]
    assert (case.name, case.mass_t, case.lcg) == ("ballast", 30.0, 4.0)
    assert tuple(settings.loading.downflooding_points[0].position) == (5.0, 2.0, 3.0)
    assert (settings.trim_m, settings.heel, settings.deck_closed) == (-0.25, 0.125, False)
    assert settings.table.trims == "-1 0"
    assert (settings.plots.sectional_areas, settings.plots.corner) == (True, "TOP_RIGHT")
