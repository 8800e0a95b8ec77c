# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull as recipes of shape fields look at it: its extent, its lines, and rows that several need.

A row is a dict of what a field has, in metres: see recipes.py.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...bridge.blender import units
from ...bridge.objects import hull_mesh
from ..flotation import ship
from . import base_curves

# Points of a curve that is laid along the hull.
ALONG = 9


@dataclass(frozen=True, eq=False)
class Form:
    """A hull in metres. surface: hull_native.LimitSurface; low, high (3,): the ends of it;
    half_breadth: with the sign of the side where it is widest; draft, depth: above the lowest
    point; control: mesh_arrays.ControlArrays."""

    surface: object
    low: np.ndarray
    high: np.ndarray
    half_breadth: float
    draft: float
    depth: float
    control: object

    @property
    def points(self):
        return self.control.points

    @cached_property
    def faces(self):
        """The points of each control face."""
        ends = np.cumsum(self.control.face_sizes)[:-1]
        return np.split(np.asarray(self.control.face_vertices), ends)

    @property
    def face_ids(self):
        return self.control.face_ids

    @property
    def length(self):
        return self.high[0] - self.low[0]

    def x(self, part):
        """From its aft end, 0, to its fore end, 1."""
        return self.low[0] + part * self.length

    def section(self, axis, position, near):
        """The base_curves.BaseCurve in which a plane cuts it, nearest to a place (3,)."""
        return base_curves.section_near(self.surface, axis, position, near)


def form_of(obj, scene):
    scale, found = units.metres_per_unit(scene), hull_mesh.read(obj)
    control = found.control(scale)
    surface = ship.source_of(found, control).new_surface()
    points = surface.evaluate_grid(4)[0].reshape(-1, 3)
    low, high = points.min(axis=0), points.max(axis=0)
    depth = float(high[2] - low[2])
    draft = units.as_typed(obj.hull.draft) * scale - low[2]
    widest = high[1] if high[1] >= -low[1] else low[1]
    if not (widest and depth > 0.0):
        raise ValueError("The hull is flat: give it a breadth and a depth first")
    draft = draft if 0 < draft < depth else 0.6 * depth
    return Form(surface, low, high, widest, draft, depth, control)


def protected_centre(form, extent):
    """What is at the centre plane keeps its breadth."""
    return {
        "name": "Centre plane kept",
        "role": "PROTECT",
        "base": "PLANE",
        "axis": "Y",
        "place": (form.x(0.5), 0.0, form.low[2] + form.draft),
        "extent": extent * abs(form.half_breadth),
        "axes": "y",
    }


def deck_near(form, part):
    """A place from which the nearest crease or border is the deck's edge."""
    deck = form.section("X", form.x(part), (form.x(part), form.half_breadth, form.high[2]))
    ends = deck.ends
    return ends[ends[:, 2].argmax()]
