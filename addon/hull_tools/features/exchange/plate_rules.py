# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.plates as hull_native's seam rules and frame tables."""

import numpy as np

from ...bridge import native
from ...bridge.blender import units

# Seams of a new list of rules: so many strakes of the depth and the half-breadth, butts of the
# length.
_STRAKES, _BUTTS, _KEEL = 5, 8, 0.35


def suggested(ship):
    """[(kind, metres)] for half a ship with length_pp, beam, depth in m."""
    strake = round(max((ship[2] + 0.5 * ship[1]) / _STRAKES, 0.05), 2)
    return [
        ("strakes", strake),
        ("butts", round(max(ship[0] / _BUTTS, 0.1), 1)),
    ]


def seam_rules(obj, scene):
    """hull_native.SeamRules of a hull. ValueError for a projected one without a line."""
    hull_native, made = native.require(), []
    for number, rule in enumerate(obj.hull.plates.rules, 1):
        if not rule.on:
            continue
        line = None
        if rule.kind == "projected":
            if rule.line is None:
                raise ValueError(f"Rule {number} has no line: choose a mesh or curve object")
            line = _points_of(rule.line, obj, units.metres_per_unit(scene))
        made.append(hull_native.SeamRule(rule.kind, round(rule.value, 6), line))
    return made


def _points_of(line, hull, scale):
    """(k, 3) m, in the hull's axes: the points of a mesh in their order, or of a curve's first
    spline, as evaluated."""
    mesh = line.to_mesh()
    try:
        points = np.empty(3 * len(mesh.vertices))
        mesh.vertices.foreach_get("co", points)
    finally:
        line.to_mesh_clear()
    if len(points) < 6:
        raise ValueError(f"{line.name} has fewer than two points to be projected")
    matrix = np.array(hull.matrix_world.inverted() @ line.matrix_world)
    return (points.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]) * scale


def frame_table(obj, scene):
    """The hull_native.FrameTable of a hull, None without ranges."""
    settings = obj.hull.plates
    ranges, first = [], settings.first_frame
    for each in settings.ranges:
        ranges.append((first, each.last, round(each.spacing, 6)))
        first = each.last
    if not ranges:
        return None
    length = obj.hull.length_pp * units.metres_per_unit(scene)
    return native.require().frame_table(
        ranges,
        numbered_from=settings.numbered_from,
        length=length or None,
        in_roman=settings.in_roman,
    )
