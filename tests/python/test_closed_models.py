# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed models: every side twice, the exact volume within tolerance times area, layers that
integrate to it; their files by programs that are not ours."""

import math
import os
import shutil
import subprocess
import zipfile
from xml.etree import ElementTree

import hull_io
import hull_native as hn
import numpy as np
import pytest
from model_checkers import ADMESH, FREECAD, admesh, freecad
from production_hulls import SAMPLES, body_of, hemisphere, odd_sides

ASSIMP = shutil.which("assimp")

# Of the length between perpendiculars.
TOLERANCES = [8e-4, 4e-4, 2e-4]

# The cube of edge 2 about the origin.
CUBE = np.array([[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)], dtype=float)
CUBE_FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
CUBE_TRIANGLES = [t for a, b, c, d in CUBE_FACES for t in ((a, b, c), (a, c, d))]


def whole_volume(body):
    points = body.surface.mesh.points
    return body.immersion([0.0, 0.0, 1.0], points[:, 2].max() + np.ptp(points[:, 0])).volume


@pytest.mark.parametrize("name", SAMPLES)
def test_closed_and_near(name):
    sample, body = body_of(name)
    exact = whole_volume(body)
    for part in TOLERANCES:
        tolerance = part * sample.ship.length_pp
        model = hn.closed_model(body, tolerance)
        assert model.open_sides == 0
        assert abs(model.volume - exact) <= tolerance * model.area
        points, triangles = model.points, model.triangles
        assert (np.bincount(triangles.ravel(), minlength=len(points)) > 0).all()
        assert points.min(axis=0)[1] == pytest.approx(-points.max(axis=0)[1], abs=1e-9)
    odd, _ = odd_sides(points, triangles)
    assert not len(odd)


@pytest.mark.parametrize("name", ["coaster", "catamaran", "sailing_yacht"])
def test_scaled_model_stays_closed(name):
    sample, body = body_of(name)
    model = hn.closed_model(body, 4e-4 * sample.ship.length_pp)
    small = model.scaled(1000 / 100)
    assert small.open_sides == 0
    assert (small.points == small.points.astype(np.float32)).all()
    assert small.volume == pytest.approx(model.volume * 1e3, rel=1e-6)


def test_what_vanishes_leaves_it_closed():
    """A corner cut off by less than single precision tells apart is one point again."""
    d = 1e-9
    points = np.vstack([CUBE, [1.0, 1.0, 1.0 - d], [1.0 - d, 1.0, 1.0], [1.0, 1.0 - d, 1.0]])
    # Point 7, (1, 1, 1), gives way to 8, 9, 10 and a triangle between them.
    faces = [(0, 2, 3, 1), (4, 5, 10, 9, 6), (0, 1, 5, 4), (2, 6, 9, 8, 3), (0, 4, 6, 2)]
    faces += [(1, 3, 8, 10, 5), (8, 9, 10)]
    triangles = [(f[0], f[k], f[k + 1]) for f in faces for k in range(1, len(f) - 1)]
    points, triangles = np.delete(points, 7, axis=0), np.array(triangles)
    triangles = np.where(triangles > 7, triangles - 1, triangles)
    model = hn.ClosedModel(points, triangles)
    assert len(model.triangles) == 16
    small = model.scaled(1.0)
    assert len(small.triangles) == 12 and len(small.points) == 8 and small.open_sides == 0
    assert small.volume == 8.0


def test_layers_of_a_cube():
    layers = hn.ClosedModel(CUBE, CUBE_TRIANGLES).layers(0.3)
    assert len(layers.slices) == 7 and layers.bottom == -1.0
    assert layers.tops[-1] == 1.0 and layers.tops[0] == pytest.approx(-0.7)
    for one in layers.slices:
        assert one.area == pytest.approx(4.0, rel=1e-14) and len(one.contours) == 1
    assert layers.volume == pytest.approx(8.0, rel=1e-14)


def test_a_hollow_runs_clockwise():
    inner = 0.5 * CUBE
    reversed_faces = [t[::-1] for t in CUBE_TRIANGLES]
    model = hn.ClosedModel(
        np.vstack([CUBE, inner]), np.vstack([CUBE_TRIANGLES, np.add(reversed_faces, 8)])
    )
    (one,) = model.slices([0.1])
    turns = sorted(
        np.sum(c[:, 0] * np.roll(c[:, 1], -1) - np.roll(c[:, 0], -1) * c[:, 1]) / 2
        for c in one.contours
    )
    assert turns == pytest.approx([-1.0, 4.0]) and one.area == pytest.approx(3.0)
    # At the height of points these count as above: nothing of the top, all of the bottom.
    low, high = model.slices([-1.0, 1.0])
    assert not low.contours and high.area == pytest.approx(4.0)


def areas_between(model):
    """(gaps between the heights of points, areas (3, n) just above, amid and just below them): a
    polyhedron's areas are quadratic in between."""
    height = np.ptp(model.points[:, 2])
    levels = np.unique(np.round(model.points[:, 2], 12))
    levels = levels[np.append(True, np.diff(levels) > 1e-6 * height)]
    ends = 1e-9 * height
    inner = np.stack([levels[:-1] + ends, 0.5 * (levels[:-1] + levels[1:]), levels[1:] - ends])
    return np.diff(levels), np.array([[one.area for one in model.slices(row)] for row in inner])


