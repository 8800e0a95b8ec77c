# SPDX-License-Identifier: GPL-3.0-or-later
"""The samples' own files read again as geometry, against the exact surface by closest points."""

import csv
import importlib.util
import itertools
import sys
import types
from dataclasses import replace
from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest
from hull_io.geometry import Geometry, GeometryMesh, guess_hull, oriented, read_geometry

pytestmark = pytest.mark.one_in(2)

ROOT = Path(__file__).resolve().parents[2]
SAMPLES = sorted(path.name.split(".")[0] for path in (ROOT / "samples").glob("*.hull.json"))


class Sample:
    def __init__(self, name):
        self.number = SAMPLES.index(name)
        self.data = hull_io.read_hull(ROOT / "samples" / f"{name}.hull.json")
        shell = hull_io.shell_arrays(self.data)
        arrays = shell.arguments()
        self.surface = hn.LimitSurface(hn.ControlMesh(*arrays))
        self.size = self.surface.mesh.size
        self.tree = hn.SurfaceTree(self.surface)
        self.length = self.data.particulars.length_pp

    def distance(self, points):
        """The largest of points (n, 3) from the surface, m."""
        return np.linalg.norm(self.tree.closest_points(points).points - points, axis=1).max()

    def triangles(self):
        facets = self.surface.tessellate(6)
        quads = facets.quads
        return facets.points, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


@pytest.fixture(params=SAMPLES)
def sample(request):
    return Sample(request.param)


