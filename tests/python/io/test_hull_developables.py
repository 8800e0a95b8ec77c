# SPDX-License-Identifier: GPL-3.0-or-later
"""Developable regions in hull files, and FREE!ship's flag of layers."""

import json

import hull_io
import numpy as np
import pytest
from freeship_writer import VERSIONS, binary_file, box_model
from hull_io import hull_developables

REGION = {"faces": [1], "warp": 0.5, "distance": 0.02}


def data(**changes):
    points = np.array([[0, 0, 0], [9, 0, 0], [9, 2, 0], [0, 2, 0], [0, 2, 3], [9, 2, 3.0]])
    return hull_io.HullData(
        "Box", points, [[0, 3, 2, 1], [3, 4, 5, 2]], face_layers=[0, 0], half=True, **changes
    )


def test_written_and_read(tmp_path):
    regions = [hull_io.Developable([1], 0.5, 0.02), hull_io.Developable([0], keep=False)]
    path = tmp_path / "box.hull.json"
    hull_io.write_hull_file(data(developables=regions), path)
    assert hull_io.read_hull_file(path).developables == regions


def test_a_file_without_any_has_no_key(tmp_path):
    path = tmp_path / "box.hull.json"
    hull_io.write_hull_file(data(), path)
    assert "developables" not in path.read_text()
    assert hull_io.read_hull_file(path).developables == []


@pytest.mark.parametrize(
    "regions, told",
    [
        ([{**REGION, "faces": []}], r"developables\[0\].faces"),
        ([{**REGION, "faces": [7]}], "face"),
        ([REGION, REGION], "named twice"),
        ([{**REGION, "warp": 0.0}], "warp"),
        ([{**REGION, "distance": -1.0}], "distance"),
        ([{"faces": [0], "warp": 1.0}], "distance: it is missing"),
    ],
)
def test_mistakes_are_refused_with_their_place(tmp_path, regions, told):
    path = tmp_path / "box.hull.json"
    hull_io.write_hull_file(data(developables=[hull_io.Developable([0])]), path)
    content = json.loads(path.read_text())
    content["developables"] = regions
    path.write_text(json.dumps(content))
    with pytest.raises(hull_io.HullFileError, match=told):
        hull_io.read_hull_file(path)


def test_regions_end_at_creases():
    whole = hull_developables.between_knuckles(data(), [0, 1])
    assert [region.faces for region in whole] == [[0, 1]]
    parted = hull_developables.between_knuckles(data(creases=[(2, 3)]), [0, 1])
    assert [region.faces for region in parted] == [[0], [1]]


@pytest.mark.parametrize("version", VERSIONS)
def test_freeship_s_developable_layers(tmp_path, version):
    path = tmp_path / "box.fbm"
    path.write_bytes(binary_file({**box_model(), "developable": {1}}, version))
    (region,) = hull_io.read_hull(path).developables
    assert region.faces == [4] and not region.keep
    path.write_bytes(binary_file(box_model(), version))
    assert hull_io.read_hull(path).developables == []