@pytest.mark.parametrize("name", SAMPLES)
def test_slices_integrate_to_the_volume(name):
    """By Simpson's rule exactly; by layers within half a layer times the sum of all changes of the
    area A: |∫ A dz - Σ A h| <= h/2 ∫ |dA|."""
    sample, body = body_of(name)
    model = hn.closed_model(body, 8e-4 * sample.ship.length_pp)
    gaps, areas = areas_between(model)
    exact = np.sum(gaps * (areas[0] + 4.0 * areas[1] + areas[2]) / 6.0)
    assert exact == pytest.approx(model.volume, rel=1e-5)
    changes = np.abs(np.diff(np.concatenate([[0.0], areas.T.ravel(), [0.0]]))).sum()
    height = np.ptp(model.points[:, 2])
    for count in (25, 100, 400):
        off = abs(model.layers(height / count).volume - model.volume)
        assert off <= 0.5 * height / count * changes


@pytest.mark.parametrize("name", ["coaster", "planing_boat", "catamaran"])
def test_layers_converge(name):
    """At second order where areas change smoothly; where a flat bottom or deck begins, at first
    order of a part of one layer."""
    sample, body = body_of(name)
    model = hn.closed_model(body, 4e-4 * sample.ship.length_pp)
    height = np.ptp(model.points[:, 2])
    errors = [abs(model.layers(height / n).volume / model.volume - 1.0) for n in (25, 50, 100, 200)]
    assert errors[-1] < 1e-3 and errors[-1] < errors[0] / 8


def test_ball():
    model = hn.closed_model(hn.HullBody(hemisphere(5.0), mirrored=False), 2e-3)
    # The segment of a sphere up to its level edge: π h² (3 r - h) / 3.
    height = 5.0 + model.points[:, 2].max()
    assert model.volume == pytest.approx(math.pi * height**2 * (15.0 - height) / 3, rel=1e-3)


@pytest.fixture(scope="module")
def printed(tmp_path_factory):
    """The coaster at 1:100, in mm: model, and its files."""
    folder = tmp_path_factory.mktemp("models")
    _, body = body_of("coaster")
    model = hn.closed_model(body, 0.02).scaled(1000 / 100)
    hull_io.write_stl(folder / "hull.stl", model.points, model.triangles)
    hull_io.write_3mf(folder / "hull.3mf", model.points, model.triangles, title="A <hull> & more")
    hull_io.write_obj(folder / "hull.obj", model.points, model.triangles)
    return model, folder


@pytest.mark.skipif(ADMESH is None, reason="admesh is not installed")
@pytest.mark.parametrize("name", SAMPLES)
def test_admesh_finds_it_closed(name, tmp_path):
    sample, body = body_of(name)
    model = hn.closed_model(body, 4e-4 * sample.ship.length_pp).scaled(10.0)
    hull_io.write_stl(tmp_path / "hull.stl", model.points, model.triangles)
    faults, facets, _, volume = admesh(tmp_path / "hull.stl")
    assert not faults and facets == {len(model.triangles)}
    # admesh sums in single precision.
    assert volume == pytest.approx(model.volume, rel=1e-3)


@pytest.mark.skipif(FREECAD is None, reason="FreeCAD is not installed")
def test_freecad_finds_it_closed(printed, tmp_path):
    """The coaster in both files, and all samples, whole: one process for all."""
    model, folder = printed
    models = {folder / "hull.stl": model, folder / "hull.obj": model}
    for name in SAMPLES:
        sample, body = body_of(name)
        path = tmp_path / f"{name}.stl"
        models[path] = hn.closed_model(body, 8e-4 * sample.ship.length_pp).scaled(10.0)
        hull_io.write_stl(path, models[path].points, models[path].triangles)
    found = freecad(models, tmp_path)
    for path, model in models.items():
        one = found[str(path)]
        assert one["solid"] and not one["loose"], path
        # The yacht's fin is a closed shell of its own that reaches into the hull's.
        assert one["crossed"] == (path.stem == "sailing_yacht"), path
        assert one["facets"] == len(model.triangles)
        assert one["volume"] == pytest.approx(model.volume, rel=1e-5)


@pytest.mark.skipif(ASSIMP is None, reason="assimp is not installed")
def test_3mf_opens_elsewhere(printed, tmp_path):
    model, folder = printed
    out = tmp_path / "again.stl"
    subprocess.run(
        [ASSIMP, "export", folder / "hull.3mf", out], capture_output=True, check=True, timeout=300
    )
    points, triangles = hull_io.read_stl(out)
    again = hn.ClosedModel(points, triangles)
    assert len(again.triangles) == len(model.triangles)
    assert again.volume == pytest.approx(model.volume, rel=1e-4)


