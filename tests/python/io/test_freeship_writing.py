# SPDX-License-Identifier: GPL-3.0-or-later
"""FREE!ship files that are written: read back they are the same hull in single precision."""

from collections import Counter
from dataclasses import replace
from pathlib import Path

import hull_io
import numpy as np
import pytest
from hull_io.freeship import is_freeship
from hull_io.freeship_points import border_edges, irregular_knuckles, point_kinds
from hull_io.hull_data import edge_key

SAMPLES = sorted((Path(__file__).parents[3] / "samples").glob("*.hull.json"))


@pytest.fixture(params=SAMPLES, ids=lambda path: path.name.split(".")[0])
def sample(request):
    return hull_io.read_hull(request.param)


def written(data, tmp_path, unit="m"):
    path = tmp_path / "hull.fbm"
    remarks = hull_io.write_freeship(data, path, unit)
    assert is_freeship(path.read_bytes())
    return hull_io.read_hull(path), remarks


def implied_corners(data):
    """Points that are corners without being tagged: of three creases, and of borders' corners."""
    borders = border_edges(data.faces)
    creases = Counter(p for edge in borders | set(map(tuple, data.creases)) for p in edge)
    faces = Counter(p for face in data.faces for p in face)
    on_border = {p for edge in borders for p in edge}
    return {p for p, n in creases.items() if n >= 3 or p in on_border and faces[p] == 1}


def test_there_are_ten_samples():
    assert len(SAMPLES) == 10


@pytest.mark.parametrize("unit", ["m", "ft"])
def test_samples_read_back_equal_in_single_precision(sample, tmp_path, unit):
    read, _ = written(sample, tmp_path, unit)
    scale = 1.0 if unit == "m" else 0.3048
    single = (sample.points / scale).astype(np.float32).astype(np.float64) * scale
    np.testing.assert_array_equal(read.points, single)
    assert read.faces == sample.faces
    assert read.face_layers == sample.face_layers
    own = {edge_key(*edge) for edge in sample.creases}
    assert set(read.creases) == own | border_edges(sample.faces)
    assert set(read.corners) == set(sample.corners) | implied_corners(sample)
    assert (read.half, read.name, read.units) == (sample.half, sample.name, unit)
    assert [(layer.name, layer.in_hydrostatics) for layer in read.layers] == [
        (layer.name, layer.in_hydrostatics) for layer in sample.layers
    ]
    for found, given in zip(read.layers, sample.layers):
        np.testing.assert_allclose(found.colour, given.colour, atol=0.5 / 255 + 1e-9)
    for name in ("length_pp", "beam", "draft", "water_density"):
        # Half a unit in the last place of a draft of 20 m, twice: of itself and of the lowest.
        wanted = getattr(sample.particulars, name)
        assert getattr(read.particulars, name) == pytest.approx(wanted, rel=3e-7), name
    assert all("mended" not in note and "Left out" not in note for note in read.notes)


def test_samples_have_the_same_surface(sample, tmp_path):
    """Implied corners and borders tagged change nothing: points differ by rounding alone."""
    hn = pytest.importorskip("hull_native")
    read, _ = written(sample, tmp_path)
    surfaces = [
        hn.LimitSurface(hn.ControlMesh(*hull_io.shell_arrays(data).arguments()))
        for data in (sample, read)
    ]
    ours, theirs = (surface.evaluate_grid(4)[0] for surface in surfaces)
    size = np.ptp(sample.points, axis=0).max()
    np.testing.assert_allclose(theirs, ours, atol=1e-7 * size)


def box(**changes):
    """Half a box of four faces, open above, with sharp points."""
    points = [(x, y, z) for x in (0.0, 8.0) for y in (0.0, 2.0) for z in (-0.5, 3.0)]
    faces = [[2, 3, 7, 6], [0, 2, 6, 4], [0, 1, 3, 2], [4, 6, 7, 5]]
    hull = hull_io.HullData("Box", np.array(points), faces, creases=[(2, 6)], half=True)
    hull.corners = list(range(8))
    hull.particulars = hull_io.Particulars(8.0, 4.0, 1.0, water_density=1.025)
    return replace(hull, **changes)


def test_draft_is_from_the_lowest_point(tmp_path):
    data = box()
    read, remarks = written(data, tmp_path)
    assert read.particulars.draft == pytest.approx(1.0, abs=1e-6)
    assert any("from the lowest point, at z = -0.5 m: it is 1.5 m" in text for text in remarks)


