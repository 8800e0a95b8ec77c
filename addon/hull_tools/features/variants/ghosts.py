# SPDX-License-Identifier: GPL-3.0-or-later
"""The other hull's lines behind a hull's own: at the same places, with its knuckles and borders.

They are of the other hull and of the places of lines alone, so that nothing is computed while
points of the hull are moved: at a pause it is looked whether they are still those.
"""

from dataclasses import dataclass, field

from ...bridge.blender import preferences, units
from ..curves_of_form import beside, sectional_areas
from ..flotation import ship
from ..hull import hull_state
from . import afloat, ghost_lines, other_hull

_ANALYSIS, _WHOSE = "sectional_areas", "ghost"


@dataclass
class Ghost:
    """Of one hull. status: why no ghost is shown though it is wanted, or ""."""

    status: str = ""
    _lines: ghost_lines.GhostLines = field(default_factory=ghost_lines.GhostLines)
    _surface_key: tuple = None
    _surface: object = None
    _body: object = None
    _area_key: tuple = None

    @property
    def groups(self):
        """lines.Group by kind, empty where no ghost is shown."""
        return self._lines.groups

    def follow(self, obj, scene, state):
        """Brings ghost and curve up to date; returns whether anything is another."""
        before, scale = (self.groups, self.status), units.metres_per_unit(scene)
        try:
            wanted = other_hull.of(obj, scale) if obj.hull.variants.show_ghost else None
            if wanted is None:
                self._clear()
            else:
                self._follow_lines(obj, wanted, scale)
            self.status = ""
        except ValueError as error:
            wanted = None
            self._clear()
            self.status = str(error)
        has_other_curve = self._follow_areas(obj, wanted, state, scale)
        return has_other_curve or (self.groups, self.status) != before

    def _clear(self):
        self._lines.clear()
        self._surface_key = self._surface = self._body = None

    def _follow_lines(self, obj, other, scale):
        if self._surface_key != other.key:
            self._surface, self._body = other.source.new_surface(), None
            self._surface_key = other.key
        self._lines.follow(obj.hull, self._surface, other.key, other.source.half, scale)

    def _follow_areas(self, obj, other, state, scale):
        curves = state.of(beside.Beside)
        key = where = None
        if other is not None and obj.hull.plots.sectional_areas:
            try:
                where = afloat.of_other(obj, scale)
                key = other.name, other.key, where
            except ValueError:
                pass  # no ship lies so; the table of differences says why
        if self._area_key == key:
            return False
        self._area_key = key
        curves.put(_ANALYSIS, _WHOSE, None if key is None else self._areas(other, where))
        return True

    def _areas(self, other, where):
        if self._body is None:
            self._body = other.source.live_body(self._surface)
        try:
            found = sectional_areas.compute(ship.Ship(self._body, ()), where).areas
        except ValueError:
            return None  # it is not afloat there; the table of differences says why
        colour = preferences.colour("ghost", "ghost")
        return beside.Curve(other.name, found.positions, found.areas, colour=colour)


def follow(obj, scene):
    """Brings the ghost of a hull up to date; returns the Ghost."""
    state = hull_state.state_of(obj) or hull_state.refresh(obj, scene)
    ghost = state.of(Ghost)
    ghost.follow(obj, scene, state)
    return ghost
