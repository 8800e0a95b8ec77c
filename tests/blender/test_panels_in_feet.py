# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of an imperial scene that come and go with choices: wanted ones of Targets, limits and
legends of colours, lists of lengths."""

import bpy
import numpy as np
import pytest
from addon_under_test import part, sample
from test_fields_in_feet import FOOT, NUMBER, SIZES, Reading, faults, is_said
from test_panels import Drawn, Notebook, context, texts


@pytest.fixture
def imperial():
    bpy.context.scene.unit_settings.system = "IMPERIAL"


def targets_drawn(hull, **given):
    """(fields and texts of the panel, texts of its list) with a row of a quantity."""
    row = hull.hull.targets.rows[0]
    for name, value in given.items():
        setattr(row, name, value)
    drawn, line = (Drawn(part("panels.targets").HULL_PT_targets) for _ in range(2))
    drawn.layout, line.layout = Reading(), Notebook()
    drawn.draw(context())
    drawing = part("panels.targets").HULL_UL_rows.draw_item
    settings = hull.hull.targets
    drawing(line, context(), line.layout, settings, row, 0, settings, "active_row", 0)
    return drawn.layout.noted, line.layout.noted


@pytest.mark.parametrize(
    "quantity, symbol", [("VOLUME", "m³"), ("WETTED", "m²"), ("DISPLACEMENT", "t"), ("LWL", "m")]
)
def test_targets(imperial, quantity, symbol):
    hull = sample("coaster")
    bpy.ops.hull.add_target()
    bpy.context.view_layer.update()
    noted, line = targets_drawn(hull, quantity=quantity, value=432.1, tolerance=3.21)
    size = SIZES[symbol][0]
    assert not list(faults(noted))
    assert is_said(symbol, 3.21, [text for text in noted if isinstance(text, str)])
    now = part("features.targets.rows").present(hull.hull.targets.rows[0], hull, bpy.context.scene)
    texts_of_line = [text for text in line if not text.startswith("property")]
    wanted, present = (float(NUMBER.findall(text)[-1]) for text in texts_of_line)
    assert wanted == pytest.approx(432.1 / size, rel=1e-3)
    assert present == pytest.approx(now / size, rel=1e-3)


def test_targets_that_have_no_unit(imperial):
    hull = sample("coaster")
    bpy.ops.hull.add_target()
    noted, _ = targets_drawn(hull, quantity="CB", value=0.71)
    assert not [text for text in noted if isinstance(text, str) and text.startswith("= ")]


def test_what_targets_miss_is_told_in_one_unit(imperial):
    reports, quantities = part("features.targets.reports"), part("features.targets.quantities")
    volume = quantities.QUANTITIES[0]
    row = reports.Reached(
        volume.label, volume.number, volume.unit, "≥ 1000", 9e2, 9.5e2, 50.0, False
    )
    report = reports.Report(None, "missed", (row,), 3, 0.0, (1.0, 1.0, 1.0), ())
    feet = "∇ ≥ 35314.7: nearest is 33548.9 ft³"
    assert feet in reports.warning(report, bpy.context.scene)
    bpy.context.scene.unit_settings.system = "METRIC"
    assert "∇ ≥ 1000: nearest is 950.000 m³" in reports.warning(report, bpy.context.scene)


@pytest.mark.parametrize("colours, unit", [("GAUSSIAN", "1/m²"), ("MEAN", "1/m")])
def test_legends_and_limits_of_colours(colours, unit):
    hull = sample("coaster")
    fairness, legend = hull.hull.fairness, part("overlays.legend")
    fairness.colours, fairness.colour_limit = colours, 0.25
    fairness.comb_stations = True
    bpy.context.view_layer.update()
    metric, told = legend.legend_of(hull), texts()
    assert metric.unit == unit and "Tooth for 1/m" in told["HULL_PT_combs"]
    bpy.context.scene.unit_settings.system = "IMPERIAL"
    feet, told_feet = legend.legend_of(hull), texts()
    assert feet.unit == SIZES[unit][1]
    said = told_feet["HULL_PT_fairness"]
    assert is_said(unit, 0.25, said[said.index("property colour_limit") :])
    # A bend of 1/ft is that many 1/m, and a tooth of a metre that many feet.
    place = told["HULL_PT_combs"].index("Tooth for 1/m") + 2
    assert told_feet["HULL_PT_combs"][place - 2] == "Tooth for 1/ft"
    tooth, other = (float(said["HULL_PT_combs"][place].split()[0]) for said in (told, told_feet))
    assert other == pytest.approx(tooth / FOOT**2, rel=1e-3)


def test_lists_that_are_not_understood_are_left_alone(imperial):
    hull = sample("coaster")
    hull.hull.lines.stations, hull.hull.lines.stations_in = "3 5", "FRAMES"
    hull.hull.lines.waterlines = "1 two"
    said = texts()["HULL_PT_sections"]
    assert not [text for text in said if text.startswith("= ")]
    hull.hull.lines.stations_in = "METRES"
    assert "= 9.8425 16.404 ft" in texts()["HULL_PT_sections"]


@pytest.mark.parametrize("kind, unit", [("gaussian", "1/m²"), ("mean", "1/m"), ("distance", "mm")])
@pytest.mark.parametrize("mapping", ["linear", "logarithmic"])
def test_legends_have_round_numbers_in_feet(kind, unit, mapping):
    """Each beside its colour, as the scale has that."""
    arrays, shown = part("overlays.legend_arrays"), part("bridge.blender.units")
    for high in (0.0123, 0.5, 7.0):
        scale = part("bridge.native").hull_native.colour_scale(
            np.array([high]), kind=kind, mapping=mapping, limits=(-high, high)
        )
        legend = arrays.arrays_of(scale, "", shown.IMPERIAL.plot_sizes())
        metric = arrays.arrays_of(scale, "", shown.METRIC.plot_sizes())
        assert legend.unit == SIZES[unit][1]
        assert (metric.unit, [text for _, text in metric.labels]) == (unit, scale.tick_labels)
        heights, texts_there = zip(*legend.labels)
        numbers = np.array([float(text) for text in texts_there])
        assert 5 <= len(numbers) <= 13 and "0" in texts_there
        assert (np.diff(numbers) > 0.0).all() and (np.diff(heights) > 2.0).all()
        assert all(float(f"{number:.2g}") == number for number in numbers)
        size = SIZES[unit][0] * (1e-3 if unit == "mm" else 1.0)
        low, room = metric.labels[0][0], metric.labels[-1][0] - metric.labels[0][0]
        ends = scale.tick_positions[0], scale.tick_positions[-1]
        along = ends[0] + (np.array(heights) - low) / room * (ends[1] - ends[0])
        np.testing.assert_allclose(along, scale.normalised(numbers * size), atol=1e-12)
