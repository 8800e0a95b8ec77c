# SPDX-License-Identifier: GPL-3.0-or-later
"""How large a hull's STEP file will be, where another conversion makes a much smaller one or was
taken for that."""

from ..conversion import file_sizes
from . import cad_curves

_LARGE = 10e6
_WORTH_IT = 0.5  # of the size: less is not worth another conversion


def is_mirrored(hull):
    """Whether the files have the mirror image of half a hull, too."""
    return hull.hull.half and hull.hull.export.extent in cad_curves.BOTH_SIDES


def remark(hull, converted):
    """A sentence about the file of a hull's patches (patches.Converted), or "": exact patches of
    triangles have very many control points."""
    sides = 2 if is_mirrored(hull) else 1
    per_cell = sides * file_sizes.of_cells(converted.cell_count)
    if converted.spared_control_points:
        exact = sides * file_sizes.of_exact(converted.spared_control_points)
        return (
            f"One patch a cell was taken: about {_megabytes(per_cell)} as STEP, where exact ones "
            f"make about {_megabytes(exact)}. Exact makes these"
        )
    exact = sides * file_sizes.of_exact(converted.quality.control_point_count)
    if not converted.is_exact or exact < _LARGE or per_cell > _WORTH_IT * exact:
        return ""
    return (
        f"About {_megabytes(exact)} as STEP, for there are many triangles or irregular points. "
        f"One a cell makes about {_megabytes(per_cell)}, with larger angles between patches"
    )


def _megabytes(size):
    return f"{size / 1e6:.{0 if size >= 1e7 else 1}f} MB"
