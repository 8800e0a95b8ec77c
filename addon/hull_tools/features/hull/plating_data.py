# SPDX-License-Identifier: GPL-3.0-or-later
"""Rules of seams, and frames: from hull_io's HullData to Object.hull.plates, and back."""

import numpy as np

from ....hull_io.plating_data import FrameRange, Plating, SeamRule
from ...bridge.blender.units import as_stored
from ...bridge.objects import curve_lines, hull_objects

_PLAIN = (
    *("along_knuckles", "across_centre", "first_frame", "numbered_from", "in_roman"),
    *("mark_waterlines", "mark_buttocks"),
)
_MM = 1000.0
_DIGITS = 6  # of matrices: more are rounding where a hull and its lines have moved together


def give_plating(obj, plating, scale):
    """To a hull without rules; scale: metres of Blender's unit. None changes nothing."""
    if plating is None:
        return
    settings = obj.hull.plates
    for name in _PLAIN:
        setattr(settings, name, getattr(plating, name))
    settings.thickness = _MM * plating.thickness
    for rule in plating.rules:
        entry = settings.rules.add()
        entry.kind, entry.value, entry.on = rule.kind, rule.value, rule.on
        if rule.line:
            points = (np.array(rule.line) / scale).tolist()
            entry.line = curve_lines.made("Seam line", points, False, obj)
    for each in plating.ranges:
        entry = settings.ranges.add()
        entry.last, entry.spacing = each.last, each.spacing


def take_plating(obj, scale):
    """The Plating of a hull, None where nothing was said of it. A projected seam without a line is
    left out. ValueError where the object of one is no line."""
    settings = obj.hull.plates
    said = ("thickness", *_PLAIN)
    if not (settings.rules or settings.ranges or any(map(settings.is_property_set, said))):
        return None
    return Plating(
        rules=[
            _rule(rule, obj, scale)
            for rule in settings.rules
            if rule.kind != "projected" or rule.line is not None
        ],
        ranges=[FrameRange(each.last, as_stored(each.spacing)) for each in settings.ranges],
        thickness=as_stored(settings.thickness) / _MM,
        **{name: getattr(settings, name) for name in _PLAIN},
    )


def _rule(rule, obj, scale):
    line = []
    if rule.kind == "projected":
        line = [tuple(point) for point in (points_of(rule.line, obj) * scale).tolist()]
    return SeamRule(rule.kind, as_stored(rule.value), line, rule.on)


def points_of(line, obj):
    """(k, 3) in another object's axes and units: the points of a mesh object along its edges, or
    in their order where it has none, or faces; or of a curve object, as evaluated. ValueError for
    other objects, for fewer than two points, and for edges that are no single line."""
    if line.type not in ("MESH", "CURVE"):
        raise ValueError(f"{line.name} is no mesh or curve object: choose another one")
    mesh = line.to_mesh()
    try:
        points = np.empty(3 * len(mesh.vertices))
        mesh.vertices.foreach_get("co", points)
        edges = np.empty(2 * len(mesh.edges), dtype=np.int32)
        mesh.edges.foreach_get("vertices", edges)
        has_faces = len(mesh.polygons) > 0
    finally:
        line.to_mesh_clear()
    if len(points) < 6:
        raise ValueError(f"{line.name} has fewer than two points to be projected")
    points = points.reshape(-1, 3)
    if len(edges) and not has_faces:
        points = points[_along(edges.reshape(-1, 2), len(points), line.name)]
    matrix = np.array(hull_objects.from_world(obj) @ line.matrix_world)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def key_of(line, obj):
    """What points_of() depends on, to be compared without having them made."""
    matrix = obj.matrix_world.inverted_safe() @ line.matrix_world
    key = [tuple(round(value, _DIGITS) for row in matrix for value in row)]
    if line.type == "MESH":
        key += [_numbers(line.data.vertices, "co", 3), _numbers(line.data.edges, "vertices", 2)]
    elif line.type == "CURVE":
        for spline in line.data.splines:
            key += [spline.use_cyclic_u, spline.resolution_u, _numbers(spline.points, "co", 4)]
            knots = spline.bezier_points
            key += [_numbers(knots, name, 3) for name in ("co", "handle_left", "handle_right")]
    return tuple(key)


def _numbers(entries, name, size):
    values = np.empty(size * len(entries), dtype=np.int32 if name == "vertices" else np.float32)
    entries.foreach_get(name, values)
    return values.tobytes()


def _along(edges, count, name):
    """[k] the points of a count from one end of a line of edges (k, 2) to the other, or around. In
    a mesh the points of an edge that was divided are the last ones."""
    beside = [[] for _ in range(count)]
    for a, b in edges.tolist():
        beside[a].append(b)
        beside[b].append(a)
    start = next((i for i, others in enumerate(beside) if len(others) == 1), 0)
    found, last = [start], None
    while True:
        onwards = sorted(i for i in beside[found[-1]] if i != last)
        last = found[-1]
        if not onwards or onwards[0] == start:
            break
        found.append(onwards[0])
        if len(found) > count:
            break
    if len(found) != count or max(map(len, beside)) > 2:
        raise ValueError(f"{name} is no single line: leave one without branches and loose points")
    return found
