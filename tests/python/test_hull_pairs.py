# SPDX-License-Identifier: GPL-3.0-or-later
"""All pairs of seagoing hulls, samples and FREE!ship's, as parents of a family: each is made, with
distances both ways within the tolerance and no member folded, or it is said why, and what to do.

HULL_ALL_PAIRS=1 tries all of them, each hull's layout on each other one; a few otherwise.
"""

import itertools
import os
import re
from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest
import vessels

FOLDER = Path(__file__).resolve().parents[3] / "shared" / "hulls" / "freeship"
SEED, FEW = 20261124, 2
SAMPLES = (
    "coaster", "container_ship", "bulk_carrier", "roro", "research_vessel", "naval_vessel",
)  # fmt: skip
OTHERS = tuple(f"FREE!ship demo {number}" for number in (3, 4, 6))
# The bar keel of the one would fold on the other, if its strip did not keep its breadth.
BARRED = ("container_ship", "research_vessel")
# Of the length, both ways: the tolerance of fit_layout().
MET = 1e-4
MEMBERS = np.linspace(0.0, 1.0, 11)
# What can be done.
REMEDY = re.compile(
    "pair by hand|pair the two by hand|mirror the half|leave out of the|all lines are"
)
REMARK = re.compile("nothing is paired with .*: pair it by hand")


def chosen():
    pairs = list(itertools.permutations(SAMPLES + OTHERS, 2))
    if os.environ.get("HULL_ALL_PAIRS") == "1":
        return pairs
    order = np.random.default_rng(SEED).permutation(len(pairs))
    return [BARRED, *(pairs[k] for k in order[:FEW])]


def surface_of(name):
    if name in SAMPLES:
        return vessels.vessel(name).surface
    path = FOLDER / f"{name}.fbm"
    if not path.exists():
        pytest.skip(f"{path} is not here")
    return vessels.surface_of(hull_io.read_hull(path))


@pytest.mark.parametrize("names", chosen(), ids=" on ".join)
def test_pairs_are_made_or_it_is_said_what_to_do(names):
    first, second = map(surface_of, names)
    length = float(np.ptp(second.mesh.points[:, 0]))
    print(SEED, names)
    try:
        fit = hn.fit_layout(first, second)
    except ValueError as error:
        print(error)
        assert REMEDY.search(str(error))
        return
    off = max(fit.rms, fit.rms_back) / length
    print(fit.rms / length, fit.rms_back / length, fit.subdivisions, fit.fold, fit.shortfall)
    assert all(REMARK.search(remark) for remark in fit.match.remarks)
    if off > MET or fit.fold is not None:
        assert REMEDY.search(fit.shortfall)
        assert ("embers are folded" in fit.shortfall) == (fit.fold is not None)
        return
    assert fit.shortfall == ""
    check_members(fit, length)


def check_members(fit, length):
    """No member is folded, and halves stay halves."""
    family = hn.HullFamily([fit.first, fit.second])
    for t in MEMBERS:
        points = family.points([1.0 - t, t])
        assert family.first_fold(points) is None
        if fit.first.mesh.points[:, 1].min() >= 0.0:
            assert points[:, 1].min() >= -1e-9 * length
