# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether points were moved by an affine map: what is told early is what least squares tell."""

import numpy as np
import pytest
from addon_under_test import part

SEED = 24


def plane_keeping():
    return part("features.constraints.plane_keeping")


def by_least_squares(before, after):
    """Whether an affine map fits, as the module says how well it has to."""
    columns = np.column_stack([before, np.ones(len(before))]).astype(np.float64)
    off = np.abs(columns @ np.linalg.lstsq(columns, after, rcond=None)[0] - after).max()
    return off <= plane_keeping()._AFFINE * max(np.abs(before).max(), np.abs(after).max())


def cases():
    random = np.random.default_rng(SEED)
    for _ in range(300):
        count = random.integers(5, 40)
        before = random.uniform(-1.0, 1.0, (count, 3)) * [100.0, 10.0, 10.0]
        if random.random() < 0.3:  # most of them in a plane, or nearly so
            before[: random.integers(0, count)] *= [1.0, 1.0, random.choice([0.0, 1e-6, 1e-3])]
        after = before.copy()
        moved = random.random(count) < random.choice([0.05, 0.3, 0.9])
        size = 10.0 ** random.uniform(-7.0, 1.0)
        after[moved] += size * random.normal(size=(moved.sum(), 3))
        yield before.astype(np.float32), after.astype(np.float32)
        matrix = np.eye(3) + size / 100.0 * random.normal(size=(3, 3))
        yield before.astype(np.float32), (before @ matrix).astype(np.float32)
        # Only what is off a plane through some of the points.
        yield before.astype(np.float32), (before * [1.0, 1.0, 1.0 + size]).astype(np.float32)


def test_early_refusals_are_those_of_least_squares():
    told = 0
    for before, after in cases():
        size = max(np.abs(before).max(), np.abs(after).max())
        is_held = plane_keeping()._is_held(before, after, plane_keeping()._AFFINE * size)
        told += is_held
        if is_held:
            assert not by_least_squares(before, after)
            assert plane_keeping().affine_map(before, after) is None
    assert told > 40


@pytest.mark.parametrize("factors", [(1.2, 1.0, 1.0), (1.0, 0.5, 2.0)])
def test_scaled_points_are_found(factors):
    random = np.random.default_rng(SEED)
    before = random.uniform(0.0, 10.0, (50, 3)).astype(np.float32)
    before[:12, 0] = 0.0  # which stay where they are
    matrix, shift = plane_keeping().affine_map(before, before * np.float32(factors))
    assert matrix == pytest.approx(np.diag(factors), abs=1e-5)
    assert shift == pytest.approx(np.zeros(3), abs=1e-4)
