# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull as shape fields find it: all that is computed once, whatever becomes of the fields."""

from dataclasses import dataclass

import numpy as np

from ...bridge import limits, native
from ...bridge.mesh import mesh_check
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
    """key: equal for hulls of which all this is the same. source: the flotation.ship.ShipSource of
    the surface. places: the hull_native.SurfacePlaces
    where shifts are wanted, and field_places: the same for fields; limits: of moves, as arguments
    of hull_native.Reshape."""

    key: tuple
    source: object
    places: object
    field_places: object
    limits: dict
    _reshape: tuple = (None, None)  # what stays and leads, and the hull_native.Reshape with that
    _net: object = None

    def net(self):
        """The hull_native.GeodesicNet of the surface, both sides of it; made when it is asked
        for."""
        if self._net is None:
            self._net = native.require().GeodesicNet(self.surface, mirrored=self.is_half)
        return self._net

    def reshape(self, staying, leading):
        """The hull_native.Reshape by which, besides the limits, these control points (k,) stay, and
        those (p,) move as told."""
        locked = np.union1d(self.limits["locked"], staying)
        key = (locked.tobytes(), leading.tobytes())
        if self._reshape[0] != key:
            limits = {**self.limits, "locked": locked, "prescribed": leading}
            reshape = native.require().Reshape(self.surface, **limits, places=self.places)
            self._reshape = (key, reshape)
        return self._reshape[1]


def of_hull(obj, found, scale, before=None):
    """The Prepared of a hull's hull_mesh.HullMesh, `before` where that is still it. ValueError
    with the reason where the hull has no surface."""
    control = found.control(scale)
    has_faces_of_before = before is not None and before.key[0] == found.topology_key
    if not has_faces_of_before:
        _check(found, control)
    allowed = move_limits.of_hull(obj, control.vertex_ids, control.points)
    key = (found.topology_key, found.points_digest, scale, allowed.key())
    if has_faces_of_before:
        if before.key == key:
            return before
        _check(found, control)
    hull_native, source = native.require(), ship.source_of(found, control)
    surface = source.new_surface()
    places = hull_native.SurfacePlaces(surface)
    return Prepared(
        scale,
        control,
        surface,
        found.half,
        key,
        source,
        places,
        hull_native.FieldPlaces(places.positions),
        allowed.reshape_arguments(surface),
    )


def _check(found, control):
    count, most = len(control.points), limits.MOST_FIELD_POINTS
    if count > most:
        raise ValueError(
            f"The hull has {count} control points, and fields take {most} at most: take a coarser "
            "mesh of it, by Un-Subdivide where it was subdivided"
        )
    check, mesh = mesh_check.check_control_mesh(found.data, control, found.half)
    if mesh is None:
        raise ValueError(check.errors[0].message)
