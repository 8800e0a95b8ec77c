# SPDX-License-Identifier: GPL-3.0-or-later
"""Writing the ties of point_ties into a Blender mesh, in edit mode or not."""

import random

import bmesh
import numpy as np

from . import own_attributes, point_ties
from .point_ties import FIRST, NAME, NUMBERS, SECOND, TIE

# Names are drawn, so that hulls can be joined, and that a mean of names is none.
_LARGEST_NAME = 2**30
_drawn = random.SystemRandom()


def tie(mesh, points, kind, leaders, numbers):
    """Ties points (k,) to leaders (k, 2), in place of the ties that they have; kind: one for all,
    by its number; numbers (k, 3)."""
    points, leaders = np.asarray(points, dtype=np.int64), np.asarray(leaders, dtype=np.int64)
    _name(mesh, np.unique(np.concatenate([points, leaders.reshape(-1)])))
    names = _column(mesh, NAME)
    numbers = np.asarray(numbers, dtype=np.float32).reshape(-1, 3)
    first, second = names[leaders[:, 0]], names[leaders[:, 1]]
    checks = [
        point_ties.checked(int(kind), *own[:3], own[3])
        for own in zip(names[points].tolist(), first.tolist(), second.tolist(), numbers)
    ]
    for column, values in ((FIRST, first), (SECOND, second), (TIE, checks)):
        _write(mesh, column, points, np.asarray(values, dtype=np.int64))
    _write(mesh, NUMBERS, points, numbers)


def give_numbers(mesh, ties, rows, numbers):
    """Gives ties, by their rows (m,) in PointTies, other numbers (m, 3)."""
    for kind in np.unique(ties.kinds[rows]).tolist():
        own = rows[ties.kinds[rows] == kind]
        chosen = numbers[np.isin(rows, own)]
        tie(mesh, ties.points[own], kind, ties.leaders[own], chosen)


def free(mesh, points):
    """Points (k,) follow no others any longer. Those that follow them go on doing so."""
    if point_ties.is_any(mesh) and len(points):
        _write(mesh, TIE, np.asarray(points, dtype=np.int64), np.zeros(len(points), np.int64))


def rename(mesh, points):
    """Gives points (k,), copies of others, names of their own, that these are not taken for them;
    their ties are gone."""
    free(mesh, points)
    _write(mesh, NAME, points, np.zeros(len(points), dtype=np.int64))


def _name(mesh, points):
    """Points without a name, or with one that a point before them has, get one."""
    names = _column(mesh, NAME)
    _, firsts = np.unique(names, return_index=True)
    has_own = np.zeros(len(names), dtype=bool)
    has_own[firsts] = True
    nameless = points[(names[points] == 0) | ~has_own[points]]
    known = set(names.tolist())
    for index in nameless.tolist():
        name = 0
        while name in known or name == 0:
            name = _drawn.randrange(1, _LARGEST_NAME)
        known.add(name)
        names[index] = name
    _write(mesh, NAME, nameless, names[nameless])


def _column(mesh, column):
    """(n,) whole numbers of all points."""
    if mesh.is_editmode:
        bm = bmesh.from_edit_mesh(mesh)
        layer = bm.verts.layers.int.get(column)
        if layer is None:
            return np.zeros(len(bm.verts), dtype=np.int64)
        return np.array([vertex[layer] for vertex in bm.verts], dtype=np.int64)
    values = np.zeros(len(mesh.vertices), dtype=np.int32)
    attribute = own_attributes.found(mesh, column, "INT", "POINT")
    if attribute is not None:
        attribute.data.foreach_get("value", values)
    return values.astype(np.int64)


def _write(mesh, column, points, values):
    if mesh.is_editmode:
        _write_edited(mesh, column, points, values)
    else:
        _write_stored(mesh, column, points, values)
        mesh.update_tag()


def _write_edited(mesh, column, points, values):
    bm = bmesh.from_edit_mesh(mesh)
    is_vector = column == NUMBERS
    layers = bm.verts.layers.float_vector if is_vector else bm.verts.layers.int
    layer = layers.get(column) or layers.new(column)
    bm.verts.ensure_lookup_table()
    for index, value in zip(points.tolist(), values.tolist()):
        bm.verts[index][layer] = value
    bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)


def _write_stored(mesh, column, points, values):
    is_vector = column == NUMBERS
    kind, name = ("FLOAT_VECTOR", "vector") if is_vector else ("INT", "value")
    attribute = own_attributes.made(mesh, column, kind, "POINT")
    width = (3,) if is_vector else ()
    stored = np.zeros((len(mesh.vertices), *width), dtype=np.float32 if is_vector else np.int32)
    attribute.data.foreach_get(name, stored.reshape(-1))
    stored[points] = values
    attribute.data.foreach_set(name, stored.reshape(-1))
