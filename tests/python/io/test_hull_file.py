# SPDX-License-Identifier: GPL-3.0-or-later
"""The project's own hull file: what is written is read, and a mistake is named."""

import json
import os
import random
import stat

import hull_io
import numpy as np
import pytest
from hull_io import bytes_on_disk, mirror


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
                       "shaft_efficiency": 0.98, "holtrop": {"bulb_area": 2, "midship": 0},
                       "delft": {"lcb": 4.5}},
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


@pytest.fixture
def read(tmp_path):
    def read_content(value):
        path = tmp_path / "box.hull.json"
        path.write_bytes(value if isinstance(value, bytes) else json.dumps(value).encode())
        return hull_io.read_hull(path)

    return read_content


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


def test_a_file_is_read(read):
    hull = read(content())
    assert hull.name == "Box"
    assert hull.half and hull.units == "m" and hull.source == "a test"
    assert hull.points.dtype == np.float64
    assert hull.points[5].tolist() == [10, 2, 3]
    assert hull.faces == [[0, 3, 2, 1], [3, 4, 5, 2]]
    assert hull.creases == [(2, 3)]
    assert hull.corners == [3]
    assert hull.particulars == hull_io.Particulars(10.0, 4.0, 1.5, 0.0, 1.025)
    assert [layer.in_hydrostatics for layer in hull.layers] == [True, False]
    assert hull_io.shell_face_indices(hull) == [0]
    assert hull.scheme == "catmull_clark" and hull.deck_edge == [(4, 5)]
    assert hull.shown_rows == [(2, 3), (2, 5)]
    assert hull.afloat == hull_io.Afloat(-0.25, 5.0, False)
    assert hull.load == hull_io.Load(12.5, 1.75, 4.5, False, False, "case", "ballast")
    assert hull.load_cases == [hull_io.LoadCase("ballast", 8.0, 5.0, -0.1, 1.0)]
    assert hull.weights == hull_io.Weights(0.01, 2.7, [hull_io.Weight("mast", 0.5, vcg=6.0)])
    assert hull.resistance == hull_io.Resistance(
        "savitsky", (5.0, 30.0, 2.5), stern=-10, deadrise_deg=18.0, thrust_arm=-0.1,
        twin_screw=True, shaft_efficiency=0.98, holtrop=hull_io.HoltropInputs(bulb_area=2.0),
        delft=hull_io.DelftInputs(lcb=4.5),
    )  # fmt: skip
    assert hull.downflooding_points == [hull_io.DownfloodingPoint("hatch", (5.0, 1.0, 3.0))]
    areas = [hull_io.WindArea("house", 20.0, 4.5), hull_io.WindArea("Wind area", 5.0)]
    assert hull.wind == hull_io.Wind(False, areas, 3.5, 252.0, 1.5, True, 4.0)
    assert hull.lines == hull_io.LineChoice(
        shown=("stations", "waterlines"),
        station_count=10,
        waterline_spacing=0.5,
        stations="1 3:9:2",
        stations_in="frames",
        frame_spacing=0.6,
        planes=[hull_io.CutPlane("bow", (1.0, 0.0, 0.0), (9.0, 0.0, 0.0), False)],
    )
    first, second, third, faces, section = hull.fields
    assert first == hull_io.ShapeField(
        "Field 1", 5, place=(1, 2, 3), falloff=0.4, shift=(0, 0.3, 0)
    )
    assert (second.name, second.role, second.on) == ("Deck edge", "protect", False)
    assert second.line[2] == (2, 0, 2) and second.closed and second.axes == "xz"
    assert (third.base, third.axis, third.line) == ("plane", "z", [])
    assert (faces.base, faces.faces, faces.end) == ("faces", [0, 1], None)
    assert section.becomes == [(5, 0, 0), (5, 2, 1)]
    assert section.end == hull_io.FieldEnd(2, 0.5, (0, 0, 0.1))
    assert hull.targets == hull_io.Targets(
        rows=[
            hull_io.Target("kmt", 6.3, "at least", 0.1),
            hull_io.Target("section_area", 5.0, station=4.0, on=False),
        ],
        moving="none",
        staying=("deck_edge",),
        beam=hull_io.FreeDimension(True, 2.0),
        fairness=0.1,
    )
    pairs = [(point.x, point.area) for point in hull.area_target.points]
    assert pairs == [(0.0, 0.0), (5.0, 4.0), (10.0, 0.5)]
    assert hull.area_target.base[1] == hull_io.AreaPoint(5.0, 4.5)
    assert hull.area_target.source == "a table"
    first, second = hull.variants
    assert (first.hull.name, first.note, first.hull.half) == ("as built", "the first", True)
    assert first.hull.points[2].tolist() == [9, 2, 0] and first.hull.locked == [2]
    assert first.hull.particulars.draft == 1.25 and first.hull.load.kg == 1.5
    assert (second.hull.name, second.note, second.hull.half) == ("Variant 2", "", False)


