# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a hull's particulars can be those of its surface, and taking them from it."""

from types import SimpleNamespace

from ....hull_io import plausibility
from ...bridge.blender import units
from ...bridge.blender.units import as_typed

# Points along each side of a cell, from which the extents of the surface are told.
_POINTS = 4
_GIVEN = ("length_pp", "beam", "draft")


def update(obj, state, scale):
    """Brings the doubts of a HullState up to date; extents wait while the mesh is edited."""
    geometry = state.keys.get("geometry")
    if state.keys.get("extents") != geometry and (obj.mode != "EDIT" or state.extents is None):
        points = state.surface.tessellate(_POINTS).points
        state.extents = plausibility.extents(points)
        state.keys["extents"] = geometry
    settings, found = obj.hull, state.hydrostatics
    given = SimpleNamespace(**{name: as_typed(getattr(settings, name)) * scale for name in _GIVEN})
    is_upright = found is not None and found.trim_m == 0.0 and found.heel == 0.0
    coefficients = (found.project_block, found.project_midship) if is_upright else (None, None)
    state.doubts = plausibility.doubts(given, settings.half, state.extents, *coefficients)


def take_from_surface(obj, state, scene, names):
    """Gives a hull the particulars of these names that its surface has; returns them, {name: m}."""
    values = plausibility.taken(names, obj.hull.half, state.extents)
    for name, value in values.items():
        setattr(obj.hull, name, value / units.metres_per_unit(scene))
    return values
