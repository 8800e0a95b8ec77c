# SPDX-License-Identifier: GPL-3.0-or-later
"""Keels and rudders that are given in place of what is joined to the hull."""

import dataclasses

import hull_native as hn
import pytest
from test_delft_series import KEEL, YD40, canoe_and_fins


def test_what_is_given_of_several_keels():
    """What is given in place of what they are together leaves the rest as it is."""
    fins = hn.delft_fins(canoe_and_fins(), draft=0.8).keels
    one = hn.one_fin(fins)
    fin, bulb = fins
    surface = fin.wetted_surface + bulb.wetted_surface
    assert (one.wetted_surface, one.volume) == (surface, fin.volume + bulb.volume)
    chord = (fin.wetted_surface * fin.chord + bulb.wetted_surface * bulb.chord) / surface
    assert (one.chord, one.total_draft) == (pytest.approx(chord), bulb.total_draft)
    assert one.name == "fin, bulb" and hn.one_fin(()) is None
    assert hn.given_fins(fins, {}) == fins
    same = hn.given_fins(fins, {"wetted_surface": one.wetted_surface, "volume": one.volume})
    for found, own in zip(same, fins):
        assert dataclasses.astuple(found)[:4] == pytest.approx(dataclasses.astuple(own)[:4])
    twice = hn.given_fins(fins, {"wetted_surface": 2.0 * surface, "chord": 1.1, "centre": 0.5})
    assert [f.wetted_surface for f in twice] == [2.0 * f.wetted_surface for f in fins]
    assert [(f.chord, f.centre, f.volume) for f in twice] == [(1.1, 0.5, f.volume) for f in fins]
    assert hn.one_fin(twice).centre == pytest.approx(0.5)


def test_what_is_given_of_no_keel_and_of_one_without_a_volume():
    (made,) = hn.given_fins((), {"wetted_surface": 4.0, "chord": 1.4}, "keel")
    assert (made.wetted_surface, made.chord, made.volume, made.name) == (4.0, 1.4, None, "keel")
    with pytest.raises(ValueError, match="no rudder joined to it"):
        hn.given_fins((), {"chord": 0.5}, "rudder")
    plain = hn.DelftFin(4.0, 1.4)
    (heavy,) = hn.given_fins((plain,), {"volume": 0.2, "total_draft": 2.0, "centre": 0.6})
    assert (heavy.volume, heavy.wetted_surface) == (0.2, 4.0)
    mixed = hn.given_fins((plain, KEEL), {"volume": 0.5, "wetted_surface": 8.4})
    assert [fin.volume for fin in mixed] == [None, 0.5]
    assert sum(fin.wetted_surface for fin in mixed) == pytest.approx(8.4)
    assert hn.delft(YD40, [3.0], keel=mixed)[0].keel_residuary > 0.0
