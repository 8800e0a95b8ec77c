# SPDX-License-Identifier: GPL-3.0-or-later
"""Boats by their chines: each file makes the same hull, which goes through all points."""

import random
import tracemalloc

import hull_io
import numpy as np
import pytest
from chine_boats import carene, carlson, chine_text, curves
from hull_io.chines.chine_files import Chines
from hull_io.chines.chine_hulls import hull_of_chines
from hull_io.geometry import read_geometry

FILES = {
    "skiff.hul": lambda found: carlson(found),
    "skiff.xyz": lambda found: carene(found),
    "skiff.txt": lambda found: chine_text(found),
    "feet.txt": lambda found: chine_text(found, 1),
}


@pytest.fixture(params=FILES)
def path(request, tmp_path):
    path = tmp_path / request.param
    path.write_text(FILES[request.param](curves()))
    return path


def surface_of(hull):
    hn = pytest.importorskip("hull_native")
    mesh = hn.ControlMesh(*hull_io.shell_arrays(hull).arguments())
    problems = hn.check_mesh(*hull_io.shell_arrays(hull).arguments())
    assert not [problem for problem in problems if problem.severity == "error"]
    return hn, hn.LimitSurface(mesh)


def test_each_file_is_the_same_hull(path):
    hull = hull_io.read_hull(path)
    assert hull.half and len(hull.faces) == 8 and len(hull.creases) == 4
    assert hull.units == ("ft" if path.name in ("feet.txt", "skiff.hul") else "m")
    assert hull.name == {"skiff.hul": "Skiff", "skiff.xyz": "Skiff"}.get(path.name, path.stem)
    assert hull.notes == []


def test_the_surface_goes_through_all_points_and_is_ruled(path):
    hull = hull_io.read_hull(path)
    hn, surface = surface_of(hull)
    tree = hn.SurfaceTree(surface)
    keel, chine, sheer = curves()
    near = tree.closest_points(np.concatenate([keel, chine, sheer]))
    assert near.distances.max() < 1e-9
    # Straight between bulkheads' points of neighbours.
    shares = np.linspace(0.0, 1.0, 5)[:, None, None]
    for low, high in ((keel, chine), (chine, sheer)):
        between = ((1 - shares) * low + shares * high).reshape(-1, 3)
        assert tree.closest_points(between).distances.max() < 1e-9


def test_faces_look_outwards(path):
    hull = hull_io.read_hull(path)
    for face in hull.faces:
        a, b, c = hull.points[face[:3]]
        assert np.cross(b - a, c - a) @ (0.0, 1.0, -0.5) > 0.0


def test_geometry_has_the_chines(path):
    found = read_geometry(path)
    assert [curve.kind for curve in found.curves] == ["knuckle"] * 3
    assert found.unit == "m" and found.is_half and found.on_ship_axes
    for curve, wanted in zip(found.curves, curves()):
        np.testing.assert_allclose(curve.points, wanted, atol=1e-9)


def written(tmp_path, found, name="boat.txt"):
    path = tmp_path / name
    path.write_text(chine_text(found))
    return hull_io.read_hull(path)


def test_chines_that_meet_in_a_point_make_triangles(tmp_path):
    found = curves()
    found[1][-1] = found[2][-1] = found[0][-1]
    hull = written(tmp_path, found)
    assert sorted(map(len, hull.faces)) == [3, 3] + [4] * 6
    hn, surface = surface_of(hull)
    assert hn.SurfaceTree(surface).closest_points(np.concatenate(found)).distances.max() < 1e-9


def test_chines_to_starboard_and_from_above_are_brought_to_port(tmp_path):
    mirrored = [curve[::-1] * (1.0, -1.0, 1.0) for curve in curves()[::-1]]
    hull = written(tmp_path, mirrored)
    usual = written(tmp_path, curves())
    np.testing.assert_allclose(
        sorted(hull.points.tolist()), sorted(usual.points.tolist()), atol=1e-12
    )
    assert any("starboard" in note for note in hull.notes)


