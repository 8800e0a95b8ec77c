# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls laid onto the demihull of a catamaran, which has both sides: halves are refused, their
wholes come onto it.

HULL_ALL_MEMBERS: those that turn over there, and the demihull's own layout on another hull, too.
"""

import hull_native as hn
import pytest
import vessels
from hull_io.mirror import mirror_faces
from test_form_numbers import Sample
from test_hull_layouts import ALL, MET, length_of


def whole(name):
    """The whole of a sample, both sides, as one surface."""
    data = vessels.vessel(name).data
    mirror_faces(data, range(len(data.faces)))
    return vessels.surface_of(data)


def test_a_half_is_no_demihull_but_its_whole_is():
    demihull = Sample("catamaran").surface
    half = Sample("naval_vessel").surface
    with pytest.raises(ValueError, match="The first hull is a half.*mirror the half"):
        hn.fit_layout(half, demihull)
    with pytest.raises(ValueError, match="The second hull is a half"):
        hn.fit_layout(demihull, half)
    fit = hn.fit_layout(whole("naval_vessel"), demihull)
    print(fit.rms / length_of(demihull), fit.rms_back / length_of(demihull))
    assert max(fit.rms, fit.rms_back) <= MET * length_of(demihull)
    assert fit.fold is None and fit.shortfall == ""


# Their chine and bulb have no counterpart on the demihull.
@pytest.mark.skipif(not ALL, reason="HULL_ALL_MEMBERS is not set")
@pytest.mark.parametrize("name", ("planing_boat", "coaster"))
def test_layouts_that_turn_over_on_the_demihull_are_told(name):
    demihull = Sample("catamaran").surface
    fit = hn.fit_layout(whole(name), demihull)
    assert max(fit.rms, fit.rms_back) <= MET * length_of(demihull)
    assert fit.fold is not None and fit.shortfall.startswith("Members are folded at (")


@pytest.mark.skipif(not ALL, reason="HULL_ALL_MEMBERS is not set")
def test_where_the_demihull_s_own_layout_falls_short_it_is_said():
    boat = whole("planing_boat")
    fit = hn.fit_layout(Sample("catamaran").surface, boat)
    print(fit.rms / length_of(boat), fit.rms_back / length_of(boat), fit.fold)
    assert max(fit.rms, fit.rms_back) > MET * length_of(boat) or fit.fold is not None
    assert "pair by hand the knuckle" in fit.shortfall
    assert "take the layout of the other hull" in fit.shortfall
