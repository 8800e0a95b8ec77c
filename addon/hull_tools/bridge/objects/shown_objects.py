# SPDX-License-Identifier: GPL-3.0-or-later
"""The object that shows a hull's surface, a child of the control mesh.

A copy of a hull still points to the first one's object; only a child counts as its own.
"""

import bpy
from mathutils import Matrix

from . import hull_objects, unrecorded

_IDENTITY = Matrix.Identity(4)


def surface_of(obj):
    shown = obj.hull.surface_object
    if shown is None or shown.parent != obj or shown.type != "MESH":
        return None
    return None if shown.library is not None or shown.data.library is not None else shown


def ensure(obj):
    """Makes the surface object that a hull lacks, still empty, beside it."""
    if surface_of(obj) is None:
        mesh = bpy.data.meshes.new(f"{obj.name} surface")
        obj.hull.surface_object = _new_child(obj, mesh)


def is_worked_on(shown):
    """Whether a mode other than object mode has a surface object's mesh, and would overwrite what
    is written to it."""
    return shown.mode != "OBJECT" or shown.data.is_editmode


def is_free(shown):
    """Whether a surface object's mesh can be written: no mode has it, it is no hull's nor shown for
    another one, and shape keys do not move its points."""
    mesh = shown.data
    if is_worked_on(shown) or mesh.shape_keys is not None:
        return False
    if mesh.users - mesh.use_fake_user <= 1:
        return True
    sharing = (other for other in bpy.data.objects if other.data == mesh and other != shown)
    return all(hull_objects.hull_of(other) is None for other in sharing)


def set_free(shown):
    """Gives a surface object, that is not worked on, a mesh of its own where it needs one."""
    if is_free(shown):
        return
    before = shown.data
    unrecorded.give_mesh(shown, bpy.data.meshes.new(shown.name))
    for material in before.materials:
        shown.data.materials.append(material)


def put_in_place(obj):
    """Has the surface object stand where its hull stands, as it is shaped by the same coordinates;
    whether it stood elsewhere.

    Applying a hull's scale, for one, leaves what was in the scale to its children.
    """
    shown = surface_of(obj)
    if shown is None:
        return False
    if shown.matrix_parent_inverse == _IDENTITY and shown.matrix_basis == _IDENTITY:
        return False
    # What a matrix is set to is turned back by these, to rounding.
    shown.delta_location, shown.delta_scale = (0.0, 0.0, 0.0), (1.0, 1.0, 1.0)
    shown.delta_rotation_euler = (0.0, 0.0, 0.0)
    shown.delta_rotation_quaternion = (1.0, 0.0, 0.0, 0.0)
    shown.matrix_parent_inverse = shown.matrix_basis = _IDENTITY
    return True


def _new_child(obj, data):
    child = bpy.data.objects.new(data.name, data)
    child.parent = obj
    child.hide_select = True
    for collection in obj.users_collection:
        collection.objects.link(child)
    return child
