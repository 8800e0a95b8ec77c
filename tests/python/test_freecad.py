# SPDX-License-Identifier: GPL-3.0-or-later
"""STEP and IGES files opened by FreeCAD, which is run without a window."""

import json
import os
import shutil
import subprocess
from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]

FREECAD = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
pytestmark = pytest.mark.skipif(FREECAD is None, reason="FreeCAD is not installed")

SHIPS = [ROOT / "samples" / "barge.hull.json", ROOT / "samples" / "coaster.hull.json"]
DEMO = ROOT.parent / "shared" / "hulls" / "freeship" / "FREE!ship demo 3.fbm"
if DEMO.exists():
    SHIPS.append(DEMO)

# FreeCAD integrates by one Gauss rule over each face, whatever its spans, which may be off by 5e-4
# (docs/cad-exchange.md). On these hulls 9.3e-5 is the most, on the barge. What is in the files
# agrees to 1e-10, by integrals of their own.
FREECAD_INTEGRALS = 2e-4

WAYS = {
    "open": {"mirrored": True},
    "whole": {"mirrored": True, "solid": True},
    "half": {"solid": True},
}


def surface_of(path):
    shell = hull_io.shell_arrays(hull_io.read_hull(path))
    mesh = hn.ControlMesh(*shell.arguments())
    return hn.LimitSurface(mesh)


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """Of every file: its ship's surface, which way it was written, our report, and FreeCAD's."""
    folder = tmp_path_factory.mktemp("freecad")
    written = {}
    for ship in SHIPS:
        surface = surface_of(ship)
        patches = hn.exact_patches(surface)
        for way, options in WAYS.items():
            for write, ending in ((hn.write_step, "step"), (hn.write_iges, "igs")):
                path = folder / f"{ship.stem} {way}.{ending}"
                unit = "m" if way == "open" else "mm"
                report = write(patches, path, name=ship.stem, unit=unit, **options)
                written[str(path)] = (surface, way, report)
    names, found = folder / "files.json", folder / "found.json"
    names.write_text(json.dumps(list(written)))
    # Its settings go into a folder of the test's own.
    environment = dict(
        os.environ,
        HOME=str(folder),
        XDG_CONFIG_HOME=str(folder),
        HULL_FREECAD_FILES=str(names),
        HULL_FREECAD_REPORT=str(found),
    )
    environment.pop("PYTHONPATH", None)
    done = subprocess.run(
        [FREECAD, str(Path(__file__).with_name("freecad_report.py"))],
        env=environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert found.exists(), done.stdout + done.stderr
    seen = json.loads(found.read_text())
    return {path: (*written[path], seen[path]) for path in written}


def test_freecad_finds_what_was_written(files):
    for path, (_, _, ours, theirs) in files.items():
        assert theirs["valid"], path
        for key in ("solids", "shells", "faces"):
            assert theirs[key] == ours[key], (path, key)
        assert theirs["area"] == pytest.approx(ours["area"], rel=FREECAD_INTEGRALS), path
        # Its box is around control points in part, so it is a little too large.
        assert theirs["length"] == pytest.approx(np.ptp(ours["box"][:, 0]), rel=0.02), path


def test_freecad_finds_closed_what_should_be(files):
    for path, (_, way, _, theirs) in files.items():
        assert theirs["closed"] == [way != "open"], path
        assert theirs["solids"] == (way != "open"), path


def test_volumes_are_those_of_the_analysis(files):
    for path, (surface, way, ours, theirs) in files.items():
        if way == "open":
            continue
        body = hn.HullBody(surface, mirrored=True)
        above = surface.mesh.points[:, 2].max() + 1.0
        volume = body.immersion(np.array([0.0, 0.0, 1.0]), above).volume
        volume *= 0.5 if way == "half" else 1.0
        assert ours["volume"] == pytest.approx(volume, rel=1e-9), path
        assert theirs["volume"] == pytest.approx(volume, rel=FREECAD_INTEGRALS), path
