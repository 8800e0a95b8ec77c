# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the patches of a conversion are worst, to be looked at in the 3D view."""

from dataclasses import dataclass

import numpy as np
from mathutils import Vector

from ...bridge.blender import units, view_target
from ..hull import hull_state
from . import conversions

# Of the hull's length: how far the view is from a spot.
_VIEW_DISTANCE = 0.1

KINDS = {
    "DISTANCE": ("Distance", "Where the patches are furthest from the surface"),
    "ANGLE": ("Seam angle", "Where the normals of neighbouring patches differ most"),
    "CURVATURE": (
        "Curvature jump",
        "Where the curvature of neighbouring patches differs most and that of the surface does not",
    ),
}


@dataclass
class Marked:
    """Which of KINDS is marked on a hull in the 3D view, or ""."""

    kind: str = ""


def marked(state):
    """The Marked of a HullState."""
    return state.of(Marked)


def shown_spot(hull, scene):
    """(place (3,) in the world, text) of the spot that is marked on a hull, or None."""
    state = hull_state.state_of(hull)
    kind = "" if state is None else marked(state).kind
    if not kind or not is_known(state, kind):
        return None
    text = _label(_quality(state), kind)
    is_current = conversions.last_outcome(hull)[1]
    return _place(hull, scene, state), text if is_current else f"{text} before the last change"


def show(hull, scene, kind):
    """Marks one of KINDS, or with "" none. ValueError when there is no such spot."""
    state = hull_state.state_of(hull)
    if state is None or _quality(state) is None:
        raise ValueError("There is no report of this hull: press Convert first")
    if kind and not is_known(state, kind):
        raise ValueError(f"{KINDS[kind][0]}: all borders of patches are knuckles")
    marked(state).kind = kind
    if kind:
        scene.cursor.location = _place(hull, scene, state)


def look_at(hull, scene, view):
    """Brings the marked spot into the middle of a RegionView3D, near enough to see it."""
    state = hull_state.state_of(hull)
    view_target.look_at(view, _place(hull, scene, state))
    view.view_distance = _VIEW_DISTANCE * _quality(state).length / units.metres_per_unit(scene)


def is_known(state, kind):
    """Whether the last conversion of a HullState has a spot of this kind."""
    return _quality(state) is not None and bool(np.isfinite(_point(_quality(state), kind)).all())


def _point(quality, kind):
    points = {
        "DISTANCE": quality.worst_point,
        "ANGLE": quality.worst_seam_point,
        "CURVATURE": quality.worst_curvature_point,
    }
    return points[kind]


def _quality(state):
    outcome = state.of(conversions.OfHull).outcome
    return None if outcome is None or outcome.converted is None else outcome.converted.quality


def _place(hull, scene, state):
    point = Vector(_point(_quality(state), marked(state).kind))
    return hull.matrix_world @ (point / units.metres_per_unit(scene))


def _label(quality, kind):
    values = {
        "DISTANCE": units.format_mm(quality.largest_distance),
        "ANGLE": units.format_small_angle(quality.largest_seam_angle),
        "CURVATURE": units.format_jump(quality.largest_curvature_jump),
    }
    return f"{KINDS[kind][0]} {values[kind]}"