def test_what_may_be_left_out(read):
    required = ("format", "version", "units", "half", "points", "faces")
    optional = [key for key in content() if key not in required]
    hull = read(content(**dict.fromkeys(optional)))
    assert hull.name == "box"
    assert hull.particulars == hull_io.Particulars()
    assert hull.creases == [] and hull.corners == []
    assert hull_io.shell_face_indices(hull) == [0, 1]
    assert hull.scheme == "biermann" and hull.deck_edge == []
    assert hull.afloat == hull_io.Afloat() and hull.load == hull_io.Load()
    assert hull.load_cases == [] and hull.downflooding_points == [] and hull.lines is None
    assert hull.wind is None and read(content(wind={})).wind == hull_io.Wind()
    assert not hull.load.kg_is_guess and read(content(load={"kg_is_guess": True})).load.kg_is_guess
    assert read(content(lines={})).lines == hull_io.LineChoice()
    assert hull.targets == hull_io.Targets() and hull.area_target is None and hull.variants == []
    assert hull.fields == []
    assert read(content(targets={})).targets == hull_io.Targets()
    assert read(content(area_target={})).area_target == hull_io.AreaTarget()
    hull = read(content(load={}, load_cases=[{"mass_t": 1}], openings=[{"position": [1, 2, 3]}]))
    assert hull.load == hull_io.Load(None, 0.0, None, True)
    assert hull.load_cases == [hull_io.LoadCase("Load case", 1.0)]
    guessed = read(content(load_cases=[{"mass_t": 1, "vcg_is_guess": True}]))
    assert guessed.load_cases == [hull_io.LoadCase("Load case", 1.0, vcg_is_guess=True)]
    assert hull.downflooding_points == [hull_io.DownfloodingPoint("Opening", (1.0, 2.0, 3.0))]


def test_reference_hulls_come_back_bit_for_bit(freeship_files, tmp_path):
    for source in freeship_files:
        hull = hull_io.read_hull(source)
        path = tmp_path / f"{source.stem}.hull.json"
        hull_io.write_hull_file(hull, path)
        assert_same(hull, hull_io.read_hull(path))


def test_any_name_and_any_number_come_back(read, tmp_path):
    hull = read(content())
    hull.name = 'Ящик "№ 1" \\ \u2028'
    noise = np.random.default_rng(11)
    hull.points = hull.points + noise.normal(size=hull.points.shape) * 1e-7
    hull_io.write_hull_file(hull, tmp_path / "again.hull.json")
    assert_same(hull, hull_io.read_hull(tmp_path / "again.hull.json"))


def test_numpy_indices_are_written_as_numbers(read, tmp_path):
    hull = read(content())
    plain = read(content())
    hull.faces = [np.array(face, dtype=np.int32) for face in hull.faces]
    hull.creases = np.array(hull.creases)
    hull.corners = np.array(hull.corners)
    hull_io.write_hull_file(hull, tmp_path / "again.hull.json")
    assert_same(plain, hull_io.read_hull(tmp_path / "again.hull.json"))


