# SPDX-License-Identifier: GPL-3.0-or-later
"""The deck edge: where the deck meets the sides, as the designer marks it.

It consists of whole chains of the surface, creases or borders from end to end. Without a mark it is
the borders along the ship.
"""

import bmesh
import numpy as np

from ...bridge.mesh import deck_edge_marks, selection
from . import tags


def points_of(surface, edges):
    """The control points of marked edges, pairs of control points, as hull_native takes them.

    None without a mark. ValueError when they are not whole chains of a hull_native.LimitSurface.
    """
    if not edges:
        return None
    marked = {tags.edge_key(*edge) for edge in edges}
    whole = set()
    for chain in tags.chains(surface):
        if chain <= marked:
            whole |= chain
    if marked - whole:
        count = len(marked - whole)
        raise ValueError(
            f"Of the edges marked as deck edge {count} of {len(marked)} belong to no crease or "
            "border, or to one that is not marked all along: select it and mark the deck edge again"
        )
    return sorted({point for edge in whole for point in edge})


def mark(obj, scene):
    """Marks, in edit mode, the whole creases and borders that selected edges belong to, and these
    only; returns how many edges they have.

    ValueError when nothing is selected, or an edge that is neither crease nor border.
    """
    selected = {tags.edge_key(*edge) for edge in selection.selected(obj, "edge")}
    if not selected:
        raise ValueError("Select edges of the crease or border that is the deck edge first")
    marked = set(tags.chains_through(obj, scene, selected))
    if selected - marked:
        raise ValueError(
            f"Selected edges that are neither crease nor border of the shell: "
            f"{len(selected - marked)} of {len(selected)}. Make a crease of them first"
        )
    bm = bmesh.from_edit_mesh(obj.data)
    edges = [tags.edge_key(*(vertex.index for vertex in edge.verts)) for edge in bm.edges]
    _store(obj, bm, [edge in marked for edge in edges])
    return len(marked)


def clear(obj):
    """Takes all marks away, in edit mode."""
    bm = bmesh.from_edit_mesh(obj.data)
    _store(obj, bm, np.zeros(len(bm.edges), dtype=bool))


def select(context, obj):
    """Selects exactly the marked edges, in edit mode; returns how many there are."""
    bm = bmesh.from_edit_mesh(obj.data)
    bm.verts.index_update()
    marks = deck_edge_marks.edited_marks(bm)
    marked = [
        [vertex.index for vertex in edge.verts] for edge, mark in zip(bm.edges, marks) if mark
    ]
    selection.select(context, obj, "edge", marked)
    return len(marked)


def _store(obj, bm, marks):
    deck_edge_marks.edit_marks(bm, marks)
    bmesh.update_edit_mesh(obj.data, loop_triangles=False, destructive=False)
