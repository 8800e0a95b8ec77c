# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls of triangles: what is found of them, and control meshes laid over them and fitted."""

import dataclasses
import io
import json
import os
import sys
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

import hull_from
import hull_io
import hull_native as hn
import numpy as np
import pytest
from hull_fitting import hull_from_geometry, station_overlays
from hull_fitting.borders import without_spurs
from hull_fitting.half_meshes import clipped, half_mesh
from hull_fitting.hull_files import particulars_of
from hull_fitting.immersion import immersed
from hull_fitting.keel_strips import closed_to_centre
from hull_fitting.outlines import shell_outline
from hull_fitting.shells import hull_shell
from hull_io.geometry import Geometry, GeometryMesh, read_geometry
from hull_io.triangles import normals_of
from vessels import triangles_of

ROOT = Path(__file__).resolve().parents[2]
ALL = os.environ.get("HULL_LONG_TESTS") == "1"


def sample(name):
    data = hull_io.read_hull(ROOT / "samples" / f"{name}.hull.json")
    shell = hull_io.shell_arrays(data)
    arrays = shell.arguments()
    return hn.LimitSurface(hn.ControlMesh(*arrays), data.scheme), data


def geometry_of(points, triangles, name="hull.stl"):
    return Geometry(name, "STL", "m", meshes=(GeometryMesh(points, triangles),))


def box(length=10.0, half_breadth=2.0, depth=3.0):
    """The port half of a box, closed but for the centre plane, of triangles."""
    points = np.array(
        [
            (x, y, z)
            for x in (0.0, length)
            for y, z in ((0.0, 0.0), (half_breadth, 0.0), (half_breadth, depth), (0.0, depth))
        ]
    )
    quads = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (0, 3, 2, 1), (4, 5, 6, 7)]
    return points, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def test_a_clipped_mesh_has_the_area_and_the_border_of_the_plane():
    points, triangles = triangles_of(sample("coaster")[0], 4)
    areas = [
        normals_of(*clipped(points, triangles, 2, 4.1, keep_above=side))[1].sum()
        for side in (True, False)
    ]
    assert sum(areas) == pytest.approx(normals_of(points, triangles)[1].sum(), rel=1e-12)
    below, _ = clipped(points, triangles, 2, 4.1, keep_above=False)
    assert (below[len(points) :, 2] == 4.1).all()


def test_of_a_box_deck_and_ends_are_found():
    points, triangles = box()
    shell = hull_shell(half_mesh(geometry_of(points, triangles)))
    assert set(shell.ends) == {"aft", "forward"}
    assert shell.deck_area == pytest.approx(20.0)
    outline = shell_outline(shell)
    mesh = shell.mesh
    # Both sides: 10 * 4 * 2 m³; bottom, sides and both ends.
    volume, area = immersed(mesh.points, mesh.triangles, outline, 2.0)
    assert volume == pytest.approx(80.0, rel=1e-12)
    assert area == pytest.approx(40.0 + 2 * 20.0 + 2 * 8.0, rel=1e-12)


@pytest.mark.parametrize("name", ["coaster", "naval_vessel"])
def test_displacement_of_triangles_is_that_of_the_surface(name):
    surface, data = sample(name)
    draft = data.particulars.draft
    shell = hull_shell(half_mesh(geometry_of(*triangles_of(surface))))
    volume, area = immersed(
        shell.mesh.points, shell.mesh.triangles, shell_outline(shell), draft
    )  # fmt: skip
    exact = hn.upright_hydrostatics(surface, draft=draft, mirrored=True)
    # Chords of 8 parts a face lie within the hull by their sagitta.
    assert volume == pytest.approx(exact.displaced_volume, rel=5e-4)
    assert area == pytest.approx(exact.wetted_surface, rel=5e-4)


def test_the_same_is_found_of_a_whole_hull_turned_inside_out():
    points, triangles = triangles_of(sample("coaster")[0], 4)
    mirrored = points * [1.0, -1.0, 1.0]
    whole = np.concatenate([points, mirrored])
    faces = np.concatenate([triangles[:, ::-1], triangles + len(points)])
    half = half_mesh(geometry_of(points, triangles))
    other = half_mesh(geometry_of(whole, faces))
    told = [shell_outline(hull_shell(mesh)) for mesh in (half, other)]
    for line in ("contour", "deck", "aft"):
        ends = [np.array(getattr(outline, line))[[0, -1]] for outline in told]
        assert np.abs(ends[0] - ends[1]).max() < 1e-9
    normals, areas = normals_of(other.points, other.triangles)
    assert (areas * normals[:, 1]).sum() > 0.0


