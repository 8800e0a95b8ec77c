# SPDX-License-Identifier: GPL-3.0-or-later
"""Which object is the hull at hand, and whether it can be worked on.

A hull's coordinates are its mesh's own coordinates times the scene's metres per unit. Where the
object stands does not matter; rotation and scale that are not applied would, and are refused.
Modifiers do not belong to the hull, and are told of. Shared mesh data is fine: each of the objects
is a hull with its own settings.
"""

import numpy as np

_UPRIGHT_TOLERANCE = 1e-6


def is_hull(obj):
    return obj is not None and obj.type == "MESH" and obj.hull.is_hull


def hull_of(obj):
    """The hull that an object is, or whose surface or lines it shows; None for any other."""
    if obj is None:
        return None
    if is_hull(obj):
        return obj
    parent = obj.parent
    if is_hull(parent) and (obj == parent.hull.surface_object or _is_line_of(parent, obj)):
        return parent
    return None


def _is_line_of(hull, obj):
    curves = hull.hull.lines.curves
    return curves is not None and obj.name in curves.objects


def hulls(objects):
    return [obj for obj in objects if is_hull(obj)]


def refusal(obj):
    """Why this object cannot be a hull or be worked on as one, as a sentence; "" when it can."""
    if obj is None or obj.type != "MESH":
        return "Select a mesh object first"
    if hull_of(obj) not in (None, obj):
        return f'This only shows the hull "{obj.parent.name}": select that'
    for block in (obj, obj.data):
        if block.library is not None:
            return f'"{block.name}" is linked from another file: make it local first'
        if block.override_library is not None:
            return f'"{block.name}" is an override of a linked one: make it local first'
    for matrix in (obj.matrix_basis, obj.matrix_world):
        turned = np.array(matrix.to_3x3()) - np.eye(3)
        if np.abs(turned).max() > _UPRIGHT_TOLERANCE:
            return f'"{obj.name}" has rotation or scale: apply them first (Ctrl A)'
    return ""


def remarks(obj):
    """Sentences about what a user may expect to count but does not."""
    return [
        f'Modifier "{modifier.name}" is not part of the hull' + _instead_of(modifier, obj)
        for modifier in obj.modifiers
    ]


def _instead_of(modifier, obj):
    if modifier.type == "SUBSURF":
        return ": the surface object shows the exact surface"
    if modifier.type == "MIRROR" and not obj.hull.half:
        return ": use Half hull"
    return ""


def excluded_slots(obj):
    """Indices of the material slots whose faces do not belong to the shell."""
    excluded = {layer.material for layer in obj.hull.layers if not layer.in_hydrostatics}
    return frozenset(
        index for index, slot in enumerate(obj.material_slots) if slot.material in excluded
    )
