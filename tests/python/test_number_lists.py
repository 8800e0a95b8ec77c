# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists of numbers in another unit."""

import pytest
from hull_io.number_lists import diagonals, numbers, scaled


def test_lengths_are_scaled_and_angles_stay():
    assert scaled("1 -2:8:0,5; 3", 2.0) == "2 -4:16:1 6"
    assert scaled("5.2/35  4/50", 10.0) == "52/35 40/50"
    assert scaled("1", 1.0 / 0.3048) == "3.2808"
    assert scaled(" ", 2.0) == ""


@pytest.mark.parametrize("text", ["0.5 1:9:1", "-3 4.25"])
def test_a_scaled_list_has_the_scaled_numbers(text):
    assert numbers(scaled(text, 3.0), "") == tuple(3.0 * x for x in numbers(text, ""))


def test_scaled_diagonals_have_their_angles():
    ((height, angle),) = diagonals("1.5/30")
    assert diagonals(scaled("1.5/30", 4.0)) == ((4.0 * height, angle),)


@pytest.mark.parametrize("text", ["two", "1:x:3", "/"])
def test_what_is_no_list_is_refused(text):
    with pytest.raises(ValueError):
        scaled(text, 2.0)
