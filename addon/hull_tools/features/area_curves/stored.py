# SPDX-License-Identifier: GPL-3.0-or-later
"""The target curve as Object.hull.area_target has it: read, and written as a whole."""

import numpy as np

from ...bridge import limits
from ...bridge.blender import units
from .target_curve import TargetCurve

_FEWEST = 3


def is_there(obj):
    return bool(obj.hull.area_target.area_points)


def numbers(obj):
    """(base (b, 2), handles (h, 2)) of a hull: x in Blender's units and areas in m², float32."""
    settings = obj.hull.area_target
    return _numbers(settings.base), _numbers(settings.area_points)


def _numbers(entries):
    found = np.empty((len(entries), 2), dtype=np.float32)
    for column, name in enumerate(("x", "area")):
        values = np.empty(len(entries), dtype=np.float32)
        entries.foreach_get(name, values)
        found[:, column] = values
    return found


def curve_of(base, handles, scale):
    """The TargetCurve of these numbers; ValueError with the remedy where they are no curve."""
    if len(handles) < _FEWEST:
        raise ValueError(
            f"The target curve has {len(handles)} points: give it {_FEWEST} or more, or take the "
            "present curve"
        )
    limits.at_most(len(handles), "points of the target curve", limits.MOST_AREA_HANDLES)
    base_x, base_areas = _metres(base, scale)
    x, areas = _metres(handles, scale)
    rises = np.diff(x) > 0.0
    if not rises.all():
        place = int(np.argmin(rises)) + 2
        raise ValueError(
            f"Point {place} of the target curve does not lie ahead of the one before: have the "
            "points in order"
        )
    return TargetCurve(base_x, base_areas, x, areas)


def _metres(pairs, scale):
    x, areas = units.all_as_stored(pairs).reshape(-1, 2).T
    for value in (x, areas):
        if not np.isfinite(value).all():
            raise ValueError("A point of the target curve is no number: take the curve anew")
    return scale * x, areas


def curve(obj, scene):
    """The TargetCurve of a hull; ValueError without one."""
    if not is_there(obj):
        raise ValueError("Take the present area curve as a target first, or read one from a table")
    return curve_of(*numbers(obj), units.metres_per_unit(scene))


def write(obj, scene, curve, source=None):
    """Makes a TargetCurve that of a hull; source: where it comes from, None: as before."""
    scale = units.metres_per_unit(scene)
    settings = obj.hull.area_target
    if source is not None:
        settings.source = source
    _put(settings.base, curve.base_x / scale, curve.base_areas)
    _put(settings.area_points, curve.x / scale, curve.areas)
    settings.active_area_point = min(settings.active_area_point, len(curve.x) - 1)
    obj.update_tag(refresh={"DATA"})


def write_handles(obj, handles):
    """Makes pairs (x in Blender's units, area in m²) the handles of a hull."""
    x, areas = np.asarray(handles, dtype=np.float64).reshape(-1, 2).T
    _put(obj.hull.area_target.area_points, x, areas)
    obj.update_tag(refresh={"DATA"})


def _put(entries, x, areas):
    while len(entries) > len(x):
        entries.remove(len(entries) - 1)
    while len(entries) < len(x):
        entries.add()
    entries.foreach_set("x", np.asarray(x, dtype=np.float32))
    entries.foreach_set("area", np.asarray(areas, dtype=np.float32))


def clear(obj):
    """Takes the target away."""
    settings = obj.hull.area_target
    settings.source = ""
    settings.base.clear()
    settings.area_points.clear()
    settings.active_area_point = 0
    obj.update_tag(refresh={"DATA"})
