# SPDX-License-Identifier: GPL-3.0-or-later
"""The sample hulls that come with the add-on."""

from pathlib import Path

_ADDON = Path(__file__).resolve().parents[3]

# In the package beside the code, in a checkout beside the add-on's folder.
_FOLDERS = (_ADDON / "samples", _ADDON.parent / "samples")


def sample_files():
    """Paths of the sample hulls by name, in alphabetical order."""
    files = [path for folder in _FOLDERS for path in sorted(folder.glob("*.hull.json"))]
    return {path.name.removesuffix(".hull.json"): path for path in files}
