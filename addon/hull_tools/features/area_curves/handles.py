# SPDX-License-Identifier: GPL-3.0-or-later
"""Handles of the target curve in the plot over the view: where they are, and what the mouse does
with them."""

from dataclasses import dataclass

import numpy as np

from ....hull_io.number_lists import numbers
from ...bridge.blender import units
from ..analyses import live_analyses
from ..curves_of_form import beside, sectional_areas
from ..hull import hull_state
from . import live_target, stored

# In pixels at a scale of 1.
NEAR = 14.0
# Of the plot's length: handles come no nearer to one another.
_APART = 2e-3


@dataclass
class Held:
    """Of one hull: which handle the mouse is at, or None, whether it is dragged, and words for it
    or ""."""

    index: object = None
    is_dragged: bool = False
    text: str = ""


def held(obj):
    """The Held of a hull of which something is known, or None."""
    return hull_state.known(obj, Held)


@dataclass(frozen=True)
class Diagram:
    """The plot in a region. rectangle: (left, bottom, right, top) between the axes in its dots;
    card: the same of all of it; frame: the ranges of the axes, see sectional_areas.frame."""

    rectangle: tuple
    card: tuple
    frame: tuple

    def dots(self, points):
        """(k, 2) dots of points (k, 2) of x in m and areas in m²."""
        low, high = np.array(self.frame).T
        left_low, right_high = np.reshape(self.rectangle, (2, 2))
        return left_low + (np.asarray(points) - low) / (high - low) * (right_high - left_low)

    def point(self, dots):
        """(2,) x in m and area in m² at a place in dots."""
        low, high = np.array(self.frame).T
        left_low, right_high = np.reshape(self.rectangle, (2, 2))
        return low + (np.asarray(dots) - left_low) / (right_high - left_low) * (high - low)

    def has(self, dots):
        """Whether a place is between the axes, or just beside them."""
        left, bottom, right, top = self.rectangle
        x, y = dots
        return left - NEAR <= x <= right + NEAR and bottom - NEAR <= y <= top + NEAR


def diagram(obj, scene, area, region):
    """The Diagram that a region of a 3D view shows of a hull with a target now, or None."""
    place = live_analyses.place_of(live_target.ANALYSIS, area, region)
    live, result = live_target.known(obj), live_target.present(obj, scene)
    if place is None or result is None or live is None or live.curve is None:
        return None
    others = hull_state.state_of(obj).of(beside.Beside).of(live_target.ANALYSIS)
    frame = sectional_areas.frame(result, others)
    return None if frame is None else Diagram(place.diagram, place.rectangle, frame)


def points_of(obj, scene):
    """(h, 2) handles of a hull's target as they are set: x in m and areas in m²."""
    found = units.all_as_stored(stored.numbers(obj)[1])
    return found * (units.metres_per_unit(scene), 1.0)


def nearest(shown, points, dots, reach):
    """The index of the handle nearest to a place in a Diagram within reach, dots; else None."""
    distances = np.hypot(*(shown.dots(points) - dots).T)
    index = int(distances.argmin())
    return index if distances[index] <= reach else None


class Drag:
    """A change of a hull's target by the mouse, which can be taken back as a whole. The axes of the
    plot stay as they are meanwhile."""

    def __init__(self, obj, scene):
        self.obj, self.scene = obj, scene
        self.scale = units.metres_per_unit(scene)
        self._before = stored.numbers(obj)[1]
        self._was_shown = obj.hull.plots.sectional_areas, obj.hull.area_target.show_target
        obj.hull.plots.sectional_areas = obj.hull.area_target.show_target = True

    def set_frame(self, frame):
        """Holds the axes' ranges, or lets them go with None."""
        live = live_target.known(self.obj)
        if live is not None and live.frame != frame:
            live.frame = frame
            self.obj.update_tag(refresh={"DATA"})

    @property
    def has_changed(self):
        return self._before.tobytes() != stored.numbers(self.obj)[1].tobytes()

    def move(self, index, point):
        """Moves a handle to (x in m, area in m²), no farther than to its neighbours."""
        points = points_of(self.obj, self.scene)
        apart = _APART * np.ptp(points[:, 0])
        low = points[index - 1, 0] + apart if index > 0 else -np.inf
        high = points[index + 1, 0] - apart if index + 1 < len(points) else np.inf
        if low > high:  # there is no room between them
            low = high = 0.5 * (low + high)
        entry = self.obj.hull.area_target.area_points[index]
        entry.x = float(np.clip(point[0], low, high)) / self.scale
        entry.area = max(float(point[1]), 0.0)
        self.obj.hull.area_target.active_area_point = index

    def cancel(self):
        """All as before."""
        self.set_frame(None)
        pairs = units.all_as_stored(self._before).reshape(-1, 2)
        stored.write_handles(self.obj, pairs)
        settings = self.obj.hull
        settings.plots.sectional_areas, settings.area_target.show_target = self._was_shown


def add_handle(obj, scene, x):
    """Adds a handle on the target curve at x, m; returns its index, None where it has no room."""
    curve = stored.curve(obj, scene)
    aft, forward = curve.ends
    if np.abs(curve.x - x).min() < _APART * (forward - aft) or not aft < x < forward:
        return None
    index = int(np.searchsorted(curve.x, x))
    area = curve.at([x])[0]
    scale = units.metres_per_unit(scene)
    handles = np.column_stack([curve.x / scale, curve.areas])
    stored.write_handles(obj, np.insert(handles, index, (x / scale, area), axis=0))
    obj.hull.area_target.active_area_point = index
    return index


def remove_handle(obj, index):
    """Removes a handle; ValueError for one of the last three, and for an end."""
    points = obj.hull.area_target.area_points
    if len(points) <= 3:
        raise ValueError("The target curve needs three points")
    if not 0 < index < len(points) - 1:
        raise ValueError("The curve's ends stay: move them instead")
    points.remove(index)
    obj.hull.area_target.active_area_point = min(index, len(points) - 1)
    obj.update_tag(refresh={"DATA"})


def text_of(obj):
    """The handles as text: x in Blender's units and area in m² of each, semicolons between."""
    points = obj.hull.area_target.area_points
    return "; ".join(f"{units.as_typed(p.x):.7g} {units.as_typed(p.area):.7g}" for p in points)


def write_text(obj, text):
    """Makes the handles those of such a text; ValueError where it is none, or they are no curve."""
    found = [numbers(part, "Points") for part in text.split(";")]
    if len(found) < 3 or any(len(pair) != 2 for pair in found):
        raise ValueError("Points: give x and area of three or more, as in 0 0; 40 70; 80 0")
    base, _ = stored.numbers(obj)
    stored.curve_of(base, np.array(found, dtype=np.float32), 1.0)
    stored.write_handles(obj, found)


def words(point, scene, present_area):
    """What is told of a handle at (x in m, area in m²) where the hull has this area."""
    x, area = (units.format_value(scene, value, unit) for value, unit in zip(point, ("m", "m2")))
    text = f"x {x}   A {area}"
    if present_area > 0.0:
        text += f"   {100.0 * (point[1] / present_area - 1.0):+.2f} %"
    return text


def present_area(obj, scene, x):
    """Of the hull as it was last computed at x, m; m²."""
    result = live_target.present(obj, scene)
    if result is None:
        return 0.0
    found = result.areas
    return float(np.interp(x, found.positions, found.areas, left=0.0, right=0.0))
