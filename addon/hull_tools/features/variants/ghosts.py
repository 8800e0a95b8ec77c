# SPDX-License-Identifier: GPL-3.0-or-later
"""The other hull's lines behind a hull's own: at the same places, with its knuckles and borders.

They are of the other hull and of the places of lines alone, so that nothing is computed while
points of the hull are moved: at a pause it is looked whether they are still those.
"""

from dataclasses import dataclass, field
from types import SimpleNamespace

from ...bridge import native
from ...bridge.blender import units
from ...bridge.mesh import moves
from ..curves_of_form import beside, sectional_areas
from ..flotation import ship
from ..hull import hull_state
from ..lines import lines
from . import afloat, other_hull

_ANALYSIS, _WHOSE = "sectional_areas", "ghost"


@dataclass
class Ghost:
    """Of one hull. groups: lines.Group by kind, empty where no ghost is shown; status: why it is
    not shown though it is wanted, or ""."""

    groups: dict = field(default_factory=dict)
    status: str = ""
    _surface_key: tuple = None
    _surface: object = None
    _body: object = None
    _area_key: tuple = None

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
        self.groups, self._surface_key, self._surface, self._body = {}, None, None, None

    def _follow_lines(self, obj, other, scale):
        if self._surface_key != other.key:
            self._surface, self._body = other.source.new_surface(), None
            self._surface_key = other.key
        cuts = _cuts(obj.hull, self._surface, other.source.half, scale)
        watch = moves.Moves(None, other.key, native.require().MoveWatch(self._surface))
        self.groups = _unless_same(
            self.groups, lines.groups(self.groups, self._surface, cuts, other.source.half, watch)
        )

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
        return beside.Curve(other.name, found.positions, found.areas)


def _unless_same(before, groups):
    """The groups of before where these are they: what is drawn stays on the graphics card."""
    is_same = before.keys() == groups.keys() and all(groups[k] is before[k] for k in groups)
    return before if is_same else groups


def _cuts(settings, surface, half, scale):
    """Of the kinds that the hull shows, and the outlines, as far as the other hull reaches."""
    kinds = [k for k in lines.KINDS if getattr(settings.lines, lines.SWITCHES[k]) and k != "flat"]
    if "feature" not in kinds:
        kinds.append("feature")
    places = SimpleNamespace(
        lines=settings.lines, length_pp=settings.length_pp, draft=settings.draft, half=half
    )
    return lines.cuts_of_kinds(places, surface.mesh.points, scale, kinds)


def follow(obj, scene):
    """Brings the ghost of a hull up to date; returns the Ghost."""
    state = hull_state.state_of(obj) or hull_state.refresh(obj, scene)
    ghost = state.of(Ghost)
    ghost.follow(obj, scene, state)
    return ghost