MISTAKES = {
    "unknown lines": (content(lines={"shown": ["frames"]}), "lines.shown[0]: it is unknown"),
    "a list of lines": (content(lines={"waterlines": "1 b"}), 'lines.waterlines: waterlines: "b"'),
    "a diagonal": (content(lines={"diagonals": "5"}), "lines.diagonals: Diagonals"),
    "too many stations": (content(lines={"station_count": 500}), "lines.station_count: 500 is no"),
    "other stations": (content(lines={"stations_in": "feet"}), "lines.stations_in: it is unknown"),
    "a plane of no direction": (
        content(lines={"planes": [{"normal": [0, 0, 0], "point": [0, 0, 0]}]}),
        "lines.planes[0].normal: it has no direction",
    ),
    "a plane of no place": (
        content(lines={"planes": [{"normal": [0, 0, 1]}]}),
        "lines.planes[0].point: it is missing",
    ),
    "other format": (content(format="ship"), 'format: it is not "hull"'),
    "other version": (content(version=2), "version: 2 is unknown; only version 1 can be read"),
    "true is no version": (content(version=True), "version: true is unknown"),
    "unknown key": (content(point=[]), 'the file: the key "point" is unknown'),
    "no half": (content(half=None), "half: it is missing"),
    "half of text": (content(half="yes"), 'half: "yes" is not true or false'),
    "feet": (content(units="ft"), 'units: "ft" is not "m"; write all lengths in metres'),
    "no points": (content(points=[]), "points: it has 0 entries"),
    "points no list": (content(points={}), "points: dict is no list"),
    "point no list": (content(points=[[0, 0, 0], 7]), "points[1]: 7 is no list"),
    "point of two": (content(points=[[0, 0]]), "points[0]: it has 2 entries, not 3"),
    "coordinate text": (content(points=[[0, "1", 0]]), 'points[0].y: "1" is not a number'),
    "coordinate null": (content(points=[[0, 0, None]]), "points[0].z: NoneType is not a number"),
    "coordinate true": (content(points=[[True, 0, 0]]), "points[0].x: true is not a number"),
    "coordinate far": (content(points=[[0, 0, -2e6]]), "points[0].z: -2000000.0 is not a number"),
    "coordinate long": (content(points=[[10**400, 0, 0]]), "points[0].x: 1000000"),
    "no faces": (content(faces=[]), "faces: it has 0 entries"),
    "face of two": (content(faces=[[0, 1]]), "faces[0]: 2 points, 2 of them different"),
    "face repeats": (content(faces=[[0, 1, 2, 1]]), "faces[0]: 4 points, 3 of them different"),
    "face twice": (
        content(faces=[[0, 1, 2, 3], [2, 1, 0, 3]]),
        "faces[1]: it has the points of faces[0]",
    ),
    "face index": (
        content(faces=[[0, 1, 6]]),
        "faces[0][2]: 6 is no index of a point; points are 0 to 5",
    ),
    "face negative": (content(faces=[[0, 1, -1]]), "faces[0][2]: -1 is no index"),
    "face real": (content(faces=[[0, 1.0, 2]]), "faces[0][1]: 1.0 is no index"),
    "face true": (content(faces=[[0, True, 2]]), "faces[0][1]: true is no index"),
    "crease no edge": (content(creases=[[0, 2]]), "creases[0]: [0, 2] is no edge of a face"),
    "crease index": (content(creases=[[0, 9]]), "creases[0][1]: 9 is no index"),
    "crease of three": (content(creases=[[0, 1, 2]]), "creases[0]: it has 3 entries, not 2"),
    "corner": (content(corners=[0, 6]), "corners[1]: 6 is no index of a point"),
    "no layers": (content(layers=[]), "layers: it has 0 entries"),
    "layer key": (content(layers=[{"color": 1}]), 'layers[0]: the key "color" is unknown'),
    "layer flag": (
        content(layers=[{}, {"in_hydrostatics": 1}]),
        "layers[1].in_hydrostatics: 1 is not true or false",
    ),
    "layer colour": (
        content(layers=[{"colour": [0, 0, 255]}, {}]),
        "layers[0].colour: 255 is not a number from 0 to 1",
    ),
    "face layers short": (content(face_layers=[0]), "face_layers: it has 1 entries, not 2"),
    "face layer": (content(face_layers=[0, 2]), "face_layers[1]: 2 is no index of a layer"),
    "particular": (
        content(particulars={"draft": -1}),
        "particulars.draft: -1 is not a number from 0 to 10000",
    ),
    "particular key": (content(particulars={"T": 1}), 'particulars: the key "T" is unknown'),
    "scheme": (content(scheme="loop"), 'scheme: "loop" is unknown; write "biermann"'),
    "scheme list": (content(scheme=[]), "scheme: list is unknown"),
    "deck edge": (content(deck_edge=[[0, 2]]), "deck_edge[0]: [0, 2] is no edge of a face"),
    "row": (content(shown_rows=[[0, 2]]), "shown_rows[0]: [0, 2] is no edge of a face"),
    "deck edge index": (content(deck_edge=[[0, 9]]), "deck_edge[0][1]: 9 is no index"),
    "afloat": (content(afloat=[]), "afloat: list is no object"),
    "afloat key": (content(afloat={"heel": 1}), 'afloat: the key "heel" is unknown'),
    "heel": (
        content(afloat={"heel_deg": 181}),
        "afloat.heel_deg: 181 is not a number from -180 to 180",
    ),
    "deck closed": (content(afloat={"deck_closed": 1}), "afloat.deck_closed: 1 is not true"),
    "load": (content(load=5), "load: 5 is no object"),
    "load mass": (
        content(load={"mass_t": -1}),
        "load.mass_t: -1 is not a number from 0 to 1e+08",
    ),
    "loaded": (content(load={"loaded": "all"}), "load.loaded: "),
    "load mass null": (content(load={"mass_t": None}), "load.mass_t: NoneType is not a number"),
    "load cases": (content(load_cases={}), "load_cases: dict is no list"),
    "weights key": (content(weights={"steel": 1}), 'weights: the key "steel" is unknown'),
    "plating": (content(weights={"thickness": 11}), "weights.thickness: 11"),
    "weight mass": (content(weights={"items": [{}]}), "weights.items[0].mass_t: it is missing"),
    "layer plating": (content(layers=[{"density": -1}] * 2), "layers[0].density: -1"),
    "resistance method": (content(resistance={"method": "guess"}), "resistance.method: "),
    "resistance stern": (content(resistance={"stern": True}), "resistance.stern: "),
    "resistance speeds": (content(resistance={"speeds_kn": [1, 2]}), "resistance.speeds_kn"),
    "deadrise": (content(resistance={"deadrise_deg": 60}), "resistance.deadrise_deg: 60"),
    "shaft": (content(resistance={"shaft_efficiency": 0}), "resistance.shaft_efficiency: 0"),
    "inputs": (content(resistance={"holtrop": []}), "resistance.holtrop: list is no object"),
    "inputs key": (
        content(resistance={"delft": {"breadth": 3}}),
        'resistance.delft: the key "breadth" is unknown',
    ),
    "inputs number": (
        content(resistance={"holtrop": {"midship": 2}}),
        "resistance.holtrop.midship: 2",
    ),
    "load case": (content(load_cases=[7]), "load_cases[0]: 7 is no object"),
    "load case key": (content(load_cases=[{"kg": 1}]), 'load_cases[0]: the key "kg" is unknown'),
    "load case mass": (content(load_cases=[{}]), "load_cases[0].mass_t: it is missing"),
    "load case centre": (
        content(load_cases=[{"mass_t": 1, "vcg": 1e5}]),
        "load_cases[0].vcg: 100000.0 is not a number from -10000 to 10000",
    ),
    "many load cases": (
        content(load_cases=[{"mass_t": 1}] * 201),
        "load_cases: it has 201 entries; write at most 200",
    ),
    "opening": (content(openings=[{}]), "openings[0].position: it is missing"),
    "opening of two": (
        content(openings=[{"position": [1, 2]}]),
        "openings[0].position: it has 2 entries, not 3",
    ),
    "opening text": (
        content(openings=[{"position": [1, 2, "3"]}]),
        'openings[0].position.z: "3" is not a number',
    ),
    "opening name": (
        content(openings=[{"position": [1, 2, 3], "name": []}]),
        "openings[0].name: it is no text",
    ),
    "wind": (content(wind=[]), "wind: list is no object"),
    "wind area": (content(wind={"areas": [{}]}), "wind.areas[0].area: it is missing"),
    "wind areas": (content(wind={"areas": 1}), "wind.areas: 1 is no list"),
    "wind pressure": (content(wind={"pressure": -1}), "wind.pressure: -1 is not a number from 0"),
    "name": (content(name=5), "name: it is no text"),
    "half a letter": (content(name="a\ud800"), "name: character 1 is no letter ('\\ud800')"),
    "null letter": (
        content(load_cases=[{"mass_t": 1, "name": "\0"}]),
        "load_cases[0].name: character 0 is no letter ('\\x00')",
    ),
    "long name": (content(name="x" * 10001), "name: it is no text of at most 10000"),
    "fields": (content(fields={}), "fields: dict is no list"),
    "many fields": (content(fields=[{"extent": 1}] * 33), "fields: it has 33 entries"),
    "field": (content(fields=[[]]), "fields[0]: list is no object"),
    "field key": (content(fields=[{"kappa": 1}]), 'fields[0]: the key "kappa" is unknown'),
    "field extent": (content(fields=[{}]), "fields[0].extent: it is missing"),
    "field extent's size": (
        content(fields=[{"extent": -1}]),
        "fields[0].extent: -1 is not a number from 0 to",
    ),
    "field role": (
        content(fields=[{"extent": 1, "role": "shift"}]),
        'fields[0].role: "shift" is unknown; write "move" or "protect"',
    ),
    "field base": (
        content(fields=[{"extent": 1, "base": "curve"}]),
        'fields[0].base: "curve" is unknown; write "point", "crease", "plane", "section", "line" '
        'or "faces"',
    ),
    "field falloff": (
        content(fields=[{"extent": 1, "falloff": 1.5}]),
        "fields[0].falloff: 1.5 is not a number from 0 to 1",
    ),
    "field end": (
        content(fields=[{"extent": 1, "base": "section", "end": {}}]),
        "fields[0].end.extent: it is missing",
    ),
    "end of a point": (
        content(fields=[{"extent": 1, "end": {"extent": 1}}]),
        'fields[0].end: a base "point" has none',
    ),
    "field face": (
        content(fields=[{"extent": 1, "base": "faces", "faces": [9]}]),
        "fields[0].faces[0]: ",
    ),
    "faces of a point": (
        content(fields=[{"extent": 1, "faces": [0]}]),
        'fields[0].faces: a base "point" has none',
    ),
    "field shift": (content(fields=[{"extent": 1, "shift": [1, 2]}]), "fields[0].shift: "),
    "field axes": (
        content(fields=[{"extent": 1, "axes": "zx"}]),
        "fields[0].axes: 'zx' are no axes",
    ),
    "field without line": (
        content(fields=[{"extent": 1, "base": "line"}]),
        'fields[0].line: a base "line" has points',
    ),
    "field with line": (
        content(fields=[{"extent": 1, "line": [[0, 0, 0], [1, 0, 0]]}]),
        'fields[0].line: a base "line" has points',
    ),
    "field's short line": (
        content(fields=[{"extent": 1, "base": "line", "line": [[0, 0, 0]]}]),
        "fields[0].line: one point is no line",
    ),
    "targets": (content(targets=[]), "targets: list is no object"),
    "target key": (content(targets={"row": []}), 'targets: the key "row" is unknown'),
    "target rows": (content(targets={"rows": {}}), "targets.rows: dict is no list"),
    "target quantity": (
        content(targets={"rows": [{"quantity": "speed", "value": 1}]}),
        'targets.rows[0].quantity: "speed" is unknown; write "volume", ',
    ),
    "target of nothing": (
        content(targets={"rows": [{"value": 1}]}),
        "targets.rows[0].quantity: it is missing",
    ),
    "target without value": (
        content(targets={"rows": [{"quantity": "cb"}]}),
        "targets.rows[0].value: it is missing",
    ),
    "target sense": (
        content(targets={"rows": [{"quantity": "cb", "value": 1, "sense": []}]}),
        'targets.rows[0].sense: list is unknown; write "equal", "at least" or "at most"',
    ),
    "target value": (
        content(targets={"rows": [{"quantity": "cb", "value": 1e10}]}),
        "targets.rows[0].value: 10000000000.0 is not a number from -1e+09 to 1e+09",
    ),
    "target tolerance": (
        content(targets={"rows": [{"quantity": "cb", "value": 1, "tolerance": -1}]}),
        "targets.rows[0].tolerance: -1 is not",
    ),
    "many targets": (
        content(targets={"rows": [{"quantity": "cb", "value": 1}] * 61}),
        "targets.rows: it has 61 entries; write at most 60",
    ),
    "target moving": (content(targets={"moving": "some"}), 'targets.moving: "some" is unknown'),
    "target staying": (content(targets={"staying": ["keel"]}), 'targets.staying[0]: "keel" is'),
    "target dimension": (
        content(targets={"beam": {"percent": 51}}),
        "targets.beam.percent: 51 is not a number from 0 to 50",
    ),
    "target fairness": (content(targets={"fairness": "x"}), 'targets.fairness: "x" is not a'),
    "area target": (content(area_target=[]), "area_target: list is no object"),
    "area target null": (content(area_target={"points": None}), "area_target.points: NoneType"),
    "area target pair": (
        content(area_target={"points": [[0, 1], [1]]}),
        "area_target.points[1]: it has 1 entries, not 2",
    ),
    "area target area": (
        content(area_target={"base": [[0, -1]]}),
        "area_target.base[0].area: -1 is not a number from 0 to 100000",
    ),
    "area target long": (
        content(area_target={"base": [[0, 1]] * 501}),
        "area_target.base: it has 501 entries; write at most 500",
    ),
    "area target source": (content(area_target={"source": 1}), "area_target.source: it is no text"),
    "variants": (content(variants={}), "variants: dict is no list"),
    "variant": (content(variants=[1]), "variants[0]: 1 is no object"),
    "variant key": (
        content(variants=[variant(), variant(variants=[])]),
        'variants[1]: the key "variants" is unknown',
    ),
    "variant targets": (
        content(variants=[variant(targets={})]),
        'variants[0]: the key "targets" is unknown',
    ),
    "variant without faces": (
        content(variants=[{"half": True, "points": []}]),
        "variants[0].faces: it is missing",
    ),
    "variant face": (
        content(variants=[variant(faces=[[0, 1, 4]])]),
        "variants[0].faces[0][2]: 4 is no index of a point; points are 0 to 3",
    ),
    "variant draft": (
        content(variants=[variant(), variant(particulars={"draft": -1})]),
        "variants[1].particulars.draft: -1 is not",
    ),
    "variant note": (content(variants=[variant(note=[])]), "variants[0].note: it is no text"),
    "many variants": (
        content(variants=[variant()] * 201),
        "variants: it has 201 entries; write at most 200",
    ),
    "not JSON": (b'{"format": "hull",\n "half" true}', "line 2, column 9: it is not JSON"),
    "cut short": (json.dumps(content()).encode()[:-50], "it is not JSON"),
    "not UTF-8": (b'{"name": "\xff"}', "byte 10: it is not UTF-8"),
    "NaN": (json.dumps(content()).replace("1.5", "NaN").encode(), "NaN is not a number"),
    "overflow": (json.dumps(content()).replace("1.5", "1e999").encode(), "particulars.draft: Inf"),
    "deep": (b'{"points":' + b"[" * 200_000, "lists are nested too deep"),
    "digits": (b'{"points": ' + b"9" * 5000 + b"}", "a number has too many digits"),
    "a list": (b" [1]", "neither a FREE!ship file nor a hull file"),
    "many": (
        content(points=[[0, 0, 0]] * 250_001),
        "points: it has 250001 entries; a hull has 1 to 250000 points",
    ),
}


