# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines plans of some views: what is on them, layer by layer, and nothing else."""

import itertools
from collections import Counter

import hull_native as hn
import pytest
from dxf_audit import assert_audited
from production_hulls import body_of
from test_lines_plan import curves_on
from test_view_drawings import length_of

# What each view has, of the coaster's plan below: its name, how many lines there are on each layer,
# and words beside them.
VIEW_PARTS = {
    "profile": (
        "Profile",
        {"BUTTOCKS": 4, "BASE_LINE": 1, "DESIGN_WATERLINE": 1, "PERPENDICULARS": 2, "MIDSHIP": 1},
        {"AP", "FP", "Midship", "BL", "DWL 5.2 m", *map(str, range(11))},
    ),
    "half_breadth": (
        "Half-breadth plan, diagonals expanded",
        {"WATERLINES": 7, "DIAGONALS": 1, "CENTRE_LINE": 1, "DESIGN_WATERLINE": 2,
         "PERPENDICULARS": 2, "MIDSHIP": 1},
        {"CL", "D1", *map(str, range(11))},
    ),
    "body_plan": (
        "Body plan",
        {"STATIONS": 12, "DIAGONAL_TRACES": 2, "BASE_LINE": 1, "CENTRE_LINE": 1,
         "DESIGN_WATERLINE": 1},
        {"BL", "CL", "DWL 5.2 m", "D1"},
    ),
}  # fmt: skip
LINE_LAYERS = {layer for _, lines, _ in VIEW_PARTS.values() for layer in lines}
COMPOSED = [views for n in (1, 2, 3) for views in itertools.combinations(VIEW_PARTS, n)]


def composed_plan(path, views, **options):
    """The document of the coaster's lines plan of views, as DXF."""
    pytest.importorskip("ezdxf")
    _, body = body_of("coaster")
    given = {"stations": 8.4, "waterlines": 2.0, "buttocks": [2.0, 4.0], "diagonals": [(5.0, 0.5)],
             "draft": 5.2, "length": 84.0, "offsets": False}  # fmt: skip
    hn.write_lines_drawing(body.surface, path, mirrored=True, views=views, **{**given, **options})
    return assert_audited(path)


def words_and_lines(document):
    """(words, {layer: number of lines} of the layers of VIEW_PARTS) of a plan."""
    entities = list(document.modelspace())
    words = {one.dxf.text for one in entities if one.dxftype() == "TEXT"}
    layers = Counter(one.dxf.layer for one in entities if one.dxftype() in ("LINE", "SPLINE"))
    return words, {layer: n for layer, n in layers.items() if layer in LINE_LAYERS}


@pytest.mark.parametrize("views", COMPOSED, ids=" ".join)
def test_lines_plan_of_some_views(tmp_path, views):
    """All of these and nothing of the others, whatever is beside what."""
    words, lines = words_and_lines(composed_plan(tmp_path / "plan.dxf", views))
    wanted = Counter()
    for view, (name, layers, beside) in VIEW_PARTS.items():
        assert (name in words) == (view in views)
        if view in views:
            wanted.update(layers)
            assert beside <= words
    assert lines == wanted
    left_out = [beside for view, (_, _, beside) in VIEW_PARTS.items() if view not in views]
    own = set().union(*(VIEW_PARTS[view][2] for view in views))
    if "body_plan" not in views:
        assert not words & (set().union(*left_out) - own)


def test_frames_in_place_of_stations(tmp_path):
    """By numbers of frames of 0.6 m, in the body plan alone: 10 is at 6 m, where the section is."""
    frames = [10.0, 70.0, 120.0]
    document = composed_plan(
        tmp_path / "plan.dxf", ("body_plan",), stations=frames, stations_in="frames",
        frame_spacing=0.6, buttocks=None, waterlines=None,
    )  # fmt: skip
    words, _ = words_and_lines(document)
    assert {"10", "70", "120"} <= words
    _, body = body_of("coaster")
    # That amidships is drawn to both sides.
    sections = [c.points for x in (6.0, 42.0, 42.0, 72.0) for c in hn.section(body.surface, "x", x)]
    drawn = length_of(curves_on(document, "STATIONS"))
    assert drawn == pytest.approx(length_of(sections), rel=1e-4)


def test_views_that_are_none_are_refused(tmp_path):
    for views, words in (((), "view at least"), (("plan",), "A view is")):
        with pytest.raises(ValueError, match=words):
            composed_plan(tmp_path / "x.dxf", views)
    assert not list(tmp_path.iterdir())


def test_one_view_has_a_larger_scale(tmp_path):
    """The body plan alone fits where three views do not."""
    _, body = body_of("coaster")
    options = {"mirrored": True, "stations": 4.2, "offsets": False, "paper": "A3", "scale": 75}
    path = tmp_path / "plan.pdf"
    with pytest.raises(ValueError, match="does not fit"):
        hn.write_lines_drawing(body.surface, path, **options)
    hn.write_lines_drawing(body.surface, path, views=("body_plan",), **options)
    assert path.stat().st_size > 5000
