# SPDX-License-Identifier: GPL-3.0-or-later
"""Named parts of a hull for CFD, segments as files, splines in space as DXF; what can't be written
leaves all as it was."""

import os
import shutil
import subprocess
import zipfile

import hull_io
import hull_native as hn
import numpy as np
import pytest
from dxf_audit import assert_audited
from production_hulls import SAMPLES, body_of, odd_sides
from test_closed_models import CUBE, CUBE_TRIANGLES

ASSIMP = shutil.which("assimp")


def area_of(corners):
    a, b, c = corners.transpose(1, 0, 2)
    return 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()


def triangles_of(corners):
    """(points, triangles) of corners (m, 3, 3)."""
    return corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3)


def assert_closed(corners):
    """By the corners alone, and no triangle is less than three of them."""
    points, triangles = triangles_of(corners)
    odd, place = odd_sides(points, triangles)
    assert not len(odd)
    assert all(len(set(one)) == 3 for one in place[triangles].tolist())


@pytest.mark.parametrize("name", SAMPLES)
def test_parts_are_the_closed_hull(name, tmp_path):
    """All solids together are closed, by the corners that were read: every side is run through once
    in each direction."""
    sample, body = body_of(name)
    model = hn.closed_model(body, 8e-4 * sample.ship.length_pp)
    assert len(model.cells) == len(model.triangles)
    parts = hn.surface_parts(model)
    assert "hull" in parts and sum(map(len, parts.values())) == len(model.triangles)
    path = tmp_path / "parts.stl"
    hull_io.write_stl_parts(path, model.points, parts)
    found = hull_io.read_stl_parts(path)
    assert set(found) == {n for n, t in parts.items() if area_of(model.points[t]) > 0.0}
    corners = np.vstack(list(found.values()))
    assert_closed(corners)
    assert area_of(corners) == pytest.approx(model.area, rel=1e-7)
    a, b, c = corners.transpose(1, 0, 2)
    assert np.einsum("ij,ij->", np.cross(a, b), c) / 6.0 == pytest.approx(model.volume, rel=1e-6)


def test_a_keel_is_a_part_of_its_own(tmp_path):
    """Cells with its name, of both sides, closed together with the rest; a keel that is joined to
    the body is in no part."""
    sample, body = body_of("sailing_yacht")
    areas = hn.surface_areas(body.surface)
    cells = np.flatnonzero(body.surface.evaluate_grid(1)[0][..., 2].max(axis=(1, 2)) < 1.0)
    assert 0 < len(cells) < body.surface.cell_count / 2
    tolerance = 1e-4 * sample.ship.length_pp
    files = []
    for joined in ([], [hn.foil("63-012", (7.0, 0, 1.2), (6.7, 0, -0.6), 2.0, tip_chord=1.5)]):
        body.join(joined)
        model = hn.closed_model(body, tolerance)
        path = tmp_path / f"{len(joined)}.stl"
        hull_io.write_stl_parts(path, model.points, hn.surface_parts(model, {"keel": cells}))
        files.append(path.read_bytes())
    assert files[0] == files[1]
    found = hull_io.read_stl_parts(path)
    assert {"hull", "keel", "deck"} <= set(found)
    assert area_of(found["keel"]) == pytest.approx(2.0 * areas.areas[cells].sum(), rel=1e-3)
    assert found["keel"][..., 1].min() == -found["keel"][..., 1].max() < 0.0
    assert_closed(np.vstack(list(found.values())))
    # By itself it is open, where the hull goes on.
    assert len(odd_sides(*triangles_of(found["keel"]))[0])


def test_parts_of_the_coaster():
    """Shell areas by another way: the integrals over the surface's cells."""
    sample, body = body_of("coaster")
    model = hn.closed_model(body, 2e-4 * sample.ship.length_pp)
    parts = hn.surface_parts(model)
    assert set(parts) >= {"hull", "deck"}
    shell = area_of(model.points[model.triangles[model.cells >= 0]])
    areas = hn.surface_areas(body.surface).areas
    assert shell == pytest.approx((2.0 if body.mirrored else 1.0) * areas.sum(), rel=1e-3)
    # A part of one's own.
    cells = np.argsort(areas)[-8:]
    own = hn.surface_parts(model, {"belt": cells})
    assert area_of(model.points[own["belt"]]) == pytest.approx(
        (2.0 if body.mirrored else 1.0) * areas[cells].sum(), rel=1e-3
    )
    a, b, c = model.points[parts["deck"]].transpose(1, 0, 2)
    assert np.cross(b - a, c - a)[:, 2].sum() > 0.0


def test_parts_refused(tmp_path):
    model = hn.ClosedModel(CUBE, CUBE_TRIANGLES)
    _, body = body_of("coaster")
    known = hn.closed_model(body, 0.1)
    for call, words in (
        (lambda: hn.surface_parts(model), "not known"),
        (lambda: hn.surface_parts(known, {"x": [10**6]}), "has not"),
        (lambda: hull_io.write_stl_parts(tmp_path / "a.stl", CUBE, {}), "no triangle"),
        (
            lambda: hull_io.write_stl_parts(tmp_path / "a.stl", CUBE, {"a b": CUBE_TRIANGLES}),
            "could be .a_b",
        ),
        (
            lambda: hull_io.write_stl_parts(tmp_path / "a.stl", CUBE, {"a": [(0, 1, 9)]}),
            "other corners",
        ),
        (lambda: hull_io.write_segments(tmp_path / "a.stl", []), "no segment"),
        (
            lambda: hull_io.write_segments(tmp_path / "a.cli", [(CUBE, CUBE_TRIANGLES)]),
            ".stl, .3mf or .obj",
        ),
    ):
        with pytest.raises(ValueError, match=words):
            call()
    assert not list(tmp_path.iterdir())


