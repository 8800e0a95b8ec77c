# SPDX-License-Identifier: GPL-3.0-or-later
"""Every function of the packages that writes a file, by its name, each with something small to
write: write(path) of one ending, and which file it makes first."""

import importlib.util
import os
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from typing import Callable

import hull_io
import hull_native as hn
import hull_studies
import numpy as np
from hull_studies.tables import Table

SAMPLES = Path(__file__).resolve().parents[2] / "samples"
PACKAGES = {"hull_native": hn, "hull_io": hull_io, "hull_studies": hull_studies}
CUBE = np.array([(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=float)
QUADS = np.array(
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
)
TRIANGLES = np.vstack([QUADS[:, [0, 1, 2]], QUADS[:, [0, 2, 3]]])


@dataclass(frozen=True)
class Writer:
    """write(path, points): the points (8, 3) are a cube's where what is written has any. part: of
    the first file's name, between the path's stem and its ending, where there are several."""

    endings: tuple
    write: Callable
    part: str = ""


@cache
def barge():
    return hull_io.read_hull(SAMPLES / "barge.hull.json")


@cache
def surface():
    shell = hull_io.shell_arrays(barge())
    return hn.LimitSurface(hn.ControlMesh(*shell.arguments()))


@cache
def patches():
    return hn.exact_patches(surface())


def square():
    drawing = hn.ShopDrawing("square")
    drawing.add_line("OUTLINE", [(0, 0), (10, 0), (10, 10), (0, 0)])
    return drawing


def study_table():
    study = SimpleNamespace(variables=["a"], variants=[(1.0,)])
    rows = [SimpleNamespace(status="made", reason="", numbers={"b": 2.0})]
    return Table(study, ["b"], rows)


def write_parquet(path, points):
    with whatever_parquet():
        hull_studies.write_parquet(study_table(), path)


@contextmanager
def whatever_parquet():
    """What pandas needs for the format is not everywhere, and the file's content does not matter
    here."""
    import pandas

    if any(map(importlib.util.find_spec, ("pyarrow", "fastparquet"))):
        yield
        return
    own = pandas.DataFrame.to_parquet
    pandas.DataFrame.to_parquet = lambda frame, file, index: file.write(b"rows")
    try:
        yield
    finally:
        pandas.DataFrame.to_parquet = own


def layers(points):
    return hn.ClosedModel(points, TRIANGLES).layers(0.3)


def hull_of(points):
    faces = [face.tolist() for face in QUADS]
    return hull_io.HullData(name="box", points=points, faces=faces)


def figures(path, points):
    body = hn.HullBody(surface(), mirrored=True)
    hn.write_hull_figures(body, path, figures=["control-mesh"])


def lines_drawing(path, points):
    hn.write_lines_drawing(surface(), path, mirrored=True, stations=10.0, offsets=False)


@cache
def plate_list():
    sheet = hn.ControlMesh(10.0 * CUBE[[0, 1, 3, 2]], [4], [0, 1, 2, 3], [], [0, 1, 2, 3])
    return hn.plate_list(hn.plates(hn.LimitSurface(sheet), []), thickness=0.01)


def plot(path, points):
    heel = np.radians(np.arange(0, 95, 5))
    hn.write_plot(hn.righting_lever_plot(heel, np.sin(2.0 * heel)), path)


PAPER = (".pdf", ".svg", ".png")
WRITERS = {
    "hull_native.write_curves_dxf": Writer(
        (".dxf",),
        lambda path, points: hn.write_curves_dxf(
            [("LINES", [0, 0, 0, 0, 1, 1, 1, 1], points[:4])], str(path)
        ),
    ),
    "hull_native.write_hull_figures": Writer(PAPER, figures, "-control-mesh"),
    "hull_native.write_iges": Writer(
        (".igs",), lambda path, points: hn.write_iges(patches(), path, mirrored=True)
    ),
    "hull_native.write_lines_drawing": Writer((*PAPER, ".dxf"), lines_drawing),
    "hull_native.write_mesh_figure": Writer(
        PAPER, lambda path, points: hn.write_mesh_figure(surface().mesh, path, mirrored=True)
    ),
    "hull_native.write_plates": Writer(
        (".pdf", ".dxf"), lambda path, points: hn.write_plates(plate_list(), path)
    ),
    "hull_native.write_plot": Writer(PAPER, plot),
    "hull_native.write_shop_booklet": Writer(
        (".pdf",), lambda path, points: hn.write_shop_booklet([square()], path)
    ),
    "hull_native.write_shop_drawings": Writer(
        (".pdf", ".dxf"), lambda path, points: hn.write_shop_drawings([square()], path)
    ),
    "hull_native.write_shop_drawings, a file each": Writer(
        (".pdf", ".svg", ".dxf"),
        lambda path, points: hn.write_shop_drawings([square()] * 2, path, names=["a", "b"]),
        "-a",
    ),
    "hull_native.write_step": Writer(
        (".step",), lambda path, points: hn.write_step(patches(), path, mirrored=True)
    ),
    "hull_native.ShopDrawing.write": Writer(
        (".pdf", ".svg", ".dxf"), lambda path, points: square().write(path)
    ),
    "hull_native.FigureSheet.write": Writer(
        PAPER, lambda path, points: hn.FigureSheet("cube", 100.0, 100.0).write(str(path))
    ),
    "hull_io.write_3mf": Writer(
        (".3mf",), lambda path, points: hull_io.write_3mf(path, points, TRIANGLES)
    ),
    "hull_io.write_cli": Writer(
        (".cli",), lambda path, points: hull_io.write_cli(path, layers(points))
    ),
    "hull_io.write_freeship": Writer(
        (".fbm",), lambda path, points: hull_io.write_freeship(hull_of(points), path)
    ),
    "hull_io.write_gdf": Writer(
        (".gdf",), lambda path, points: hull_io.write_gdf(path, points, QUADS, half=False)
    ),
    "hull_io.write_hull_file": Writer(
        (".hull.json",), lambda path, points: hull_io.write_hull_file(hull_of(points), path)
    ),
    "hull_io.write_nemoh": Writer(
        (".dat",), lambda path, points: hull_io.write_nemoh(path, points, QUADS, half=False)
    ),
    "hull_io.write_obj": Writer(
        (".obj",), lambda path, points: hull_io.write_obj(path, points, QUADS)
    ),
    "hull_io.write_segments": Writer(
        (".stl", ".obj"),
        lambda path, points: hull_io.write_segments(path, [(points, TRIANGLES)]),
        "-1",
    ),
    "hull_io.write_segments, in one file": Writer(
        (".3mf",), lambda path, points: hull_io.write_segments(path, [(points, TRIANGLES)])
    ),
    "hull_io.write_stl": Writer(
        (".stl",), lambda path, points: hull_io.write_stl(path, points, TRIANGLES)
    ),
    "hull_io.write_stl_parts": Writer(
        (".stl",), lambda path, points: hull_io.write_stl_parts(path, points, {"cube": TRIANGLES})
    ),
    "hull_studies.write_csv": Writer(
        (".csv",), lambda path, points: hull_studies.write_csv(study_table(), path)
    ),
    "hull_studies.write_parquet": Writer((".parquet",), write_parquet),
}
CASES = [(name, ending) for name, writer in WRITERS.items() for ending in writer.endings]


def writers_there_are():
    """Names of all functions and methods of the packages that write files."""
    found = set()
    for package, module in PACKAGES.items():
        for name in dir(module):
            one = getattr(module, name)
            if name.startswith("write"):
                found.add(f"{package}.{name}")
            if isinstance(one, type) and any(member.startswith("write") for member in dir(one)):
                found.add(f"{package}.{name}.write")
    return found


def made_first(name, stem, ending):
    """The name of the first file that a writer makes of such a path."""
    return f"{stem}{WRITERS[name].part}{ending}"


@contextmanager
def as_nobody(folder):
    """Within, files are written as nobody, from a folder in which nobody may not write."""
    before, is_root = os.getcwd(), os.geteuid() == 0
    os.chdir(folder)
    os.chmod(folder, 0o555)
    if is_root:
        os.seteuid(65534)
    try:
        yield
    finally:
        if is_root:
            os.seteuid(0)
        os.chmod(folder, 0o755)
        os.chdir(before)