def test_creases_of_a_deck_that_is_no_shell_do_not_count_for_the_draft(tmp_path):
    data = box()
    points = np.vstack([data.points, [(2.0, 0.0, 3.0), (6.0, 0.0, 3.0)]])
    deck = hull_io.Layer("Deck", in_hydrostatics=False)
    data = replace(
        data,
        points=points,
        faces=[*data.faces, [1, 3, 8], [3, 7, 9, 8]],
        layers=[hull_io.Layer("Hull"), deck],
        face_layers=[0] * 4 + [1] * 2,
        creases=[*data.creases, (8, 9), (3, 8)],
    )
    read, _ = written(data, tmp_path)
    assert read.particulars.draft == pytest.approx(1.0, abs=1e-6)


def test_spacings_that_would_fill_the_memory_are_refused(tmp_path):
    lines = hull_io.LineChoice(waterline_spacing=1e-9)
    with pytest.raises(hull_io.HullFileError, match="1e-09 m apart are more than 1000: take a"):
        hull_io.write_freeship(box(lines=lines), tmp_path / "box.fbm")


def test_stations_are_planes_within_the_hull(tmp_path):
    lines = hull_io.LineChoice(station_count=4, waterlines="0 1 2.5 7", buttock_spacing=1.5)
    path = tmp_path / "box.fbm"
    hull_io.write_freeship(box(lines=lines), path)
    found = hull_io.stored_sections(path)
    assert [(cut.kind, -cut.plane[3]) for cut in found] == [
        ("station", 2.0),
        ("station", 4.0),
        ("station", 6.0),
        ("buttock", 1.5),
        ("waterline", 0.0),
        ("waterline", 1.0),
        ("waterline", 2.5),
    ]
    assert all(not cut.curves for cut in found)


@pytest.mark.parametrize(
    "changes, words",
    [
        ({"faces": [[2, 3, 7], [2, 7, 6]], "face_layers": []}, "beside 2 of them"),
        ({"half": False}, "not symmetric"),
        ({"particulars": hull_io.Particulars(8.0, 0.0, 1.0)}, "The beam of the project"),
        ({"particulars": hull_io.Particulars(8.0, 4.0, -0.6)}, "below the lowest"),
        ({"load_cases": [hull_io.LoadCase("Full", 10.0)]}, "load cases"),
        ({"name": "Σκάφος"}, "letters of names"),
        ({"points": box().points + (1e4, 0.0, 0.0) + 1.0 / 3.0}, "single precision, by up to"),
    ],
)
def test_what_freeship_cannot_have_is_told(tmp_path, changes, words):
    _, remarks = written(box(**changes), tmp_path)
    assert any(words in text for text in remarks), remarks
    assert all(text.endswith(".") for text in remarks)


@pytest.mark.parametrize(
    "changes, words",
    [
        ({"faces": []}, "no faces"),
        ({"points": box().points * 1e6}, "further than"),
        ({"points": box().points * np.nan}, "further than"),
    ],
)
def test_hulls_that_are_refused(tmp_path, changes, words):
    path = tmp_path / "box.fbm"
    with pytest.raises(hull_io.HullFileError, match=words):
        hull_io.write_freeship(box(**changes, face_layers=[]), path)
    assert not path.exists()


def test_unit_that_is_unknown_is_refused(tmp_path):
    with pytest.raises(ValueError, match="unknown to FREE!ship"):
        hull_io.write_freeship(box(), tmp_path / "box.fbm", "cm")


def plate(creases):
    """Two rows of four quads in a plane."""
    points = [(x, y, 0.0) for y in range(3) for x in range(5)]
    quads = [
        [5 * y + x, 5 * y + x + 1, 5 * y + x + 6, 5 * y + x + 5] for y in (0, 1) for x in range(4)
    ]
    return hull_io.HullData("Plate", np.array(points), quads, creases=creases)


KNUCKLE = [(5 + x, 6 + x) for x in range(4)]


def test_kinds_of_points():
    row = [3, 1, 1, 1, 3]
    assert point_kinds(plate(KNUCKLE)) == row + [3, 1, 1, 1, 3] + row
    assert point_kinds(plate([])) == row + [1, 0, 0, 0, 1] + row
    assert point_kinds(plate([(6, 7)])) == row + [1, 2, 2, 0, 1] + row
    assert point_kinds(replace(plate([]), corners=[7])) == row + [1, 0, 3, 0, 1] + row


def test_sectors_beside_knuckles():
    """Along a knuckle through a row of quads all is regular; where it meets triangles it is not."""
    data = plate(KNUCKLE)
    assert irregular_knuckles(data) == []
    cut = replace(
        data, faces=[*data.faces[:5], [6, 7, 12], [6, 12, 11], *data.faces[6:]], face_layers=[]
    )
    # 6 has three faces on one side of the knuckle, 12 three on the border's.
    assert irregular_knuckles(cut) == [6, 12]
