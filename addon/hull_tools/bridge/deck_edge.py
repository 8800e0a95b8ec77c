# SPDX-License-Identifier: GPL-3.0-or-later
"""The deck edge: where the deck meets the sides, as the designer marks it.

It consists of whole chains of the surface, creases or borders from end to end. Without a mark it is
the borders along the ship.
"""

import bmesh
import numpy as np

from . import edge_marks, hull_state, native


def points_of(surface, edges):
    """The control points of marked edges, pairs of control points, as hull_native takes them.

    None without a mark. ValueError when they are not whole chains of a hull_native.LimitSurface.
    """
    if not edges:
        return None
    marked = {_key(*edge) for edge in edges}
    whole = set()
    for chain in _chains(surface):
        if chain <= marked:
            whole |= chain
    if marked - whole:
        count = len(marked - whole)
        raise ValueError(
            f"{count} of the {len(marked)} edges marked as deck edge are no crease or border, or "
            "part of one that is not marked all along: select them and mark the deck edge again"
        )
    return sorted({point for edge in whole for point in edge})


def mark(obj, scene):
    """Marks, in edit mode, the whole creases and borders that selected edges belong to, and these
    only; returns how many edges they have.

    ValueError when nothing is selected, or an edge that is neither crease nor border.
    """
    state = hull_state.refresh(obj, scene)
    if state.status:
        raise ValueError(state.status)
    bm = bmesh.from_edit_mesh(obj.data)
    edges = [_key(*(vertex.index for vertex in edge.verts)) for edge in bm.edges]
    selected = {edge for edge, element in zip(edges, bm.edges) if element.select}
    if not selected:
        raise ValueError("Select edges of the crease or border that is the deck edge first")
    ids = state.source.control.vertex_ids
    marked = set()
    for chain in _chains(state.surface):
        own = {_key(int(ids[a]), int(ids[b])) for a, b in chain}
        if own & selected:
            marked |= own
    if selected - marked:
        raise ValueError(
            f"{len(selected - marked)} of the {len(selected)} selected edges are neither crease "
            "nor border of the shell: make them a crease first"
        )
    _store(obj, bm, [edge in marked for edge in edges])
    return len(marked)


def clear(obj):
    """Takes all marks away, in edit mode."""
    bm = bmesh.from_edit_mesh(obj.data)
    _store(obj, bm, np.zeros(len(bm.edges), dtype=bool))


def select(obj):
    """Selects exactly the marked edges, in edit mode; returns how many."""
    bm = bmesh.from_edit_mesh(obj.data)
    marks = edge_marks.edited_marks(bm)
    for sequence in (bm.faces, bm.edges, bm.verts):
        for element in sequence:
            element.select_set(False)
    for edge, mark in zip(bm.edges, marks):
        if mark and not edge.hide:
            edge.select_set(True)
    bm.select_flush_mode()
    bmesh.update_edit_mesh(obj.data, loop_triangles=False, destructive=False)
    return int(np.count_nonzero(marks))


def _store(obj, bm, marks):
    edge_marks.edit_marks(bm, marks)
    bmesh.update_edit_mesh(obj.data, loop_triangles=False, destructive=False)


def _key(a, b):
    return (a, b) if a < b else (b, a)


def _chains(surface):
    """The creases and borders of a surface, each as the set of its edges."""
    for curve in native.require().crease_curves(surface):
        points = curve.vertices.tolist()
        following = points[1:] + (points[:1] if curve.closed else [])
        yield {_key(a, b) for a, b in zip(points, following)}
