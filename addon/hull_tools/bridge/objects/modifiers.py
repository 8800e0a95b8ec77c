# SPDX-License-Identifier: GPL-3.0-or-later
"""Modifiers of a control mesh: what Blender shows by them is not the hull, and what to do."""

_SIDE = 1  # the axis across the ship


def mirrors_sides(modifier):
    """Whether a modifier shows the other side of the ship."""
    return modifier.type == "MIRROR" and modifier.mirror_object is None and modifier.use_axis[_SIDE]


def remark(modifier, is_half):
    """A sentence about a modifier that is switched on, for a half hull or a whole one; "" where it
    shows what the hull is."""
    if not modifier.show_viewport:
        return ""
    name = f'Modifier "{modifier.name}"'
    if modifier.type == "SUBSURF":
        return f"{name} is not the surface: that is exact. Switch it off, or the points hide in it"
    if mirrors_sides(modifier):
        if tuple(modifier.use_axis) != (False, True, False):
            return f"{name} mirrors more than the sides: only these count"
        return "" if is_half else f"{name} does not count: switch on Half hull instead"
    return f"{name} is not part of the hull: apply it, or remove it"
