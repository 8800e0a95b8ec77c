# SPDX-License-Identifier: GPL-3.0-or-later
"""What can't be true of a hull is named, and what is true is not."""

from pathlib import Path

import hull_io
import numpy as np
import pytest
from hull_io import Particulars
from hull_io.plausibility import HALF, KEEL, TAKE, WHOLE, doubts, extents, taken

SAMPLES = Path(__file__).resolve().parents[3] / "samples"
SHIP = Particulars(length_pp=100.0, beam=16.0, draft=6.0, depth=9.0)


def surface(low=(-3.0, 0.0, 0.0), high=(102.0, 8.0, 9.0)):
    """Extents of a block between two corners."""
    axes = [np.linspace(a, b, 21) for a, b in zip(low, high)]
    return extents(np.stack(np.meshgrid(*axes), axis=-1).reshape(-1, 3))


def remedies(found):
    return [doubt.remedy for doubt in found]


def test_a_ship_is_not_doubted():
    assert doubts(SHIP, True, surface(), 0.7, 0.98) == []
    assert doubts(SHIP, False, surface(low=(-3.0, -8.0, 0.0)), 1.0, 1.0) == []
    assert doubts(Particulars(), True, surface()) == []


@pytest.mark.parametrize(
    "block, midship, named", [(1.07, 0.9, ["Cb"]), (0.9, 1.2, ["Cm"]), (1.1, 1.2, ["Cb", "Cm"])]
)
def test_more_than_full(block, midship, named):
    (doubt,) = doubts(SHIP, True, surface(), block, midship)
    assert [name for name in ("Cb", "Cm") if f"{name} is" in doubt.message] == named
    assert doubt.remedy == TAKE and set(doubt.takes) == {"length_pp", "beam"}


def test_both_sides_counted_as_half():
    (doubt,) = doubts(SHIP, True, surface(low=(-3.0, -8.0, 0.0)), 1.07, 1.9)
    assert doubt.remedy == WHOLE and "Both sides" in doubt.message


@pytest.mark.parametrize(
    "low, high, side",
    [(0.0, 8.0, "port"), (-8.0, 0.0, "starboard"), (-0.16, 8.0, "port"), (-8.0, 0.16, "starboard")],
)
def test_one_side_counted_as_whole(low, high, side):
    beam = Particulars(length_pp=100.0, beam=8.0)
    (doubt,) = doubts(beam, False, surface((-3.0, low, 0.0), (102.0, high, 9.0)))
    assert doubt.remedy == HALF and side in doubt.message


@pytest.mark.parametrize(
    "length, is_odd",
    [
        (100.0, False),
        (115.0, False),
        (120.0, True),
        (60, True),
        (64.1, True),
        (80.0, True),
        (88.0, False),
    ],
)
def test_a_length_far_from_the_surface(length, is_odd):
    found = doubts(Particulars(length_pp=length, beam=16.0), True, surface())
    assert remedies(found) == [TAKE] * is_odd
    assert [doubt.takes for doubt in found] == [("length_pp",)] * is_odd


@pytest.mark.parametrize("beam, is_odd", [(16.0, False), (12.0, False), (8.0, True), (32.0, True)])
def test_a_beam_far_from_the_surface(beam, is_odd):
    found = doubts(Particulars(length_pp=100.0, beam=beam), True, surface())
    assert [doubt.takes for doubt in found] == [("beam",)] * is_odd


def test_dimensions_that_are_all_1_m():
    (doubt,) = doubts(Particulars(1.0, 1.0, 1.0), True, surface(), 2000.0)[:1]
    assert doubt.remedy == TAKE and "all 1 m" in doubt.message


def test_a_classic_yacht_s_overhangs_are_no_doubt():
    """A Lpp of 70 m on 105 m, which is that of its waterline."""
    yacht = Particulars(length_pp=70.0, beam=16.0)
    assert doubts(yacht, True, surface(), waterline=71.0) == []
    for length, waterline in ((70.0, 100.0), (70.0, 80.0), (70.0, None), (60.0, 62.0)):
        shorter = Particulars(length_pp=length, beam=16.0)
        (doubt,) = doubts(shorter, True, surface(), waterline=waterline)
        assert (doubt.remedy, doubt.takes) == (TAKE, ("length_pp",))


def test_a_surface_without_length_or_waterline():
    (keel,) = doubts(SHIP, True, surface((5.0, 0.0, 1.0), (5.0, 8.0, 9.0)), waterline=0.0)
    assert keel.remedy == KEEL


@pytest.mark.parametrize("keel, where", [(-2.0, "2 m below"), (3.0, "3 m above")])
def test_a_keel_that_is_not_on_the_base_line(keel, where):
    (doubt,) = doubts(SHIP, True, surface((-3.0, 0.0, keel), (102.0, 8.0, 9.0)))
    assert doubt.remedy == KEEL and where in doubt.message


def test_a_keel_that_rises_from_the_base_line_is_on_it():
    """A skiff's, whose heel is at z = 0; of one that lies higher as a whole it is told."""
    points = np.array(
        [(x, y, 0.02 * x**2 + y) for x in np.linspace(0, 4, 41) for y in (0.0, 0.9)]
    )
    skiff = Particulars(length_pp=4.0, beam=1.8, draft=0.3)
    assert doubts(skiff, True, extents(points)) == []
    (doubt,) = doubts(skiff, True, extents(points + (0.0, 0.0, 0.2)))
    assert doubt.remedy == KEEL and "above the base line" in doubt.message


def test_a_hull_too_full_by_its_keel_is_not_asked_for_its_length():
    """The draft is of 2 m less than is immersed."""
    deep = surface((-3.0, 0.0, -2.0), (102.0, 8.0, 7.0))
    assert remedies(doubts(SHIP, True, deep, 1.094, 1.3)) == [KEEL]
    high = surface((-3.0, 0.0, 1.0), (102.0, 8.0, 10.0))
    assert remedies(doubts(SHIP, True, high, 1.094, 1.3)) == [KEEL, TAKE]


@pytest.mark.parametrize("name", sorted(path.name for path in SAMPLES.glob("*.hull.json")))
def test_samples_have_the_dimensions_of_their_surface(name):
    """By their control points, which reach a little further."""
    data = hull_io.read_hull(SAMPLES / name)
    used = {point for face in hull_io.shell_face_indices(data) for point in data.faces[face]}
    assert doubts(data.particulars, data.half, extents(data.points[sorted(used)])) == []


def test_a_dome_below_the_base_line_is_none():
    hull = np.array([[x, 1.0, z] for x in range(101) for z in (0.0, 9.0)])
    dome = np.array([[x, 0.5, -2.0] for x in range(88, 96)])
    assert doubts(SHIP, False, extents(np.vstack([hull, dome * [1, -1, 1], dome]))) != []
    both = np.vstack([hull * [1, 8, 1], hull * [1, -8, 1], dome])
    assert doubts(SHIP, False, extents(both)) == []


def test_what_is_taken_is_the_surface():
    assert taken(("length_pp", "beam"), True, surface()) == {"length_pp": 105.0, "beam": 16.0}
    assert taken(("beam",), False, surface(low=(-3.0, -8.0, 0.0))) == {"beam": 16.0}
    assert taken(("depth",), True, surface()) == {"depth": 9.0}
