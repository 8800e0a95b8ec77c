# SPDX-License-Identifier: GPL-3.0-or-later
"""Half hulls whose centre line is in the centre plane but for noise, as in files of other programs:
one rule for what is on it, whatever is made of the hull."""

import re

import hull_io
import hull_native as hn
import numpy as np
import pytest
from hull_io import mirror
from reference_data import hull_path

SEED = 20251
NAMES = ("coaster", "barge", "naval_vessel")
ON, NEAR = hn.tolerances.ON_CENTRE_PLANE, hn.tolerances.NEAR_CENTRE_PLANE
# Of the size: what is on the plane, from rounding to the last that is.
NOISES = (1e-9, 1e-8, 1e-7, 3e-7, 0.999 * ON)
EXTENTS = {
    "both": {"mirrored": True},
    "solid": {"mirrored": True, "solid": True},
    "half solid": {"solid": True},
}


def mesh_of(name):
    data = hull_io.read_hull(hull_path(f"{name}.hull.json"))
    shell = hull_io.shell_arrays(data)
    mesh = hn.ControlMesh(*shell.arguments())
    return data, mesh


def centre_line(mesh):
    border = np.unique(mesh.border_edges)
    return border[mesh.points[border, 1] == 0.0]


def with_noise(mesh, noise, only=None):
    """The mesh with its centre line off the plane by up to so much of the size, to both sides; or
    one point of it."""
    found = centre_line(mesh)
    points = mesh.points.copy()
    away = np.random.default_rng(SEED).uniform(-1.0, 1.0, len(found))
    away[np.argmax(np.abs(away))] = 1.0
    if only is not None:
        found, away = found[[only]], 1.0
    points[found, 1] += away * noise * mesh.size
    return mesh.with_points(points)


def particulars(mesh, draft):
    body = hn.HullBody(hn.LimitSurface(mesh), mirrored=True)
    return hn.hydrostatics(body, draft=draft)


def report(mesh, tmp_path, extent, write=hn.write_step):
    return write(hn.exact_patches(hn.LimitSurface(mesh)), tmp_path / "hull.file", **EXTENTS[extent])


def counts(found):
    return [found[key] for key in ("shells", "solids", "faces", "edges", "free_edges")]


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("extent", EXTENTS)
def test_noise_does_not_change_files(name, extent, tmp_path):
    _, mesh = mesh_of(name)
    clean = report(mesh, tmp_path, extent)
    for noise in (NOISES[0], NOISES[-1]):
        found = report(with_noise(mesh, noise), tmp_path, extent)
        assert counts(found) == counts(clean), noise
        assert found["valid"]
        assert found["area"] == pytest.approx(clean["area"], rel=1e-12)
        if clean["volume"] is not None:
            assert found["volume"] == pytest.approx(clean["volume"], rel=1e-12)


@pytest.mark.parametrize("write", [hn.write_step, hn.write_iges], ids=["STEP", "IGES"])
@pytest.mark.parametrize("noise", NOISES)
def test_one_point_off_the_centre_plane(noise, write, tmp_path):
    _, mesh = mesh_of("coaster")
    clean = counts(report(mesh, tmp_path, "both", write))
    for only in range(0, len(centre_line(mesh)), 7):
        assert counts(report(with_noise(mesh, noise, only), tmp_path, "both", write)) == clean


@pytest.mark.parametrize("name", NAMES)
def test_hydrostatics_close_what_files_join(name):
    data, mesh = mesh_of(name)
    draft = data.particulars.draft
    clean = particulars(mesh, draft)
    for noise in NOISES:
        noisy = particulars(with_noise(mesh, noise), draft)
        assert noisy.displaced_volume == pytest.approx(clean.displaced_volume, rel=30 * noise)
        assert noisy.wetted_surface == pytest.approx(clean.wetted_surface, rel=30 * noise)
        # Nothing floods along the keel: it is no opening.
        surface = hn.LimitSurface(with_noise(mesh, noise))
        hn.hydrostatics(hn.HullBody(surface, mirrored=True, openings="open"), draft=draft)


def test_both_sides_share_what_is_on_the_plane():
    _, mesh = mesh_of("coaster")
    shared = []
    for noise in (0.0, *NOISES):
        surface = hn.LimitSurface(with_noise(mesh, noise))
        shared.append(hn.ShownPoints(surface, 4, mirrored=True).shared)
    assert shared[0].any()
    assert all(np.array_equal(shared[0], one) for one in shared)
    beyond = hn.LimitSurface(with_noise(mesh, 1.01 * ON))
    assert hn.ShownPoints(beyond, 4, mirrored=True).shared.sum() < shared[0].sum()
    assert "tolerances.ON_CENTRE_PLANE" in hn.ShownPoints.__doc__


def test_per_cell_patches_join_too(tmp_path):
    _, mesh = mesh_of("barge")
    clean, noisy = (
        hn.write_step(
            hn.fit_per_cell(hn.LimitSurface(one)), tmp_path / "hull.step", mirrored=True, solid=True
        )
        for one in (mesh, with_noise(mesh, NOISES[-1]))
    )
    assert counts(noisy) == counts(clean)


