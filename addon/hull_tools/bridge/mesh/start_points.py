# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the points of a mesh were before they are shown elsewhere for a while.

An attribute of the mesh's points keeps them, so that they survive saving and undo. A digest beside
it tells whether the points are still as they were shown, or were moved by something else since.
"""

import bmesh
import numpy as np

ATTRIBUTE, _SHOWN = "hull_start", "hull_shown_for_a_while"


def keep(mesh, points):
    """Keeps where the points are, (n, 3) float32 in Blender's units."""
    if mesh.is_editmode:
        bm = bmesh.from_edit_mesh(mesh)
        layer = bm.verts.layers.float_vector.get(ATTRIBUTE)
        layer = layer or bm.verts.layers.float_vector.new(ATTRIBUTE)
        for vertex, point in zip(bm.verts, points.tolist()):
            vertex[layer] = point
        return
    attribute = _attribute(mesh) or mesh.attributes.new(ATTRIBUTE, "FLOAT_VECTOR", "POINT")
    attribute.data.foreach_set("vector", np.ascontiguousarray(points).reshape(-1))


def read(mesh):
    """(n, 3) float32 in Blender's units; None where nothing is kept."""
    if mesh.is_editmode:
        bm = bmesh.from_edit_mesh(mesh)
        layer = bm.verts.layers.float_vector.get(ATTRIBUTE)
        if layer is None:
            return None
        return np.array([vertex[layer] for vertex in bm.verts], dtype=np.float32).reshape(-1, 3)
    attribute = _attribute(mesh)
    if attribute is None:
        return None
    points = np.empty((len(mesh.vertices), 3), dtype=np.float32)
    attribute.data.foreach_get("vector", points.reshape(-1))
    return points


def forget(mesh):
    """Keeps nothing any longer."""
    if _SHOWN in mesh:
        del mesh[_SHOWN]
    if mesh.is_editmode:
        layers = bmesh.from_edit_mesh(mesh).verts.layers.float_vector
        layer = layers.get(ATTRIBUTE)
        if layer is not None:
            layers.remove(layer)
        return
    attribute = _attribute(mesh)
    if attribute is not None:
        mesh.attributes.remove(attribute)


def set_shown(mesh, digest):
    """Tells that the points are shown as they are now; digest: of these, bytes."""
    mesh[_SHOWN] = digest.hex()


def are_as_shown(mesh, digest):
    """Whether the points, of this digest, are as they were shown last."""
    return mesh.get(_SHOWN) == digest.hex()


def _attribute(mesh):
    attribute = mesh.attributes.get(ATTRIBUTE)
    if attribute is None or (attribute.data_type, attribute.domain) != ("FLOAT_VECTOR", "POINT"):
        return None
    return attribute
