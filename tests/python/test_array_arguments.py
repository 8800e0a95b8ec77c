# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments that are to be arrays of real numbers: what is none is refused by name."""

from fractions import Fraction

import hull_native as hn
import numpy as np
import pytest

POINTS = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]


def surface():
    return hn.LimitSurface(hn.ControlMesh(POINTS, [4], [0, 1, 2, 3]))


def uv():
    return np.full((1, 2), 0.25)


# The argument's name, a value that serves, and what takes it.
TAKERS = {
    "mesh": ("points", POINTS, lambda value: hn.ControlMesh(value, [4], [0, 1, 2, 3])),
    "set_points": ("points", POINTS, lambda value: surface().set_points(value)),
    "positions": ("uv", uv(), lambda value: surface().positions([0], value)),
    "sections": ("planes", [[1.0, 0.0, 0.0, 0.5]], lambda value: hn.sections(surface(), value)),
    "tree": (
        "points",
        [[0.0, 0.0, 1.0]],
        lambda value: hn.SurfaceTree(surface()).closest_points(value),
    ),
    "ray": (
        "direction",
        [0.0, 0.0, 1.0],
        lambda value: hn.SurfaceTree(surface()).all_ray_hits([0.5, 0.5, -1.0], value),
    ),
}
WRONG = {
    "complex": (lambda value: np.array(value) + 1e-30j, "not of complex ones"),
    "text": (lambda value: np.array(value).astype(str), "not of text"),
    "bytes": (lambda value: np.array(value).astype(bytes), "not of text"),
    "text among objects": (
        lambda value: np.array(value).astype(str).astype(object),
        "not of text",
    ),
    "complex objects": (lambda value: (np.array(value) + 1j).astype(object), ""),
    "dates": (lambda value: np.array(value).astype("M8[s]"), ""),
    "ragged": (lambda value: [[1.0, 2.0], [1.0]], ""),
    "none": (lambda value: None, ""),
    "a dictionary": (lambda value: {"points": value}, ""),
}


@pytest.mark.parametrize("taker", TAKERS)
@pytest.mark.parametrize("wrong", WRONG)
def test_what_is_no_array_of_real_numbers_is_refused_by_name(taker, wrong):
    name, value, take = TAKERS[taker]
    take(value)
    spoil, words = WRONG[wrong]
    with pytest.raises(ValueError, match=f"^{name} must be an array of real numbers.*{words}"):
        take(spoil(value))


@pytest.mark.parametrize(
    "same",
    [
        lambda value: np.array(value, dtype=np.float32),
        lambda value: np.array(value).astype(int),
        lambda value: np.array(value).astype(bool),
        lambda value: [[Fraction(number) for number in point] for point in value],
        lambda value: np.asfortranarray(value),
    ],
    ids=["single precision", "whole numbers", "truth values", "fractions", "by columns"],
)
def test_other_kinds_of_real_numbers_serve(same):
    mesh = hn.ControlMesh(same(POINTS), [4], [0, 1, 2, 3])
    np.testing.assert_array_equal(mesh.points, POINTS)


@pytest.mark.parametrize("number", [2**31, -(2**31) - 1, 2**63, 2**64 - 1])
def test_whole_numbers_that_32_bits_cannot_hold_are_refused(number):
    """Of these, 2⁶⁴ - 1 is -1 where bits are taken for those of a number with a sign."""
    with pytest.raises(ValueError, match=f"holds {number}, which is out of range"):
        surface().positions(np.array([number]), uv())
