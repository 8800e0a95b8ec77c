# SPDX-License-Identifier: GPL-3.0-or-later
"""A lines plan in feet: the same drawing as in metres, with other words."""

import re

import numpy as np
import pytest
from lines_plans import ROOT, draw, dxf_of, read

FOOT, INCH = 0.3048, 0.0254
OFFSET = re.compile(r"(-?)(\d+)-(\d+)-(\d)(\+?)")


@pytest.fixture(scope="module")
def coaster():
    return read(ROOT / "samples" / "coaster.hull.json")


def words(hull, folder, **options):
    """The texts of a plan, in the order in which they are drawn."""
    folder.mkdir()
    document = dxf_of(hull, folder, particulars=(), **options)
    return [text.dxf.text for text in document.modelspace().query("TEXT")]


def metres_of(offset):
    sign, feet, inches, eighths, sixteenth = OFFSET.fullmatch(offset).groups()
    inches = int(inches) + int(eighths) / 8 + (1 / 16 if sixteenth else 0)
    return (-1.0 if sign else 1.0) * (int(feet) * FOOT + inches * INCH)


@pytest.fixture(scope="module")
def both(coaster, tmp_path_factory):
    """(texts in metres, texts in feet)."""
    folder = tmp_path_factory.mktemp("plans")
    return [words(coaster, folder / unit, lengths_in=unit, paper="A1") for unit in ("m", "ft")]


def test_every_word_is_there_in_the_other_unit(both):
    metric, feet = both
    assert "Lengths in metres" in metric and "Lengths in feet" in feet
    assert "Table of offsets, moulded, feet-inches-eighths" in feet
    assert {"Half-breadths, WL ft", "Heights, buttock ft"} <= set(feet)
    assert "600 mm" in metric and "23.622 in" in feet  # between frames
    assert not [text for text in feet if "metre" in text or "mm" in text]


def numbers(texts, pattern):
    return sorted(float(found[1]) for text in texts if (found := re.fullmatch(pattern, text)))


def test_places_of_lines_are_the_same(both):
    metric, feet = both
    places = numbers(metric, r"(?:DWL )?(\d+\.\d+) m")
    assert len(places) > 8
    np.testing.assert_allclose(
        numbers(feet, r"(?:DWL )?(\d+\.\d+) ft"), np.array(places) / FOOT, atol=2e-3
    )


def test_offsets_are_the_same(both):
    """To a thirty-second of an inch and half a millimetre: words follow in one order."""
    metric, feet = both
    assert len(metric) == len(feet)
    pairs = [(a, b) for a, b in zip(metric, feet) if OFFSET.fullmatch(b)]
    assert len(pairs) > 200
    for millimetres, offset in pairs:
        assert abs(1e-3 * int(millimetres) - metres_of(offset)) <= INCH / 32 + 5e-4 + 1e-12


def test_the_scale_bar_is_in_feet(both):
    """Its last mark has the unit, and is five times a round number."""
    (last,) = [text for text in both[1] if re.fullmatch(r"\d+ ft", text)]
    part = float(last.split()[0]) / 5.0
    mantissa = part / 10 ** np.floor(np.log10(part))
    assert min(abs(mantissa - one) for one in (1.0, 2.0, 5.0)) < 1e-12


def test_another_unit_is_refused(coaster, tmp_path):
    with pytest.raises(ValueError, match='lengths_in is "m" or "ft"'):
        draw(coaster, tmp_path / "plan.pdf", lengths_in="yd")
    assert not list(tmp_path.iterdir())
