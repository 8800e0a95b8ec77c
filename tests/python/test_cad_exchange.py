# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids, regions and curves of whole ships in STEP and IGES files."""

import hull_native as hn
import numpy as np
import pytest
from reference_data import hull_path
from test_step import NAMES, hull_io, surface_of

pytestmark = pytest.mark.one_in(2)

FORMATS = [(hn.write_step, "ship.step"), (hn.write_iges, "ship.igs")]


class Cancelled(Exception):
    pass


def volume_of(surface, mirrored):
    """Of the closed hull, by the analysis."""
    body = hn.HullBody(surface, mirrored=mirrored)
    above = surface.mesh.points[:, 2].max() + 1.0
    return body.immersion(np.array([0.0, 0.0, 1.0]), above).volume


@pytest.mark.parametrize("name", NAMES)
def test_solids_have_the_volume_of_the_analysis(name, tmp_path):
    data, surface = surface_of(name)
    patches = hn.exact_patches(surface)
    volume = volume_of(surface, data.half)
    area = hn.HullBody(surface, mirrored=data.half).shell_area
    for write, file in FORMATS:
        for mirrored, share in ((True, 1.0), (False, 0.5)):
            write(patches, tmp_path / file, name=data.name, mirrored=mirrored, solid=True)
            report = hn.read_cad_report(tmp_path / file)
            assert report["valid"] and report["closed"] and report["solids"] == 1
            assert report["volume"] == pytest.approx(share * volume, rel=1e-8)
            caps = {"deck", "transom", "centre plane", "opening"}
            names = {region["name"] for region in report["regions"]}
            assert names & caps and "shell" in names
            assert ("centre plane" in names) == (not mirrored)
        shell = write(patches, tmp_path / file, mirrored=True)
        assert shell["area"] == pytest.approx(area, rel=1e-7)
        assert not shell["closed"]


def both_sides(name):
    """The surface of the hull with its mirror image in one mesh."""
    shell = hull_io.shell_arrays(hull_io.read_hull(hull_path(name)))
    points = np.array(shell.points)
    on_plane = np.abs(points[:, 1]) < 1e-6
    points[on_plane, 1] = 0.0
    image = np.arange(len(points))
    image[~on_plane] = len(points) + np.arange((~on_plane).sum())
    points = np.vstack([points, points[~on_plane] * [1, -1, 1]])
    faces = np.split(np.asarray(shell.face_vertices), np.cumsum(shell.face_sizes)[:-1])
    faces += [image[face][::-1] for face in faces]
    creases = np.asarray(shell.creases, dtype=int).reshape(-1, 2)
    creases = np.unique(np.sort(np.vstack([creases, image[creases]]), axis=1), axis=0)
    corners = np.asarray(shell.corners, dtype=int)
    mesh = hn.ControlMesh(
        points,
        [len(face) for face in faces],
        np.concatenate(faces),
        creases,
        np.unique(np.concatenate([corners, image[corners]])),
    )
    return hn.LimitSurface(mesh)


# The coaster's deck edge goes around her bow, where it is cut; no block ends there.
@pytest.mark.parametrize("name", ["barge.hull.json", "coaster.hull.json"])
def test_hulls_modelled_on_both_sides_can_be_solids(name, tmp_path):
    surface = both_sides(name)
    for write, file in FORMATS:
        report = write(surface, tmp_path / file, solid=True)
        assert report["solids"] == 1
        assert report["volume"] == pytest.approx(volume_of(surface, False), rel=1e-9)


def test_files_have_sections_and_knuckles(tmp_path):
    _, surface = surface_of("coaster.hull.json")
    planes = [hn.plane_across("x", x) for x in (10.0, 30.0, 50.0)]
    curves = [
        (f"station {i}", "stations", spline)
        for i, branches in enumerate(hn.section_splines(surface, planes, tolerance=1e-3))
        for branch in branches
        for spline in branch.splines
    ]
    curves += [(c.kind, "knuckles", c) for c in hn.crease_curves(surface)]
    curves.append(("base", "lines", [0, 0, 1, 1], [[0.0, 0.0, 0.0], [70.0, 0.0, 0.0]]))
    for write, file in FORMATS:
        report = write(surface, tmp_path / file, curves=curves)
        assert report["curves"] == len(curves)
        assert {"stations", "knuckles", "lines"} <= set(report["layers"])
        both = write(surface, tmp_path / file, curves=curves, mirrored=True)
        assert len(curves) < both["curves"] < 2 * len(curves)


