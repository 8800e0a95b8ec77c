# SPDX-License-Identifier: GPL-3.0-or-later
"""The reference files."""

from pathlib import Path

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
