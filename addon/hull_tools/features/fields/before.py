# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull that is previewed as it was before: its lines as a ghost, its sectional areas beside those
of now, its hydrostatics to be compared with. They do not change while fields do."""

from dataclasses import dataclass, field, replace

from ...bridge.blender import preferences, units
from ..curves_of_form import beside, sectional_areas
from ..flotation import afloat, hydrostatics, ship
from ..hull import hull_state
from ..variants import ghost_lines
from . import preview

_ANALYSIS, _WHOSE, _NAME = "sectional_areas", "fields", "Before"


@dataclass
class Before:
    """Of one hull. lines: its ghost, empty where none is shown; values:
    hydrostatics.HydrostaticValues as the hull lies in the water now, or None."""

    lines: ghost_lines.GhostLines = field(default_factory=ghost_lines.GhostLines)
    values: object = None
    _ship: object = None
    _key: tuple = None  # of the surface, how it lies in the water, and what is joined to it
    _own: object = None  # the surface that the ships are of
    _ships: dict = field(default_factory=dict)  # by what is joined
    _area_key: tuple = None

    def follow(self, obj, state, own, scale):
        """Brings all up to date with the prepared.Prepared of before, None without a preview."""
        if own is None:
            self.values = self._ship = self._key = self._own = None
            self._ships = {}
        else:
            self._follow_numbers(own, state.ship, _where(obj.hull, scale))
        self._follow_lines(obj.hull, own, scale)
        self._follow_areas(obj, state)

    def _follow_lines(self, settings, own, scale):
        if own is None or not settings.fields.show_before:
            self.lines.clear()
            return
        try:
            self.lines.follow(settings, own.surface, own.key, own.is_half, scale)
        except ValueError:  # no places for lines, which the hull's own lines tell
            self.lines.clear()

    def _follow_numbers(self, own, now, where):
        """now: the live_ship.LiveShip, whose openings and appendages it has, so that what differs
        is the fields' alone."""
        like = now.source or own.source
        joined = like.appendages and now.appendages_key
        what = (like.openings, like.deck_edge, like.once, joined)
        key = (own.key, where, what)
        if self._key == key:
            return
        self._key, self.values = key, None
        source = replace(
            own.source,
            openings=like.openings,
            deck_edge=like.deck_edge,
            appendages=like.appendages,
            once=like.once,
        )
        try:
            self._ship = self._ship_of(source, own.surface, what)
            if where is not None:
                self.values = hydrostatics.at(self._ship, where)
        except ValueError:
            pass  # it does not float so, which the panel tells of the hull itself

    def _ship_of(self, source, surface, key):
        """While points move appendages are left out, and joined again when they rest: both ships
        are kept."""
        if self._own is not surface:
            self._own, self._ships = surface, {}
        if key not in self._ships:
            body = source.new_body(surface, tolerance=ship.LIVE)
            while len(self._ships) > 1:
                self._ships.pop(next(iter(self._ships)))
            self._ships[key] = ship.Ship(body, source.deck_edge)
        return self._ships[key]

    def _follow_areas(self, obj, state):
        is_wanted = self.values is not None and obj.hull.plots.sectional_areas
        key = self._key if is_wanted else None
        if key == self._area_key:
            return
        self._area_key, curve = key, None
        if key is not None:
            found = sectional_areas.compute(self._ship, key[1]).areas
            colour = preferences.colour("ghost", "ghost")
            curve = beside.Curve(_NAME, found.positions, found.areas, colour=colour)
        state.of(beside.Beside).put(_ANALYSIS, _WHOSE, curve)


def of_hull(obj):
    """The Before of a hull of which something is known, else None."""
    return hull_state.known(obj, Before)


def changes(obj):
    """[(name, how much it changes by the fields, as text)] of a hull that is previewed; [] where
    that is not known."""
    known, state = of_hull(obj), hull_state.state_of(obj)
    if known is None or known.values is None or state.hydrostatics.values is None:
        return []
    was, now = known.values, state.hydrostatics.values
    part = 100.0 * (now.displacement_t / was.displacement_t - 1.0)
    return [
        ("Displacement by", f"{part:+.2f} %"),
        ("LCB by", f"{1e3 * (now.lcb - was.lcb):+.0f} mm"),
    ]


def follow(obj, scene):
    """Brings what is known of a hull before its preview up to date."""
    state = hull_state.state_of(obj)
    if state is None:
        return
    found = preview.of_hull(obj)
    scale = units.metres_per_unit(scene)
    state.of(Before).follow(obj, state, None if found is None else found.own, scale)


def _where(settings, scale):
    """The afloat.Afloat of an Object.hull; None for what no ship has."""
    try:
        return afloat.afloat(settings, scale)
    except ValueError:
        return None
