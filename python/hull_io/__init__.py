# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading and writing hulls: plain Python and NumPy, no Blender.

Start at `read_hull`, which finds out what a file is, and `HullData`, which it returns.
"""

from .area_tables import read_area_table
from .errors import HullFileError
from .freeship_writing import write_freeship
from .hull_curves import ControlCurve
from .hull_data import (
    LINE_KINDS,
    CutPlane,
    Developable,
    FieldEnd,
    Flat,
    HullData,
    Kept,
    Layer,
    LineChoice,
    Particulars,
    PointGroup,
    ShapeField,
    Tie,
    Variant,
)
from .hull_file import read_hull_file, write_hull_file
from .keeping import to_dimensions_keeping
from .model_files import write_3mf, write_cli
from .panel_files import gdf_title, panel_areas, write_gdf, write_nemoh, write_obj
from .part_files import read_stl_parts, write_segments, write_stl_parts
from .plating_data import SEAM_KINDS, FrameRange, Plating, SeamRule
from .reading import read_hull, read_mended, stored_sections
from .scaling import scaled, to_dimensions
from .shell import ShellArrays, shell_arrays, shell_face_indices
from .ship_data import (
    Afloat,
    Appendage,
    DelftInputs,
    DownfloodingPoint,
    HoltropInputs,
    Load,
    LoadCase,
    MichellInputs,
    Resistance,
    Weight,
    Weights,
    Wind,
    WindArea,
)
from .stl import read_stl, write_stl
from .wanted import AreaPoint, AreaTarget, FreeDimension, Target, Targets

__all__ = [
    "LINE_KINDS",
    "SEAM_KINDS",
    "Afloat",
    "Appendage",
    "AreaPoint",
    "AreaTarget",
    "ControlCurve",
    "CutPlane",
    "DelftInputs",
    "DownfloodingPoint",
    "FieldEnd",
    "Developable",
    "Flat",
    "FrameRange",
    "FreeDimension",
    "HoltropInputs",
    "HullData",
    "HullFileError",
    "Kept",
    "Layer",
    "LineChoice",
    "Load",
    "LoadCase",
    "MichellInputs",
    "Particulars",
    "Plating",
    "PointGroup",
    "Resistance",
    "SeamRule",
    "ShapeField",
    "ShellArrays",
    "Target",
    "Targets",
    "Tie",
    "Variant",
    "Weight",
    "Weights",
    "Wind",
    "WindArea",
    "gdf_title",
    "panel_areas",
    "read_area_table",
    "read_hull",
    "read_hull_file",
    "read_mended",
    "read_stl",
    "read_stl_parts",
    "scaled",
    "shell_arrays",
    "shell_face_indices",
    "stored_sections",
    "to_dimensions",
    "to_dimensions_keeping",
    "write_3mf",
    "write_cli",
    "write_freeship",
    "write_gdf",
    "write_hull_file",
    "write_nemoh",
    "write_obj",
    "write_segments",
    "write_stl",
    "write_stl_parts",
]
