# SPDX-License-Identifier: GPL-3.0-or-later
"""A wave that is not as deep as before is no new mark: where a line bent to the other side between
two inflections and only bends less then, that flat spot was more than one before."""

import hull_native as hn
import numpy as np
import pytest
from hull_fairness import changes, lines
from transformation_hulls import grid_mesh

BEAM, BEND = 10.0, 0.01  # m, 1/m


@pytest.fixture(autouse=True)
def only_waterlines(monkeypatch):
    monkeypatch.setattr(lines, "PLANES", {"waterline": ("z", 2)})
    monkeypatch.setattr(lines, "_features", lambda *wanted: ())
    monkeypatch.setattr(lines, "reflection_lines", lambda *wanted: ())


def wall(*bends):
    """An upright wall of 40 m whose waterlines bend by -BEND, but by factor · BEND between x of
    each of bends (from, to, factor), the later ones upon the former."""
    x = np.linspace(0.0, 40.0, 161)
    bend = np.full(len(x), -BEND)
    for start, end, factor in bends:
        bend[(x >= start) & (x <= end)] = factor * BEND
    step = x[1] - x[0]
    slope = step * np.cumsum(bend)
    y = BEAM / 2.0 + step * np.cumsum(slope - slope.mean())
    heights = np.linspace(0.0, 2.0, 4)
    rows = [np.stack([x, y, np.full(len(x), z)], axis=-1) for z in heights]
    return hn.LimitSurface(grid_mesh(np.stack(rows, axis=1)))


def new_marks(before, after):
    """[(line, mark, x)] that are new."""
    known = changes.Known(before, BEAM)
    new = known.compared(lines.judged(after, BEAM), after).new
    return [(one.line.name, one.found.mark, one.place[0]) for one in new]


def test_what_is_left_of_a_wave_is_not_new():
    wave, left = wall((15.0, 25.0, 1.0)), wall((15.0, 25.0, -0.3))
    found = [one.mark for line in lines.judged(left, BEAM) for one in line.found]
    assert found == ["dip", "dip"]
    assert new_marks(wave, left) == []
    # The other way round it is worse.
    assert {mark for _, mark, _ in new_marks(left, wave)} == {"inflection"}


def test_a_flat_spot_elsewhere_is_new():
    new = new_marks(wall((5.0, 12.0, 1.0)), wall((24.0, 32.0, -0.3)))
    assert len({line for line, _, _ in new}) == len(new) == 2
    assert all(mark == "dip" and 24.0 < x < 32.0 for _, mark, x in new)


def test_a_flat_spot_of_the_wave_itself_is_new():
    """It is of the side to which the line bent between the inflections; these moved away."""
    new = new_marks(wall((15.0, 25.0, 1.0)), wall((8.0, 32.0, 1.0), (17.0, 23.0, 0.2)))
    dips = [x for _, mark, x in new if mark == "dip"]
    assert len(dips) == 2 and all(17.0 < x < 23.0 for x in dips)
