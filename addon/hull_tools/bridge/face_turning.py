# SPDX-License-Identifier: GPL-3.0-or-later
"""Turning a hull's faces so that their normals point into the water."""

import contextlib

import bmesh

from . import hull_objects, mesh_arrays, mesh_check


def turn_outwards(obj):
    """Turns the faces of each connected part the same way, and the whole shell outwards."""
    with _editing(obj.data) as bm:
        bmesh.ops.recalc_face_normals(bm, faces=bm.faces)
    data = mesh_arrays.read_mesh(obj.data)
    control = mesh_arrays.control_arrays(data, 1.0, hull_objects.excluded_slots(obj))
    if len(control.face_sizes) and mesh_check.outward_flux(control) < 0.0:
        with _editing(obj.data) as bm:
            bmesh.ops.reverse_faces(bm, faces=bm.faces)


@contextlib.contextmanager
def _editing(mesh):
    """A BMesh of the mesh, in edit mode or not, whose changes are stored at the end."""
    if mesh.is_editmode:
        yield bmesh.from_edit_mesh(mesh)
        bmesh.update_edit_mesh(mesh)
        return
    bm = bmesh.new()
    try:
        bm.from_mesh(mesh)
        yield bm
        bm.to_mesh(mesh)
    finally:
        bm.free()
