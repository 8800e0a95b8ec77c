# SPDX-License-Identifier: GPL-3.0-or-later
"""Every test starts from an empty file, and finds the reference data if they are there."""

import bpy
import pytest
from addon_under_test import SHARED
from one_in import pytest_collection_modifyitems  # noqa: F401: a hook


@pytest.fixture(autouse=True)
def empty_file():
    bpy.ops.wm.read_homefile(use_empty=True)


@pytest.fixture(scope="session")
def freeship_folder():
    folder = SHARED / "hulls" / "freeship"
    if not folder.is_dir():
        pytest.skip(f"reference data missing: {folder}")
    return folder


@pytest.fixture(scope="session")
def reference_folder():
    folder = SHARED / "reference"
    if not folder.is_dir():
        pytest.skip(f"reference data missing: {folder}")
    return folder
