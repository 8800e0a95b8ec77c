# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls beside one another of which one has no length between perpendiculars, or both."""

import hull_native as hn
import pytest
from test_comparison import box, by_name, lying


def test_what_is_of_lpp_is_undefined_without():
    known, unknown = lying(box(), 1.0, length_pp=10.0), lying(box(), 1.0)
    for hull, other, names in ((known, unknown, ["other"]), (unknown, unknown, ["value", "other"])):
        rows = by_name(hn.compare_hulls(hull, other))
        for name in ("lcb_percent", "lcf_percent", "mtc", "midship_section.area"):
            row = rows[name]
            assert [each for each in ("value", "other") if getattr(row, each) is None] == names
            assert row.difference is None and row.percent is None
    # A box has its centre exactly amidships: that is a number.
    same = by_name(hn.compare_hulls(known, known))
    assert same["lcb_percent"].value == pytest.approx(0.0, abs=1e-9)
    assert same["mtc"].difference == 0.0


def test_trims_about_other_places_are_refused():
    known, unknown = lying(box(), 1.0, length_pp=10.0), lying(box(), 1.0)
    trimmed = [lying(box(), 1.0, trim=0.02, length_pp=length) for length in (10.0, None)]
    for pair in ((trimmed[0], unknown), (known, trimmed[1]), trimmed):
        with pytest.raises(ValueError, match="give draft_at, or Lpp of both"):
            hn.compare_hulls(*pair)
    hn.compare_hulls(trimmed[1], unknown)
    hn.compare_hulls(lying(box(), 1.0, trim=0.02, draft_at=5.0), known)