def test_a_seam_is_no_border_and_a_spur_is_cut_off():
    line = np.array([(0, 0, 0), (1, 0, 0), (1, 0, -2), (1.0001, 0, 0), (2, 0, 0)], dtype=float)
    assert without_spurs(line, 1e-3)[:, 2].min() == 0.0
    # Two patches whose points along their common side are not the same.
    points, triangles = triangles_of(sample("coaster")[0], 4)
    is_aft = points[triangles].mean(axis=1)[:, 0] < 40.0
    moved = points + [0.0, 2e-4, 0.0] * (np.abs(points[:, 1:2]) > 0.0)
    meshes = (
        GeometryMesh(points, triangles[is_aft]),
        GeometryMesh(moved, triangles[~is_aft]),
    )
    shell = hull_shell(half_mesh(Geometry("patches.stl", "STL", "m", meshes=meshes)))
    outline = shell_outline(shell)
    whole = shell_outline(hull_shell(half_mesh(geometry_of(points, triangles))))
    for line in ("contour", "deck"):
        lengths = [
            np.linalg.norm(np.diff(getattr(one, line), axis=0), axis=1).sum()
            for one in (outline, whole)
        ]
        assert lengths[0] == pytest.approx(lengths[1], rel=1e-4)


# Budgets are at most 1.5 times the samples' own points.
NAMES = ["coaster"] + (["naval_vessel", "roro", "bulk_carrier", "container_ship"] if ALL else [])


@pytest.mark.parametrize("name", NAMES)
def test_a_sample_of_triangles_becomes_a_hull_again(name):
    surface, data = sample(name)
    draft = data.particulars.draft
    budget = int(1.3 * len(data.points))
    made = hull_from_geometry(geometry_of(*triangles_of(surface, 6)), budget=budget, draft=draft)
    report = made.report
    length = report["length"]
    assert report["points"] == len(made.data.points) <= budget
    assert report["points_in_rows_of_one_x"] >= 0.8 * report["points"]
    # By another way: the exact surface that the triangles are of.
    places = surface.tessellate(3).points
    apart = np.asarray(hn.SurfaceTree(made.fitted.surface).closest_points(places).distances)
    assert np.sqrt(np.mean(apart**2)) < 2e-4 * length
    exact = hn.upright_hydrostatics(surface, draft=draft, mirrored=True)
    assert report["displaced_volume"]["hull"] == pytest.approx(exact.displaced_volume, rel=1e-3)
    assert report["wetted_surface"]["hull"] == pytest.approx(exact.wetted_surface, rel=2e-3)
    mesh = made.fitted.surface.mesh
    assert mesh.warnings == [] and len(mesh.near_centre_line) == 0
    for flat in made.data.flats:
        corners = sorted({corner for face in flat.faces for corner in made.data.faces[face]})
        off = made.data.points[corners] @ np.array(flat.normal) - flat.offset
        assert np.abs(off).max() < 1e-9 * length
    stations = station_overlays(made.shell, made.fitted)
    assert len(stations) == 11
    assert max(one.rms for one in stations) < 1e-3 * length


def test_a_shell_that_ends_beside_the_centre_plane_is_closed_to_it():
    points, triangles = box()
    points = points + [0.0, 0.05, 0.0]
    mesh, beside = closed_to_centre(half_mesh(geometry_of(points, triangles[:4])))
    assert beside == pytest.approx(0.05)
    # The bottom's strip, looking downwards as that does: 10 m by 0.05 m.
    normals, areas = normals_of(mesh.points, mesh.triangles)
    is_bottom = normals[:, 2] < -0.9
    assert areas[is_bottom].sum() == pytest.approx(10.0 * 2.05)
    assert not (normals[:, 2] > 0.9).any()
    whole = half_mesh(geometry_of(*box()))
    assert closed_to_centre(whole) == (whole, 0.0)


def test_beam_and_depth_are_of_the_surface():
    """And not of control points, between which a round hull lies."""
    surface, data = sample("sailing_yacht")
    found = particulars_of(10.0, surface, 1.2)
    high = np.max(surface.tessellate(32).points, axis=0)
    # Chords of 8 parts of a face miss a 64th of the fullness of one, or less.
    assert found.beam == pytest.approx(2.0 * high[1], rel=1e-4)
    assert found.depth == pytest.approx(high[2], rel=1e-4)
    assert 2.0 * data.points[:, 1].max() > 1.002 * found.beam
    assert (found.length_pp, found.draft) == (10.0, 1.2)


def test_what_is_no_hull_is_refused():
    points, triangles = triangles_of(sample("coaster")[0], 4)
    is_aside = points[triangles].mean(axis=1)[:, 1] > 0.5
    with pytest.raises(ValueError, match="No border of the shell runs along the centre plane"):
        hull_from_geometry(geometry_of(points, triangles[is_aside]), is_half=True)
    with pytest.raises(ValueError, match="The draft of 40 m is not within the hull"):
        hull_from_geometry(geometry_of(points, triangles), draft=40.0)
    with pytest.raises(ValueError, match="more than the budget of 30"):
        hull_from_geometry(geometry_of(points, triangles), budget=30)
    with pytest.raises(ValueError, match="tolerance has to be above zero"):
        hull_from_geometry(geometry_of(points, triangles), tolerance=0.0)


