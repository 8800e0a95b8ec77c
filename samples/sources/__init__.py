# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the sample hulls come from: a module each, with make(hull_io) -> HullData.

A module also tells of FEATURES (what the vessel shows, and how it is in the mesh;
tests/python/features/table.py has a check of each), MOST_POINTS (of the half hull's control mesh),
WANTED (inflections and extrema of curvature that the design calls for) and, where there are any,
PUBLISHED values.
"""

import importlib
from pathlib import Path

# Modules that hold what the vessels share.
SHARED = ("barred", "mesh")


def names():
    """Names of the vessels that have a source."""
    files = Path(__file__).parent.glob("[a-z]*.py")
    return sorted(path.stem for path in files if path.stem not in SHARED)


def source(name):
    """The module of a vessel; its file is samples/NAME.hull.json."""
    return importlib.import_module(f"{__name__}.{name}")
