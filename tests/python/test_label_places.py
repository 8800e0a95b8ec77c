# SPDX-License-Identifier: GPL-3.0-or-later
"""Of labels that would cover one another the nearest is written, and none over marks."""

import importlib.util
from pathlib import Path

import numpy as np
import pytest

FILE = Path(__file__).resolve().parents[2] / "addon" / "hull_tools" / "overlays" / "label_places.py"
SEED = 20261123


@pytest.fixture(scope="module")
def written():
    spec = importlib.util.spec_from_file_location("label_places", FILE)
    label_places = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(label_places)
    return label_places.written


def overlaps(corners, sizes):
    """(n, n) which of boxes overlap, each itself too."""
    low, high = corners, corners + sizes
    return ((low[:, None] < high[None]) & (low[None] < high[:, None])).all(axis=2)


def test_the_nearer_of_two_is_written(written):
    corners, sizes = [(0, 0), (3, 4)], [(7, 14), (7, 14)]
    assert written(corners, sizes, [0.2, 0.9]).tolist() == [True, False]
    assert written(corners, sizes, [0.9, 0.2]).tolist() == [False, True]
    assert written(corners, sizes, [0.5, 0.5]).tolist() == [True, False]


def test_labels_that_touch_are_written(written):
    corners, sizes = [(0, 0), (7, 0), (0, 14), (-7, -14)], [(7, 14)] * 4
    assert written(corners, sizes, [1, 2, 3, 4]).all()


def test_one_that_is_not_written_takes_no_room(written):
    # The second gives way to the first, the third overlaps the second alone.
    corners, sizes = [(0, 0), (5, 0), (10, 0)], [(7, 14)] * 3
    assert written(corners, sizes, [1, 2, 3]).tolist() == [True, False, True]


def test_a_wide_label_meets_those_beside_it(written):
    corners, sizes = [(0, 0), (25, 3), (31, 3)], [(30, 14), (7, 14), (7, 14)]
    assert written(corners, sizes, [1, 2, 3]).tolist() == [True, False, True]


def test_what_is_taken_stays_free(written):
    corners, sizes, taken = (
        [(0, 0), (20, 0), (40, 0)],
        [(7, 14)] * 3,
        [(-50, 5, 1, 9), (27, 0, 35, 9)],
    )
    assert written(corners, sizes, [1, 2, 3], taken).tolist() == [False, True, True]


def test_no_labels(written):
    assert written([], [], [], [(0, 0, 1, 1)]).shape == (0,)
    assert written(np.empty((0, 2)), np.empty((0, 2)), np.empty(0)).shape == (0,)


def test_crowds_of_labels(written):
    rng = np.random.default_rng(SEED)
    print("seed", SEED)
    for count in (10, 100, 600):
        corners = rng.uniform(-300.0, 300.0, (count, 2))
        sizes = rng.uniform(5.0, 40.0, (count, 2))
        depths = rng.permutation(count)
        low = rng.uniform(-300.0, 300.0, (count // 5, 2))
        size = rng.uniform(5.0, 60.0, (count // 5, 2))
        taken = np.hstack([low, low + size])
        is_written = written(corners, sizes, depths, taken)
        both = overlaps(np.concatenate([corners, low]), np.concatenate([sizes, size]))
        meet = both[:count, :count] & ~np.eye(count, dtype=bool)
        is_on_taken = both[:count, count:].any(axis=1)
        assert not meet[np.ix_(is_written, is_written)].any()
        nearer = depths[None] < depths[:, None]
        gives_way = (meet & nearer & is_written[None]).any(axis=1)
        assert (is_written == ~(gives_way | is_on_taken)).all()
        # In any order.
        order = rng.permutation(count)
        again = written(corners[order], sizes[order], depths[order], taken[::-1])
        assert (again == is_written[order]).all()
