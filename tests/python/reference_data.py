# SPDX-License-Identifier: GPL-3.0-or-later
"""Where reference values are: those of the project, and those of hulls that come with it or not."""

import json
from pathlib import Path

import hull_native as hn
import numpy as np
import pytest

_ROOT = Path(__file__).resolve().parents[2]
REFERENCE = _ROOT / "tests" / "reference"
MESHES = sorted(path.stem for path in (REFERENCE / "meshes").glob("*.json"))

_SHARED = _ROOT.parent / "shared"
FREESHIP = _SHARED / "hulls" / "freeship"
HYDROSTATICS = _SHARED / "reference" / "hydrostatics.json"


def reference_mesh(name):
    """The ControlMesh of one of MESHES."""
    data = json.loads((REFERENCE / "meshes" / f"{name}.json").read_text())
    return hn.ControlMesh(
        np.array(data["vertices"], float),
        np.array([len(face) for face in data["faces"]]),
        np.concatenate(data["faces"]),
        np.array(data["crease_edges"], int).reshape(-1, 2),
        np.array(data["corner_vertices"], int),
    )


def foreign_ships(*names):
    """File names in FREESHIP, by default those of HYDROSTATICS, as parameters of a test; one that
    is skipped where they are not there."""
    if FREESHIP.is_dir() and HYDROSTATICS.exists():
        return names or [entry["file"] for entry in json.loads(HYDROSTATICS.read_text())]
    reason = f"hulls that are no part of the project are missing: {FREESHIP}, {HYDROSTATICS}"
    return [pytest.param("foreign ships", marks=pytest.mark.skip(reason=reason))]


def hull_path(name):
    """Of a sample's file, or of a ship in FREESHIP."""
    return (_ROOT / "samples" if name.endswith(".json") else FREESHIP) / name
