# SPDX-License-Identifier: GPL-3.0-or-later
"""The two objects that show a hull: its surface and its lines, children of the control mesh.

A copy of a hull still points to the first one's objects; only a child counts as its own.
"""

import bpy


def surface_of(obj):
    return _own(obj, obj.hull.surface_object, "MESH")


def lines_of(obj):
    return _own(obj, obj.hull.lines_object, "CURVE")


def _own(obj, shown, kind):
    if shown is None or shown.parent != obj or shown.type != kind:
        return None
    return None if shown.library is not None or shown.data.library is not None else shown


def ensure(obj):
    """Makes the surface and lines objects that a hull lacks, still empty, beside it."""
    if surface_of(obj) is None:
        mesh = bpy.data.meshes.new(f"{obj.name} surface")
        obj.hull.surface_object = _new_child(obj, mesh)
    if lines_of(obj) is None:
        curve = bpy.data.curves.new(f"{obj.name} lines", "CURVE")
        obj.hull.lines_object = _new_child(obj, curve)


def _new_child(obj, data):
    child = bpy.data.objects.new(data.name, data)
    child.parent = obj
    child.hide_select = True
    for collection in obj.users_collection:
        collection.objects.link(child)
    return child
