# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the points of a mesh were before they are shown elsewhere for a while.

An attribute of the mesh's points keeps them, and another one where they are shown, which tells
whether they are there still or were moved by something else since. Saving and undo take both along
with the points, undo in edit mode too.
"""

import bmesh
import numpy as np

from . import own_attributes

_KIND = "FLOAT_VECTOR", "POINT"
_START, _SHOWN = "hull_start", "hull_shown_for_a_while"


def store(mesh, points):
    """Stores where the points are, (n, 3) float32 in Blender's units; they are shown there
    still."""
    _write(mesh, _START, points)
    set_shown(mesh, points)


def read(mesh):
    """(n, 3) float32 in Blender's units; None where nothing is stored."""
    return _read(mesh, _START)


def forget(mesh):
    """Stores nothing any longer."""
    for name in (_START, _SHOWN):
        _remove(mesh, name)


def set_shown(mesh, points):
    """Tells that the points (n, 3) float32 are shown where they are now."""
    _write(mesh, _SHOWN, points)


def are_as_shown(mesh, points):
    """Whether the points (n, 3) float32 as they are now are where they were shown last, bit by
    bit."""
    shown = _read(mesh, _SHOWN)
    return shown is not None and shown.tobytes() == np.ascontiguousarray(points).tobytes()


def _write(mesh, name, points):
    if mesh.is_editmode:
        bm = bmesh.from_edit_mesh(mesh)
        layer = bm.verts.layers.float_vector.get(name) or bm.verts.layers.float_vector.new(name)
        for vertex, point in zip(bm.verts, points.tolist()):
            vertex[layer] = point
        return
    attribute = own_attributes.made(mesh, name, *_KIND)
    attribute.data.foreach_set("vector", np.ascontiguousarray(points).reshape(-1))


def _read(mesh, name):
    if mesh.is_editmode:
        bm = bmesh.from_edit_mesh(mesh)
        layer = bm.verts.layers.float_vector.get(name)
        if layer is None:
            return None
        return np.array([vertex[layer] for vertex in bm.verts], dtype=np.float32).reshape(-1, 3)
    attribute = own_attributes.found(mesh, name, *_KIND)
    if attribute is None:
        return None
    points = np.empty((len(mesh.vertices), 3), dtype=np.float32)
    attribute.data.foreach_get("vector", points.reshape(-1))
    return points


def _remove(mesh, name):
    if mesh.is_editmode:
        layers = bmesh.from_edit_mesh(mesh).verts.layers.float_vector
        layer = layers.get(name)
        if layer is not None:
            layers.remove(layer)
        return
    attribute = own_attributes.found(mesh, name, *_KIND)
    if attribute is not None:
        mesh.attributes.remove(attribute)
