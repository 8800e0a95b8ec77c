# SPDX-License-Identifier: GPL-3.0-or-later
"""The hydrostatics of a hull at its draft, trim and heel, which follow its edits."""

from dataclasses import dataclass

from . import afloat, hydrostatics


@dataclass
class LiveHydrostatics:
    """values: hydrostatics.HydrostaticValues or None, and then status says why."""

    values: object = None
    status: str = ""
    _key: tuple = None

    def follow(self, settings, ship, scale):
        """Brings the values up to date with an Object.hull and a live_ship.LiveShip."""
        key = None
        try:
            where = afloat.afloat(settings, scale)
            key = (ship.key, where)
            if self._key == key:
                return
            self.values, self.status = hydrostatics.at(ship.as_it_is(), where), ""
        except ValueError as error:
            self.values, self.status = None, str(error)
        self._key = key
