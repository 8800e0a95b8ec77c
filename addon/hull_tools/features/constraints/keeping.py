# SPDX-License-Identifier: GPL-3.0-or-later
"""What holds while a hull's points are moved, put into effect in its mesh: flats stay flat, kept
points in their stations, waterlines and buttocks, the border of a half hull on the centre plane,
tied points where others say, and developable regions developable.

This comes first after an edit, and is the one step of what follows it that writes the mesh.
"""

from dataclasses import dataclass, field

from ...bridge.counts import counted_are
from ...bridge.objects import hull_mesh
from . import centre_keeping, developable_keeping, flat_keeping, plane_keeping, tie_keeping

_IN_FLATS = "Points stay in their flats: Release under Shape frees them."
_IN_PLANES = (
    "Points stay in their stations, waterlines or buttocks: Free under Edges and Points lets them "
    "go."
)
_CONTRADICTED = (
    "{} kept in a plane that does not meet their flat, which counts: free them, or release the "
    "flat."
)
_ON_CENTRE = "Points stay on the centre plane: Keep on centre, switched off, frees them."


@dataclass
class Keeping:
    """flats, planes, ties: what flat_keeping, plane_keeping and tie_keeping have seen of the hull.
    regions: the same of developable_keeping.
    held: what points were kept from in the last edit that moved any, for the user, or ""."""

    flats: flat_keeping.Memory = field(default_factory=flat_keeping.Memory)
    planes: plane_keeping.Memory = field(default_factory=plane_keeping.Memory)
    ties: tie_keeping.Memory = field(default_factory=tie_keeping.Memory)
    regions: developable_keeping.Memory = field(default_factory=developable_keeping.Memory)
    held: str = ""
    _held_at: tuple = ()

    def keep(self, obj, before, is_by_hand=True):
        """Brings points back that may not leave their place; returns the HullMesh with them there.

        before: the flotation.live_ship.LiveShip of the hull as it was. is_by_hand: points were
        dragged; those that undo or numbers have placed may leave the centre plane, and their
        stations, waterlines and buttocks go along with them.
        """
        tie_keeping.lead(obj, self.ties, is_by_hand)
        held = [_IN_FLATS] if flat_keeping.keep(obj, self.flats) else []
        found = hull_mesh.read(obj)
        kept = plane_keeping.kept(obj, found.data, self.planes, is_by_hand)
        if kept is not found.data:
            found = found.with_points(kept)
            held.append(_IN_PLANES)
        if self.planes.contradicted:
            held.append(_CONTRADICTED.format(counted_are(self.planes.contradicted, "point")))
        if is_by_hand and _keeps_centre(obj, found, before):
            control, mesh = before.source.control, before.surface.mesh
            kept = centre_keeping.kept(obj, found.data, control, mesh)
            if kept is not found.data:
                found = found.with_points(kept)
                held.append(_ON_CENTRE)
        kept = tie_keeping.kept(obj, found.data, self.ties, is_by_hand)
        if kept is not found.data:
            found = found.with_points(kept)
            self.planes.points = kept.points
        held += self.ties.told
        kept = developable_keeping.kept(obj, found, self.regions, before, is_by_hand)
        if kept is not found.data:
            found = found.with_points(kept)
            self.planes.points = kept.points
        held += self.regions.told
        self._tell(held, (found.topology, found.points_digest))
        return found

    def _tell(self, held, geometry):
        if held or geometry != self._held_at:
            self.held, self._held_at = " ".join(held), geometry


def _keeps_centre(obj, found, before):
    return (
        found.half
        and obj.hull.keep_centre
        and obj.data.is_editmode
        and before.surface is not None
        and before.topology_key == found.topology_key
    )
