# SPDX-License-Identifier: GPL-3.0-or-later
"""Variants of studies: they are what the functions of hull_native make of them, whatever was made
before; what can't be made is a row with its reason."""

from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest
import vessels
from coaster_study import described
from hull_studies import hull_set, study_from
from hull_studies.evaluation import Evaluator, task_of

ROOT = Path(__file__).resolve().parents[2]
SAMPLES = ROOT / "samples"
SEED = 20261124
COASTER = "coaster.hull.json"
FIELD = {"base": "point", "point": [64, 6, 4], "shift": [0, 1, 0], "extent": 9}


def study(changes, variables=None, rows=((),), hulls=(COASTER,), **more):
    """A Study of the coaster with a list of rows."""
    description = {
        "hulls": list(hulls),
        "variables": variables or {},
        "sampling": {"kind": "list", "rows": rows},
        "changes": changes,
        **more,
    }
    return study_from(description, SAMPLES)


def rows_of(made):
    evaluator = Evaluator(task_of(made, hull_set(made)))
    return [evaluator.row(values) for values in made.variants]


def test_what_only_we_can_get_wrong_names_the_variant(monkeypatch):
    def fail(*arguments, **named):
        raise RuntimeError("no")

    monkeypatch.setattr(hn, "hydrostatics", fail)
    with pytest.raises(RuntimeError) as told:
        rows_of(study([{"change": "dimensions", "beam": "$b"}], {"b": [13, 14]}, [[13.5]]))
    assert told.value.__notes__ == ["That was of the study's variant {'b': 13.5}."]


def all_changes():
    """A study with each kind of change, whose first ones have few values."""
    wanted = {"number": "displaced_volume", "value": "$volume"}
    return study(
        [
            {"change": "weights", "weights": ["$finer"]},
            {"change": "dimensions", "beam": 13.9},
            {"change": "fields", "fields": [{**FIELD, "shift": [0, "$shift", 0]}]},
            {"change": "sections", "part": "whole", "lcb_percent": 0.4},
            {"change": "targets", "targets": [wanted]},
        ],
        {"finer": [0, 1], "shift": [0, 1], "volume": [4000, 5000]},
        [(w, s, v) for w in (0.0, 0.5) for s in (0.1, 0.3) for v in (4350.0, 4450.0)],
        [COASTER, {"changes": [{"change": "sections", "part": "fair", "block": 0.73}]}],
    )


@pytest.mark.parametrize("made", [study_from(described(12, SEED), SAMPLES), all_changes()])
def test_rows_do_not_depend_on_what_was_made_before(made):
    task = task_of(made, hull_set(made))
    evaluator = Evaluator(task)
    there = [evaluator.row(values) for values in made.variants]
    back = [evaluator.row(values) for values in reversed(made.variants)][::-1]
    alone = [Evaluator(task).row(values) for values in made.variants]
    assert there == back == alone
    assert {row.status for row in there} == {"made"}


def test_variants_are_what_the_functions_make_of_them():
    """Another way through the same numbers: no body, place or surface is used twice."""
    made = study_from(described(6, SEED), SAMPLES)
    hulls = hull_set(made)
    evaluator = Evaluator(task_of(made, hulls))
    arrays = (hulls.face_sizes, hulls.face_vertices, hulls.creases, hulls.corners)

    def surface_of(points):
        return hn.LimitSurface(hn.ControlMesh(points, *arrays), hulls.scheme)

    family = hn.HullFamily([surface_of(points) for points in hulls.parents])
    ship = {"length_pp": 84.0, "beam": 13.6, "design_draft": 5.2}
    for values in made.variants:
        finer, shoulders, flare, volume, lcb = values
        weights = [1 - (finer + shoulders + flare), finer, shoulders, flare]
        member = surface_of(family.points(weights))
        tied, directions = hn.square_ties(member)
        targets = [
            hn.FormTarget("displaced_volume", volume),
            hn.FormTarget("lcb_percent", lcb),
            hn.FormTarget("km_transverse", 6.1, sense="at least"),
        ]
        reached = hn.reach_targets(
            member, targets, mirrored=True, draft=5.2, **ship, beam_scale=(0.98, 1.02),
            held_points=hulls.held_points, held_normals=hulls.held_normals, tied=tied,
            tied_directions=directions, kept=hn.square_sums(member), locked=hulls.locked,
        )  # fmt: skip
        beam = 13.6 * reached.scale[1]
        body = hn.HullBody(surface_of(member.mesh.points + reached.moves), mirrored=True)
        there = hn.hydrostatics(body, draft=5.2, length_pp=84.0, beam=beam, design_draft=5.2)
        row = evaluator.row(values)
        assert row.status == "made" and row.reason == ""
        numbers = row.numbers
        assert numbers["beam"] == beam
        for name in ("displaced_volume", "lcb_percent", "km_transverse", "wetted_surface"):
            assert numbers[name] == getattr(there, name)
        assert numbers["displaced_volume"] == pytest.approx(volume, rel=1e-8)
        assert numbers["lcb_percent"] == pytest.approx(lcb, abs=1e-8)
        assert numbers["km_transverse"] >= 6.1 - 1e-8


