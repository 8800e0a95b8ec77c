# SPDX-License-Identifier: GPL-3.0-or-later
"""Points that are no real numbers are refused by everything that takes points, in the same words,
and nothing is written."""

from fractions import Fraction
from pathlib import Path

import all_writers
import hull_io
import hull_native as hn
import numpy as np
import pytest
from all_writers import CUBE, QUADS, WRITERS
from hull_io.real_points import real_points

# Of those that take points themselves.
WRITING = [(name, ending) for name, ending in all_writers.CASES if name.startswith("hull_io.")]


def hull_whose_points_became(points):
    data = all_writers.hull_of(CUBE)
    data.points = points
    return data


TAKING = {
    "panel_areas": lambda points: hull_io.panel_areas(points, QUADS),
    "HullData": all_writers.hull_of,
    "shell_arrays": lambda points: hull_io.shell_arrays(hull_whose_points_became(points)),
    "write_hull_file": lambda points: hull_io.write_hull_file(
        hull_whose_points_became(points), Path("no") / "file"
    ),
    "write_freeship": lambda points: hull_io.write_freeship(
        hull_whose_points_became(points), Path("no") / "file"
    ),
    "real_points": real_points,
}
WRONG = {
    "complex": (CUBE + 1e-30j, "not of complex ones"),
    "text": (CUBE.astype(str), "not of text"),
    "bytes": (CUBE.astype(bytes), "not of text"),
    "text among objects": (CUBE.astype(str).astype(object), "not of text"),
    "complex objects": ((CUBE + 1j).astype(object), ""),
    "dates": (CUBE.astype("M8[s]"), ""),
    "ragged": ([[1.0, 2.0], [1.0]], ""),
    "none": (None, ""),
}
wrong = pytest.mark.parametrize("kind", WRONG)


def refused(take, kind):
    points, words = WRONG[kind]
    with pytest.raises(ValueError) as told:
        take(points)
    assert str(told.value).startswith(f"points must be an array of real numbers{words and ', '}")
    assert words in str(told.value)
    # As the core says it.
    with pytest.raises(ValueError) as core:
        hn.ControlMesh(points, [4], [0, 1, 2, 3])
    assert str(told.value) == str(core.value)


@wrong
@pytest.mark.parametrize("name, ending", WRITING)
def test_writers_refuse_what_is_no_real_number(name, ending, kind, tmp_path):
    path = tmp_path / f"file{ending}"
    WRITERS[name].write(path, CUBE)
    before = {one: one.read_bytes() for one in tmp_path.iterdir()}
    refused(lambda points: WRITERS[name].write(path, points), kind)
    assert {one: one.read_bytes() for one in tmp_path.iterdir()} == before


@wrong
@pytest.mark.parametrize("name", TAKING)
def test_what_takes_points_refuses_them(name, kind):
    refused(TAKING[name], kind)


@pytest.mark.parametrize("same", [
    lambda points: points.astype(np.float32),
    lambda points: points.astype(int),
    lambda points: points.astype(bool),
    lambda points: points.tolist(),
    lambda points: [[Fraction(int(x)) for x in point] for point in points],
    np.asfortranarray,
])  # fmt: skip
def test_other_kinds_of_real_numbers_serve(same, tmp_path):
    for name, ending in WRITING:
        paths = [tmp_path / f"{which}{ending}" for which in ("own", "same")]
        for path, points in zip(paths, (CUBE, same(CUBE))):
            WRITERS[name].write(path, points)
        own, other = (
            (tmp_path / all_writers.made_first(name, path.stem.split(".")[0], ending)).read_bytes()
            for path in paths
        )
        assert own == other, name
