# SPDX-License-Identifier: GPL-3.0-or-later
"""The front of a study: against the comparison of all with all, and its picture."""

from pathlib import Path
from types import SimpleNamespace

import hull_native as hn
import numpy as np
import pytest
from hull_studies import Table, front_plot, pareto_front
from hull_studies.evaluation import Row

SEED = 20261124


def surpassed(x, y, k, senses):
    """Whether another point is as good in both and better in one, by looking at each."""
    signs = [1 if sense == "least" else -1 for sense in senses]
    a, b = signs[0] * x, signs[1] * y
    as_good = (a <= a[k]) & (b <= b[k])
    return bool((as_good & ((a < a[k]) | (b < b[k]))).any())


@pytest.mark.parametrize("senses", [(a, b) for a in ("least", "most") for b in ("least", "most")])
@pytest.mark.parametrize("levels", [4, 1000])
def test_the_front_is_what_none_surpasses(senses, levels):
    random = np.random.default_rng([SEED, levels])
    for count in (1, 2, 50, 200):
        x, y = random.integers(0, levels, (2, count)).astype(float)
        found = pareto_front(x, y, senses)
        expected = [k for k in range(count) if not surpassed(x, y, k, senses)]
        assert sorted(found) == expected
        assert (np.diff(x[found]) >= 0).all()


def test_what_is_no_number_or_not_among_them_does_not_count():
    x, y = [np.nan, 1.0, 2.0, 0.0], [0.0, 1.0, np.inf, 0.0]
    assert list(pareto_front(x, y)) == [3]
    assert list(pareto_front(x, y, among=[True, True, True, False])) == [1]
    assert len(pareto_front([], [])) == 0
    with pytest.raises(ValueError, match='"least" or "most", not "best"'):
        pareto_front([1.0], [1.0], ("best", "least"))
    with pytest.raises(ValueError, match="one shape"):
        pareto_front([1.0], [1.0, 2.0])


@pytest.fixture
def table():
    random = np.random.default_rng(SEED)
    values = random.random((40, 2))
    rows = [Row("made", "", {"a": float(a), "b": float(b)}) for a, b in values]
    rows[3] = Row("refused", "It folds.", {})
    rows[4] = Row("missed", "b is 0, 1 too small.", {"a": 0.0, "b": 0.0})
    study = SimpleNamespace(name="Two numbers", variables={"v": (0, 1)}, variants=[(0.5,)] * 40)
    return Table(study, ["a", "b"], rows)


@pytest.mark.parametrize("ending", ["svg", "pdf", "png"])
def test_a_front_is_drawn(table, ending, tmp_path):
    plot, front = front_plot(table, "a", "b", ("least", "most"), labels=(("A", "m"), ("B", "")))
    assert plot.subtitles == ["40 variants: 38 made, 1 missed, 1 refused"]
    assert 4 not in front and 3 not in front
    path = Path(tmp_path / f"front.{ending}")
    hn.write_plot(plot, path)
    assert path.stat().st_size > 1000


def test_a_front_of_nothing_is_drawn(table, tmp_path):
    none = [Row("refused", "It folds.", {})] * 40
    plot, front = front_plot(Table(table.study, ["a", "b"], none), "a", "b")
    assert len(front) == 0
    hn.write_plot(plot, tmp_path / "front.svg")
    with pytest.raises(
        ValueError, match="The table has no numbers 'c': it has variant, \\$v, a, b"
    ):
        front_plot(table, "a", "c")
