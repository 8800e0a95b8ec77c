# SPDX-License-Identifier: GPL-3.0-or-later
"""Control curves: chains of edges with a name, shown with combs each by its own switch.

Which edges are of a curve the mesh knows (bridge.mesh.curve_marks), by the curve's number; its name
and switch are in the list Object.hull.fairness.curves. All their edges are marked as rows, too.
Undo in edit mode is of the mesh alone: so an entry stays where its edges go, is none of the list's
then, and is there again when they come back.
"""

import numpy as np

from ....hull_io import control_rows
from ...bridge.mesh import curve_marks, row_marks, selection
from ..hull import curve_entries, hull_state
from . import row_choice


def add(obj, scene, name=""):
    """A new curve of the selected edges of a hull in edit mode; of an edge by itself its whole row.
    Edges that were another curve's are of this one alone. Returns its entry of the list.

    ValueError where the edges are no chain.
    """
    control = hull_state.up_to_date(obj, scene).ship.source.control
    edges = row_choice.selected_edges(obj, control)
    if not edges:
        raise ValueError("Select the edges of the curve first, or one of its row")
    if len(edges) == 1:
        edges = control_rows.edges_of(control_rows.RowNet(control).row_through(edges[0]))
    _check_chain(edges)
    ids = control.vertex_ids
    pairs = [(int(ids[a]), int(ids[b])) for a, b in edges]
    fairness = obj.hull.fairness
    number = curve_entries.new_number(obj)
    curve_marks.give(obj.data, pairs, number)
    row_marks.mark(obj.data, [*row_marks.marked(obj.data).tolist(), *pairs])
    entry = curve_entries.add(obj, number, name or f"Curve {len(fairness.curves) + 1}")
    fairness.active_curve = len(fairness.curves) - 1
    fairness.comb_rows = True
    hull_state.follow_edit(obj, scene, is_by_hand=False)
    return entry


def _check_chain(edges):
    """ValueError unless edges follow one another, from end to end or around."""
    around = {}
    for a, b in edges:
        around.setdefault(a, []).append(b)
        around.setdefault(b, []).append(a)
    if max(map(len, around.values())) > 2:
        raise ValueError("The selected edges branch: select edges that follow one another")
    seen, todo = set(), [edges[0][0]]
    while todo:
        point = todo.pop()
        if point not in seen:
            seen.add(point)
            todo += around[point]
    if len(seen) < len(around):
        raise ValueError("The selected edges are apart: select edges that follow one another")


def chosen(obj):
    """The entry that is chosen in the list.

    ValueError where there is none.
    """
    fairness = obj.hull.fairness
    if 0 <= fairness.active_curve < len(fairness.curves):
        entry = fairness.curves[fairness.active_curve]
        if entry.number in curve_marks.present(obj.data):
            return entry
    raise ValueError("Choose a curve of the list first, or add one")


def select(context, obj, extend=False):
    """Selects the edges of the curve that is chosen, in edit mode; returns how many."""
    edges = curve_marks.edges_of(obj.data, chosen(obj).number)
    return selection.select(context, obj, "edge", edges, extend=extend, reveal=True)


def remove(obj, scene):
    """Takes the curve that is chosen off its edges, which are shown no longer. Returns its name."""
    entry, fairness = chosen(obj), obj.hull.fairness
    edges = curve_marks.edges_of(obj.data, entry.number)
    curve_marks.give(obj.data, edges, 0)
    own = {tuple(sorted(edge)) for edge in edges.tolist()}
    left = [edge for edge in row_marks.marked(obj.data).tolist() if tuple(sorted(edge)) not in own]
    row_marks.mark(obj.data, np.array(left, dtype=np.int64).reshape(-1, 2))
    present = curve_marks.present(obj.data)
    places = [place for place, other in enumerate(fairness.curves) if other.number in present]
    last = fairness.active_curve
    fairness.active_curve = min(places, key=lambda place: abs(place - last), default=0)
    hull_state.follow_edit(obj, scene, is_by_hand=False)
    return entry.name
