# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines of another surface at the places of a hull's own: stations, waterlines … that the hull
shows, with knuckles and borders."""

from dataclasses import dataclass, field
from types import SimpleNamespace

from ...bridge.mesh import moves
from ..lines import lines


@dataclass
class GhostLines:
    """groups: lines.Group by kind; the same object while they are the same, so that what is drawn
    stays on the graphics card."""

    groups: dict = field(default_factory=dict)
    _moved: object = None

    def clear(self):
        self.groups, self._moved = {}, None

    def follow(self, settings, surface, key, is_half, scale):
        """Brings them up to date with a hull_native.LimitSurface at the places of an Object.hull.
        key: equal for surfaces that are the same; scale: metres a unit."""
        if self._moved is None or self._moved.after != key:
            self._moved = moves.Moves.of(surface, key)
        cuts = _cuts(settings, surface, is_half, scale)
        found, known = lines.groups(self.groups, surface, cuts, is_half, self._moved), self.groups
        if known.keys() != found.keys() or any(found[kind] is not known[kind] for kind in found):
            self.groups = found


def _cuts(settings, surface, is_half, scale):
    """Of the kinds that the hull shows, and the outlines, as far as the surface reaches."""
    kinds = [k for k in lines.KINDS if getattr(settings.lines, lines.SWITCHES[k]) and k != "flat"]
    if "feature" not in kinds:
        kinds.append("feature")
    places = SimpleNamespace(
        lines=settings.lines, length_pp=settings.length_pp, draft=settings.draft, half=is_half
    )
    return lines.cuts_of_kinds(places, surface.mesh.points, scale, kinds)