def test_dimensions_scale_volumes():
    plain, scaled = rows_of(
        study(
            [{"change": "dimensions", "length_pp": "$length", "beam": "$beam", "draft": "$draft"}],
            {"length": [80, 100], "beam": [13, 15], "draft": [5, 6]},
            [[84.0, 13.6, 5.2], [96.6, 14.28, 5.46]],
        )
    )
    factor = 96.6 / 84.0 * 14.28 / 13.6 * 5.46 / 5.2
    ratio = scaled.numbers["displaced_volume"] / plain.numbers["displaced_volume"]
    assert ratio == pytest.approx(factor, rel=1e-10)
    names = ("project.block", "project.waterplane", "lcb_percent")
    for name in names:
        assert scaled.numbers[name] == pytest.approx(plain.numbers[name], rel=1e-9)
    assert scaled.numbers["depth"] == pytest.approx(7.4 * 5.46 / 5.2)


def test_sections_meet_block_and_lcb():
    made = study(
        [{"change": "sections", "part": "fair", "block": "$block", "lcb_percent": "$lcb"}],
        {"block": [0.7, 0.95], "lcb": [-1, 1]},
        [[0.73, 0.0], [0.745, 0.5], [0.95, 0.0]],
    )
    *reached, refused = rows_of(made)
    for (block, lcb), row in zip(made.variants, reached):
        assert row.numbers["project.block"] == pytest.approx(block, abs=1e-9)
        assert row.numbers["lcb_percent"] == pytest.approx(lcb, abs=1e-7)
        assert 0 <= row.numbers["sections.residual_rms"] < 0.2
    assert (refused.status, refused.numbers) == ("refused", {})
    assert "here" in refused.reason and "0." in refused.reason


def test_fields_shift_the_surface_around_them():
    made = study(
        [
            {
                "change": "fields",
                "fields": [{**FIELD, "shift": [0, "$shift", 0], "extent": "$reach"}],
            }
        ],
        {"shift": [-9, 9], "reach": [1, 20]},
        [[0.0, 12.0], [0.3, 12.0], [0.3, 18.0], [-8.0, 12.0]],
    )
    still, near, far, folded = rows_of(made)
    volume = [row.numbers["displaced_volume"] for row in (still, near, far)]
    assert volume[0] < volume[1] < volume[2]
    assert still.numbers["fields.residual_rms"] == 0.0
    assert folded.status == "refused" and "folds the hull at x" in folded.reason


def test_what_contradicts_itself_is_missed_with_its_reason():
    targets = [
        {"number": "displaced_volume", "value": 4400},
        {"number": "project.block", "value": 0.6},
    ]
    (row,) = rows_of(study([{"change": "targets", "targets": targets}]))
    assert row.status == "missed"
    assert "project.block is" in row.reason and "too great" in row.reason
    assert row.numbers["targets.project.block.miss"] > 0.05


def test_members_far_out_are_refused_with_the_place():
    made = study_from(described(1, 1), SAMPLES)
    evaluator = Evaluator(task_of(made, hull_set(made)))
    row = evaluator.row((90.0, -60.0, 50.0, 4400.0, 0.0))
    assert row.status == "refused" and "The member is folded at x" in row.reason


def test_weights_are_sought_in_the_family():
    wanted = {"number": "displaced_volume", "value": "$volume"}
    hulls = [COASTER, {"changes": [{"change": "sections", "part": "fair", "block": 0.72}]}]
    made = study(
        [
            {"change": "weights", "weights": [0.0]},
            {"change": "targets", "moves": "weights", "targets": [wanted]},
        ],
        {"volume": [4200, 4400]},
        [[4310.0], [4350.0]],
        hulls,
    )
    for (volume,), row in zip(made.variants, rows_of(made)):
        assert row.numbers["displaced_volume"] == pytest.approx(volume, rel=1e-8)
        weights = [row.numbers[f"targets.weight {k}"] for k in (1, 2)]
        assert sum(weights) == pytest.approx(1.0, abs=1e-12) and 0 < weights[1] < 1


def test_hulls_of_other_layouts_and_halves(tmp_path):
    data = hull_io.read_hull(SAMPLES / COASTER)
    hull_io.write_hull_file(data, tmp_path / "coaster.hull.json")
    surface = vessels.surface_of(data)
    finer = surface.refined_mesh()
    data.points = finer.points
    ends = np.cumsum(finer.face_sizes)[:-1]
    data.faces = [tuple(map(int, face)) for face in np.split(finer.face_vertices, ends)]
    data.creases = [tuple(map(int, edge)) for edge in finer.creases]
    data.corners = [int(one) for one in np.flatnonzero(finer.vertex_kinds >= 3)]
    data.flats, data.deck_edge, data.face_layers = [], [], [0] * len(data.faces)
    hull_io.write_hull_file(data, tmp_path / "finer.hull.json")
    base = {
        "variables": {"t": [0, 1]},
        "sampling": {"kind": "list", "rows": [[0.0], [0.5], [1.0]]},
        "changes": [{"change": "weights", "weights": ["$t"]}],
    }
    two = study_from({**base, "hulls": ["coaster.hull.json", "finer.hull.json"]}, tmp_path)
    volumes = [row.numbers["displaced_volume"] for row in rows_of(two)]
    assert volumes == pytest.approx([volumes[0]] * 3, rel=1e-9)
    demihull = study_from({**base, "hulls": [COASTER, "catamaran.hull.json"]}, SAMPLES)
    with pytest.raises(ValueError, match="Hull 2 has no part in the family"):
        hull_set(demihull)
    data.half = False
    hull_io.write_hull_file(data, tmp_path / "whole.hull.json")
    whole = study_from({**base, "hulls": ["coaster.hull.json", "whole.hull.json"]}, tmp_path)
    with pytest.raises(ValueError, match="Hull 2 of the study is a hull of both sides.*mirror"):
        hull_set(whole)
