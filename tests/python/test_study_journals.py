# SPDX-License-Identifier: GPL-3.0-or-later
"""Journals of studies: rows survive whatever ends a run, at any byte; what is no journal of the
study is refused and left as it is."""

import errno
import fcntl
import json
import os
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from hull_studies.evaluation import Row
from hull_studies.journal import Expected, Journal, variant_key

SEED = 20261124
COLUMNS = ("volume", "lcb")
STUDY = SimpleNamespace(digest="d" * 64, parts={"sampling": "s", "changes": "c"}, name="A study")
KEYS = [variant_key(STUDY.digest, (0.1 * k, 1.0 / 3.0)) for k in range(6)]
EXPECTED = Expected(STUDY, frozenset(KEYS), COLUMNS)
ROWS = {
    KEYS[0]: Row("made", "", {"volume": 1.0 / 3.0, "lcb": 5e-324}),
    KEYS[1]: Row("missed", "lcb is 1e-3 too small; ∇ too.", {"volume": 1e300, "lcb": None}),
    KEYS[2]: Row("refused", "The member is\nfolded.", {}),
    KEYS[3]: Row("made", "", {"volume": -0.0, "lcb": 0.1 + 0.2}),
}


@pytest.fixture
def path(tmp_path):
    return tmp_path / "study.jsonl"


def written(path, rows=ROWS):
    with Journal(path, EXPECTED) as journal:
        for key, row in rows.items():
            journal.add({key: row})
    return path.read_bytes()


def read(path, expected=EXPECTED):
    with Journal(path, expected) as journal:
        return dict(journal.rows)


def test_rows_come_back_bit_by_bit(path):
    data = written(path)
    assert data.count(b"\n") == 1 + len(ROWS)
    assert repr(read(path)) == repr(ROWS)
    assert path.read_bytes() == data


def test_a_journal_cut_off_at_any_byte_goes_on(path):
    data = written(path)
    ends = [k + 1 for k in range(len(data)) if data[k : k + 1] == b"\n"]
    for length in range(len(data) + 1):
        path.write_bytes(data[:length])
        whole = max(sum(end <= length for end in ends) - 1, 0)
        with Journal(path, EXPECTED) as journal:
            assert list(journal.rows) == KEYS[:whole]
            journal.add({key: ROWS[key] for key in KEYS[whole:4]})
        assert path.read_bytes() == data


def test_what_is_no_journal_is_left_alone(path):
    for data in (b"x,y\n1,2\n", b"\x00" * 5000, b'{"journal":1}\n', b"{", b"[" * 10**6):
        if written(path).startswith(data):
            continue
        path.write_bytes(data)
        with pytest.raises(ValueError, match="study.jsonl: it is no journal of a study; take ano"):
            read(path)
        assert path.read_bytes() == data
        path.unlink()


def test_another_study_is_told_by_what_differs(path):
    data = written(path)
    other = SimpleNamespace(digest="e" * 64, parts={**STUDY.parts, "sampling": "t"}, name="Two")
    with pytest.raises(ValueError, match=r"another study \(sampling differ\); take another file"):
        read(path, Expected(other, frozenset(KEYS), COLUMNS))
    assert path.read_bytes() == data
    path.write_bytes(data.replace(b'"version":1', b'"version":2', 1))
    with pytest.raises(ValueError, match="of another version"):
        read(path)


GOOD = {"key": KEYS[4], "status": "made", "reason": "", "numbers": {"volume": 1.0, "lcb": 2.0}}


@pytest.mark.parametrize(
    "line, said",
    [
        (b"", "it is not JSON"),
        (b"\xff\xfe", "it is not UTF-8"),
        (b"[1]", "is no object"),
        (b"[" * 200_000, "nested too deep"),
        (b'{"key":' + b"1" * 10_000 + b"}", "too many digits|no variant"),
        ({**GOOD, "key": "0" * 32}, "of no variant"),
        ({**GOOD, "key": ["a"]}, "of no variant"),
        ({**GOOD, "key": KEYS[0]}, "line 6 has a row that is there before"),
        ({**GOOD, "status": "done"}, 'status: "done" is unknown'),
        ({**GOOD, "status": {}}, "status"),
        ({**GOOD, "reason": None}, "reason"),
        ({**GOOD, "more": 1}, 'the key "more" is unknown'),
        ({**GOOD, "numbers": {"volume": 1.0}}, "there are 1"),
        ({**GOOD, "numbers": {"volume": 1.0, "lcb": 2.0, "x": 1.0}}, 'the key "x" is unknown'),
        ({**GOOD, "numbers": {"volume": 1.0, "lcb": True}}, "one is no number"),
        ({**GOOD, "numbers": {"volume": 1.0, "lcb": "2"}}, "one is no number"),
        ({**GOOD, "status": "refused"}, "there are 2"),
        (json.dumps(GOOD).replace("2.0", "NaN").encode(), "NaN is not a number"),
        (json.dumps(GOOD).replace("2.0", "1e999").encode(), "one is no number"),
        (b'{"key":"' + b"a" * 2**21 + b'"}', "longer than any row"),
    ],
)
def test_hostile_lines_are_told_and_left(path, line, said):
    data = written(path) + (line if isinstance(line, bytes) else json.dumps(line).encode()) + b"\n"
    path.write_bytes(data)
    with pytest.raises(ValueError, match=said):
        read(path)
    assert path.read_bytes() == data


def test_changed_bytes_give_rows_of_the_study_or_a_sentence(path):
    data = written(path)
    random = np.random.default_rng(SEED)
    refused = 0
    for _ in range(400):
        changed = bytearray(data)
        for place in random.integers(0, len(data), random.integers(1, 4)):
            changed[place] = random.integers(0, 256)
        path.write_bytes(changed)
        try:
            rows = read(path)
        except ValueError as error:
            refused += 1
            assert path.read_bytes() == changed
            assert "\n" not in str(error) and str(error).startswith("study.jsonl")
        else:
            assert set(rows) <= set(KEYS)
    print(SEED, refused)
    assert refused > 100


def test_one_run_at_a_time(path):
    with Journal(path, EXPECTED):
        with pytest.raises(ValueError, match="another run has it open"):
            read(path)
    assert read(path) == {}


def test_a_disk_that_keeps_no_file_for_one_run_is_told(path, monkeypatch):
    def fail(*arguments):
        raise OSError(errno.ENOLCK, os.strerror(errno.ENOLCK))

    monkeypatch.setattr(fcntl, "flock", fail)
    with pytest.raises(ValueError, match=r"kept for this run alone \(No locks available\); take"):
        read(path)


def test_places_that_are_no_files(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    for place in (
        tmp_path,
        tmp_path / "none" / "study.jsonl",
        tmp_path / "pipe",
        Path("/dev/null"),
    ):
        with pytest.raises(ValueError, match="can't be opened|is not a file"):
            read(place)
