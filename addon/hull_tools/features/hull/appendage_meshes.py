# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes that show appendages, and appendages made new."""

import bpy
import numpy as np

from ...bridge.mesh import mesh_arrays
from ...bridge.objects import appendages, hull_objects
from ..flotation.appendages import native_body

# Of each patch: cylinders have 64 around, sections 96 along the outline.
_DIVISIONS = 1
_SAME_PLACE = 1e-7  # of the size: points at common sides of patches


def show(obj):
    """Gives an appendage's object the mesh of the body that its settings say; one that is none has
    no faces. One that is cut out is a wire, and on no picture. What shares its mesh stays as it
    is."""
    if obj.data.users - obj.data.use_fake_user > 1 and not obj.data.is_editmode:
        obj.data = obj.data.copy()
    is_cut = obj.hull.appendage.is_cut
    obj.display_type, obj.hide_render = ("WIRE" if is_cut else "TEXTURED"), is_cut
    try:
        body = native_body(appendages.described(obj), 1.0)
    except ValueError:
        _write(obj.data, np.zeros((0, 3)), np.zeros((0, 4), dtype=np.int32))
        return
    _write(obj.data, *body.grid(_DIVISIONS))


def _write(mesh, points, faces):
    size = float(np.ptp(points, axis=0).max()) if len(points) else 1.0
    _, first, place = np.unique(
        np.round(points / (_SAME_PLACE * size)), axis=0, return_index=True, return_inverse=True
    )
    faces = place.ravel()[faces]
    # Sides of no length, where patches end in a point.
    rows = [row[row != np.roll(row, 1)] for row in faces]
    rows = [row for row in rows if len(row) > 2]
    sizes = np.array([len(row) for row in rows], dtype=np.int32)
    corners = np.concatenate(rows).astype(np.int32) if rows else np.zeros(0, dtype=np.int32)
    mesh.clear_geometry()
    mesh_arrays.write_faces(mesh, points[first], sizes, corners)


def add(hull, name, place, values, collection):
    """A new appendage object of a hull, its origin at a place on the hull's axes, with these values
    of its settings. ValueError for bodies that are none, and then there is none."""
    if not hull_objects.is_hull(hull):
        raise ValueError("Select the hull first that the appendage belongs to")
    obj = bpy.data.objects.new(name, bpy.data.meshes.new(name))
    for key, value in sorted(values.items(), key=lambda item: item[0] == "shape"):
        setattr(obj.hull.appendage, key, value)  # the shape last: then it is shown
    try:
        native_body(appendages.described(obj), 1.0)
    except ValueError:
        mesh = obj.data
        bpy.data.objects.remove(obj)
        bpy.data.meshes.remove(mesh)
        raise
    collection.objects.link(obj)
    obj.parent = hull
    obj.location = place
    show(obj)
    return obj
