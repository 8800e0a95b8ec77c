# SPDX-License-Identifier: GPL-3.0-or-later
"""What a 3D view has room for: the part of its region that nothing of Blender's own covers."""

# At a user interface scale of 1 a text of 2.5 mm has 11 dots, as Blender's own.
DOTS_PER_MM = 4.4

_TEXTS = 56.0  # dots that Blender's own texts take at the top on the left, at a scale of 1


def free_room(area, region):
    """(left, bottom, width, height) of the region that toolbar, sidebar and header leave free."""
    left, right = 0, region.width
    bottom, top = 0, region.height
    for other in area.regions:
        if other.width <= 1 or other.height <= 1 or other.type == "WINDOW":
            continue
        x, y = other.x - region.x, other.y - region.y
        overlaps = x < region.width and x + other.width > 0 and y < region.height
        if not overlaps or y + other.height <= 0:
            continue
        if other.type in {"TOOLS", "UI"}:
            if x > region.width / 2:
                right = min(right, x)
            else:
                left = max(left, x + other.width)
        elif other.type in {"HEADER", "TOOL_HEADER"}:
            if y > region.height / 2:
                top = min(top, y)
            else:
                bottom = max(bottom, y + other.height)
    return left, bottom, right - left, top - bottom


def below_texts(room, space, ui_scale):
    """A `free_room` without what Blender's own texts at its top take, where the view shows them."""
    left, bottom, width, height = room
    if space.overlay.show_text:
        height = max(height - _TEXTS * ui_scale, 0.0)
    return left, bottom, width, height
