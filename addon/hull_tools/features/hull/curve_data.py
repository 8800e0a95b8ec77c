# SPDX-License-Identifier: GPL-3.0-or-later
"""Control curves to and from hull_io.HullData."""

import numpy as np

from ....hull_io.hull_curves import ControlCurve
from ...bridge.mesh import curve_marks, edge_marks, mesh_arrays, row_marks


def give(obj, curves):
    """Gives an object, not in edit mode, these ControlCurves."""
    fairness = obj.hull.fairness
    fairness.curves.clear()
    for number, curve in enumerate(curves, start=1):
        entry = fairness.curves.add()
        entry.name, entry.number, entry.is_shown = curve.name, number, curve.shown
        curve_marks.give(obj.data, curve.edges, number)
    if curves:
        numbers = edge_marks.stored_values(obj.data, curve_marks.ATTRIBUTE)
        rows = edge_marks.stored_marks(obj.data, row_marks.ATTRIBUTE)
        edge_marks.store_marks(obj.data, row_marks.ATTRIBUTE, rows | (numbers != 0))
        fairness.comb_rows = True


def of(obj, edges):
    """The ControlCurves of an object, of those of its edges that are among `edges` (e, 2)."""
    pairs, numbers = curve_marks.numbered(obj.data)
    is_there = np.isin(mesh_arrays.edge_keys(pairs), mesh_arrays.edge_keys(edges))
    pairs, numbers = np.sort(pairs[is_there], axis=1), numbers[is_there]
    return [
        ControlCurve(
            entry.name,
            sorted(map(tuple, pairs[numbers == entry.number].tolist())),
            entry.is_shown,
        )
        for entry in obj.hull.fairness.curves
    ]
