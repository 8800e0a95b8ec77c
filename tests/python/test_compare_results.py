# SPDX-License-Identifier: GPL-3.0-or-later
"""The comparison of results tells each bit that differs, and nothing else."""

import json
import sys

import compare_results
import numpy as np
import pytest

NUMBERS = np.array([1.0, -2.5, np.nan, 0.0])


def found_between(before, after):
    (one,) = compare_results.records(before).values()
    (other,) = compare_results.records(after).values()
    return compare_results.difference(one, other)


def test_equal_results_are_equal():
    assert found_between(NUMBERS, NUMBERS.copy()) is None
    assert found_between("at 1.25 m", "at 1.25 m") is None


def test_the_last_bit_is_told():
    moved = NUMBERS.copy()
    moved[1] = np.nextafter(moved[1], 0.0)
    told = found_between(NUMBERS, moved)
    assert told == "1 of 4 numbers differ, by up to 4.44e-16 (1.8e-16 of the greatest)"
    assert "sign of zeros" in found_between(NUMBERS, np.array([1.0, -2.5, np.nan, -0.0]))


def test_numbers_in_texts_are_compared_as_numbers():
    assert "by up to 0.5" in found_between("at 1.25 m", "at 1.75 m")
    assert "words" in found_between("at 1.25 m", "near 1.25 m")


def test_shapes_and_undefined_values_are_told():
    assert "shape" in found_between(NUMBERS, NUMBERS.reshape(2, 2))
    assert "in one only" in found_between(NUMBERS, np.array([1.0, -2.5, 0.0, 0.0]))


def test_all_of_complex_numbers_and_of_large_integers_is_compared():
    assert "1 of 4 numbers differ, by up to 1 " in found_between(
        np.array([1.0 + 2.0j, 3.0]), np.array([1.0 + 3.0j, 3.0])
    )
    assert found_between(1.0j, 1.0j) is None
    for kind in (np.int64, np.uint64):
        large = np.array([2**53, 2**62 + 1], dtype=kind)
        assert found_between(large, large.copy()) is None
        assert "by up to 1 " in found_between(large, large + np.array([0, 1], dtype=kind))
    # As it was written of all that doubles hold.
    record = compare_results.records(np.array([3, 2**53]))[""]
    assert record["count"] == 2 and compare_results.numbers_of(record).tolist() == [3.0, 2.0**53]
    assert "shape" in found_between(np.array([2**53]), np.array([2**53 + 1]))


def test_what_is_in_one_only_is_not_taken_off_what_is_equal(capsys):
    one, other = (compare_results.records(value)[""] for value in (1.0, 2.0))
    before = {"a: b: c": one, "a: b: d": one, "a: b: e": one}
    assert compare_results.compare(before, {"a: b: c": one, "a: b: d": other, "a: b: f": one}) == 3
    assert "1 of 3 results are bit-equal, 3 differ" in capsys.readouterr().out


def test_subjects_are_chosen_of_both_files(tmp_path, monkeypatch, capsys):
    record = compare_results.records(1.0)[""]
    file = tmp_path / "both.json"
    file.write_text(json.dumps({f"coaster: {of}: x": record for of in ("surface", "stability")}))
    words = ["compare_results.py", "--only", "surface", str(file), str(file)]
    monkeypatch.setattr(sys, "argv", words)
    with pytest.raises(SystemExit) as ended:
        compare_results.main()
    assert ended.value.code == 0
    assert "1 of 1 results are bit-equal, 0 differ" in capsys.readouterr().out


@pytest.mark.parametrize(
    "words, told",
    [
        (["--only", "waves", "a.json"], "there is no subject 'waves'; these are: surface, "),
        (["--write", "a.json", "titanic"], "there is no sample 'titanic'; these are: barge, "),
    ],
)
def test_unknown_names_are_told(words, told, monkeypatch, capsys):
    monkeypatch.setattr(sys, "argv", ["compare_results.py", *words])
    with pytest.raises(SystemExit) as ended:
        compare_results.main()
    assert ended.value.code == 2 and told in capsys.readouterr().err


def test_missing_and_new_results_count(capsys):
    before = {"a: b: c.lever": compare_results.records(1.0)[""]}
    assert compare_results.compare(before, {}) == 1
    assert compare_results.compare({}, before) == 1
    after = {compare_results.renamed("a: b: c.gz", {"lever": "gz"}): before["a: b: c.lever"]}
    assert compare_results.compare(before, after) == 0
    assert "1 of 1 results are bit-equal, 0 differ" in capsys.readouterr().out


def test_names_of_either_file_may_be_the_new_ones(tmp_path, monkeypatch, capsys):
    record = compare_results.records(1.0)[""]
    for old, new in (("now", "now"), ("before", "now"), ("now", "before")):
        names = {
            "before": "coaster: stability: all.flooding_heel",
            "now": "coaster: stability: all.downflooding_heel",
        }
        files = [tmp_path / "one.json", tmp_path / "other.json"]
        for file, name in zip(files, (old, new)):
            file.write_text(json.dumps({names[name]: record}), encoding="ascii")
        monkeypatch.setattr(sys, "argv", ["compare_results.py", *map(str, files)])
        with pytest.raises(SystemExit) as ended:
            compare_results.main()
        assert ended.value.code == 0, (old, new)
        assert "1 of 1 results are bit-equal, 0 differ" in capsys.readouterr().out
