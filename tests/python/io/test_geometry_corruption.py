# SPDX-License-Identifier: GPL-3.0-or-later
"""Damaged files of each kind of geometry are refused in one sentence or read, soon, and in bounded
memory. HULL_CORRUPTIONS=300 tries so many copies of each."""

import os
import random
import resource

import hull_io
import numpy as np
import pytest
from hull_io.geometry import read_geometry
from test_geometry_drawings import OBJ
from test_geometry_tables import BY_COLUMNS, IN_BLOCKS, IN_MM

COPIES = int(os.environ.get("HULL_CORRUPTIONS", 24))
SEED = 24112026
SECONDS = 5.0

TEXTS = {
    "mm.csv": IN_MM,
    "columns.csv": BY_COLUMNS,
    "blocks.txt": IN_BLOCKS,
    "points.xyz": "0 0 0\n0 1 1\n\n5 0 0\n5 2 1\n5 3 2\n",
    "hull.obj": OBJ,
}
CAD = ("hull.step", "hull.igs")


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """{name: path} of undamaged files."""
    native = pytest.importorskip("hull_native")
    folder = tmp_path_factory.mktemp("whole")
    for name, text in TEXTS.items():
        (folder / name).write_text(text)
    x, y = np.meshgrid([0.0, 1.0, 2.0, 3.0], [0.0, 1.0, 2.0], indexing="ij")
    points = np.stack([x, y, 0.1 * x * y], axis=-1).reshape(-1, 3)
    faces = [(a, a + 3, a + 4, a + 1) for i in range(3) for a in (3 * i, 3 * i + 1)]
    mesh = native.ControlMesh(points, [4] * 6, np.ravel(faces), [], [])
    surface = native.LimitSurface(mesh)
    curve = [("line", "lines", [0, 0, 1, 1], [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0]])]
    native.write_step(surface, folder / "hull.step", curves=curve)
    native.write_iges(surface, folder / "hull.igs", curves=curve)
    plan = {"stations": [0.5, 1.5, 2.5], "waterlines": [0.2], "buttocks": [0.5], "length": 3.0}
    native.write_lines_drawing(surface, folder / "lines.dxf", mirrored=True, draft=0.3, **plan)
    hull_io.write_stl(folder / "hull.stl", points, [face[:3] for face in faces])
    return {path.name: path for path in folder.iterdir()}


def damaged(data, choice):
    """Cut short, bytes exchanged, digits changed, or a piece twice or gone."""
    kind = choice.randrange(5)
    if kind == 0:
        return data[: choice.randrange(len(data))]
    copy = bytearray(data)
    if kind == 1:
        for _ in range(choice.choice((1, 3, 20))):
            copy[choice.randrange(len(copy))] = choice.randrange(256)
    elif kind == 2:
        digits = [k for k, letter in enumerate(copy) if 48 <= letter < 58] or [0]
        for _ in range(choice.choice((1, 3, 20))):
            copy[choice.choice(digits)] = choice.choice(b"0123456789-.E#")
    else:
        start = choice.randrange(len(data))
        end = min(len(data), start + choice.randrange(1, 400))
        return data[:start] + (data[start:end] * 2 if kind == 3 else b"") + data[end:]
    return bytes(copy)


def computed():
    """Seconds that this process and those that it waited for have computed."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(one.ru_utime + one.ru_stime for one in used)


def check(geometry):
    """What every consumer relies on, whatever the file was."""
    assert not geometry.is_empty
    assert np.isfinite(geometry.all_points()).all()
    for curve in geometry.curves:
        assert len(curve.points) >= 2 and curve.knuckles.shape == (len(curve.points),)
    for mesh in geometry.meshes:
        assert not len(mesh.triangles) or 0 <= mesh.triangles.min()
        assert mesh.triangles.max(initial=-1) < len(mesh.points)


@pytest.mark.parametrize("name", [*TEXTS, *CAD, "lines.dxf", "hull.stl"])
def test_damaged_copies_are_read_or_refused(files, name, tmp_path):
    data = files[name].read_bytes()
    check(read_geometry(files[name]))
    choice = random.Random(f"{SEED} {name}")
    path = tmp_path / name
    counts, longest = {"read": 0, "refused": 0}, 0.0
    for copy in range(COPIES):
        path.write_bytes(damaged(data, choice))
        begin = computed()
        try:
            check(read_geometry(path))
            counts["read"] += 1
        except hull_io.HullFileError as error:
            message = str(error)
            assert message.startswith(f"{name}: ") and message.endswith("."), (copy, message)
            assert "\n" not in message
            counts["refused"] += 1
        longest = max(longest, computed() - begin)
        assert longest < SECONDS, copy
    print(f"seed {SEED} {name}", counts, f"longest {longest:.2f} s")
