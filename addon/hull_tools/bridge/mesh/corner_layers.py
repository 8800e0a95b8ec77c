# SPDX-License-Identifier: GPL-3.0-or-later
"""What corners of faces carry in edit meshes: UV, colours, attributes."""

_KINDS = ("bool", "color", "float", "float_color", "float_vector", "int", "string", "uv")


def of(bm):
    """All layers of the corners (loops) of a BMesh."""
    found = (getattr(bm.loops.layers, kind, None) for kind in _KINDS)
    return [layer for of_kind in found if of_kind is not None for layer in of_kind.values()]


def copy(layers, source, target):
    """Gives a corner what another one has in these layers. BMLoop.copy_from() would do, but leaves
    Blender 4.3 with loops that it takes for removed."""
    for layer in layers:
        target[layer] = source[layer]
