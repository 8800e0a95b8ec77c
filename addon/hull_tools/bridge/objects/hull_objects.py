# SPDX-License-Identifier: GPL-3.0-or-later
"""Which object is the hull at hand, and whether it can be worked on.

A hull's coordinates are its mesh's own coordinates times the scene's metres per unit. Where the
object stands does not matter; rotation and scale that are not applied would, and are refused.
Modifiers do not belong to the hull, and are told of. Shared mesh data is fine: each of the objects
is a hull with its own settings. A hull that is linked from another file is shown and measured, and
cannot be changed.
"""

from . import migration, modifiers

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
    """Why this object cannot be a hull, or be measured as one, as a sentence; "" when it can."""
    if obj is None or obj.type != "MESH":
        return "Select a mesh object first"
    if hull_of(obj) not in (None, obj):
        return f'This only shows the hull "{obj.parent.name}": select that'
    keys = obj.data.shape_keys
    if keys is not None and len(keys.key_blocks) > 1:
        return f'"{obj.name}" has shape keys, and a hull has one shape: remove them first'
    return _following_itself(obj) or _turned_by_points(obj) or _turned(obj)


def has_shape_keys(obj):
    """Whether an object is a hull, or shows one's surface, and its mesh has shape keys."""
    return obj.type == "MESH" and obj.data.shape_keys is not None and hull_of(obj) is not None


def locked(obj):
    """Why this object cannot be changed, as a sentence; "" when it can."""
    for block in (obj, obj.data):
        if block.library is not None:
            return f'"{block.name}" is linked from another file: make it local first'
        if block.override_library is not None:
            return f'"{block.name}" is an override of a linked one: make it local first'
    return ""


def _following_itself(obj):
    """That a hull's place hangs on that of its own surface or lines, or of another object that
    follows it; "" when it does not. Where such a hull stands is undefined: Blender breaks the
    cycle somewhere, turns the hull after all was told of a change, and tells nobody."""
    seen, left = set(), _followed(obj)
    while left:
        other = left.pop()
        if other == obj:
            return f'"{obj.name}" follows itself by a constraint: remove that first'
        if other not in seen:
            seen.add(other)
            left += _followed(other)
    return ""


def _followed(obj):
    """The objects that an object's place hangs on, by its parent and its constraints."""
    acting = (constraint for constraint in obj.constraints if not constraint.mute)
    followed = [obj.parent, *(getattr(constraint, "target", None) for constraint in acting)]
    return [other for other in followed if other is not None]


def _turned_by_points(obj):
    """That three points of a mesh hold an object, or one that it is parented to; "" when none do.
    They turn it whenever one of them moves, and Blender may tell of the one and not the other."""
    while obj.parent is not None:
        if obj.parent_type == "VERTEX_3":
            return (
                f'"{obj.name}" is turned by three points of "{obj.parent.name}": clear its parent '
                "and keep the transform (Alt P), or make it an object's child"
            )
        obj = obj.parent
    return ""


def _turned(obj):
    """What turns or scales an object, and what to do about it; "" when nothing does."""
    if is_turned(obj):
        return f'"{obj.name}" has rotation or scale: apply them first (Ctrl A)'
    if not _is_turned(obj.matrix_world):
        return ""
    if any(not constraint.mute for constraint in obj.constraints):
        return f'"{obj.name}" is turned or scaled by a constraint: remove it first'
    parent = obj.parent
    if parent is None:
        return ""  # the world's matrix is not up to date yet
    return (
        f'"{obj.name}" is turned or scaled by its parent "{parent.name}": clear the parent and '
        "keep the transform (Alt P), then apply (Ctrl A)"
    )


def is_turned(obj):
    """Whether an object has rotation or scale of its own."""
    return _is_turned(obj.matrix_basis)


def from_world(obj):
    """The matrix from the world's axes to an object's. ValueError where it has no inverse."""
    matrix = obj.matrix_world.inverted(None)
    if matrix is None:
        raise ValueError(
            f'"{obj.name}" is scaled to nothing in a direction: clear its scale first (Alt S)'
        )
    return matrix


def _is_turned(matrix):
    return any(
        abs(part - (row == column)) > _UPRIGHT_TOLERANCE
        for row, parts in enumerate(matrix.to_3x3())
        for column, part in enumerate(parts)
    )


def remarks(obj):
    """Sentences about what a user may expect to count but does not, or cannot do."""
    found = [modifiers.remark(modifier, obj.hull.half) for modifier in obj.modifiers]
    return [text for text in (locked(obj), migration.newer(obj), *found) if text]


def excluded_slots(obj):
    """Indices of the material slots whose faces do not belong to the shell."""
    excluded = {layer.material for layer in obj.hull.layers if not layer.in_hydrostatics}
    return frozenset(
        index for index, slot in enumerate(obj.material_slots) if slot.material in excluded
    )


def layer_name(layer):
    """What an entry of Object.hull.layers is called: by a name of its own, since Blender numbers
    those of materials through all of a file, "Shell.002" in the third hull; without a name as its
    material."""
    return layer.name or (layer.material.name if layer.material is not None else "")


def slot_names(obj):
    """One name for each material slot of a hull, or of a variant in its place."""
    named = {}
    for layer in obj.hull.layers:
        named.setdefault(layer.material, layer_name(layer))
    return [
        f"Layer {index}" if slot.material is None else named.get(slot.material, slot.material.name)
        for index, slot in enumerate(obj.material_slots)
    ]
