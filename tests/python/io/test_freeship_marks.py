# SPDX-License-Identifier: GPL-3.0-or-later
"""Locked points, plating of layers and shown rows: into FREE!ship's files and back."""

from collections import Counter
from dataclasses import replace

import hull_io
import numpy as np
import pytest
from freeship_writer import binary_file, box_model, text_file
from hull_io import freeship, mirror
from hull_io.freeship_curves import control_curves
from hull_io.hull_curves import ControlCurve
from hull_io.hull_data import HullData, edge_key, face_edges
from test_freeship_writing import SAMPLES, box, plate, written

INCH, POUND_PER_CUBIC_FOOT = 0.0254, 1.025 / 65.016  # FREE!ship's own, of sea water


def marked(data, seed=2502):
    """A sample with locks, plating and rows at random: whole lines of the mesh and odd edges."""
    print("seed", seed)
    random = np.random.default_rng(seed)
    edges = sorted({edge_key(a, b) for face in data.faces for a, b in face_edges(face)})
    rows = [edges[k] for k in random.choice(len(edges), len(edges) // 4, replace=False)]
    layers = [
        replace(layer, thickness=random.uniform(0.001, 0.05), density=random.uniform(0.5, 12.0))
        for layer in data.layers
    ]
    locked = random.choice(len(data.points), len(data.points) // 3, replace=False)
    return replace(data, locked=sorted(locked.tolist()), layers=layers, shown_rows=sorted(rows))


@pytest.fixture(params=SAMPLES, ids=lambda path: path.name.split(".")[0])
def sample(request):
    return marked(hull_io.read_hull(request.param))


@pytest.mark.parametrize("unit", ["m", "ft"])
def test_samples_with_all_of_them_come_back(sample, tmp_path, unit):
    read, remarks = written(sample, tmp_path, unit)
    assert read.locked == sample.locked and len(read.locked) > 3
    assert read.shown_rows == sample.shown_rows and len(read.shown_rows) > 3
    for found, given in zip(read.layers, sample.layers):
        assert found.thickness == pytest.approx(given.thickness, rel=1.2e-7)
        assert found.density == pytest.approx(given.density, rel=1.2e-7 if unit == "m" else 3e-6)
    assert not any(word in text for text in remarks for word in ("lock", "row", "plating"))
    again, _ = written(read, tmp_path, unit)
    assert (again.locked, again.shown_rows, again.layers) == (
        read.locked,
        read.shown_rows,
        read.layers,
    )


def test_hull_files_keep_them(sample, tmp_path):
    hull_io.write_hull_file(sample, tmp_path / "ship.hull.json")
    read = hull_io.read_hull_file(tmp_path / "ship.hull.json")
    assert (read.locked, read.shown_rows) == (sample.locked, sample.shown_rows)
    assert read.layers == sample.layers


def test_each_edge_is_in_one_control_curve(sample):
    parts = Counter(
        edge_key(a, b) for curve in control_curves(sample) for a, b in zip(curve, curve[1:])
    )
    assert set(parts) == set(sample.shown_rows) and set(parts.values()) == {1}


def test_curves_go_straight_on_and_close():
    """Both lines through the middle of a plate of quads cross there; a ring ends where it begins,
    and a row that meets a point of five faces goes on where no other does."""
    row, column = [5, 6, 7, 8, 9], [2, 7, 12]
    pairs = [pair for line in (row, column) for pair in zip(line, line[1:])]
    assert control_curves(replace(plate([]), shown_rows=pairs)) == [column, row]
    tube = [[k, (k + 1) % 6, 6 + (k + 1) % 6, 6 + k] for k in range(6)]
    tube += [[a + 6 for a in face] for face in tube]
    ring = [edge_key(6 + k, 6 + (k + 1) % 6) for k in range(6)]
    (curve,) = control_curves(HullData("Tube", np.zeros((18, 3)), tube, shown_rows=ring))
    assert curve[0] == curve[-1] and sorted(curve[1:]) == list(range(6, 12))
    fan = [[0, 2 * k + 1, 2 * k + 2, (2 * k + 3 - 1) % 10 + 1] for k in range(5)]
    bent = replace(plate([]), points=np.zeros((11, 3)), faces=fan, face_layers=[])
    assert control_curves(replace(bent, shown_rows=[(0, 1), (0, 5)])) == [[1, 0, 5]]
    lone = [[1, 0], [3, 0], [5, 0]]
    found = control_curves(replace(bent, shown_rows=[(0, 1), (0, 3), (0, 5)]))
    assert sorted(sorted(curve) for curve in found) == sorted(sorted(curve) for curve in lone)


@pytest.mark.parametrize("units, metre, density", [(0, 1e-3, 1.0), (1, INCH, POUND_PER_CUBIC_FOOT)])
def test_plating_is_in_the_units_of_the_file(tmp_path, units, metre, density):
    """6 and 7.8 are what each layer of the model has, of version 1.91 on."""
    path = tmp_path / "box.fbm"
    for version, there in ((190, 0.0), (191, 1.0)):
        path.write_bytes(binary_file({**box_model(), "units": units}, version))
        for layer in hull_io.read_hull(path).layers:
            assert layer.thickness == pytest.approx(there * 6.0 * metre, rel=1e-12)
            assert layer.density == pytest.approx(there * 7.8 * density, rel=2e-5)


def test_plating_of_the_hull_is_that_of_the_layers_without(tmp_path):
    """FREE!ship weighs area x thickness x density of each layer: the shell weighs the same."""
    layers = [
        hull_io.Layer("Own", thickness=0.02, density=2.7),
        hull_io.Layer("Thick", thickness=0.03),
        hull_io.Layer("Bare"),
        hull_io.Layer("Deck", in_hydrostatics=False, density=0.6),
    ]
    data = box(layers=layers, weights=hull_io.Weights(0.01, 7.85))
    read, remarks = written(data, tmp_path)
    assert [(layer.thickness, layer.density) for layer in read.layers] == [
        (0.02, 2.7), (0.03, 7.85), (0.01, 7.85), (0.0, 0.6)
    ]  # fmt: skip
    assert not any("weights" in text for text in remarks)
    read, _ = written(box(layers=layers), tmp_path)
    assert [(layer.thickness, layer.density) for layer in read.layers][2:] == [(0, 0), (0, 0.6)]


@pytest.mark.parametrize("value", [-1.0, float("nan"), 1e9])
def test_plating_that_cannot_be_is_noted(tmp_path, value):
    path = tmp_path / "box.fbm"
    hull_io.write_freeship(box(layers=[hull_io.Layer("Hull", thickness=value, density=1.5)]), path)
    read = hull_io.read_hull(path)
    assert (read.layers[0].thickness, read.layers[0].density) == (0.0, 1.5)
    assert any(note.startswith("The file's thickness of layer Hull") for note in read.notes)
    hull_io.write_freeship(box(layers=[hull_io.Layer("Hull", thickness=0.01, density=value)]), path)
    read = hull_io.read_hull(path)
    assert (read.layers[0].thickness, read.layers[0].density) == (0.01, 0.0)
    assert any(note.startswith("The file's density of layer Hull") for note in read.notes)
    assert any("a thickness and no density: it is weighed with 7.85 t/m³" in n for n in read.notes)


@pytest.mark.parametrize("write, ending", [(binary_file, "fbm"), (text_file, "ftm")])
def test_control_curves_of_a_file(tmp_path, write, ending):
    """Curves are along edges of faces; what is none is left out, and told."""
    model = {**box_model(), "curves": [[3, 2, 6, 4], [2, 6], [0, 7], [5]]}
    path = tmp_path / f"box.{ending}"
    path.write_bytes(write(model, 335))
    read = hull_io.read_hull(path)
    assert read.shown_rows == [(2, 3), (2, 6), (4, 6)] and read.locked == list(range(8))
    assert any("Left out of control curves" in note and "1 parts" in note for note in read.notes)
    path.write_bytes(write({**model, "curves": [[2, 6], [2, 8]]}, 335))
    with pytest.raises(hull_io.HullFileError, match="control curve 1, .*it uses point 8, but the"):
        hull_io.read_hull(path)
    path.write_bytes(write(model, 190))
    assert hull_io.read_hull(path).locked == hull_io.read_hull(path).shown_rows == []


def test_curves_and_plating_of_freeships_files(freeship_files, tmp_path):
    """Three files have control curves, along edges all of them: 14, 3 and 4, and two have plating.
    All read the same once they are written, and curves are the same lists but for where they end
    on corners."""
    counts = {
        "FREE!ship demo tug.fbm": (14, 75),
        "board.ftm": (3, 18),
        "pdock+weght_symm.fbm": (4, 14),
    }
    plated = {"board.ftm": (0.006, 0.6), "pdock+weght_symm.fbm": (0.01, 10.0)}
    paths = {path.name: path for path in freeship_files}
    for name, (count, edges) in counts.items():
        path = paths[name]
        data = hull_io.read_hull(path)
        cursor, version = freeship._open(path.read_bytes(), name)
        stored = freeship._read_model(cursor, version).curves
        assert (len(stored), len(data.shown_rows)) == (count, edges)
        if name != "board.ftm":
            own = {min(tuple(curve), tuple(curve[::-1])) for curve in control_curves(data)}
            assert own == {min(tuple(curve), tuple(curve[::-1])) for curve in stored}
        found = {(layer.thickness, layer.density) for layer in data.layers if layer.thickness}
        assert found == ({plated[name]} if name in plated else set())
        again, _ = written(data, tmp_path)
        assert again.shown_rows == data.shown_rows and again.locked == data.locked
        assert [(one.thickness, one.density) for one in again.layers] == [
            (one.thickness, one.density) for one in data.layers
        ]


def test_the_other_side_has_them_too():
    data = box(shown_rows=[(2, 6), (3, 7)], locked=[2])
    mirror.mirror_faces(data, range(len(data.faces)))
    places = {frozenset(tuple(data.points[p]) for p in edge) for edge in data.shown_rows}
    assert len(places) == len(data.shown_rows) == 4
    assert places == {frozenset((x, -y, z) for x, y, z in edge) for edge in places}


def test_damaged_copies_are_refused_in_a_sentence_or_read(tmp_path):
    """Cut anywhere, or a byte of anything changed: no other error, and indices are in range."""
    data = marked(hull_io.read_hull(SAMPLES[0]))
    path, random = tmp_path / "ship.fbm", np.random.default_rng(2503)
    hull_io.write_freeship(data, path)
    whole, refused = path.read_bytes(), 0
    for number in range(120):
        copy = bytearray(whole)
        if number % 2:
            copy = copy[: random.integers(len(copy))]
        else:
            copy[random.integers(len(copy))] ^= 1 << random.integers(8)
        path.write_bytes(copy)
        try:
            read = hull_io.read_hull(path)
        except hull_io.HullFileError as error:
            refused += 1
            assert str(error).endswith(".") and "\n" not in str(error)
        else:
            count = len(read.points)
            assert all(0 <= point < count for edge in read.shown_rows for point in edge)
            assert all(0 <= point < count for point in read.locked)
            assert all(layer.thickness >= 0.0 <= layer.density for layer in read.layers)
    assert refused >= 50


@pytest.mark.parametrize(
    "changes, words",
    [
        ({"load": hull_io.Load(mass_t=12.0)}, "the load"),
        ({"afloat": hull_io.Afloat(heel_deg=3.0)}, "trim and heel"),
        ({"weights": hull_io.Weights(items=[hull_io.Weight("Mast", 0.1)])}, "weights beside"),
        ({"plating": hull_io.Plating([hull_io.SeamRule("strakes", 2.0)])}, "seams of plates"),
        ({"lines": hull_io.LineChoice(diagonals="2/45")}, "diagonals"),
        ({"curves": [ControlCurve("chine", [(0, 1)], True)]}, "names of control curves"),
    ],
)
def test_what_is_not_in_the_file_is_told(tmp_path, changes, words):
    _, remarks = written(box(**changes), tmp_path)
    assert any(text.startswith("Not in FREE!ship's files") and words in text for text in remarks)
    _, remarks = written(box(), tmp_path)
    assert not any(text.startswith("Not in FREE!ship's files") for text in remarks)
