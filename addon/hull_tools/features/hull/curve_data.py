# SPDX-License-Identifier: GPL-3.0-or-later
"""Control curves to and from hull_io.HullData."""

from ....hull_io.hull_curves import ControlCurve
from ....hull_io.hull_data import edge_key, face_edges
from ...bridge.mesh import curve_marks, edge_marks, row_marks
from . import curve_entries


def give_curves(obj, curves):
    """Gives an object, not in edit mode, these ControlCurves."""
    fairness = obj.hull.fairness
    fairness.curves.clear()
    for number, curve in enumerate(curves, start=curve_entries.new_number(obj)):
        curve_entries.add(obj, number, curve.name, curve.shown)
        curve_marks.give(obj.data, curve.edges, number)
    if curves:
        numbers = edge_marks.stored_values(obj.data, curve_marks.ATTRIBUTE)
        rows = edge_marks.stored_marks(obj.data, row_marks.ATTRIBUTE)
        edge_marks.store_marks(obj.data, row_marks.ATTRIBUTE, rows | (numbers != 0))
        fairness.comb_rows = True


def take_curves(obj, faces):
    """The ControlCurves of an object, of those of its edges that are of faces, lists of points."""
    known = {edge_key(a, b) for face in faces for a, b in face_edges(face)}
    pairs, numbers = curve_marks.numbered(obj.data)
    return [
        ControlCurve(
            entry.name,
            sorted(known & {edge_key(a, b) for a, b in pairs[numbers == entry.number].tolist()}),
            entry.is_shown,
        )
        for entry in obj.hull.fairness.curves
        if (numbers == entry.number).any()
    ]
