# SPDX-License-Identifier: GPL-3.0-or-later
"""The docs' examples run, and what they tell is what the module computes."""

import re
import subprocess
import sys
from pathlib import Path

import hull_io
import hull_native as hn
import pytest
import vessels

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "docs" / "examples"
COASTER = ROOT / "samples" / "coaster.hull.json"


def run(name, *arguments):
    command = [sys.executable, EXAMPLES / name, *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def displacement(data):
    body = hn.HullBody(vessels.surface_of(data), mirrored=data.half)
    return hn.hydrostatics(body, draft=data.particulars.draft).displaced_volume


def test_hydrostatics_of_a_file():
    told = run("hydrostatics_of_a_file.py", COASTER)
    last = told.splitlines()[-1].split()
    assert len(told.splitlines()) == 8
    assert float(last[1]) == pytest.approx(displacement(hull_io.read_hull(COASTER)), abs=0.005)


@pytest.mark.parametrize("name", ["hull.step", "hull.igs"])
def test_hull_to_a_cad_file(tmp_path, name):
    told = run("hull_to_step.py", COASTER, str(tmp_path / name))
    assert (tmp_path / name).stat().st_size > 10_000
    assert re.search(r"^valid: True$", told, re.MULTILINE), told


def test_a_family_of_hulls(tmp_path):
    # Itself longer: the same layout, so that it is quick.
    data = hull_io.read_hull(COASTER)
    data.points = data.points * [1.1, 1.0, 1.0]
    hull_io.write_hull_file(data, tmp_path / "longer.hull.json")
    told = run("family_of_hulls.py", COASTER, tmp_path / "longer.hull.json", tmp_path / "all", "3")
    volumes = [float(found) for found in re.findall(r"∇ ([\d.]+)", told)]
    first = displacement(hull_io.read_hull(COASTER))
    assert volumes == pytest.approx([first, 1.05 * first, 1.1 * first], abs=0.06)
    for t, volume in zip(("0.00", "0.50", "1.00"), volumes):
        member = hull_io.read_hull(tmp_path / "all" / f"member-{t}.hull.json")
        assert displacement(member) == pytest.approx(volume, abs=0.06)
