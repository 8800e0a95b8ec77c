# SPDX-License-Identifier: GPL-3.0-or-later
"""B-spline surfaces in PolyCAD's files: evaluated against Bernstein polynomials and by hand."""

import hull_io
import numpy as np
import pytest
from hull_io.geometry import polycad, read_geometry


def written(tmp_path, grid, orders=(4, 4), extra=""):
    """A file of one surface with control points (u, v, 3)."""
    rows = ["$POLYCADVERSION=10", extra, "[TBSplineSurface]", "Name=Hull", "KnotType=0"]
    rows += [f"OrderU={orders[0]}", f"OrderV={orders[1]}"]
    rows += [f"NumU={grid.shape[0]}", f"NumV={grid.shape[1]}"]
    rows += [" ".join(f"{v:.9f}" for v in point) + " 1.0" for point in grid.reshape(-1, 3)]
    path = tmp_path / "hull.geo"
    path.write_text("\r\n".join(rows) + "\r\n")
    return path


def random_grid(u, v):
    x, y = np.meshgrid(np.arange(u), np.arange(v), indexing="ij")
    bend = np.random.default_rng(25).normal(size=(u, v))
    return np.stack([10.0 * x, y, bend], axis=-1)


def bernstein(points, t):
    a, b, c, d = points
    return (1 - t) ** 3 * a + 3 * t * (1 - t) ** 2 * b + 3 * t**2 * (1 - t) * c + t**3 * d


def test_a_bezier_patch_is_evaluated(tmp_path):
    grid = random_grid(4, 4)
    (mesh,) = read_geometry(written(tmp_path, grid)).meshes
    side = np.linspace(0.0, 1.0, 7)
    wanted = [bernstein([bernstein(row, v) for row in grid], u) for u in side for v in side]
    np.testing.assert_allclose(mesh.points, wanted, atol=1e-8)
    assert len(mesh.triangles) == 2 * 36 and mesh.group == "TBSplineSurface"


def test_larger_surfaces_pass_through_their_corners_and_have_the_usual_knots(tmp_path):
    grid = random_grid(7, 5)
    (mesh,) = read_geometry(written(tmp_path, grid, orders=(3, 2))).meshes
    places = mesh.points.reshape(5 * 6 + 1, 4 * 6 + 1, 3)
    for i in (0, -1):
        for j in (0, -1):
            np.testing.assert_allclose(places[i, j], grid[i, j], atol=1e-8)
    # Of second order in v: straight between control points; in u, at an inner knot of a quadratic
    # spline with uniform knots, the middle of two control points.
    np.testing.assert_allclose(places[6, 6], 0.5 * (grid[1, 1] + grid[2, 1]), atol=1e-8)


def test_several_surfaces_are_several_meshes(tmp_path):
    path = written(tmp_path, random_grid(4, 4))
    path.write_text(path.read_text() + path.read_text() + "[TContours]\nNum=1\n1 5.0\n")
    found = read_geometry(path)
    assert [mesh.name for mesh in found.meshes] == ["surface 1", "surface 2"]
    assert (found.format, found.unit, found.on_ship_axes) == ("PolyCAD", "m", True)


@pytest.mark.parametrize(
    "change, words",
    [
        (("NumU=4", "NumU=5"), "5 times 4 points are announced, and 16 are there"),
        (("NumU=4", "NumU=x"), "'NumU=x' is no whole number"),
        (("NumU=4", ""), "'NumU=' is no whole number"),
        (("NumV=4", "NumV=999999"), "no whole number"),
        (("OrderU=4", "OrderU=1"), "'OrderU=1' is no whole number"),
        (("10.000000000 0.0", "1e30 0.0"), "can't be a ship's"),
        (("10.000000000 0.0", "1..2 0.0"), "line 14: '1..2 0.0"),
        (("10.000000000 1.000000000 ", "10.0 1.0 1abc "), "line 15: '10.0 1.0 1abc "),
        (("10.000000000 1.000000000 ", "10.0 1.0 0,3 "), "line 15: '10.0 1.0 0,3 "),
        (("[TBSplineSurface]", "[TShipLines] x"), "no line begins a surface"),
    ],
)
def test_damaged_files_are_refused(tmp_path, change, words):
    path = written(tmp_path, random_grid(4, 4))
    path.write_text(path.read_text().replace(*change, 1))
    with pytest.raises(hull_io.HullFileError) as caught:
        read_geometry(path)
    assert words in str(caught.value) and str(caught.value).startswith("hull.geo")


def test_places_of_all_surfaces_are_counted(tmp_path, monkeypatch):
    """They are 36 times as many as the file has points."""
    path = written(tmp_path, random_grid(4, 4))
    path.write_text(path.read_text() + path.read_text())
    monkeypatch.setattr(polycad, "MAX_GEOMETRY_POINTS", 2 * 49)
    assert sum(len(mesh.points) for mesh in read_geometry(path).meshes) == 2 * 49
    monkeypatch.setattr(polycad, "MAX_GEOMETRY_POINTS", 2 * 49 - 1)
    with pytest.raises(hull_io.HullFileError, match="line 28: its surfaces up to here have more"):
        read_geometry(path)
