# SPDX-License-Identifier: GPL-3.0-or-later
"""Mistakes in hull files are named: in the file, its mesh, its lines and its loads."""

import json

import pytest
from hull_file_content import assert_mistake_is_named, content

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
    "zeros": (content(resistance={"zeros": ["beam"]}), 'resistance.zeros: "beam" is unknown'),
    "zeros that are none": (content(resistance={"zeros": [[0]]}), "resistance.zeros: "),
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
    assert_mistake_is_named(tmp_path, *MISTAKES[case])