@pytest.mark.parametrize("case", MISTAKES)
def test_a_mistake_is_named(tmp_path, case):
    value, problem = MISTAKES[case]
    path = tmp_path / "box.hull"
    path.write_bytes(value if isinstance(value, bytes) else json.dumps(value).encode())
    with pytest.raises(hull_io.HullFileError) as caught:
        hull_io.read_hull(path)
    message = str(caught.value)
    assert message.startswith("box.hull: ")
    assert problem in message
    assert "; " in message and message.endswith(".") and "\n" not in message


def test_writing_replaces_a_file_whole_or_not_at_all(read, tmp_path, monkeypatch):
    path = tmp_path / "kept.hull.json"
    hull = read(content())
    hull_io.write_hull_file(hull, path)
    before = path.read_bytes()
    os.chmod(path, 0o640)

    hull.points = hull.points + np.nan
    with pytest.raises(hull_io.HullFileError, match="NaN is not a number"):
        hull_io.write_hull_file(hull, path)
    assert path.read_bytes() == before

    hull.points = np.zeros((6, 3))

    def full_disk(_):
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(bytes_on_disk.os, "fsync", full_disk)
        with pytest.raises(hull_io.HullFileError, match="No space left on device"):
            hull_io.write_hull_file(hull, path)
    assert path.read_bytes() == before

    hull_io.write_hull_file(hull, path)
    assert not hull_io.read_hull(path).points.any()
    assert stat.S_IMODE(os.stat(path).st_mode) == 0o640
    assert sorted(os.listdir(tmp_path)) == ["box.hull.json", "kept.hull.json"]


