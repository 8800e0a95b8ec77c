# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.fields: how shape fields come, are put in order, and go."""

import numpy as np

from ...bridge import limits
from ...bridge.mesh import mesh_points
from ...bridge.objects import field_faces, hull_objects

# What a copy of a field has of it.
_KEPT = """use role colour base place axis curve becomes along_surface extent falloff shift axes
    varies extent_end falloff_end shift_end""".split()
# Of a palette of colours that are told apart on light and dark grounds.
_COLOURS = ((0.9, 0.5, 0.1), (0.1, 0.6, 0.9), (0.2, 0.7, 0.3), (0.8, 0.3, 0.6), (0.7, 0.7, 0.1))
# Of the hull's longest side: what a new field reaches.
_EXTENT = 0.15


def in_use(obj):
    """The fields that are on; ValueError without one that shifts."""
    found = [field for field in obj.hull.fields.fields if field.use]
    if not any(field.role == "MOVE" for field in found):
        raise ValueError("Add a field that shifts first, and switch it on")
    limits.at_most(len(found), "fields", limits.MOST_FIELDS)
    return found


def add(obj, scene, role="MOVE", base="POINT"):
    """A new field, placed as put() does it, which is chosen then; returns it."""
    settings = obj.hull.fields
    limits.at_most(len(settings.fields) + 1, "fields", limits.MOST_FIELDS)
    place = _place(obj, scene)
    field = settings.fields.add()
    number = len(settings.fields)
    field.name = f"Field {number}"
    field.role, field.base = role, base
    field.colour = _COLOURS[(number - 1) % len(_COLOURS)]
    points = mesh_points.read(obj.data)
    field.extent = _EXTENT * float(np.ptp(points, axis=0).max()) if len(points) else 1.0
    field.place = place
    settings.active_field = number - 1
    return field


def put(field, obj, scene):
    """Places a field's base at the middle of the points selected in edit mode, else at the 3D
    cursor."""
    field.place = _place(obj, scene)


def _place(obj, scene):
    selected = mesh_points.selected(obj.data) if obj.data.is_editmode else ()
    if len(selected):
        return mesh_points.read(obj.data, selected).mean(axis=0)
    return hull_objects.from_world(obj) @ scene.cursor.location


def chosen(obj):
    """The field that is chosen; ValueError without one."""
    settings = obj.hull.fields
    if not 0 <= settings.active_field < len(settings.fields):
        raise ValueError("Choose a field first")
    return settings.fields[settings.active_field]


def remove(obj):
    """Removes the field that is chosen."""
    settings = obj.hull.fields
    field_faces.forget(obj, chosen(obj))
    settings.fields.remove(settings.active_field)
    settings.active_field = max(min(settings.active_field, len(settings.fields) - 1), 0)


def duplicate(obj):
    """Adds a copy of the chosen field after it, which is chosen then; returns it."""
    chosen(obj)
    settings = obj.hull.fields
    limits.at_most(len(settings.fields) + 1, "fields", limits.MOST_FIELDS)
    index = settings.active_field
    old = settings.fields[index]
    copy = copied(old, obj, f"{old.name} copy")
    field_faces.give(obj, copy, field_faces.of_field(obj, settings.fields[index]))
    settings.fields.move(len(settings.fields) - 1, index + 1)
    settings.active_field = index + 1
    return settings.fields[index + 1]


def copied(field, obj, name):
    """A new field, the last of a hull's, that is as another one, but for its faces."""
    kept = {key: getattr(field, key) for key in _KEPT}
    kept = {key: tuple(v) if hasattr(v, "__len__") and not isinstance(v, str) else v
            for key, v in kept.items()}  # fmt: skip
    made = obj.hull.fields.fields.add()
    for key, value in kept.items():
        setattr(made, key, value)
    made.name = name
    return made


def move(obj, steps):
    """Moves the chosen field down the list by so many places, up where they are negative."""
    chosen(obj)
    settings = obj.hull.fields
    index = min(max(settings.active_field + steps, 0), len(settings.fields) - 1)
    settings.fields.move(settings.active_field, index)
    settings.active_field = index