def exporter():
    """The add-on's table of offsets, without Blender: of its package only the names are there."""
    path = ROOT / "addon" / "hull_tools" / "features" / "lines" / "offset_table.py"
    for name in ("bare", "bare.bridge", "bare.features", "bare.features.lines"):
        sys.modules.setdefault(name, types.ModuleType(name)).__path__ = []
    sys.modules["bare.bridge"].native = sys.modules["bare.features.lines"].line_places = None
    sys.modules["bare.features.lines"].__path__ = [str(path.parent)]
    spec = importlib.util.spec_from_file_location("bare.features.lines.offset_table", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_tables_of_offsets(sample, tmp_path):
    points = sample.surface.mesh.points
    table = hn.offset_table(
        sample.surface,
        stations=np.linspace(0.0, sample.length, 21),
        waterlines=np.linspace(0.0, points[:, 2].max(), 11),
        buttocks=np.linspace(0.0, points[:, 1].max(), 5)[:-1],
    )
    own = exporter()
    path = tmp_path / "offsets.csv"
    with open(path, "w", newline="") as file:
        csv.writer(file).writerows([own.header(table), *own.rows(table)])
    found = read_geometry(path)
    assert found.unit == "m" and not found.left_out
    kinds = {curve.kind for curve in found.curves}
    assert {"station", "waterline", "buttock"} <= kinds
    # Half of the last digit across and up; where the hull is flat the table has the flat's edge,
    # to a millionth of the size.
    tolerance = np.hypot(5e-5, 5e-5) + 1.1e-6 * sample.size
    assert sample.distance(found.all_points()) < tolerance
    has_place = np.isfinite(table.half_breadths).sum(axis=1) + np.isfinite(table.heights).sum(
        axis=1
    )
    stations = [curve for curve in found.curves if curve.kind == "station"]
    wanted = [x for x, count in zip(table.stations, has_place) if count > 1]
    assert {round(x, 6) for x in wanted} <= {round(c.points[0, 0], 6) for c in stations}


@pytest.mark.parametrize("write, ending", [(hn.write_step, "step"), (hn.write_iges, "igs")])
def test_cad_files(sample, write, ending, tmp_path):
    planes = [hn.plane_across("x", share * sample.length) for share in (0.1, 0.5, 0.9)]
    curves = [
        (f"station {i}", "stations", spline)
        for i, branches in enumerate(hn.section_splines(sample.surface, planes, tolerance=1e-4))
        for branch in branches
        for spline in branch.splines
    ]
    path = tmp_path / f"hull.{ending}"
    report = write(hn.exact_patches(sample.surface), path, unit="mm", curves=curves)
    found = read_geometry(path)
    assert found.unit == "mm" and not found.left_out
    assert len(found.meshes) == report["faces"]
    assert {mesh.group for mesh in found.meshes} == {r["name"] for r in report["regions"]}
    borders = [curve for curve in found.curves if curve.kind == "border"]
    assert len(borders) == report["free_edges"]
    loose = [curve for curve in found.curves if not curve.kind]
    assert sorted(curve.name for curve in loose) == sorted(name for name, _, _ in curves)
    assert {curve.group for curve in loose} == {"stations"}
    metres = oriented(found, replace(guess_hull(found), **FILE_AXES))
    # Patches are exact to a millionth of the size, sections to what was asked for.
    assert sample.distance(np.concatenate([m.points for m in metres.meshes])) < 1e-6 * sample.size
    assert sample.distance(metres.all_points()) < 1e-4 + 1e-6 * sample.size
    middles = [m.points[m.triangles].mean(axis=1) for m in metres.meshes]
    assert sample.distance(np.concatenate(middles)) < 2.1e-5 * sample.size + 1e-6 * sample.size


FILE_AXES = {"forward": "+x", "port": "+y", "up": "+z", "origin": (0.0, 0.0, 0.0)}


def test_stl_files(sample, tmp_path):
    points, triangles = sample.triangles()
    hull_io.write_stl(tmp_path / "hull.stl", points, triangles)
    found = read_geometry(tmp_path / "hull.stl")
    # Single precision.
    assert sample.distance(found.meshes[0].points) < 1e-7 * sample.size
    assert found.unit is None


def test_drawings(sample, tmp_path):
    """Buttocks and waterlines of the lines plan, at true size where their own view has them."""
    points = sample.surface.mesh.points
    inner, outer = points[:, 1].min(), points[:, 1].max()
    buttock = inner + 0.4 * (outer - inner)
    path = tmp_path / "lines.dxf"
    hn.write_lines_drawing(
        sample.surface,
        path,
        mirrored=sample.data.half,
        stations=sample.length / 10.0,
        waterlines=[],
        buttocks=[buttock],
        draft=sample.data.particulars.draft,
        length=sample.length,
    )
    found = read_geometry(path)
    assert found.unit == "m"
    assert {"STATIONS", "BUTTOCKS", "OUTLINE"} <= {curve.group for curve in found.curves}
    drawn = [c for c in found.curves if c.group == "BUTTOCKS" and c.spline is not None]
    assert drawn
    for curve in drawn:
        x, z, _ = curve.points.T
        placed = np.column_stack([x, np.full(len(x), buttock), z])
        assert sample.distance(placed) < 1.1e-6 * sample.size


def turns():
    for order in itertools.permutations(range(3)):
        for signs in itertools.product((1.0, -1.0), repeat=3):
            matrix = np.zeros((3, 3))
            matrix[range(3), order] = signs
            yield matrix


def mesh_geometry(points, triangles, unit=None):
    return Geometry("hull.stl", "STL", unit, meshes=(GeometryMesh(points, triangles),))


@pytest.mark.parametrize("whole", [False, True], ids=["half", "whole"])
def test_axes_are_guessed_however_they_are_turned(sample, whole):
    points, triangles = sample.triangles()
    if whole:
        triangles = np.concatenate([triangles, triangles[:, ::-1] + len(points)])
        points = np.concatenate([points, points * [1.0, -1.0, 1.0]])
    straight = guess_hull(mesh_geometry(points, triangles))
    # Each of the 48 turns of one sample, half and whole of another.
    own = list(turns())[(sample.number + 5 * whole) % 10 :: 10]
    assert straight.is_half == (not whole)
    assert straight.length == pytest.approx(np.ptp(points[:, 0]), rel=1e-9)
    assert straight.beam == pytest.approx(2.0 * points[:, 1].max(), rel=1e-9)
    for turn in own:
        geometry = mesh_geometry(points @ turn.T, triangles)
        guess = guess_hull(geometry)
        back = guess.matrix() @ turn
        assert back[0, 0] == back[2, 2] == 1.0 and abs(back[1, 1]) == 1.0
        assert guess.is_half == straight.is_half
        assert guess.length_pp == pytest.approx(straight.length_pp, rel=1e-9)
        if not whole:
            assert back[1, 1] == 1.0
            placed = oriented(geometry, guess).meshes[0]
            np.testing.assert_allclose(placed.points, points, atol=1e-9 * sample.size)
            # Reflected triangles are turned, so that they look outwards as before.
            same = np.array_equal(placed.triangles, triangles)
            assert same == (np.linalg.det(turn) > 0.0)


@pytest.mark.parametrize("unit, scale", [("mm", 1e3), ("m", 1.0), ("ft", 1 / 0.3048)])
def test_units(sample, unit, scale):
    points, triangles = sample.triangles()
    told = guess_hull(mesh_geometry(scale * points, triangles, unit))
    assert told.unit == unit and "unit" not in told.doubts
    guess = guess_hull(mesh_geometry(scale * points, triangles))
    if unit == "ft":
        # Feet look like metres: it is asked about, or too long for any ship.
        assert "unit" in guess.doubts
        guess = guess_hull(mesh_geometry(scale * points, triangles), unit="ft")
    assert guess.unit == unit
    assert guess.length == pytest.approx(np.ptp(points[:, 0]), rel=1e-9)
    assert ("unit" in guess.doubts) == (unit == "m")


def test_what_is_known_is_kept(tmp_path):
    sample = Sample("coaster")
    geometry = mesh_geometry(*sample.triangles())
    assert guess_hull(geometry, forward="-x").forward == "-x"
    assert guess_hull(geometry, up="-z").up == "-z"
    assert guess_hull(geometry, is_half=False).is_half is False
    for wrong in ({"forward": "x"}, {"up": "north"}, {"forward": "+x", "up": "-x"}, {"unit": "yd"}):
        with pytest.raises(ValueError):
            guess_hull(geometry, **wrong)
    flat = mesh_geometry(sample.triangles()[0] * [1.0, 1.0, 0.0], sample.triangles()[1])
    with pytest.raises(ValueError, match="in one plane"):
        guess_hull(flat)
