# SPDX-License-Identifier: GPL-3.0-or-later
"""How large patches will be in a file, and whether one patch a cell is to be taken instead of exact
ones."""

# Bytes in a STEP file for each control point, measured: of exact patches, and of small ones.
_EXACT, _PER_CELL = 90, 100
_IN_CELL = 25  # control points, as the conversion has by default

# Nobody minds a file of less, and exact patches are the better ones.
_SMALL = 1e6
_MUCH = 2.0  # as large: then one a cell is taken


def of_exact(control_point_count):
    """Bytes of the STEP file of exact patches, one side."""
    return _EXACT * control_point_count


def of_cells(cell_count):
    """Bytes of the STEP file with a patch for each cell, one side."""
    return _PER_CELL * _IN_CELL * cell_count


def are_cells_better(control_point_count, cell_count):
    """Whether exact patches with so many control points are too large beside one patch a cell."""
    exact = of_exact(control_point_count)
    return exact > _SMALL and exact > _MUCH * of_cells(cell_count)
