# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh as a BMesh, for tools that change its faces."""

import contextlib

import bmesh


@contextlib.contextmanager
def editing(mesh):
    """A BMesh of the mesh, in edit mode or not, whose changes are stored at the end unless
    something goes wrong (in edit mode they are the mesh's own at once)."""
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


def check_single_user(mesh):
    """ValueError where several objects have the mesh: what suits one of them may not suit the
    others."""
    users = mesh.users - mesh.use_fake_user
    if users > 1:
        raise ValueError(
            f'{users} objects share the mesh "{mesh.name}": make it single-user first (Object ▸ '
            "Relations)"
        )
