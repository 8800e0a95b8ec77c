# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of a Blender mesh's faces, 0 for none.

They are attributes of the mesh, so that they survive saving, undo, copying and joining, and a face
that is divided leaves its number on all its parts.
"""

import bmesh
import numpy as np

from . import own_attributes


def stored(mesh, name):
    """(faces,) int32; `mesh` is not in edit mode. Zeros too of an attribute of another kind."""
    numbers = np.zeros(len(mesh.polygons), dtype=np.int32)
    attribute = own_attributes.found(mesh, name, "INT", "FACE")
    if attribute is not None:
        attribute.data.foreach_get("value", numbers)
    return numbers


def read(mesh, name):
    """(faces,) int32 of a Blender mesh, in edit mode or not."""
    if not mesh.is_editmode:
        return stored(mesh, name)
    bm = bmesh.from_edit_mesh(mesh)
    layer = bm.faces.layers.int.get(name)
    if layer is None:
        return np.zeros(len(bm.faces), dtype=np.int32)
    return np.array([face[layer] for face in bm.faces], dtype=np.int32)


def write(mesh, name, faces, numbers):
    """Gives numbers (k,) to faces (k,) of a Blender mesh, in edit mode or not; one number may be
    given for all. In edit mode every BMFace that the caller holds may become invalid."""
    faces = np.asarray(faces, dtype=np.int64).reshape(-1)
    numbers = np.broadcast_to(numbers, faces.shape)
    if mesh.is_editmode:
        _write_edited(mesh, name, faces, numbers)
    else:
        _write_stored(mesh, name, faces, numbers)


def _write_edited(mesh, name, faces, numbers):
    bm = bmesh.from_edit_mesh(mesh)
    layers = bm.faces.layers.int
    layer = layers.get(name) or layers.new(name)
    bm.faces.ensure_lookup_table()
    for face, number in zip(faces.tolist(), numbers.tolist()):
        bm.faces[face][layer] = number
    bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)


def _write_stored(mesh, name, faces, numbers):
    every = stored(mesh, name)
    every[faces] = numbers
    own_attributes.made(mesh, name, "INT", "FACE").data.foreach_set("value", every)
    mesh.update_tag()
