# SPDX-License-Identifier: GPL-3.0-or-later
"""Families in which a parent is met no better than so: it is told, with what to do."""

import re

import pytest
from addon_under_test import part
from expect_morph import morph_of, ships

pytestmark = pytest.mark.once


def test_what_falls_short_is_told_with_a_remedy():
    """In the status of the making, and with the parent; in the hulls' names."""
    first, second = ships("barge", "planing_boat")
    first.hull.morph.tolerance, first.hull.morph.most_subdivisions = 0.001, 0
    stored = part("features.morphing.stored_parents")
    told = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(
            stored, "told", lambda *args, own=stored.told: told.append(own(*args)) or told[-1]
        )
        made = morph_of(first, second)
    own, other = made.hull.morph.parents
    assert own.shortfall == ""
    assert other.shortfall.startswith("The layout is left ")
    for hull in (first, second):
        assert f'of "{hull.name}"' in other.shortfall
    assert not re.search("the (first|second)", other.shortfall)
    assert re.search("pair by hand|pair the two by hand|all lines are paired", other.shortfall)
    assert other.shortfall.endswith("or of a third one, such as the sample coaster's.")
    ((text, warns),) = told
    assert warns and other.shortfall in text
