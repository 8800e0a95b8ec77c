# SPDX-License-Identifier: GPL-3.0-or-later
"""Mistakes in hull files are named: in shape fields, targets, wanted area curves and variants."""

import pytest
from hull_file_content import assert_mistake_is_named, content, variant

MISTAKES = {
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
}


@pytest.mark.parametrize("case", MISTAKES)
def test_a_mistake_is_named(tmp_path, case):
    assert_mistake_is_named(tmp_path, *MISTAKES[case])
