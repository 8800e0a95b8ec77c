# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes `import hull_io` work in the tests of this folder, and finds the reference files."""

import pytest
from hull_io_loader import SHARED, load_hull_io

load_hull_io()


@pytest.fixture(scope="session")
def freeship_files():
    """The FREE!ship files of the reference data, sorted by name."""
    folder = SHARED / "hulls" / "freeship"
    files = sorted(folder.glob("*.f[bt]m"))
    if not files:
        pytest.skip(f"reference data missing: {folder}")
    return files