def test_what_would_be_too_large_to_be_read_is_not_written(read, tmp_path):
    hull = read(content())
    large = hull_io.Variant(hull_io.read_hull(tmp_path / "box.hull.json"))
    large.hull.source = "x" * 10_000
    hull.variants = [large] * 1000
    with pytest.raises(hull_io.HullFileError, match="at most 8; remove some of its variants"):
        hull_io.write_hull_file(hull, tmp_path / "large.hull.json")
    assert not (tmp_path / "large.hull.json").exists()


def test_files_without_targets_and_variants_are_as_they_were(read, tmp_path):
    keys = ("targets", "area_target", "variants")
    hull_io.write_hull_file(read(content(**dict.fromkeys(keys))), tmp_path / "a.hull.json")
    assert not set(keys) & set(json.loads((tmp_path / "a.hull.json").read_text()))


def test_writing_into_no_folder_is_refused(read, tmp_path):
    with pytest.raises(hull_io.HullFileError, match="x.hull.json: it can't be written"):
        hull_io.write_hull_file(read(content()), tmp_path / "no" / "x.hull.json")


@pytest.mark.parametrize("begin, said", [("n" * 300, "too long"), ("two\nlines", "line breaks")])
def test_names_that_no_file_can_have(read, tmp_path, begin, said):
    before = os.listdir(tmp_path)
    with pytest.raises(hull_io.HullFileError, match=said):
        hull_io.write_hull_file(read(content()), tmp_path / f"{begin}.hull.json")
    assert set(os.listdir(tmp_path)) <= {*before, "box.hull.json"}


