# SPDX-License-Identifier: GPL-3.0-or-later
"""The reference files, and what is read of hull files made for a test."""

import json
from pathlib import Path

import hull_io
import pytest

SHARED = Path(__file__).resolve().parents[4] / "shared"


@pytest.fixture(scope="session")
def freeship_files():
    """The FREE!ship files of the reference data, sorted by name."""
    folder = SHARED / "hulls" / "freeship"
    files = sorted(folder.glob("*.f[bt]m"))
    if not files:
        pytest.skip(f"reference data missing: {folder}")
    return files


@pytest.fixture
def read(tmp_path):
    """The hull_io.HullData that is read of a hull file with this content."""

    def read_content(value):
        path = tmp_path / "box.hull.json"
        path.write_text(json.dumps(value))
        return hull_io.read_hull_file(path)

    return read_content
