# SPDX-License-Identifier: GPL-3.0-or-later
"""All pairs of seagoing hulls, samples and FREE!ship's, as parents of a family: each is made, with
distances both ways within the tolerance and no member folded, or it is said why, and what to do.

What neither layout of the two does a third hull's does.

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
ALL = os.environ.get("HULL_ALL_PAIRS") == "1"
SEED, FEW = 20261126, 1
SAMPLES = (
    "coaster", "container_ship", "bulk_carrier", "roro", "research_vessel", "naval_vessel",
)  # fmt: skip
OTHERS = tuple(f"FREE!ship demo {number}" for number in (3, 4, 6))
# The bar keel of the one would fold on the other, if its strip did not keep its breadth.
BARRED = ("container_ship", "research_vessel")
# Of the length, both ways: the tolerance of fit_layout().
MET = 1e-4
MEMBERS = np.linspace(0.0, 1.0, 11)
# Whose layouts do not come onto one another, or turn over there, and a third hull whose layout
# comes onto both.
BY_A_THIRD = (
    ("coaster", "bulk_carrier", "roro"),
    ("coaster", "FREE!ship demo 4", "naval_vessel"),
    ("coaster", "FREE!ship demo 6", "naval_vessel"),
    ("container_ship", "bulk_carrier", "research_vessel"),
    ("container_ship", "FREE!ship demo 3", "naval_vessel"),
    ("container_ship", "FREE!ship demo 4", "naval_vessel"),
    ("container_ship", "FREE!ship demo 6", "naval_vessel"),
    ("bulk_carrier", "naval_vessel", "roro"),
    ("bulk_carrier", "FREE!ship demo 3", "roro"),
    ("bulk_carrier", "FREE!ship demo 4", "roro"),
    ("roro", "FREE!ship demo 6", "naval_vessel"),
    ("FREE!ship demo 3", "FREE!ship demo 4", "roro"),
    ("FREE!ship demo 3", "FREE!ship demo 6", "naval_vessel"),
)
# What can be done.
REMEDY = re.compile(
    "pair by hand|pair the two by hand|mirror the half|leave out of the|all lines are"
)
REMARK = re.compile("nothing is paired with .*: pair it by hand")


def chosen():
    pairs = list(itertools.permutations(SAMPLES + OTHERS, 2))
    if ALL:
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
    check_members(hn.HullFamily([fit.first, fit.second]), length)


@pytest.mark.skipif(not ALL, reason="HULL_ALL_PAIRS is not set")
@pytest.mark.parametrize("names", BY_A_THIRD, ids=", ".join)
def test_a_third_layout_makes_what_the_two_do_not(names):
    *hulls, third = [surface_of(name) for name in names]
    made = hn.common_layout(hulls, layout=third)
    for hull, fit in zip(hulls, made.fits):
        length = float(np.ptp(hull.mesh.points[:, 0]))
        print(names, fit.rms / length, fit.rms_back / length, made.subdivisions)
        assert max(fit.rms, fit.rms_back) <= MET * length
        assert fit.shortfall == ""
    check_members(made.family, length)


def check_members(family, length):
    """No member is folded, and halves stay halves."""
    is_half = family.points([1.0, 0.0])[:, 1].min() >= 0.0
    for t in MEMBERS:
        points = family.points([1.0 - t, t])
        assert family.first_fold(points) is None
        if is_half:
            assert points[:, 1].min() >= -1e-9 * length