def test_the_longest_name(read, tmp_path):
    path = tmp_path / ("n" * 245 + ".hull.json")
    hull_io.write_hull_file(read(content()), path)
    assert len(hull_io.read_hull(path).points) > 0


def test_damaged_copies_are_refused_or_read(tmp_path):
    """Cut short, bits turned, or a piece replaced by something hostile."""
    seed = 12
    choice = random.Random(seed)
    data = json.dumps(content()).encode()
    hostile = [b"1e999", b"-1", b"null", b"[]", b"{}", b'""', b"true", b"99999999999", b"NaN"]
    path = tmp_path / "box.hull.json"
    read = 0
    for copy in range(1000):
        damaged = bytearray(data)
        start = choice.randrange(len(data))
        if copy % 3 == 0:
            del damaged[start:]
        elif copy % 3 == 1:
            damaged[start] ^= 1 << choice.randrange(8)
        else:
            damaged[start : start + choice.randrange(4)] = choice.choice(hostile)
        path.write_bytes(damaged)
        try:
            hull = hull_io.read_hull(path)
        except hull_io.HullFileError as error:
            assert str(error).startswith("box.hull.json: "), f"seed {seed}, copy {copy}"
            continue
        read += 1
        hull_io.shell_arrays(hull)
    assert 0 < read < 500


