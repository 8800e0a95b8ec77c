# SPDX-License-Identifier: GPL-3.0-or-later
"""Faces of the control mesh on which shape fields are based: each face has a bit for each field, so
that it may be of several."""

import bpy
import numpy as np

from .. import limits
from ..mesh import face_numbers, selection

ATTRIBUTE = "hull_field_faces"


def choose(obj, field):
    """Makes the faces that are selected in edit mode those of a row. ValueError without."""
    faces = selection.selected(obj, "face") if obj.data.is_editmode else []
    if not faces:
        raise ValueError("Select the faces in edit mode first")
    if not field.faces_number:
        field.faces_number = _free_number(obj)
    _write(obj, field, faces)


def of_field(obj, field):
    """(k,) the faces of a row, by their indices in the mesh."""
    if not field.faces_number:
        return np.empty(0, dtype=np.int64)
    return np.flatnonzero(_bits(obj) & _bit(field))


def give(obj, field, faces):
    """Gives faces (k,) to a row that has none."""
    field.faces_number = _free_number(obj) if len(faces) else 0
    if len(faces):
        _write(obj, field, faces)


def forget(obj, field):
    """Takes its faces from a row."""
    if field.faces_number:
        _write(obj, field, ())
        field.faces_number = 0


def _free_number(obj):
    """One that no field of any hull has, as long as there is such a one, so that faces of a hull
    that is joined to another are of no field there."""
    own = {field.faces_number for field in obj.hull.fields.fields}
    used = {field.faces_number for other in bpy.data.objects for field in other.hull.fields.fields}
    numbers = [i for i in range(1, limits.MOST_FIELDS + 1) if i not in own]
    return next((i for i in numbers if i not in used), numbers[0])


def _bit(field):
    return np.uint32(1) << np.uint32(field.faces_number - 1)


def _bits(obj):
    return face_numbers.read(obj.data, ATTRIBUTE).view(np.uint32)


def _write(obj, field, faces):
    bits = _bits(obj)
    bits &= ~_bit(field)
    bits[np.asarray(faces, dtype=np.int64)] |= _bit(field)
    face_numbers.write(obj.data, ATTRIBUTE, np.arange(len(bits)), bits.view(np.int32))