def test_a_flat_bottom_is_closed_to_the_centre_plane(tmp_path):
    hull = written(tmp_path, [c + (0.0, 0.3, 0.0) for c in curves()])
    assert len(hull.faces) == 12 and hull.points[:, 1].min() == 0.0
    assert any("level bottom" in note for note in hull.notes)


def test_chines_of_unequal_counts_are_sampled(tmp_path):
    x = np.linspace(0.0, 4.0, 9)
    keel = np.stack([x, 0.0 * x, 0.1 * x], axis=1)  # straight: any places of it are on it
    hull = written(tmp_path, [keel, *curves()[1:]])
    assert any("from 5 to 9 points" in note for note in hull.notes)
    hn, surface = surface_of(hull)
    assert hn.SurfaceTree(surface).closest_points(keel).distances.max() < 1e-9
    # Natural splines of 5 points by chord length are within a few millimetres of these.
    assert hn.SurfaceTree(surface).closest_points(curves()[1]).distances.max() < 5e-3


def _long(count):
    x = np.linspace(0.0, 4.0, count)
    return [np.stack([x, y + 0.0 * x, z + 0.1 * np.sin(x)], axis=1) for y, z in ((0, 0), (1, 0.5))]


def test_long_chines_take_memory_by_their_points():
    """Two of 3,000 points have 36 kB of coordinates each; a square matrix of theirs has 72 MB."""
    long = (_long(3000)[0], _long(2999)[1])
    tracemalloc.start()
    hull_of_chines(Chines("", long, "m", ""))
    size = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert size < 10e6


def test_the_surface_goes_through_all_points_of_long_chines(tmp_path):
    hn, surface = surface_of(written(tmp_path, _long(300)))
    points = np.concatenate(_long(300))
    assert hn.SurfaceTree(surface).closest_points(points).distances.max() < 1e-9


@pytest.mark.parametrize(
    "name, text, words",
    [
        ("a.hul", "", "line 0: the file ends"),
        ("a.hul", "x\n", "a number is wanted, but there is 'x'"),
        ("a.hul", "1\n", "a boat of 1 chines"),
        ("a.hul", "2.5\n", "a boat of 2.5 chines"),
        ("a.hul", "1e9\n", "can't be of a boat"),
        ("a.hul", "3\n1\n2\n", "cut short"),
        ("a.hul", "2\n" + "nan\n" * 40, "can't be of a boat"),
        ("a.xyz", "A\nLINE\n\n1 2\n", "x, y and z are wanted, but there is '1 2'"),
        ("a.xyz", "A\nLINE\n\n1 2 3\n", "there are 0 chines"),
        ("a.txt", "0\n1 2 3\n2 2 3\n\nEOF\n", "there are 1 chines"),
        ("a.txt", "0\n1 2 z\n1 2 3\n\nEOF\n", "line 2: x, y and z are wanted"),
        ("a.txt", "0\n1 2 1e9\n1 2 3\n\nEOF\n", "line 2: '1 2 1e9' can't be of a boat"),
    ],
)
def test_what_is_no_boat_is_refused(tmp_path, name, text, words):
    (tmp_path / name).write_text(text)
    with pytest.raises(hull_io.HullFileError) as caught:
        hull_io.read_hull(tmp_path / name)
    assert words in str(caught.value) and str(caught.value).startswith(name)


def test_damaged_files_are_read_or_refused(tmp_path):
    choice = random.Random(25112026)
    for name, write in FILES.items():
        whole = write(curves()).encode()
        for _ in range(60):
            data = bytearray(whole[: choice.randrange(1, len(whole))])
            for _ in range(choice.choice((0, 1, 5))):
                data[choice.randrange(len(data))] = choice.choice(b"0123456789.-e \nx")
            path = tmp_path / name
            path.write_bytes(data)
            try:
                assert hull_io.read_hull(path).faces
            except hull_io.HullFileError as error:
                assert str(error).startswith(name)