def test_3mf_parts(printed):
    model, folder = printed
    with zipfile.ZipFile(folder / "hull.3mf") as package:
        assert package.namelist()[0] == "[Content_Types].xml"
        root = ElementTree.fromstring(package.read("3D/3dmodel.model"))
    space = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
    assert root.get("unit") == "millimeter"
    assert root.find(f"{space}metadata").text == "A <hull> & more"
    points = [[float(v.get(k)) for k in "xyz"] for v in root.iter(f"{space}vertex")]
    assert (np.array(points, dtype=np.float32) == model.points).all()
    triangles = [[int(t.get(k)) for k in ("v1", "v2", "v3")] for t in root.iter(f"{space}triangle")]
    assert (np.array(triangles) == model.triangles).all()


def test_cli_layers(printed, tmp_path):
    model, _ = printed
    layers = model.layers(0.75)
    path = tmp_path / "hull.cli"
    hull_io.write_cli(path, layers)
    rows = path.read_text().splitlines()
    assert rows[:4] == ["$$HEADERSTART", "$$ASCII", "$$UNITS/1", "$$VERSION/200"]
    assert f"$$LAYERS/{len(layers.slices)}" in rows and rows[-1] == "$$GEOMETRYEND"
    volume, top, under, turns = 0.0, 0.0, 0.0, set()
    for row in rows:
        if row.startswith("$$LAYER/"):
            under, top = top, float(row.split("/")[1])
        elif row.startswith("$$POLYLINE/"):
            _, way, count, *numbers = row.split("/")[1].split(",")
            x, y = np.array(numbers, dtype=float).reshape(int(count), 2).T
            assert (x[0], y[0]) == (x[-1], y[-1])
            area = np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]) / 2
            assert (area > 0) == (way == "1")
            turns.add(way)
            volume += area * (top - under)
    assert turns == {"1"} and volume == pytest.approx(layers.volume, rel=1e-6)
    assert top == pytest.approx(np.ptp(model.points[:, 2]))


@pytest.mark.parametrize(
    "tolerance, words", [(0.0, "positive length, not 0"), (1e-7, "m would do")]
)
def test_tolerances_refused(tolerance, words):
    with pytest.raises(ValueError, match=words):
        hn.closed_model(body_of("coaster")[1], tolerance)


def test_models_refused(tmp_path):
    cube = hn.ClosedModel(CUBE, CUBE_TRIANGLES)
    astray = [np.where(np.arange(8)[:, None] == 3, one, CUBE) for one in (np.nan, np.inf)]
    for call, words in (
        (lambda: hn.ClosedModel(CUBE, CUBE_TRIANGLES[:-1]), "do not enclose"),
        (lambda: hn.ClosedModel(CUBE, [(0, 1, 9)]), "no point"),
        (lambda: hn.ClosedModel(astray[0], CUBE_TRIANGLES), r"points\[3\] is not of finite"),
        (lambda: hn.ClosedModel(astray[1], CUBE_TRIANGLES), r"points\[3\] is not of finite"),
        (lambda: cube.covers([[0.0, 0.0, 0.0], [np.nan, 0.0, 0.0]]), r"points\[1\] is not of"),
        (lambda: hn.places_covered(astray[0], CUBE_TRIANGLES, CUBE), r"points\[3\] is not of"),
        (lambda: hn.places_covered(CUBE, CUBE_TRIANGLES, astray[1]), r"places\[3\] is not of"),
        (lambda: cube.scaled(1e39), "single precision"),
        (lambda: cube.scaled(0.0), "positive number"),
        (lambda: cube.scaled(1e-60), "nothing is left"),
        (lambda: cube.layers(0.0), "positive length"),
        (lambda: cube.layers(1e-7), "would do"),
        (lambda: cube.slices([1.0, 0.5]), "rise"),
    ):
        with pytest.raises(ValueError, match=words):
            call()
    with pytest.raises(hull_io.HullFileError, match="can't be written"):
        hull_io.write_3mf(tmp_path / "none" / "a.3mf", CUBE, CUBE_TRIANGLES)
    assert not list(tmp_path.iterdir())


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="there is no full device")
def test_a_full_disk_leaves_the_old_file(tmp_path, monkeypatch):
    path = tmp_path / "hull.3mf"
    path.write_bytes(b"before")
    real = os.fdopen
    monkeypatch.setattr(
        os,
        "fdopen",
        lambda handle, mode: (os.close(handle), real(os.open("/dev/full", os.O_WRONLY), mode))[1],
    )
    with pytest.raises(hull_io.HullFileError, match="free space"):
        hull_io.write_3mf(path, CUBE, CUBE_TRIANGLES)
    monkeypatch.undo()
    assert path.read_bytes() == b"before" and list(tmp_path.iterdir()) == [path]


def test_covers_in_the_largest_model():
    """Whose sizes no number tells: the sum of its coordinates is beyond all of them."""
    huge = hn.ClosedModel(1.5e308 * CUBE, CUBE_TRIANGLES)
    assert list(huge.covers([[0.0, 0.0, 1.6e308]])) == [False]
