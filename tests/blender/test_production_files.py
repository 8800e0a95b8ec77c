# SPDX-License-Identifier: GPL-3.0-or-later
"""Models and panels written in Blender: what the functions of the module make."""

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, part


def read_stl(path):
    data = path.read_bytes()
    records = np.frombuffer(
        data, np.dtype([("n", "<f4", 3), ("p", "<f4", (3, 3)), ("a", "<u2")]), -1, 84
    )
    return records["p"].astype(float)


def test_model_is_closed_at_its_scale(tmp_path):
    add_hull()
    path = tmp_path / "box.stl"
    assert bpy.ops.hull.export_model(filepath=str(path), scale=10.0) == {"FINISHED"}
    a, b, c = read_stl(path).transpose(1, 0, 2)
    volume = np.sum(np.cross(a, b) * c) / 6.0
    # The box of the tests is 10 x 4 x 3 m.
    assert volume == pytest.approx(120.0 * 1e9 / 1e3, rel=1e-6)


@pytest.mark.parametrize("ending", ["3mf", "obj", "cli"])
def test_other_files_of_the_model(tmp_path, ending):
    add_hull()
    path = tmp_path / f"box.{ending}"
    assert bpy.ops.hull.export_model(filepath=str(path), layer=1.0) == {"FINISHED"}
    assert path.stat().st_size > 300
    if ending == "cli":
        assert "$$LAYERS/30" in path.read_text()


def test_panels_of_the_hull_as_it_floats(tmp_path):
    hull = add_hull()
    hull.hull.draft = 2.0
    path = tmp_path / "box.gdf"
    assert bpy.ops.hull.export_panels(filepath=str(path), along=20) == {"FINISHED"}
    title, _, symmetry, count, *rows = path.read_text().splitlines()
    assert title and int(count) == len(rows)
    corners = np.array([row.split() for row in rows], dtype=float).reshape(-1, 4, 3)
    assert corners[..., 2].max() == 0.0 and corners[..., 2].min() == pytest.approx(-2.0)
    half = symmetry.split()[1] == "1"
    a, b, c, d = corners.transpose(1, 0, 2)
    flux = np.sum(corners.mean(axis=1)[:, 2] * np.cross(c - a, d - b)[:, 2] / 2)
    assert flux * (2 if half else 1) == pytest.approx(80.0, rel=1e-9)
    assert bpy.ops.hull.export_panels(filepath=str(tmp_path / "box.dat")) == {"FINISHED"}
    assert (tmp_path / "box.dat").read_text().splitlines()[-1] == "0 0 0 0"


def test_a_hull_out_of_the_water_is_one_sentence(tmp_path):
    hull = add_hull()
    hull.hull.draft = 0.0
    with pytest.raises(RuntimeError, match="out of the water|draft"):
        bpy.ops.hull.export_panels(filepath=str(tmp_path / "box.gdf"))
    assert not list(tmp_path.iterdir())


def test_too_many_triangles_is_one_sentence(tmp_path, monkeypatch):
    add_hull()
    monkeypatch.setattr(part("bridge.limits"), "MOST_MODEL_TRIANGLES", 10)
    with pytest.raises(RuntimeError, match="larger tolerance"):
        bpy.ops.hull.export_model(filepath=str(tmp_path / "box.stl"))
    assert not list(tmp_path.iterdir())