def test_locked_and_kept_points_are_written_and_read(read, tmp_path):
    kept = {"stations": [1, 4], "waterlines": [2]}
    data = read(content(locked=[5, 0, 5], kept=kept))
    assert data.locked == [0, 5]
    assert data.kept == hull_io.Kept(stations=[1, 4], waterlines=[2])
    hull_io.write_hull_file(data, tmp_path / "again.hull.json")
    again = hull_io.read_hull_file(tmp_path / "again.hull.json")
    assert (again.locked, again.kept) == (data.locked, data.kept)
    # Files of hulls without any are as they were.
    data.locked, data.kept = [], hull_io.Kept()
    hull_io.write_hull_file(data, tmp_path / "none.hull.json")
    assert not {"locked", "kept"} & set(json.loads((tmp_path / "none.hull.json").read_text()))
    assert hull_io.read_hull_file(tmp_path / "none.hull.json").kept == hull_io.Kept()


@pytest.mark.parametrize(
    "changes, where",
    [({"locked": [6]}, "locked[0]"), ({"locked": 1}, "locked"), ({"kept": {"x": [1]}}, "kept"),
     ({"kept": {"stations": [1, -1]}}, "kept.stations[1]"), ({"kept": []}, "kept")],
)  # fmt: skip
def test_wrong_locked_and_kept_points_are_named(read, changes, where):
    with pytest.raises(hull_io.HullFileError) as caught:
        read(content(**changes))
    assert where in str(caught.value)


def test_split_and_mirrored_points_keep_what_they_are(read):
    """Two boxes' sides that meet in a point part there; the mirror image has the same."""
    data = read(content(locked=[3, 5], kept={"stations": [3], "buttocks": [4]}))
    mirror.mirror_faces(data, range(len(data.faces)))
    points = data.points.tolist()
    assert [points[i] for i in data.locked] == [
        [0, 2, 0], [10, 2, 3], [0, -2, 0], [10, -2, 3]
    ]  # fmt: skip
    assert [points[i] for i in data.kept.stations] == [[0, 2, 0], [0, -2, 0]]
    assert [points[i] for i in data.kept.buttocks] == [[0, 2, 3], [0, -2, 3]]
