# SPDX-License-Identifier: GPL-3.0-or-later
"""Exports the samples, makes hulls of the files, and tells how near these are to the samples.

PYTHONPATH=build/release/python:samples python3 scripts/geometry_round_trips.py
    [--kinds KIND,...] [--marks] [--into FOLDER] [SAMPLE ...]

KIND is stl, step, iges, offsets, bare (a table of stations and heights of the keel alone), dxf. One
line for each: control points beside the sample's, RMS and largest distance of the sample's exact
surface from the hull, of the length, the error of the displacement, the share of points in rows of
one x, with --marks the unwanted marks beside the sample's, and the processor's seconds.
"""

import argparse
import csv
import importlib.util
import sys
import tempfile
import time
import types
from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import vessels
from hull_fairness.lines import judged
from hull_fitting import hull_from_geometry
from hull_fitting.profile_ends import end_lines
from hull_io.geometry import read_geometry
from hull_io.triangles import spread_points

STATIONS, WATERLINES, PARTS, MEASURED = 20, 11, 8, 20_000
_LINES = vessels.ROOT / "addon" / "hull_tools" / "features" / "lines"


def offset_rows():
    """The module of the add-on's table of offsets, without Blender: of its package only the names
    are there."""
    for name in ("bare", "bare.bridge", "bare.features", "bare.features.lines"):
        sys.modules.setdefault(name, types.ModuleType(name)).__path__ = []
    sys.modules["bare.bridge"].native = sys.modules["bare.features.lines"].line_places = None
    sys.modules["bare.features.lines"].__path__ = [str(_LINES)]
    path = _LINES / "offset_table.py"
    spec = importlib.util.spec_from_file_location("bare.features.lines.offset_table", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _stations(vessel):
    """At Lpp / 20, and on to both ends, as the add-on has them."""
    points, length = vessel.surface.mesh.points, vessel.data.particulars.length_pp
    step = length / STATIONS
    first = int(np.ceil((min(points[:, 0].min(), 0.0) - 1e-6) / step))
    last = int(np.floor((max(points[:, 0].max(), length) + 1e-6) / step))
    return step * np.arange(first, last + 1)


def _table(vessel, stations):
    points = vessel.surface.mesh.points
    return hn.offset_table(
        vessel.surface,
        stations=stations,
        waterlines=np.linspace(0.0, points[:, 2].max(), WATERLINES),
        buttocks=[0.0],
    )


def write_offsets(vessel, path):
    own, table = offset_rows(), _table(vessel, _stations(vessel))
    found = own.with_ends(table, end_lines(vessel.surface, table.stations))
    with open(path, "w", newline="") as file:
        csv.writer(file).writerows([own.header(found), *own.rows(found)])


def write_bare(vessel, path):
    own = offset_rows()
    x = np.asarray(vessel.surface.tessellate(6).points)[:, 0]
    found = _table(vessel, np.linspace(x.min(), x.max(), STATIONS + 1))
    with open(path, "w", newline="") as file:
        csv.writer(file).writerows([own.header(found), *own.rows(found)])


def write_stl(vessel, path):
    hull_io.write_stl(path, *vessels.triangles_of(vessel.surface, PARTS))


def write_step(vessel, path):
    hn.write_step(hn.exact_patches(vessel.surface), path)


def write_iges(vessel, path):
    hn.write_iges(hn.exact_patches(vessel.surface), path)


def write_dxf(vessel, path):
    low, high = vessel.surface.mesh.points.min(axis=0), vessel.surface.mesh.points.max(axis=0)
    given = vessel.data.particulars
    hn.write_lines_drawing(
        vessel.surface,
        path,
        mirrored=vessel.data.half,
        stations=given.length_pp / STATIONS,
        waterlines=(high[2] - low[2]) / (WATERLINES - 1),
        buttocks=high[1] / 5.0,
        draft=given.draft,
        length=given.length_pp,
    )


KINDS = {
    "stl": (write_stl, "stl"),
    "step": (write_step, "step"),
    "iges": (write_iges, "igs"),
    "offsets": (write_offsets, "csv"),
    "bare": (write_bare, "csv"),
    "dxf": (write_dxf, "dxf"),
}


def main_part(surface):
    """(points, triangles) of the largest body: without appendages."""
    from hull_fitting.triangle_edges import components, edge_table
    from hull_io.triangles import normals_of

    points, triangles = vessels.triangles_of(surface, 6)
    _, first, which = np.unique(points.round(6), axis=0, return_index=True, return_inverse=True)
    points, triangles = points[first], which.reshape(-1)[triangles]
    table = edge_table(triangles)
    body = components(len(triangles), table.owners[table.counts > 1])
    areas = np.bincount(body, normals_of(points, triangles)[1])
    return points, triangles[body == areas.argmax()]


def measured(vessel, made):
    """(RMS, largest, place of it) of the sample from the hull, of the length."""
    guess, fitted = made.guess, made.fitted
    places, _ = spread_points(*main_part(vessel.surface), MEASURED)
    length = np.ptp(places[:, 0])
    scale = guess.metres_per_unit
    in_file = places / scale
    placed = scale * ((in_file - np.asarray(guess.origin)) @ guess.matrix().T)
    apart = np.asarray(hn.SurfaceTree(fitted.surface).closest_points(placed).distances)
    most = int(apart.argmax())
    return np.sqrt(np.mean(apart**2)) / length, apart[most] / length, places[most]


def marks(surface, vessel):
    lines = judged(surface, vessel.data.particulars.beam, vessel.wanted)
    return sum(len(line.unwanted) for line in lines)


def run(vessel, kind, folder, with_marks):
    write, ending = KINDS[kind]
    path = Path(folder) / f"{vessel.name}.{ending}"
    write(vessel, path)
    begun = time.process_time()
    given = vessel.data.particulars
    own = len(hull_io.shell_arrays(vessel.data).arguments()[0])
    budget = int(1.5 * own)
    try:
        made = hull_from_geometry(read_geometry(path), budget=budget, draft=given.draft)
    except (ValueError, hull_io.HullFileError) as error:
        print(f"{vessel.name:16} {kind:8} refused: {error}", flush=True)
        return
    seconds = time.process_time() - begun
    rms, largest, place = measured(vessel, made)
    exact = hn.upright_hydrostatics(vessel.surface, draft=given.draft, mirrored=vessel.data.half)
    lower = made.guess.origin[2] * made.guess.metres_per_unit
    found = hn.upright_hydrostatics(made.fitted.surface, draft=given.draft - lower, mirrored=True)
    report = made.report
    told = [
        f"{vessel.name:16} {kind:8} {report['points']:4d}/{own:<4d}",
        f"rms {1e4 * rms:6.2f}e-4 largest {1e4 * largest:6.1f}e-4",
        f"at ({', '.join(f'{c:.2f}' for c in place)})",
        f"V {100 * (found.displaced_volume / exact.displaced_volume - 1):+.3f} %",
        f"S {100 * (found.wetted_surface / exact.wetted_surface - 1):+.2f} %",
        f"rows {100 * report['points_in_rows_of_one_x'] / report['points']:.0f} %",
        f"warnings {len(made.fitted.surface.mesh.warnings)}",
    ]
    if with_marks:
        told.append(f"marks {marks(made.fitted.surface, vessel)}/{marks(vessel.surface, vessel)}")
    print("  ".join(told), f" {seconds:.0f} s", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("samples", nargs="*", metavar="SAMPLE")
    parser.add_argument("--kinds", default=",".join(KINDS))
    parser.add_argument("--marks", action="store_true")
    parser.add_argument("--into", type=Path)
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for name in given.samples or vessels.names():
            vessel = vessels.vessel(name)
            for kind in given.kinds.split(","):
                run(vessel, kind, given.into or folder, given.marks)


if __name__ == "__main__":
    main()
