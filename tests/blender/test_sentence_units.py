# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences are metric in the core, and in feet where the scene's units are imperial."""

from types import SimpleNamespace

import bpy
import pytest
from addon_under_test import add_hull, part
from test_panels import texts

SCENES = {
    system: SimpleNamespace(unit_settings=SimpleNamespace(system=system))
    for system in ("NONE", "METRIC", "IMPERIAL")
}
# As sentences of the core are written, and the same in feet, worked out by hand.
SAME = {
    "Nothing is under water at a draft of 3.048 m": "Nothing is under water at a draft of 10 ft",
    "at x 3.048, y -6.096, z 0.3048 m it folds": "at x 10, y -20, z 1 ft it folds",
    "Lies from x = 3.048 to 30.48 m, where": "Lies from x = 10 to 100 ft, where",
    "near (3.048, 0, -0.3048) m: move it": "near (10, 0, -1) ft: move it",
    "2.54 mm RMS, 25.4 mm at most": "0.1 in RMS, 1 in at most",
    "4 m long, 3 m broad": "13.12 ft long, 9.843 ft broad",
    "3.048 × 6.096 × 9.144 m": "10 × 20 × 30 ft",
    "of 9.290304 m² now": "of 100 ft² now",
    "overlap by about 0.0283 m³": "overlap by about 0.9994 ft³",
    "2 plates, 2.03 t; 3.048 m of a butt": "2 plates, 1.998 LT; 10 ft of a butt",
    "from 3.048–6.096 m on": "from 10–20 ft on",
    "LCB by +25.4 mm": "LCB by +1 in",
    "LCB by -25.4 mm": "LCB by -1 in",
    "of 10000000 m": "of 32808399 ft",
    "below 1e-06 mm": "below 3.937e-08 in",
    "comes near 1e+09 m of it": "comes near 3.281e+09 ft of it",
    "a jump of 0.1 1/m": "a jump of 0.03048 1/ft",
}
# No quantities, or names.
STAY = (
    "3 of 4 points at t = 0.5",
    'Of "WL 2 m" and "12 t"',
    "5 t·m/cm, 3 m/s, 20 m-sections",
    "of 2 members, 3 tons",
    "P2-3 m, a-5 t",
    "16 kn, 30° and 5.2 %",
    "10 ft, 2 LT",
    "",
)


@pytest.fixture
def in_scene_units():
    return part("bridge.blender.sentence_units").in_scene_units


@pytest.mark.parametrize("text", SAME)
def test_quantities_are_in_the_units_of_the_scene(in_scene_units, text):
    assert in_scene_units(SCENES["IMPERIAL"], text) == SAME[text]
    assert in_scene_units(SCENES["METRIC"], text) == in_scene_units(SCENES["NONE"], text) == text


@pytest.mark.parametrize("text", STAY)
def test_what_is_no_quantity_stays(in_scene_units, text):
    assert in_scene_units(SCENES["IMPERIAL"], text) == text


def test_small_lengths_are_written_out():
    shown = {
        0.0: "0",
        0.25: "0.25",
        999.4: "999",
        999.7: "1000",
        1000.0: "1000",
        123456.7: "123457",
    }
    for mm, text in shown.items():
        assert part("bridge.blender.units").format_mm(1e-3 * mm) == f"{text} mm"


@pytest.fixture
def hull():
    """Of a scene in feet, far above the water."""
    made = add_hull()
    bpy.context.scene.unit_settings.system = "IMPERIAL"
    for vertex in made.data.vertices:
        vertex.co.z += 100.0
    made.hull.draft = 3.048
    bpy.context.view_layer.update()
    return made


def test_what_panels_say(hull):
    said = " ".join(texts()["HULL_PT_hydrostatics"])
    assert "under water at a draft of 10 ft" in said


def test_refusals():
    bpy.context.scene.unit_settings.system = "IMPERIAL"
    with pytest.raises(RuntimeError, match=r"give at most [\d.]+ ft"):
        bpy.ops.hull.add_hull(kind="BARGE", length=1e9)


def test_refusals_of_files_tell_what_stands_there(hull, tmp_path):
    """In the file's own units, as a text editor shows them."""
    table = tmp_path / "areas.csv"
    table.write_text("x,area\n1e7,1\n2e7,2\n3e7,1\n")
    with pytest.raises(RuntimeError, match="line 2: x is 1e.07 m, which no ship has"):
        bpy.ops.hull.load_area_curve(filepath=str(table))


def test_reports(hull):
    said = []
    told_by = SimpleNamespace(report=lambda levels, text: said.append((levels, text)))
    part("operators.shared").BaseOperator.tell(told_by, "INFO", "moved by 0.3048 m")
    assert said == [({"INFO"}, "moved by 1 ft")]
