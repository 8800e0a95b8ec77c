# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a hull's particulars can be those of its surface, and taking them from it."""

from dataclasses import dataclass, field
from types import SimpleNamespace

from ....hull_io import plausibility
from ...bridge.blender import units
from ...bridge.blender.units import as_typed

# Points along each side of a cell, from which the extents of the surface are told.
_POINTS = 4
_GIVEN = ("length_pp", "beam", "draft")


@dataclass
class Plausible:
    """extents: hull_io.plausibility's of the surface, which wait while the mesh is edited; doubts:
    its Doubts."""

    extents: object = None
    doubts: list = field(default_factory=list)
    _key: tuple = None

    def follow(self, obj, ship, found, scale):
        """Brings all up to date with a hull, its live_ship.LiveShip and
        hydrostatics.HydrostaticValues, or None."""
        geometry = ship.geometry_key
        if self._key != geometry and (obj.mode != "EDIT" or self.extents is None):
            self.extents = _extents(ship)
            self._key = geometry
        settings = obj.hull
        given = {name: as_typed(getattr(settings, name)) * scale for name in _GIVEN}
        is_upright = found is not None and found.trim_m == 0.0 and found.heel == 0.0
        names = ("project_block", "project_midship", "waterline_length")
        numbers = [getattr(found, name) for name in names] if is_upright else []
        self.doubts = plausibility.doubts(
            SimpleNamespace(**given), settings.half, self.extents, *numbers
        )


def _extents(ship):
    return plausibility.extents(ship.surface.tessellate(_POINTS).points)


def take_from_surface(obj, state, scene, names):
    """Gives a hull the particulars of these names that its surface has; returns them, {name: m}."""
    # Those that doubts go by are of before edit mode.
    values = plausibility.taken(names, obj.hull.half, _extents(state.ship))
    for name, value in values.items():
        setattr(obj.hull, name, value / units.metres_per_unit(scene))
    return values
