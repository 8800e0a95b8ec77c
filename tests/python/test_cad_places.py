# SPDX-License-Identifier: GPL-3.0-or-later
"""CAD files of shapes that readers misread, and refusals that lead to the place."""

from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest

SHARED = Path(__file__).resolve().parents[3] / "shared"
MOTORBOAT = SHARED / "hulls" / "freeship" / "Motorboat.fbm"


def mesh(points, faces, creases=()):
    return hn.ControlMesh(
        np.array(points, float),
        np.array([len(face) for face in faces]),
        np.concatenate(faces),
        np.array(creases, int).reshape(-1, 2),
        np.array([], int),
    )


def ring(around, along, point, *, is_closed=False):
    """A mesh of quadrilaterals, joined to itself around and, if closed, along."""
    rows = along if is_closed else along + 1
    points = [point(i / around, j / along) for i in range(around) for j in range(rows)]
    faces = [
        [
            (a % around) * rows + b % rows
            for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
        ]
        for i in range(around)
        for j in range(along)
    ]
    return mesh(points, faces)


def tube(s, t):
    return 4.0 * t, -np.sin(2.0 * np.pi * s), np.cos(2.0 * np.pi * s)


def torus(s, t):
    radius = 3.0 + np.cos(2.0 * np.pi * t)
    return (
        radius * np.cos(2.0 * np.pi * s),
        radius * np.sin(2.0 * np.pi * s),
        np.sin(2.0 * np.pi * t),
    )


@pytest.mark.parametrize("most", [0, 16, 30])
@pytest.mark.parametrize("shape", ["tube", "torus"])
def test_rings_become_patches_that_are_not_closed(shape, most, tmp_path):
    around = 5
    made = ring(around, 2, tube) if shape == "tube" else ring(around, 4, torus, is_closed=True)
    surface = hn.LimitSurface(made)
    patches = hn.exact_patches(surface, most_control_points=most)
    for sides in patches.sides:
        own = [edge for side in sides for edge, _, _ in side]
        assert len(set(own)) == len(own)
    if not most:
        assert patches.patch_count == (2 if shape == "tube" else 4)
    assert hn.measure_quality(surface, patches).largest_distance < 1e-12
    report = hn.write_step(patches, tmp_path / "ring.step", solid=True)
    assert report["valid"] and report["solids"] == 1
    # Of points on the surface the volume by another way: prisms below the faces of a fine net.
    fine = 64
    uv = (np.indices((fine, fine)).reshape(2, -1).T + 0.5) / fine
    cells = np.repeat(np.arange(surface.cell_count), len(uv))
    point, du, dv = surface.evaluate(cells, np.tile(uv, (surface.cell_count, 1)), 1)[:3]
    flux = (point[:, 2] * np.cross(du, dv)[:, 2]).sum() / fine**2
    assert report["volume"] == pytest.approx(flux, rel=1e-3)


@pytest.mark.skipif(not MOTORBOAT.exists(), reason="no foreign hulls here")
@pytest.mark.parametrize("write", [hn.write_step, hn.write_iges])
def test_a_solid_that_its_first_face_would_turn_inside_out(write, tmp_path):
    """A triangle of its deck lies close above the rest: seen from there Open CASCADE takes the
    inside for the outside."""
    shell = hull_io.shell_arrays(hull_io.read_hull(MOTORBOAT))
    surface = hn.LimitSurface(hn.ControlMesh(*shell.arguments()))
    report = write(surface, tmp_path / "boat.cad", mirrored=True, solid=True)
    assert report["valid"] and report["solids"] == 1
    assert report["volume"] == pytest.approx(398.645, abs=0.001)


def test_refusals_name_the_face(tmp_path):
    # A box without its lid, whose border is bent, far from the origin.
    points = [(x, y, z) for x in (10, 14) for y in (1, 3) for z in (0, 2)]
    points[7] = (14, 3, 2.7)
    faces = [[0, 2, 6, 4], [0, 4, 5, 1], [4, 6, 7, 5], [6, 2, 3, 7], [2, 0, 1, 3]]
    creases = [(0, 2), (2, 6), (6, 4), (4, 0), (0, 1), (2, 3), (4, 5), (6, 7)]
    surface = hn.LimitSurface(mesh(points, faces, creases))
    with pytest.raises(hn.PlaceError, match="neither flat nor symmetric.*face [1-4] of") as refused:
        hn.write_step(surface, tmp_path / "box.step", solid=True)
    error = refused.value
    assert isinstance(error, ValueError)
    assert error.kind == "face" and error.elements[0] in (1, 2, 3, 4)
    assert f"(face {error.elements[0]} of the control mesh)" in str(error)
    assert error.point[2] > 1.5 and not list(tmp_path.iterdir())
