# SPDX-License-Identifier: GPL-3.0-or-later
"""The manners of hull_native in plain Python: what it loads, shapes, words on mistakes."""

import subprocess
import sys
from pathlib import Path

import hull_native as hn
import numpy as np
import pytest

CUBE_POINTS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
CUBE_FACES = np.array(
    [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
)
SIZES = np.full(6, 4)


def cube(**tags):
    return hn.ControlMesh(CUBE_POINTS, SIZES, CUBE_FACES.ravel(), **tags)


def run_python(code):
    """The output of a Python of its own: what is loaded there is loaded by the code alone."""
    folder = str(Path(hn.__file__).parents[1])
    program = f"import sys; sys.path.insert(0, {folder!r}); {code}"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_modelling_loads_neither_open_cascade_nor_cairo():
    loaded = run_python("import hull_native; print(open('/proc/self/maps').read())")
    assert "_core" in loaded
    assert "libTK" not in loaded
    assert "libcairo" not in loaded


def test_names_of_later_parts_are_listed():
    assert {"write_step", "write_iges", "read_cad_report", "write_lines_drawing"} <= set(dir(hn))
    with pytest.raises(AttributeError, match="no_such_thing"):
        hn.no_such_thing


def test_everything_has_a_docstring():
    silent = [
        name
        for name in dir(hn)
        if not name.startswith("_")
        and callable(getattr(hn, name))
        and not (getattr(hn, name).__doc__ or "").strip()
    ]
    assert silent == []


def test_mesh_gives_back_its_arrays():
    mesh = cube(creases=np.array([[0, 1]]), corners=np.array([7]))
    assert (mesh.vertex_count, mesh.edge_count, mesh.face_count) == (8, 12, 6)
    np.testing.assert_array_equal(mesh.points, CUBE_POINTS)
    np.testing.assert_array_equal(mesh.face_sizes, SIZES)
    np.testing.assert_array_equal(mesh.face_vertices, CUBE_FACES.ravel())
    assert {tuple(sorted(pair)) for pair in mesh.creases} == {(0, 1)}
    assert mesh.border_edges.shape == (0, 2)
    np.testing.assert_array_equal(mesh.vertex_valences, np.full(8, 3))
    assert mesh.vertex_kinds[7] == 4


def test_surface_arrays_have_the_documented_shapes():
    surface = hn.LimitSurface(cube())
    assert surface.cell_count == 24
    cells = np.arange(24)
    uv = np.full((24, 2), 0.25)
    assert surface.positions(cells, uv).shape == (24, 3)
    np.testing.assert_allclose(np.linalg.norm(surface.normals(cells, uv), axis=1), 1, atol=1e-14)
    tessellation = surface.tessellate(3)
    quad_count = 24 * 9
    assert tessellation.quads.shape == (quad_count, 4)
    assert tessellation.corner_normals.shape == (quad_count, 4, 3)
    # A closed surface of genus 0 made of quadrilaterals has two points more than faces.
    point_count = quad_count + 2
    assert tessellation.points.shape == (point_count, 3)
    assert tessellation.cells.shape == (point_count,)
    assert tessellation.uv.shape == (point_count, 2)
    np.testing.assert_allclose(
        surface.positions(tessellation.cells, tessellation.uv), tessellation.points, atol=1e-14
    )


def test_no_places_give_no_points():
    surface = hn.LimitSurface(cube())
    empty = np.zeros(0, dtype=np.int32)
    assert surface.positions(empty, np.zeros((0, 2))).shape == (0, 3)


@pytest.mark.parametrize(
    "arguments, words",
    [
        ((np.zeros((8, 2)), SIZES, CUBE_FACES.ravel()), ["points", "(n, 3)", "(8, 2)"]),
        ((CUBE_POINTS, SIZES, CUBE_FACES), ["face_vertices", "(n,)", "(6, 4)"]),
        ((CUBE_POINTS, SIZES * 1.0, CUBE_FACES.ravel()), ["face_sizes", "whole numbers"]),
        ((CUBE_POINTS, SIZES, CUBE_FACES.ravel(), np.arange(3)), ["creases", "(n, 2)", "(3,)"]),
        (
            (CUBE_POINTS, SIZES, CUBE_FACES.ravel(), None, np.ones((1, 1), int)),
            ["corners", "(n,)", "(1, 1)"],
        ),
    ],
)
def test_wrong_arrays_of_a_mesh_are_named(arguments, words):
    with pytest.raises(ValueError) as refused:
        hn.ControlMesh(*arguments)
    for word in words:
        assert word in str(refused.value)


def test_a_mesh_that_cannot_be_is_refused_as_its_check_says():
    faces = CUBE_FACES.ravel().copy()
    faces[0] = 99
    problems = hn.check_mesh(CUBE_POINTS, SIZES, faces)
    assert problems[0].severity == "error"
    assert "99" in problems[0].message
    with pytest.raises(ValueError) as refused:
        hn.ControlMesh(CUBE_POINTS, SIZES, faces)
    assert str(refused.value) == problems[0].message


@pytest.mark.parametrize(
    "cells, uv, word",
    [
        ([24], [[0, 0]], "24"),
        ([-1], [[0, 0]], "-1"),
        ([0, 1], [[0, 0]], "equal length"),
        ([0], [[0, 1.5]], "[0, 1]"),
        ([0], [[np.nan, 0]], "[0, 1]"),
        ([0], [[0, 0, 0]], "(n, 2)"),
    ],
)
def test_wrong_places_are_named(cells, uv, word):
    surface = hn.LimitSurface(cube())
    with pytest.raises(ValueError) as refused:
        surface.positions(np.array(cells), np.array(uv, dtype=float))
    assert word in str(refused.value)


def test_wrong_scheme_and_density_are_named():
    with pytest.raises(ValueError, match="loop"):
        hn.LimitSurface(cube(), "loop")
    for n in (0, -1, 100000):
        with pytest.raises(ValueError, match=str(n)):
            hn.LimitSurface(cube()).tessellate(n)


def test_no_name_is_also_that_of_a_module_in_the_package():
    """A module that is imported takes its name in the package, whatever that was before."""
    folder = Path(hn.__file__).parent
    modules = {path.stem for path in folder.glob("*.py")}
    modules |= {path.parent.name for path in folder.glob("*/__init__.py")}
    assert not modules & {name for name in dir(hn) if callable(getattr(hn, name))}
    assert {"polylines", "networks"} <= modules