@pytest.mark.parametrize("distance", [1.1 * ON, 3e-6, 1e-5, 0.99 * NEAR])
def test_what_is_near_the_plane_is_told_and_never_leaves_two_shells(distance, tmp_path):
    _, mesh = mesh_of("coaster")
    for only in (None, 5):
        noisy = with_noise(mesh, distance, only)
        assert len(noisy.near_centre_line) >= 1
        for extent in EXTENTS:
            with pytest.raises(ValueError, match="off the centre plane, by up to .* set y to 0"):
                report(noisy, tmp_path, extent)
        assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("write", [hn.write_step, hn.write_iges], ids=["STEP", "IGES"])
def test_the_refusal_tells_the_points(write, tmp_path):
    _, mesh = mesh_of("coaster")
    only = 5
    noisy = with_noise(mesh, 1e-4 / mesh.size, only)
    for extent in EXTENTS:
        with pytest.raises(hn.PlaceError, match="use Put on Centre Plane, or set y to") as refused:
            report(noisy, tmp_path, extent, write)
        error = refused.value
        assert error.kind == "vertex" and error.elements == (centre_line(mesh)[only],)
        assert np.array_equal(error.point, noisy.points[error.elements[0]])
    points = noisy.points.copy()
    points[noisy.near_centre_line, 1] = 0.0
    assert report(noisy.with_points(points), tmp_path, "both", write)["shells"] == 1


@pytest.mark.parametrize("write", [hn.write_step, hn.write_iges], ids=["STEP", "IGES"])
def test_a_gap_in_the_centre_line_is_told(write, tmp_path):
    """Further off than what is refused: it may be meant, but probably is not."""
    _, mesh = mesh_of("coaster")
    for extent in EXTENTS:
        assert report(mesh, tmp_path, extent, write)["warnings"] == []
    apart = with_noise(mesh, 1.1 * NEAR, 5)
    assert not len(apart.near_centre_line)
    [warning] = report(apart, tmp_path, "both", write)["warnings"]
    assert re.match(r"a control point .* off the centre plane, by up to .* not joined", warning)
    x, _, z = apart.points[centre_line(mesh)[5]]
    assert f"({x:.6g}, " in warning and f", {z:.6g}) m" in warning
    # The half alone has no side to join.
    assert write(hn.exact_patches(hn.LimitSurface(apart)), tmp_path / "half")["warnings"] == []


@pytest.mark.parametrize("levels", [1, 2])
def test_many_patches_of_a_fine_mesh_join(levels, tmp_path):
    """Of 555 and 2,143 points, its centre line noisy: of so many patches the borders in the centre
    plane join in both sides and in solids."""
    data, mesh = mesh_of("naval_vessel")
    for _ in range(levels):
        mesh = hn.LimitSurface(mesh, data.scheme).refined_mesh()
    surface = hn.LimitSurface(with_noise(mesh, NOISES[-1]), data.scheme)
    few, many = (hn.exact_patches(surface, most_control_points=most) for most in (0, 64))
    assert many.patch_count > 2 * few.patch_count
    for extent in ("both", "solid"):
        wanted = hn.write_step(few, tmp_path / "few.step", **EXTENTS[extent])
        for write in (hn.write_step, hn.write_iges):
            found = write(many, tmp_path / "many.file", **EXTENTS[extent])  # read back from there
            assert found["valid"] and found["faces"] >= 2 * many.patch_count
            for key in ("shells", "solids"):
                assert found[key] == wanted[key], key
            for key in ("area", "volume", "free_edge_length"):
                assert found[key] == pytest.approx(wanted[key], rel=1e-8), key


def test_the_half_alone_is_written_whatever_its_centre_line(tmp_path):
    _, mesh = mesh_of("coaster")
    noisy = with_noise(mesh, 1e-5)
    found = hn.write_step(hn.exact_patches(hn.LimitSurface(noisy)), tmp_path / "half.step")
    assert found["shells"] == 1 and found["valid"]


def test_a_gap_that_is_meant_stays(tmp_path):
    _, mesh = mesh_of("barge")
    points = mesh.points + [0.0, 1.1 * NEAR * mesh.size, 0.0]
    apart = mesh.with_points(points)
    assert not len(apart.near_centre_line)
    assert report(apart, tmp_path, "both")["shells"] == 2


def test_with_centre_line_changes_nothing_else():
    for name in NAMES:
        _, mesh = mesh_of(name)
        assert np.array_equal(mesh.with_centre_line().points, mesh.points)
        assert not len(mesh.near_centre_line)
        noisy = with_noise(mesh, NOISES[-1])
        assert np.array_equal(noisy.with_centre_line().points, mesh.points)


def test_readers_of_files_share_the_rule():
    assert mirror.ON_CENTRE_PLANE == ON
    data, mesh = mesh_of("coaster")
    data.points = with_noise(mesh, NOISES[-1]).points.copy()
    assert mirror.put_on_centre_plane(data) == len(centre_line(mesh))
    assert np.array_equal(data.points, mesh.points)
