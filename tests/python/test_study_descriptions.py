# SPDX-License-Identifier: GPL-3.0-or-later
"""Descriptions of studies: samplings, and what is no study is refused by its key."""

import json
from pathlib import Path

import numpy as np
import pytest
from coaster_study import described
from hull_studies import study_from
from hull_studies.sampling import variants

ROOT = Path(__file__).resolve().parents[2]
SAMPLES = ROOT / "samples"
SEED = 20261124
COASTER = "coaster.hull.json"


# --- sampling ---


def test_a_latin_hypercube_has_each_part_of_each_range_once():
    bounds = {"a": (-1.0, 3.0), "b": (10.0, 10.5), "c": (0.0, 1e6)}
    sampling = {"kind": "latin", "count": 50, "seed": SEED}
    found = np.array(variants(sampling, bounds))
    assert found.shape == (50, 3)
    low, high = np.array(list(bounds.values())).T
    parts = np.floor((found - low) / (high - low) * 50).astype(int)
    assert (np.sort(parts, axis=0) == np.arange(50)[:, None]).all()
    assert variants(sampling, bounds) == variants(dict(sampling), bounds)
    assert variants({**sampling, "seed": 1}, bounds) != variants(sampling, bounds)


def test_a_grid_has_all_combinations_with_ends():
    found = variants({"kind": "grid", "steps": {"a": 3, "b": 2, "c": 1}},
                     {"a": (0.0, 1.0), "b": (-1.0, 1.0), "c": (4.0, 6.0)})  # fmt: skip
    assert found == [
        (0.0, -1.0, 5.0), (0.0, 1.0, 5.0), (0.5, -1.0, 5.0),
        (0.5, 1.0, 5.0), (1.0, -1.0, 5.0), (1.0, 1.0, 5.0),
    ]  # fmt: skip


def test_random_values_are_in_their_ranges():
    found = np.array(variants({"kind": "random", "count": 400, "seed": SEED}, {"a": (2.0, 4.0)}))
    assert found.min() >= 2.0 and found.max() < 4.0
    # The mean of 400 uniform ones: five standard deviations.
    assert abs(found.mean() - 3.0) < 5 * 2 / np.sqrt(12 * 400)


# --- what is no study ---

FIELD = {"base": "point", "point": [64, 6, 4], "shift": [0, 1, 0], "extent": 9}
TARGET = {"number": "lcb", "value": 41}
TARGETS = {"change": "targets", "targets": [TARGET]}


def _with_field(**changed):
    return {"change": "fields", "fields": [{**FIELD, **changed}]}


@pytest.mark.parametrize(
    "changed, said",
    [
        ({"colour": 1}, 'the key "colour" is unknown'),
        ({"hulls": []}, "the first is no file"),
        ({"hulls": [{"changes": []}]}, "the first is no file"),
        ({"hulls": ["nowhere.json"]}, "nowhere.json: it can't be opened"),
        (
            {"hulls": [COASTER, {"changes": [{"change": "targets", "targets": ["$a"]}]}]},
            "no object",
        ),
        ({"variables": {"a": [1, 0]}}, "variables.a: 1 is above 0"),
        ({"variables": {"a": [0, float("nan")]}}, "no plain data"),
        ({"variables": {"a": [0, 10**400]}}, "variables.a: .* is not a number from"),
        ({"variables": {"a": [0, 1], "b": [0, 1]}}, "variables.b: nothing varies with it"),
        ({"sampling": None}, "sampling: NoneType is no object"),
        ({"sampling": {"kind": "sobol"}}, 'sampling.kind: "sobol" is unknown'),
        ({"sampling": {"kind": "latin", "count": 0}}, "sampling.count: .* 1 to 1000000"),
        ({"sampling": {"kind": "latin", "count": True}}, "sampling.count"),
        ({"sampling": {"kind": "grid", "steps": {"a": 2, "z": 3}}}, 'the key "z" is unknown'),
        ({"sampling": {"kind": "list", "rows": [[1, 2]]}}, "2 entries, not 1"),
        ({"sampling": {"kind": "list", "rows": []}}, "no rows"),
        ({"changes": [{"change": "polish"}]}, 'changes\\[0\\].change: "polish" is unknown'),
        ({"changes": [{"change": "weights", "weights": ["$a"]}]}, "the study has one hull"),
        ({"changes": [{"change": "dimensions", "beam": "$b"}]}, "variables: \\$a"),
        ({"changes": [{"change": "dimensions"}]}, "it has no dimension"),
        ({"changes": [{"change": "sections", "block": 1, "volume": 1}]}, "say the same"),
        ({"changes": [{"change": "sections"}]}, "nothing is wanted"),
        ({"changes": [_with_field(base="sphere")]}, 'base: "sphere" is unknown'),
        ({"changes": [_with_field(point=[1, 2])]}, "2 entries, not 3"),
        ({"changes": [_with_field(axes="$a")]}, 'axes: "\\$a" names no axes; write letters of x'),
        ({"changes": [_with_field(cells=[1])]}, 'the key "cells" is unknown'),
        ({"changes": [{"change": "targets", "targets": []}]}, "it has none"),
        ({"changes": [{"change": "targets", "targets": [{**TARGET, "number": "x"}]}]}, "unknown"),
        ({"changes": [{"change": "targets", "targets": [{**TARGET, "station": 1}]}]}, "no station"),
        ({"changes": [{"change": "targets", "targets": [TARGET], "moves": "weights"}]}, "family"),
        ({"water": {"draft": "deep"}}, "water.draft"),
        (
            {"water": {"draft": 2.0}, "changes": [{**TARGETS, "draft_scale": ["$a", 1]}]},
            "changes\\[0\\].draft_scale: it would scale the water, whose draft the study fixes",
        ),
        ({"numbers": ["displaced_volume", "price"]}, "numbers\\[1\\]: it is no number of hydro"),
    ],
)
def test_what_is_no_study_is_told_with_its_key(changed, said):
    base = {
        "hulls": [COASTER],
        "variables": {"a": [0.0, 1.0]},
        "sampling": {"kind": "latin", "count": 4, "seed": 1},
        "changes": [{"change": "dimensions", "beam": "$a"}],
    }
    study_from(base, SAMPLES)
    with pytest.raises(ValueError, match=said):
        study_from({**base, **changed}, SAMPLES)


def test_digests_are_of_what_rows_depend_on(tmp_path):
    text = (SAMPLES / COASTER).read_text()
    (tmp_path / "other name.json").write_text(text)
    description = described(10, 1)
    first = study_from(description, SAMPLES)
    turned = json.loads(json.dumps(description, sort_keys=True))
    turned["variables"] = description["variables"]  # whose order is that of values
    assert study_from(turned, SAMPLES).digest == first.digest
    moved = {**description, "hulls": ["other name.json", *description["hulls"][1:]]}
    assert study_from(moved, tmp_path).digest == first.digest
    (tmp_path / "other name.json").write_text(text.replace("8.1]", "8.1001]", 1))
    changed = study_from(moved, tmp_path)
    assert changed.digest != first.digest
    assert [key for key in first.parts if first.parts[key] != changed.parts[key]] == ["hulls"]
    assert study_from(described(11, 1), SAMPLES).digest != first.digest
