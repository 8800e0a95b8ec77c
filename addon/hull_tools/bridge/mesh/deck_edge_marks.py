# SPDX-License-Identifier: GPL-3.0-or-later
"""The edges of a Blender mesh that are marked as deck edge."""

from . import edge_marks

ATTRIBUTE = "hull_deck_edge"


def stored_marks(mesh):
    """(edges,) bool; `mesh` is not in edit mode."""
    return edge_marks.stored_marks(mesh, ATTRIBUTE)


def edited_marks(bm):
    """(edges,) bool of a BMesh."""
    return edge_marks.edited_marks(bm, ATTRIBUTE)


def store_marks(mesh, marks):
    """Marks exactly the edges of (edges,) bool; `mesh` is not in edit mode."""
    edge_marks.store_marks(mesh, ATTRIBUTE, marks)


def edit_marks(bm, marks):
    """The same of a BMesh. Every BMEdge that the caller holds may become invalid."""
    edge_marks.edit_marks(bm, ATTRIBUTE, marks)
