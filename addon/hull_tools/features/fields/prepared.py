# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull as shape fields find it: all that is computed once, whatever becomes of the fields."""

from dataclasses import dataclass

import numpy as np

from ...bridge import native
from ..constraints import move_limits
from ..flotation import ship


@dataclass(eq=False)
class Ground:
    """A hull that fields are on. scale: metres a unit; control: mesh_arrays.ControlArrays, surface:
    of these."""

    scale: float
    control: object
    surface: object
    is_half: bool


@dataclass(eq=False)
class Prepared(Ground):
    """key: equal for hulls of which all this is the same. places: the hull_native.SurfacePlaces
    where shifts are wanted, and field_places: the same for fields; limits: of moves, as arguments
    of hull_native.Reshape."""

    key: tuple
    places: object
    field_places: object
    limits: dict
    _reshape: tuple = (None, None)  # what stays, as bytes, and the hull_native.Reshape with that
    _net: object = None

    def net(self):
        """The hull_native.GeodesicNet of the surface, both sides of it; made when it is asked
        for."""
        if self._net is None:
            self._net = native.require().GeodesicNet(self.surface, mirrored=self.is_half)
        return self._net

    def reshape(self, staying):
        """The hull_native.Reshape by which these control points (k,) stay, besides the limits."""
        locked = np.union1d(self.limits["locked"], staying)
        if self._reshape[0] != locked.tobytes():
            reshape = native.require().Reshape(
                self.surface, **{**self.limits, "locked": locked}, places=self.places
            )
            self._reshape = (locked.tobytes(), reshape)
        return self._reshape[1]


def of_hull(obj, found, scale, before=None):
    """The Prepared of a hull's hull_mesh.HullMesh, `before` where that is still it. ValueError
    with the reason where the hull has no surface."""
    control = found.control(scale)
    size = float(np.ptp(control.points, axis=0).max(initial=0.0))
    allowed = move_limits.of_hull(obj, control.vertex_ids, control.points, size)
    held = allowed.held_points.tobytes(), allowed.held_normals.tobytes()
    key = (found.topology_key, found.points_digest, scale, allowed.locked.tobytes(), *held)
    if before is not None and before.key == key:
        return before
    hull_native, surface = native.require(), ship.source_of(found, control).new_surface()
    places = hull_native.SurfacePlaces(surface)
    return Prepared(
        scale,
        control,
        surface,
        found.half,
        key,
        places,
        hull_native.FieldPlaces(places.positions),
        allowed.reshape_arguments(surface),
    )
