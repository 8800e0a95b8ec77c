# SPDX-License-Identifier: GPL-3.0-or-later
"""Handles of the chosen shape field in the 3D view, at the tip of its shift and on the circle of
its extent: where they are, and what the mouse does with them."""

from dataclasses import dataclass

import numpy as np

from ...bridge.blender import units
from ..hull import hull_state
from ..lines import lines
from ..modelling import drags
from . import seen

# In pixels at a scale of 1.
NEAR = 14.0
# Of the hull's size: no extent that is dragged is shorter.
_SHORTEST = 1e-3
# Sine of the angle between view and the plane of two axes, for a shift to be dragged in it.
_LEAST_SINE = 0.2


@dataclass
class Held:
    """Of one hull. is_on: whether handles are there to be dragged; kind: "shift" or "extent" of
    the one that the mouse is at, or None; is_dragged: whether it is."""

    is_on: bool = False
    kind: object = None
    is_dragged: bool = False


def held(obj):
    """The Held of a hull of which something is known, or None."""
    return hull_state.known(obj, Held)


def at_hand(obj, scene):
    """(the chosen field, its seen_bases.Base) of a hull as they are now; ValueError without."""
    seen.follow(obj, scene)
    found, rows = seen.of_hull(obj), obj.hull.fields.fields
    if found is None or found.chosen is None or found.chosen.number >= len(rows):
        raise ValueError("The chosen field has no base to be seen: choose one, and show the fields")
    return rows[found.chosen.number], found.chosen


def places(row, base, eye, scale):
    """{"shift" or "extent": (3,) m} of the handles of a field with its seen_bases.Base, as a
    pull_lines.Eye sees them; what is protected is not shifted. scale: metres a unit."""
    extent = units.as_typed(row.extent) * scale
    found = {"extent": base.anchor + extent * _beside(row, eye)}
    if row.role == "MOVE":
        found["shift"] = base.anchor + _shift(row) * scale
    return found


def nearest(found, eye, mouse, reach):
    """ "shift" or "extent" of the one of these places that is nearest to the mouse within reach,
    pixels; else None."""
    kinds = sorted(found, reverse=True)  # the shift first: it begins within small extents
    away = drags.in_picture(eye.to_clip, eye.size, np.array([found[kind] for kind in kinds]))
    away = np.nan_to_num(np.hypot(*(away - mouse).T), nan=np.inf)
    index = int(away.argmin())
    return kinds[index] if away[index] <= reach else None


class Drag:
    """One drag of a handle of a field; it stays as far from the mouse as when it was taken."""

    def __init__(self, obj, scene, kind, eye, mouse):
        self._obj, self._scene, self.kind = obj, scene, kind
        self._scale = units.metres_per_unit(scene)
        row, self._base = at_hand(obj, scene)
        self._shift = _shift(row) * self._scale
        self._place = places(row, self._base, eye, self._scale)[kind]
        here = drags.in_picture(eye.to_clip, eye.size, self._place[None])[0]
        self._beside = here - mouse

    def move(self, eye, mouse, axis=None):
        """Follows the mouse; axis: 0 to 2, the only coordinate that a shift changes then."""
        row = self._obj.hull.fields.fields[self._base.number]
        ray = eye.ray(mouse + self._beside)
        if self.kind == "extent":
            self._move_extent(row, ray, eye)
        else:
            self._move_shift(row, ray, eye, axis)

    def _move_extent(self, row, ray, eye):
        if row.base == "PLANE":
            target = drags.on_line(*ray, self._base.anchor, _beside(row, eye))
        else:
            target = drags.on_plane(*ray, self._base.anchor, eye.direction)
        if target is not None:
            surface = hull_state.state_of(self._obj).ship.surface
            extent = np.linalg.norm(target - self._base.anchor)
            row.extent = max(extent, _SHORTEST * lines.size_of(surface)) / self._scale

    def _move_shift(self, row, ray, eye, axis):
        free = np.array(row.axes) if axis is None else np.arange(3) == axis
        target = _on_free(ray, self._place, eye.direction, free)
        if target is not None:
            row.shift = np.where(free, target - self._base.anchor, self._shift) / self._scale


def words(row, kind, scene):
    """What is told of a handle of a field."""
    scale = units.metres_per_unit(scene)
    if kind == "extent":
        return f"Extent {units.format_value(scene, row.extent * scale, 'm')}"
    shift = _shift(row) * scale
    parts = (units.format_value(scene, value, "m") for value in (*shift, np.linalg.norm(shift)))
    x, y, z, length = parts
    return f"Shift x {x}  y {y}  z {z}    Length {length}"


def _shift(row):
    return np.array([units.as_typed(value) for value in row.shift])


def _beside(row, eye):
    """(3,) the direction from a base to the handle of the extent."""
    if row.base == "PLANE":
        return (np.arange(3) == "XYZ".index(row.axis)).astype(np.float64)
    return eye.right


def _on_free(ray, place, direction, free):
    """Where a ray brings a place whose coordinates are free (3,) or not; None where it cannot be
    told. direction: that of the view."""
    if free.sum() == 1:
        return drags.on_line(*ray, place, free.astype(np.float64))
    normal = (~free).astype(np.float64)
    is_in_plane = free.sum() == 2 and abs(direction @ normal) > _LEAST_SINE
    return drags.on_plane(*ray, place, normal if is_in_plane else direction)
