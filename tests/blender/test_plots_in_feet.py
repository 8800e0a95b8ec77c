# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots of an imperial scene: no metres, no tonnes, no kilonewtons."""

import re

import bpy
import pytest
from addon_under_test import part, sample
from test_panels import Drawn, context

METRIC = re.compile(r"(?<![a-zA-Z°])(m|m²|m³|t|t/cm|t·m/cm|kN|m·rad)(?![a-zA-Z²³/·])")
PLOTS = (
    "hydrostatic_table", "sectional_areas", "bonjean_curves", "righting_levers", "cross_curves",
    "resistance_curves", "wave_pattern", "wave_spectrum", "knuckle_angles",
)  # fmt: skip
FOOT = 0.3048


@pytest.fixture
def coaster():
    hull = sample("coaster")
    hull.hull.resistance.method = "MICHELL"
    hull.hull.resistance.speed_to = 8.0
    hull.hull.trim_m = 0.3
    hull.hull.loading.kg = 5.0
    bpy.context.view_layer.update()
    return hull


def texts(hull, name):
    analyses, units = part("features.analyses"), part("bridge.blender.units")
    scene = bpy.context.scene
    result = analyses.result_of(hull, scene, name)
    plot = analyses.plot_of(name, result, hull.name, (), units.shown_in(scene))
    sheet = part("bridge.native").require().lay_out_plot(plot, width_mm=200, height_mm=140)
    return [label["text"] for label in sheet.labels]


@pytest.mark.parametrize("name", PLOTS)
def test_no_text_has_a_metric_unit(coaster, name):
    assert any(METRIC.search(text) for text in texts(coaster, name))
    bpy.context.scene.unit_settings.system = "IMPERIAL"
    found = texts(coaster, name)
    assert not [text for text in found if METRIC.search(text)]
    assert any(re.search(r"\b(ft|LT|lbf)\b", text) for text in found)


def greatest(found):
    (text,) = [text for text in found if text.startswith("max ")]
    return float(text.split()[1])


def test_the_numbers_are_those_of_metres(coaster):
    metres = greatest(texts(coaster, "righting_levers"))
    bpy.context.scene.unit_settings.system = "IMPERIAL"
    feet = greatest(texts(coaster, "righting_levers"))
    assert feet * FOOT == pytest.approx(metres, abs=6e-4)


def test_plots_over_the_view_follow_the_scene(coaster):
    coaster.hull.plots.sectional_areas = True
    bpy.context.view_layer.update()

    def shown():
        live = part("features.analyses.live_analyses")
        live.show_plots(coaster, bpy.context.scene)
        (one,) = live.plots().shown
        arrays = part("overlays.plot_arrays").arrays_of(one.card)
        return " ".join(label["text"] for label in arrays.labels)

    assert "[m²]" in shown()
    bpy.context.scene.unit_settings.system = "IMPERIAL"
    assert "[ft²]" in shown() and "[m²]" not in shown()
    part("features.analyses.live_analyses").stop()


@pytest.mark.parametrize("ending", ["svg", "pdf"])
def test_plots_on_paper_follow_the_scene(coaster, tmp_path, ending):
    files = []
    for system in ("METRIC", "IMPERIAL", "METRIC"):
        bpy.context.scene.unit_settings.system = system
        path = tmp_path / f"{len(files)}.{ending}"
        bpy.ops.hull.export_plot(analysis="righting_levers", filepath=str(path))
        files.append(path.read_bytes())
    assert files[0] != files[1]
    assert len(files[0]) == len(files[2])


@pytest.mark.parametrize("system", ["METRIC", "IMPERIAL"])
def test_masses_in_tonnes_are_told_in_long_tons(coaster, system):
    """10.160469088 t are ten of them."""
    bpy.context.scene.unit_settings.system = system
    bpy.ops.hull.add_load_case()
    case = coaster.hull.loading.load_cases[0]
    case.mass_t = 10.160469088
    drawn = Drawn(part("panels.load_cases").HULL_PT_load_cases)
    drawn.draw(context())
    assert ("= 10.000 LT" in drawn.layout.noted) == (system == "IMPERIAL")
