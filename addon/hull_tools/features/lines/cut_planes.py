# SPDX-License-Identifier: GPL-3.0-or-later
"""The list of Object.hull.lines.planes: planes of one's own to cut the hull by."""

_AXES = {"X": (1.0, 0.0, 0.0), "Y": (0.0, 1.0, 0.0), "Z": (0.0, 0.0, 1.0)}


def add(obj, cursor, direction):
    """A plane through a 3D cursor, given by its matrix in the world, across an axis "X", "Y" or "Z"
    or ("CURSOR") the cursor's own z axis; returns it."""
    lines = obj.hull.lines
    point = cursor.translation - obj.matrix_world.translation
    plane = lines.planes.add()
    plane.normal = _AXES[direction] if direction in _AXES else cursor.col[2].xyz.normalized()
    plane.point = point
    plane.name = _name(direction, point, len(lines.planes))
    lines.active_plane = len(lines.planes) - 1
    lines.show_planes = True
    return plane


def _name(direction, point, number):
    if direction in _AXES:
        return f"{direction.lower()} = {point['XYZ'.index(direction)]:.5g}"
    return f"Plane {number}"


def remove(obj):
    """Removes the chosen plane."""
    lines = obj.hull.lines
    lines.planes.remove(min(max(lines.active_plane, 0), len(lines.planes) - 1))
    lines.active_plane = max(min(lines.active_plane, len(lines.planes) - 1), 0)
    obj.update_tag(refresh={"DATA"})
