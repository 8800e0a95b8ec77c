# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading and writing hulls: plain Python and NumPy, no Blender.

Start at `read_hull`, which finds out what a file is, and `HullData`, which it returns.
"""

from .errors import HullFileError
from .hull_data import (
    LINE_KINDS,
    Afloat,
    CutPlane,
    HullData,
    Layer,
    LineChoice,
    Load,
    LoadCase,
    Opening,
    Particulars,
    ShellArrays,
    Wind,
    WindArea,
    shell_arrays,
    shell_face_indices,
)
from .hull_file import read_hull_file, write_hull_file
from .reading import read_hull, stored_sections
from .stl import read_stl

__all__ = [
    "LINE_KINDS",
    "Afloat",
    "CutPlane",
    "HullData",
    "HullFileError",
    "Layer",
    "LineChoice",
    "Load",
    "LoadCase",
    "Opening",
    "Particulars",
    "ShellArrays",
    "Wind",
    "WindArea",
    "read_hull",
    "read_hull_file",
    "read_stl",
    "shell_arrays",
    "shell_face_indices",
    "stored_sections",
    "write_hull_file",
]
