# SPDX-License-Identifier: GPL-3.0-or-later
"""Of labels that would cover one another the nearest is written."""

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


def test_no_labels(written):
    assert written(np.empty((0, 2)), np.empty((0, 2)), np.empty(0)).shape == (0,)


def test_crowds_of_labels(written):
    rng = np.random.default_rng(SEED)
    print("seed", SEED)
    for count in (10, 100, 600):
        corners = rng.uniform(-300.0, 300.0, (count, 2))
        sizes = rng.uniform(5.0, 40.0, (count, 2))
        depths = rng.permutation(count)
        is_written = written(corners, sizes, depths)
        meet = overlaps(corners, sizes) & ~np.eye(count, dtype=bool)
        assert not meet[np.ix_(is_written, is_written)].any()
        nearer = depths[None] < depths[:, None]
        assert (is_written == ~(meet & nearer & is_written[None]).any(axis=1)).all()
        # In any order.
        order = rng.permutation(count)
        assert (written(corners[order], sizes[order], depths[order]) == is_written[order]).all()
