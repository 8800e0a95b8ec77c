# SPDX-License-Identifier: GPL-3.0-or-later
"""How large a hull's STEP file will be, where another conversion makes a much smaller one."""

from ..conversion import patches
from . import cad_curves

# Bytes for each control point, measured: of exact patches, and of small ones.
_EXACT, _PER_CELL = 90, 100
_FEWEST_IN_CELL = 25  # control points, as the conversion has by default
_LARGE = 10e6
_WORTH_IT = 0.5  # of the size: less is not worth another conversion


def is_mirrored(hull):
    """Whether the files have the mirror image of half a hull, too."""
    return hull.hull.half and hull.hull.export.extent in cad_curves.BOTH_SIDES


def warning(hull, converted):
    """A sentence about the file of a hull's exact patches (patches.Converted), or "": those of
    triangles have very many control points."""
    sides = 2 if is_mirrored(hull) else 1
    now = sides * _EXACT * converted.quality.control_point_count
    per_cell = sides * _PER_CELL * _FEWEST_IN_CELL * converted.cell_count
    is_chosen = hull.hull.export.conversion == patches.PER_CELL
    if is_chosen or now < _LARGE or per_cell > _WORTH_IT * now:
        return ""
    return (
        f"About {_megabytes(now)} as STEP, for there are many triangles or irregular points. "
        f"One a cell makes about {_megabytes(per_cell)}, with larger angles between patches"
    )


def _megabytes(size):
    return f"{size / 1e6:.{0 if size >= 1e7 else 1}f} MB"
