# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines of a hull that are shown, which follow its edits."""

from dataclasses import dataclass, field

from . import lines


@dataclass
class LiveLines:
    """groups: lines.Group by kind; status: why they are not up to date, or ""."""

    groups: dict = field(default_factory=dict)
    status: str = ""

    def follow(self, settings, ship, scale):
        """Brings the lines up to date with an Object.hull and a flotation.live_ship.LiveShip."""
        try:
            wanted = lines.wanted_cuts(settings, ship.surface.mesh.points, scale)
            self.groups = lines.groups(self.groups, ship.surface, wanted, settings.half, ship.moved)
            self.status = ""
        except ValueError as error:
            self.status = str(error)
