# SPDX-License-Identifier: GPL-3.0-or-later
"""What a hull file may hold, and how what is wrong with one is told."""

import json

import hull_io
import numpy as np
import pytest


def variant(**changes):
    """A valid entry of variants with some keys changed."""
    return {
        "name": "as built",
        "note": "the first",
        "half": True,
        "points": [[0, 0, 0], [9, 0, 0], [9, 2, 0], [0, 2, 0]],
        "faces": [[0, 3, 2, 1]],
        "particulars": {"draft": 1.25},
        "locked": [2],
        "load": {"kg": 1.5},
        **changes,
    }


def content(**changes):
    """A valid file's content with some keys changed, or taken out where the value is None."""
    value = {
        "format": "hull",
        "version": 1,
        "name": "Box",
        "source": "a test",
        "units": "m",
        "half": True,
        "particulars": {"length_pp": 10.0, "beam": 4, "draft": 1.5, "water_density": 1.025},
        "points": [[0, 0, 0], [10, 0, 0], [10, 2, 0], [0, 2, 0], [0, 2, 3], [10, 2, 3]],
        "faces": [[0, 3, 2, 1], [3, 4, 5, 2]],
        "creases": [[3, 2]],
        "corners": [3],
        "layers": [{"name": "Bottom"}, {"name": "Side", "in_hydrostatics": False}],
        "face_layers": [0, 1],
        "scheme": "catmull_clark",
        "deck_edge": [[5, 4]],
        "shown_rows": [[2, 5], [3, 2]],
        "afloat": {"trim": -0.25, "heel_deg": 5, "deck_closed": False},
        "load": {"mass_t": 12.5, "kg": 1.75, "lcg": 4.5, "free_trim": False,
                 "loaded": "case", "case": "ballast"},
        "load_cases": [{"name": "ballast", "mass_t": 8, "lcg": 5, "tcg": -0.1, "vcg": 1}],
        "weights": {"thickness": 0.01, "density": 2.7,
                    "items": [{"name": "mast", "mass_t": 0.5, "vcg": 6}]},
        "resistance": {"method": "savitsky", "speeds_kn": [5, 30, 2.5], "stern": -10,
                       "deadrise_deg": 18, "thrust_arm": -0.1, "twin_screw": True,
                       "shaft_efficiency": 0.98, "zeros": ["deadrise_deg", "transom_area"],
                       "holtrop": {"bulb_area": 2, "midship": 0},
                       "open_stern": True, "hulls": "one", "blade_area_ratio": 0.7,
                       "delft": {"lcb": 4.5, "keel_centre": -0.5},
                       "michell": {"wetted_surface": 70}},
        "openings": [{"name": "hatch", "position": [5, 1, 3]}],
        "wind": {
            "hull_profile": False,
            "areas": [{"name": "house", "area": 20, "z": 4.5}, {"area": 5}],
            "lever": 3.5,
            "pressure": 252,
            "keel_area": 1.5,
            "sharp_bilges": True,
            "roll_period": 4,
        },
        "lines": {
            "shown": ["waterlines", "stations"],
            "station_count": 10,
            "waterline_spacing": 0.5,
            "stations": "1 3:9:2",
            "stations_in": "frames",
            "frame_spacing": 0.6,
            "planes": [{"name": "bow", "normal": [1, 0, 0], "point": [9, 0, 0], "shown": False}],
        },
        "targets": {
            "rows": [
                {"quantity": "kmt", "sense": "at least", "value": 6.3, "tolerance": 0.1},
                {"quantity": "section_area", "value": 5, "station": 4, "on": False},
            ],
            "moving": "none",
            "staying": ["deck_edge"],
            "beam": {"free": True, "percent": 2},
            "fairness": 0.1,
        },
        "area_target": {
            "source": "a table",
            "base": [[0, 0], [5, 4.5], [10, 0]],
            "points": [[0, 0], [5, 4], [10, 0.5]],
        },
        "fields": [
            {"extent": 5, "shift": [0, 0.3, 0], "falloff": 0.4, "place": [1, 2, 3]},
            {"name": "Deck edge", "role": "protect", "on": False, "colour": [0, 0.5, 1],
             "base": "line", "line": [[0, 1, 2], [1, 1, 2], [2, 0, 2]], "closed": True,
             "extent": 2, "axes": "xz"},
            {"base": "plane", "axis": "z", "extent": 1},
            {"base": "faces", "faces": [1, 0, 1], "extent": 1},
            {"base": "section", "place": [5, 2, 1], "extent": 3, "becomes": [[5, 0, 0], [5, 2, 1]],
             "end": {"extent": 2, "falloff": 0.5, "shift": [0, 0, 0.1]}},
        ],
        "variants": [variant(), {"half": False, "points": [[0, 0, 0], [1, 0, 0], [1, 1, 0]],
                                 "faces": [[0, 1, 2]]}],
    }  # fmt: skip
    value.update(changes)
    return {key: part for key, part in value.items() if part is not None}


def assert_same(first, second):
    np.testing.assert_array_equal(first.points, second.points)
    for key in ("name", "faces", "creases", "corners", "half", "face_layers"):
        assert getattr(first, key) == getattr(second, key), key
    assert first.layers == second.layers
    assert first.particulars == second.particulars
    assert first.source == second.source
    for key in ("scheme", "deck_edge", "shown_rows", "flats", "developables", "locked", "kept",
                "afloat", "load", "load_cases", "downflooding_points", "wind", "weights",
                "resistance", "lines", "targets", "area_target", "fields"):  # fmt: skip
        assert getattr(first, key) == getattr(second, key), key
    assert len(first.variants) == len(second.variants)
    for one, other in zip(first.variants, second.variants):
        assert one.note == other.note
        assert_same(one.hull, other.hull)


def assert_mistake_is_named(tmp_path, value, problem):
    """Of a file with this content, or with these bytes: one sentence with the place and the
    remedy."""
    path = tmp_path / "box.hull"
    path.write_bytes(value if isinstance(value, bytes) else json.dumps(value).encode())
    with pytest.raises(hull_io.HullFileError) as caught:
        hull_io.read_hull(path)
    message = str(caught.value)
    assert message.startswith("box.hull: ")
    assert problem in message
    assert "; " in message and message.endswith(".") and "\n" not in message