def two_cubes():
    return [(CUBE, CUBE_TRIANGLES), (CUBE + [3.0, 0.0, 0.0], CUBE_TRIANGLES)]


def test_segments_in_files(tmp_path):
    paths = hull_io.write_segments(tmp_path / "hull.stl", two_cubes())
    assert [p.name for p in paths] == ["hull-1.stl", "hull-2.stl"]
    points, triangles = hull_io.read_stl(paths[1])
    assert hn.ClosedModel(points, triangles).volume == 8.0 and points[:, 0].min() == 2.0
    assert [p.name for p in hull_io.write_segments(tmp_path / "hull.obj", two_cubes())] == [
        "hull-1.obj",
        "hull-2.obj",
    ]
    (path,) = hull_io.write_segments(tmp_path / "hull.3mf", two_cubes(), title="A & B")
    with zipfile.ZipFile(path) as package:
        text = package.read("3D/3dmodel.model").decode()
    assert text.count("<object ") == 2 and text.count("<item ") == 2 and "A &amp; B 2" in text


@pytest.mark.skipif(ASSIMP is None, reason="assimp is not installed")
def test_segments_open_elsewhere(tmp_path):
    (path,) = hull_io.write_segments(tmp_path / "hull.3mf", two_cubes())
    out = tmp_path / "again.stl"
    subprocess.run([ASSIMP, "export", path, out], capture_output=True, check=True, timeout=300)
    points, triangles = hull_io.read_stl(out)
    again = hn.ClosedModel(points, triangles)
    assert len(triangles) == 24 and again.volume == pytest.approx(16.0, rel=1e-6)


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="there is no full device")
@pytest.mark.parametrize("full_from", [1, 2])
def test_a_full_disk_leaves_all_segments_as_they_were(tmp_path, monkeypatch, full_from):
    (tmp_path / "hull-1.stl").write_bytes(b"before")
    real, count = os.fdopen, [0]

    def opened(handle, mode):
        count[0] += 1
        if count[0] < full_from:
            return real(handle, mode)
        os.close(handle)
        return real(os.open("/dev/full", os.O_WRONLY), mode)

    monkeypatch.setattr(os, "fdopen", opened)
    with pytest.raises(hull_io.HullFileError, match="free space"):
        hull_io.write_segments(tmp_path / "hull.stl", two_cubes())
    monkeypatch.undo()
    assert [p.name for p in tmp_path.iterdir()] == ["hull-1.stl"]
    assert (tmp_path / "hull-1.stl").read_bytes() == b"before"


def test_no_folder_is_one_sentence(tmp_path):
    for write in (
        lambda path: hull_io.write_segments(path, two_cubes()),
        lambda path: hull_io.write_stl_parts(path, CUBE, {"a": CUBE_TRIANGLES}),
    ):
        with pytest.raises(hull_io.HullFileError, match="can't be written"):
            write(tmp_path / "none" / "a.stl")


# --- splines in space -----------------------------------------------------------------------------


def test_curves_in_space(tmp_path):
    """Read back by their group codes: knots and control points as they were given."""
    _, body = body_of("coaster")
    curves = []
    for branch in hn.section_splines(body.surface, hn.plane_across("x", 30.0)[None], 1e-5)[0]:
        curves += [("STATIONS", one.knots, one.control_points) for one in branch.splines]
    features = hn.crease_curves(body.surface)
    curves += [("FEATURES", one.knots, one.control_points) for one in features]
    path = tmp_path / "lines.dxf"
    hn.write_curves_dxf(curves, path, unit="mm")
    assert_audited(path)
    rows = path.read_text().splitlines()
    pairs = list(zip(map(int, map(str.strip, rows[::2])), rows[1::2]))
    at = [k for k, (code, value) in enumerate(pairs) if code == 0 and value.strip() == "SPLINE"]
    assert len(at) == len(curves)
    for start, (layer, knots, points) in zip(at, curves):
        own = []
        for code, value in pairs[start + 1 :]:
            if code == 0:
                break
            own.append((code, value))
        assert dict(own)[8].strip() == layer
        assert [float(v) for c, v in own if c == 40] == pytest.approx(list(knots), abs=1e-12)
        read = np.stack([[float(v) for c, v in own if c == k] for k in (10, 20, 30)], axis=1)
        assert np.abs(read - 1000.0 * points).max() < 1e-9


def test_curves_refused(tmp_path):
    knots, points = np.repeat([0.0, 1.0], 4), np.eye(4)[:, :3]
    for curves, words in (
        ([], "no curve"),
        ([("A B", knots, points)], "layer"),
        ([("A", knots[:-1], points)], "four more knots"),
        ([("A", knots[::-1], points)], "rise"),
        ([("A", knots, np.where(points == 1.0, np.nan, points))], "not finite"),
        ([("A", [*knots[:-1], np.inf], points)], "not finite"),
        ([("A", np.where(knots == 1.0, np.nan, knots), points)], "not finite"),
    ):
        with pytest.raises(ValueError, match=words):
            hn.write_curves_dxf(curves, tmp_path / "a.dxf")
    with pytest.raises(OSError):
        hn.write_curves_dxf([("A", knots, points)], tmp_path / "none" / "a.dxf")
    assert not list(tmp_path.iterdir())


def test_odd_sides_are_none():
    """The parts of a cube, as files have them, share their sides."""
    model = hn.ClosedModel(CUBE, CUBE_TRIANGLES)
    assert not len(odd_sides(model.points, model.triangles)[0])
