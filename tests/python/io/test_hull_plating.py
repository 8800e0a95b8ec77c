# SPDX-License-Identifier: GPL-3.0-or-later
"""Rules of seams and frames in hull files: written and read, scaled, and refused where wrong."""

import json

import hull_io
import hull_native as hn
import pytest
from hull_native.production.seam_rules import KINDS
from test_hull_file import content

PLATING = {
    "rules": [
        {"kind": "strakes", "value": 2.4},
        {"kind": "station", "value": 12.5, "on": False},
        {"kind": "projected", "line": [[0, 2, 1], [9, 2, 1.5]]},
    ],
    "across_centre": False,
    "thickness": 0.012,
    "ranges": [{"last": 10, "spacing": 0.5}, {"last": 80, "spacing": 0.65}],
    "numbered_from": "FP",
    "mark_buttocks": True,
}


def test_written_and_read(read, tmp_path):
    data = read(content(plating=PLATING))
    own = data.plating
    assert own == hull_io.Plating(
        [
            hull_io.SeamRule("strakes", 2.4),
            hull_io.SeamRule("station", 12.5, on=False),
            hull_io.SeamRule("projected", line=[(0.0, 2.0, 1.0), (9.0, 2.0, 1.5)]),
        ],
        across_centre=False,
        thickness=0.012,
        ranges=[hull_io.FrameRange(10, 0.5), hull_io.FrameRange(80, 0.65)],
        numbered_from="FP",
        mark_buttocks=True,
    )
    hull_io.write_hull_file(data, tmp_path / "again.hull.json")
    assert hull_io.read_hull_file(tmp_path / "again.hull.json").plating == own
    data.plating = None
    hull_io.write_hull_file(data, tmp_path / "none.hull.json")
    assert "plating" not in json.loads((tmp_path / "none.hull.json").read_text())


def test_kinds_are_those_of_the_rules():
    assert hull_io.SEAM_KINDS == tuple(KINDS)
    for kind in hull_io.SEAM_KINDS:
        hn.SeamRule(kind, 1.0, [(0.0, 0.0, 0.0)] * 2)


def test_places_follow_and_girths_stay(read):
    made = hull_io.scaled(read(content(plating=PLATING)), (2.0, 3.0, 4.0)).plating
    assert [rule.value for rule in made.rules] == [2.4, 25.0, 0.0]
    assert made.rules[2].line == [(0.0, 6.0, 4.0), (18.0, 6.0, 6.0)]
    assert made.ranges == read(content(plating=PLATING)).plating.ranges


@pytest.mark.parametrize(
    "changed, where",
    [
        ({"rules": [{"kind": "seams", "value": 1}]}, "plating.rules[0].kind"),
        ({"rules": [{"kind": "strakes"}]}, "plating.rules[0].value: it is missing"),
        ({"rules": [{"kind": "strakes", "value": 0}]}, "plating.rules[0].value"),
        ({"rules": [{"kind": "projected"}]}, "plating.rules[0].line: it is missing"),
        ({"rules": [{"kind": "projected", "line": [[0, 0, 0]]}]}, "it has 1 points"),
        ({"rules": [{"kind": "butts", "value": 1, "girth": 2}]}, "plating.rules[0]: the key"),
        ({"ranges": [{"last": 1.5, "spacing": 1}]}, "plating.ranges[0].last"),
        ({"ranges": [{"last": 1}]}, "plating.ranges[0].spacing: it is missing"),
        ({**PLATING, "first_frame": 1}, "plating.ranges: frames 1 to 80 leave out frame 0"),
        ({"ranges": [{"last": -5, "spacing": 1}]}, "plating.ranges[0].last: frame -5 is not bey"),
        ({"thickness": 0}, "plating.thickness"),
        ({"numbered_from": "midship"}, "plating.numbered_from"),
        ({"in_roman": 1}, "plating.in_roman"),
        ({"mark_waterlines": 1}, "plating.mark_waterlines"),
    ],
)
def test_what_is_wrong_is_refused(read, changed, where):
    with pytest.raises(hull_io.HullFileError) as error:
        read(content(plating=changed))
    assert where in str(error.value)
