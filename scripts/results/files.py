# SPDX-License-Identifier: GPL-3.0-or-later
"""Results that are handed over: patches and CAD files, lines plans and plots."""

import re
import tempfile
import zlib
from pathlib import Path

import numpy as np

from .calls import attempt, body_of, native


def patches_as_lists(patches):
    numbers = range(patches.patch_count)
    yield "control points", [patches.control_points(number) for number in numbers]
    yield "knots", [patches.knots(number) for number in numbers]
    yield "cells", [patches.half_edges(number) for number in numbers]
    yield "topology", [patches.corners, patches.sides, patches.largest_gap]


def conversion_results(vessel):
    surface = vessel.surface
    patches = native("exact_patches", surface)
    for name, result in patches_as_lists(patches):
        yield f"exact {name}", result
    quality = native("measure_quality", surface, patches)
    yield "quality", [quality, quality.text()]
    cut = native("exact_patches", surface, tolerance=1e-4, most_control_points=200)
    for name, result in patches_as_lists(cut):
        yield f"cut {name}", result
    for name, result in patches_as_lists(native("fit_per_cell", surface)):
        yield f"per cell {name}", result
    for ending in ("step", "iges"):
        yield ending, attempt(cad_file, patches, ending, vessel.data.half)


def cad_file(patches, ending, mirrored):
    """Report and text, without what tells the time and the place of writing."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"hull.{ending}"
        report = native(f"write_{ending}", patches, path, mirrored=mirrored)
        text = path.read_text(encoding="latin-1").replace(folder, "")
    text = re.sub(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d", "DATE", text)
    text = re.sub(r"\d{8}\.\d{6}", "DATE", text)
    # The header of IGES counts the letters of the path, and wraps after them.
    if ending == "iges":
        text = "".join(line for line in text.splitlines(True) if line[72:73] != "G")
    report.pop("bytes")
    return [report, text]


def drawing_results(vessel):
    given = vessel.data.particulars
    options = dict(
        mirrored=vessel.data.half,
        stations=given.length_pp / 10,
        waterlines=given.draft / 3,
        buttocks=given.beam / 6,
        diagonals=[(given.draft, 0.6)],
        draft=given.draft,
        length=given.length_pp,
        title=vessel.data.name,
        paper="A1",
    )
    for ending in ("svg", "pdf", "dxf"):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"plan.{ending}"
            refusal = attempt(native, "write_lines_drawing", vessel.surface, path, **options)
            yield f"lines plan {ending}", refusal or text_of(path)
    body = body_of(vessel)
    x = np.linspace(0, given.length_pp, 41)
    areas = native("section_areas", body, list(x), draft=given.draft).areas
    rows = native("hydrostatic_table", body, drafts=list(np.linspace(0.2, 1.2, 6) * given.draft))
    plots = {
        "sectional area plot": native("sectional_area_plot", x, areas, length_pp=given.length_pp),
        "hydrostatic curves plot": native("hydrostatic_curves_plot", rows, draft=given.draft),
    }
    for name, plot in plots.items():
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "plot.svg"
            native("write_plot", plot, path)
            yield name, text_of(path)


def text_of(path):
    """A drawing's text; that of a PDF unpacked and without its date."""
    data = path.read_bytes()
    if path.suffix == ".pdf":
        data = re.sub(rb"/CreationDate \([^)]*\)", b"", data)
        data = re.sub(rb"stream\r?\n(.*?)\r?\nendstream", _unpacked, data, flags=re.S)
    return data.decode("latin-1")


def _unpacked(stream):
    try:
        return zlib.decompress(stream[1])
    except zlib.error:
        return stream[0]