@pytest.fixture(scope="module")
def command():
    """What ./hull from does when it is called from a folder with arguments: main of its script."""

    def call(folder, *arguments):
        places = ["--called-from", str(folder), "--into", str(folder / "out")]
        with mock.patch.object(sys, "argv", ["hull_from.py", *places, *arguments]):
            hull_from.main()

    return call


@pytest.mark.parametrize(
    "arguments, words",
    [
        (["nothing.stl"], "nothing.stl: "),
        (["missing.stl"], "there is no file 'missing.stl'"),
        (["folder"], "'folder' is a folder"),
        ([], "FILE"),
        (["nothing.stl", "--unit", "yd"], "--unit"),
        (["--tolerance", "nan", "nothing.stl"], "above zero, not 'nan'"),
        (["nothing.stl", "--tolerance", "inf"], "above zero, not 'inf'"),
        (["nothing.stl", "--draft", "-1"], "above zero, not '-1'"),
        (["nothing.stl", "--draft", "abc"], "above zero, not 'abc'"),
        (["nothing.stl", "--points", "1e9"], "whole number from 20 to 1000, not '1e9'"),
        (["nothing.stl", "--points", "5000"], "from 20 to 1000"),
        (["nothing.stl", "--forward", "-x"], "nothing.stl: "),
        (["nothing.stl", "--forward", "north"], "--forward"),
        (["nothing.stl", "--half", "--whole"], "--whole"),
        (["nothing.stl", "other.stl"], "other.stl"),
    ],
)
def test_the_command_tells_in_a_sentence_what_it_can_not_do(command, tmp_path, arguments, words):
    (tmp_path / "nothing.stl").write_bytes(b"solid nothing\nendsolid")
    (tmp_path / "folder").mkdir()
    with pytest.raises(SystemExit) as ended:
        command(tmp_path, *arguments)
    told = ended.value.code
    assert told.startswith("hull from: ") and words in told and len(told.splitlines()) == 1
    assert sorted(entry.name for entry in tmp_path.iterdir()) == ["folder", "nothing.stl"]


class Terminal(io.StringIO):
    def isatty(self):
        return True


def fitted_box(name, progress, **_):
    """As hull_from_geometry() of a file of that name, but for the fit."""
    progress(0.4)
    data = dataclasses.replace(sample("barge")[1], name="box")
    return SimpleNamespace(
        data=data, report={"source": name, "draft": 2.0}, shell=None, fitted=None
    )


def drawn_empty(name, stations, draft, stem):
    for ending in ("pdf", "png"):
        Path(f"{stem}.{ending}").write_text(f"{name} {stem.name}")


def test_the_command_replaces_all_files_or_none(command, tmp_path, monkeypatch, capsys):
    folder = tmp_path / "out" / "box"
    for file in ("box.stl", "box.obj"):
        (tmp_path / file).write_bytes(b"")
    for name, made in (
        ("read_geometry", lambda path: path.name),
        ("hull_from_geometry", fitted_box),
        ("station_overlays", lambda *_: []),
        ("_tell", lambda report: None),
    ):
        monkeypatch.setattr(hull_from, name, made)
    monkeypatch.setattr(hull_from.overlays, "draw", drawn_empty)
    command(tmp_path, "box.stl")
    names = ["box.hull.json", "report.json", "sections.pdf", "sections.png"]
    assert sorted(os.listdir(folder)) == names and "was replaced" not in capsys.readouterr().out
    before = {name: (folder / name).read_bytes() for name in names}
    terminal = Terminal()
    with monkeypatch.context() as patched:
        # The disk is full by the time of the pictures; a line is open in the terminal.
        patched.setattr(hull_from.overlays, "draw", mock.Mock(side_effect=OSError("disk full")))
        patched.setattr(sys, "stderr", terminal)
        with pytest.raises(SystemExit, match="hull from: disk full"):
            command(tmp_path, "box.obj")
    assert terminal.getvalue() == "\rFitting: 40 %\n"
    assert {name: (folder / name).read_bytes() for name in os.listdir(folder)} == before
    command(tmp_path, "box.obj")
    assert "the hull of box.stl, which was there, was replaced\n" in capsys.readouterr().out


@pytest.mark.skipif(not ALL, reason="HULL_LONG_TESTS=1")
@pytest.mark.parametrize(
    "file, budget, draft, scale, rms, volume",
    [
        ("DTC-scaled.stl.gz", 140, 14.5 / 59.407, 59.407, 0.060, 3e-3),
        ("kvlcc2_lq.stl", 130, 20.8, 1.0, 0.1, 5e-3),
    ],
)
def test_published_hulls(file, budget, draft, scale, rms, volume):
    path = ROOT.parent / "shared" / "hulls" / "reference" / file
    if not path.exists():
        pytest.skip("without the published hulls")
    report = hull_from_geometry(read_geometry(path), budget=budget, draft=draft).report
    assert report["points"] <= budget
    assert scale * report["distances"]["rms"] <= rms
    told = report["displaced_volume"]
    assert told["hull"] == pytest.approx(told["source"], rel=volume)
    json.dumps(report)
