# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of an imperial scene: the same numbers as those of a metric one, in feet and their like;
offsets in feet, inches and eighths, read back."""

import csv
import re
from importlib import import_module

import bpy
import numpy as np
import pytest
from addon_under_test import hull_io, part, sample

FOOT = 0.3048
# By a plain list, so that a slip in the add-on's shows.
SIZES = {
    "m": (FOOT, "ft"), "m2": (FOOT**2, "ft2"), "m3": (FOOT**3, "ft3"), "m4": (FOOT**4, "ft4"),
    "t": (1.0160469088, "LT"), "t/cm": (1.0160469088 / 2.54, "LT/in"),
    "t m/cm": (1.0160469088 * FOOT / 2.54, "LT ft/in"), "m rad": (FOOT, "ft rad"),
    "m/rad": (FOOT, "ft/rad"), "m/s": (FOOT, "ft/s"), "mm": (25.4, "in"),
    "kN": (0.0044482216152605, "lbf"), "kN/deg": (0.0044482216152605, "lbf/deg"),
    "kW": (0.74569987158227, "hp"),
}  # fmt: skip
TABLES = (
    "hydrostatic_table", "sectional_areas", "bonjean_curves", "righting_levers", "cross_curves",
    "criteria", "load_cases", "weights", "resistance_curves", "wave_pattern", "wave_spectrum",
    "knuckle_angles",
)  # fmt: skip


def table(name, path):
    assert bpy.ops.hull.export_table(filepath=str(path), analysis=name) == {"FINISHED"}
    with open(path, newline="", encoding="utf-8-sig") as file:
        return list(csv.reader(file))


def imperial():
    bpy.context.scene.unit_settings.system = "IMPERIAL"


@pytest.fixture
def coaster():
    hull = sample("coaster")
    hull.hull.resistance.method = "MICHELL"
    hull.hull.resistance.speed_to = 8.0
    hull.hull.loading.kg = 5.0
    case = hull.hull.loading.load_cases.add()
    case.name, case.mass_t, case.lcg, case.vcg = "Ballast", 2000.0, 40.0, 4.0
    return hull


@pytest.mark.parametrize("name", TABLES)
def test_numbers_are_those_in_metres(coaster, tmp_path, name):
    metric = table(name, tmp_path / "metric.csv")
    imperial()
    feet = table(name, tmp_path / "feet.csv")
    assert len(metric) == len(feet) > 1
    units = [re.search(r"\[([^\]]+)\]", title) for title in metric[0]]
    own = metric[0].index("unit") if "unit" in metric[0] else None
    turned = 0
    for column, unit in enumerate(units):
        for row, other in zip(metric[1:], feet[1:]):
            word = unit and (row[own] if unit[1] == "see unit" else unit[1])
            size, symbol = SIZES.get(word, (1.0, word))
            assert own is None or other[own] == SIZES.get(row[own], (1.0, row[own]))[1]
            if unit and unit[1] != "see unit":
                assert f"[{symbol}]" in feet[0][column]
            if not unit or not row[column]:
                assert own == column or other[column] == row[column]
                continue
            assert float(other[column]) == pytest.approx(
                float(row[column]) / size, rel=1e-7, abs=1e-9
            )
            turned += size != 1.0
    assert turned > 0


def read_offsets(path):
    """{(station, line's kind, its place in mm, what): m} by hull_io's reader."""
    name = hull_io().__name__
    reader, text = (
        import_module(f"{name}.{module}") for module in ("geometry.offset_tables", "table_text")
    )
    found = reader.parse_offset_table(text.table_rows(path.read_text("utf-8-sig")), path.name)
    size = reader.METRES_PER_UNIT[found.unit]

    def metres(length):
        return length and size * found.in_unit(length)

    places = sorted({metres(length) for length in found.positions.values()})
    offsets = [
        (
            one.line.kind,
            one.line.what,
            round(metres(one.line.position) or 0.0, 4),
            metres(one.value),
        )
        for one in found.offsets
    ]
    return places, offsets


def test_offsets_in_feet_inches_and_eighths(coaster, tmp_path):
    table("offset_table", tmp_path / "metric.csv")
    imperial()
    feet = table("offset_table", tmp_path / "feet.csv")
    assert feet[0][0] == "x from AP [ft]" and not any("mm" in title for title in feet[0])
    cells = [cell for row in feet[1:] for cell in row[1:] if "-" in cell]
    lengths = [cell for cell in cells if re.fullmatch(r"-?\d+-\d+-[0-7][+]?", cell)]
    assert len(lengths) > 100
    (places, one), (other_places, other) = (
        read_offsets(tmp_path / f"{name}.csv") for name in ("metric", "feet")
    )
    np.testing.assert_allclose(other_places, places, atol=1e-6)
    assert [row[:3] for row in one] == [row[:3] for row in other] and len(one) > 100
    # Half a sixteenth of an inch, and the tenths of a millimetre of the metric table.
    away = [abs(mine[3] - theirs[3]) for mine, theirs in zip(one, other)]
    assert max(away) < 0.0254 / 32 + 1e-4
    feet_text = part("features.lines.feet_offsets").feet_text
    assert feet_text(5 * FOOT + 3.5 * 0.0254) == "5-3-4"
    assert feet_text(-(0.0254 * 11 + 0.0254 * 15.6 / 16)) == "-1-0-0"
    assert feet_text(0.0254 / 16) == "0-0-0+"