def test_names_are_held_as_files_can(tmp_path):
    """Control characters become blanks, as in the product's name; curves need no layer."""
    _, surface = surface_of("barge.hull.json")
    patches = hn.exact_patches(surface)
    regions = ["flat\nside" if i % 2 else "a\tb\x7f" for i in range(patches.patch_count)]
    colours = {"flat\nside": (1.0, 0.0, 0.0)}
    line = [0, 0, 1, 1], [[0.0, 0.0, 0.0], [9.0, 0.0, 0.0]]
    curves = [("base\n", "li\nnes", *line), ("other", "", *line), ("third", " x ", *line)]
    for write, file in FORMATS:
        report = write(patches, tmp_path / file, regions=regions, colours=colours, curves=curves)
        assert {region["name"] for region in report["regions"]} == {"flat side", "a b "}
        assert report["curves"] == 3 and {"li nes", " x "} <= set(report["layers"])


def test_cancelling_leaves_the_old_file(tmp_path):
    _, surface = surface_of("barge.hull.json")
    for write, file in FORMATS:
        path = tmp_path / "folder" / file
        path.parent.mkdir(exist_ok=True)
        path.write_text("old")
        for end in (0.0, 0.05, 0.3, 0.7, 1.0):

            def progress(share, end=end):
                if share >= end:
                    raise Cancelled

            with pytest.raises(Cancelled):
                write(surface, path, progress=progress)
            assert path.read_text() == "old"
            assert [p.name for p in path.parent.iterdir()] == [file]
        path.unlink()


def test_options_that_are_wrong_are_named(tmp_path):
    _, surface = surface_of("barge.hull.json")
    path = tmp_path / "ship.step"
    for options, said in (
        ({"schema": "AP203"}, "AP203"),
        ({"unit": "furlong"}, "furlong"),
        ({"regions": ["shell"]}, "patches"),
        ({"colours": {"shell": (1.0, 2.0, 0.0)}}, "shell"),
        ({"colours": {"shell": ()}}, "shell"),
        ({"curves": [("a", "b")]}, "curve"),
        ({"regions": [1]}, "regions must be a list of names"),
        ({"colours": {1: (0.0, 0.0, 0.0)}}, "colours must be a dict"),
        ({"colours": {"shell": "red"}}, "shell"),
        ({"curves": [("a", "b", 1)]}, "A curve must be"),
        (
            {"curves": [("a", 1, [0, 0, 1, 1], [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]])]},
            "A curve must be",
        ),
        ({"curves": [("bilge", "b", [0, 1], [[0.0, 0.0, 0.0]])]}, "bilge"),
    ):
        with pytest.raises(ValueError, match=said):
            hn.write_step(surface, path, **options)
    for knots, said in (
        ([0, 0, np.nan, 1, 1], "a knot is not finite"),
        ([0, 0, 0.5, 1, np.inf], "a knot is not finite"),
        ([0, 1, 1, 1, 2], "its parameters have no range"),
        ([0, 0, 0.5, 0.5, 1, 1], "the knot 0.5"),
        ([0, 0, 0, 0.5, 1, 1], "the knot 0.0"),
    ):
        points = [[float(i), 0.0, 0.0] for i in range(len(knots) - 2)]
        for write, file in FORMATS:
            with pytest.raises(ValueError, match=f'curve "bilge": {said}'):
                write(surface, tmp_path / file, curves=[("bilge", "b", knots, points)])
    for options in ({"colours": [1]}, {"curves": [1]}):
        with pytest.raises(TypeError):
            hn.write_step(surface, path, **options)
    with pytest.raises(OSError, match="there is no folder"):
        hn.write_step(surface, tmp_path / "none" / "ship.step")
    assert list(tmp_path.iterdir()) == []
