# SPDX-License-Identifier: GPL-3.0-or-later
"""Which rows of control points are meant by what is selected in edit mode."""

from dataclasses import dataclass

import numpy as np

from ....hull_io import control_rows
from ...bridge.mesh import curve_marks, mesh_points, row_marks, selection
from ..hull import hull_state


def show(obj, scene, adds=False):
    """Has the rows through all that is selected shown with combs: of selected edges their rows, of
    points between none of these all rows through them. adds: besides those that are shown. Returns
    how many these are.

    ValueError when nothing of the shell is selected.
    """
    state = hull_state.up_to_date(obj, scene)
    control = state.ship.source.control
    net = control_rows.RowNet(control)
    chosen = selected_edges(obj, control)
    points = np.flatnonzero(np.isin(control.vertex_ids, mesh_points.selected(obj.data)))
    alone = set(points.tolist()) - {point for edge in chosen for point in edge}
    through = [edge for point in alone for edge in net.edges_at(point)]
    rows = net.rows_of(chosen + through)
    if not rows:
        raise ValueError("Select edges or points of the rows that are to be shown first")
    ids = control.vertex_ids
    edges = [(int(ids[a]), int(ids[b])) for row in rows for a, b in control_rows.edges_of(row)]
    # Rows of control curves are shown by their own switches.
    kept = row_marks.marked(obj.data) if adds else curve_marks.numbered(obj.data)[0]
    edges += kept.tolist()
    row_marks.mark(obj.data, edges)
    obj.hull.fairness.comb_rows = True
    state = hull_state.follow_edit(obj, scene, is_by_hand=False)
    if "row" not in state.fairness.combs:
        raise ValueError(state.fairness.status)
    return len(state.fairness.combs["row"].rows)


@dataclass(frozen=True)
class Choice:
    """row: the whole control_rows.Row; moving: those of its control points that are chosen, in
    their order, all or a part that runs on."""

    row: control_rows.Row
    moving: np.ndarray

    @property
    def ends(self):
        """The first and the last of the chosen points; none of a row that is closed, and whole."""
        is_ring = self.row.is_closed and len(self.moving) == len(self.row.points)
        return self.moving[:0] if is_ring else self.moving[[0, -1]]


def chosen(obj, control):
    """The Choices of the selected edges of a hull in edit mode, with mesh_arrays.ControlArrays
    `control`: of an edge by itself all of its row.

    ValueError when no edges of the shell are selected, and where rows meet in them.
    """
    edges, net = selected_edges(obj, control), control_rows.RowNet(control)
    if not edges:
        raise ValueError("Select the row: edges that follow one another, or one of them")
    found = []
    for part in net.rows_of(edges, are_whole=False):
        row = net.row_through(control_rows.edges_of(part)[0])
        found.append(Choice(row, row.points if len(part.points) == 2 else part.points))
    points = np.concatenate([choice.moving for choice in found])
    if len(np.unique(points)) < len(points):
        raise ValueError("Rows meet in the selection: select edges of one row, or of rows apart")
    return found


def selected_edges(obj, control):
    """The selected edges of the shell of a hull in edit mode, as control_rows has them."""
    pairs = np.array(selection.selected(obj, "edge"), dtype=np.int64).reshape(-1, 2)
    pairs = pairs[np.isin(pairs, control.vertex_ids).all(axis=1)]
    found = np.searchsorted(control.vertex_ids, pairs)
    return [control_rows.edge_key(a, b) for a, b in found.tolist()]
