# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines as a Blender curve object: one polyline each, coloured by kind, thin tubes to render."""

import numpy as np

from . import materials

# The tubes' radius as a part of the hull's length: a pencil line seen from a ship's length away.
_LINE_RADIUS = 6e-4


def write_lines(curve, lines, length, metres_per_unit):
    """Replaces the splines of a Blender curve by these lines.Lines of a hull of `length` metres."""
    curve.dimensions = "3D"
    curve.bevel_depth = _LINE_RADIUS * length / metres_per_unit
    curve.bevel_resolution = 1
    curve.splines.clear()
    if not curve.materials:
        for kind in materials.LINE_COLOURS:
            curve.materials.append(materials.line_material(kind))
    for slot, kind in enumerate(materials.LINE_COLOURS):
        for points, closed in lines.curves.get(kind, ()):
            _add_polyline(curve, points / metres_per_unit, closed, slot)


def _add_polyline(curve, points, closed, slot):
    if closed and len(points) > 1 and np.array_equal(points[0], points[-1]):
        points = points[:-1]
    spline = curve.splines.new("POLY")
    spline.points.add(len(points) - 1)
    co = np.ones((len(points), 4), dtype=np.float32)
    co[:, :3] = points
    spline.points.foreach_set("co", co.reshape(-1))
    spline.use_cyclic_u = closed
    spline.use_smooth = True
    spline.material_index = slot
