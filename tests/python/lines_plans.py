# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines plans of samples and of a hull of FREE!ship, drawn for tests."""

from math import radians
from pathlib import Path

import hull_io
import hull_native as hn
import pytest
from dxf_audit import assert_audited

ROOT = Path(__file__).resolve().parents[2]
SAMPLES = ("barge", "coaster")
FREESHIP = ROOT.parent / "shared" / "hulls" / "freeship" / "FREE!ship demo 3.fbm"
DIAGONALS = [(5.0, radians(35.0)), (3.5, radians(50.0))]


def read(path):
    data = hull_io.read_hull(path)
    shell = hull_io.shell_arrays(data)
    arrays = shell.arguments()
    return data, hn.LimitSurface(hn.ControlMesh(*arrays))


def draw(hull, path, **others):
    data, surface = hull
    given = data.particulars
    options = {
        "mirrored": data.half,
        "stations": given.length_pp / 20,
        "waterlines": given.draft / 5,
        "buttocks": given.beam / 8,
        "diagonals": DIAGONALS,
        "draft": given.draft,
        "length": given.length_pp,
        "frame_spacing": 0.6,
        "title": data.name,
        "title_block": [("Drawn", "N. N."), ("Date", "1 May")],
        "particulars": [("Draft", f"{given.draft:.2f} m")],
        "paper": "A2",
    }
    hn.write_lines_drawing(surface, path, **{**options, **others})
    return path


def dxf_of(hull, folder, **others):
    pytest.importorskip("ezdxf")
    return assert_audited(draw(hull, folder / "plan.dxf", **others))
