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
    """(k, 3) in another object's axes and units: the points of a mesh object in their order, or of
    a curve object, as evaluated. ValueError where there are fewer than two."""
    mesh = line.to_mesh()
    try:
        points = np.empty(3 * len(mesh.vertices))
        mesh.vertices.foreach_get("co", points)
    finally:
        line.to_mesh_clear()
    if len(points) < 6:
        raise ValueError(f"{line.name} has fewer than two points to be projected")
    matrix = np.array(hull_objects.from_world(obj) @ line.matrix_world)
    return points.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]
