# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull as it is before a transformation: its surface, body and flotation, and what is kept."""

from dataclasses import dataclass

import numpy as np

from ...bridge import limits, native
from ...bridge.blender import units
from ...bridge.mesh import mesh_points
from ...bridge.objects import hull_mesh
from ..constraints import flats, held_points, move_limits
from ..flotation import afloat, ship
from ..hull import form_before, hull_state

# How steeply sections that are kept may meet those that are shifted.
_LEAST_FADE = 1e-3  # of the length


@dataclass(frozen=True, eq=False)
class Parent:
    """obj: the hull; scale: metres a unit; control: its ControlArrays; surface, body: of these, of
    its own; where: the Afloat. Nothing of it is written before `write`."""

    obj: object
    scale: float
    control: object
    surface: object
    body: object
    where: afloat.Afloat

    @property
    def ends(self):
        """x of the aftmost and the foremost control point, m."""
        x = self.control.points[:, 0]
        return float(x.min()), float(x.max())

    def position(self):
        """Arguments of hull_native's transformations about the water."""
        found = self.where.position()
        if found.pop("heel"):
            raise ValueError("The hull is transformed upright: set the heel to zero first")
        return found

    def limits(self, keeps_ranges=False):
        """hull_native.TransformLimits of limit_arguments."""
        return native.require().TransformLimits(**self.limit_arguments(keeps_ranges))

    def limit_arguments(self, keeps_ranges=False):
        """Arguments of hull_native.TransformLimits: locked points and those of the group that is
        kept stay; flats along the ship and the centre plane hold their points; flats that are raked
        or across the ship, and transoms in planes, move as one. keeps_ranges: control points of the
        ends that are kept stay, too."""
        ids = self.control.vertex_ids
        found = move_limits.of_hull(self.obj, ids, self.control.points)
        locked = [found.locked, self._kept_points()]
        if keeps_ranges:
            locked.append(self._points_of_ranges())
        rigid, holds = [], np.ones(len(found.held_points), dtype=bool)
        for points, plane in flats.flat_planes(self.obj):
            if plane[0] != 0.0:
                rigid.append(np.flatnonzero(np.isin(ids, points)))
                is_in_plane = (found.held_normals == plane[:3]).all(axis=1)
                holds &= ~(np.isin(found.held_points, rigid[-1]) & is_in_plane)
        arguments = found.reshape_arguments(self.surface)
        return {
            **arguments,
            "locked": np.unique(np.concatenate(locked)),
            "held_points": found.held_points[holds],
            "held_normals": found.held_normals[holds],
            "rigid": [*rigid, *native.require().plane_ends(self.surface)],
        }

    def reach_arguments(self, profile, deck, side, ends="stay"):
        """Arguments of hull_native.reach_targets by what control points may do one by one: within
        limit_arguments, and so that the ends that are kept stay. What would move as one stays, or
        with ends="in plane" stays in its plane. profile, deck, side: what stays besides, see
        held_points.of_outline."""
        arguments = self.limit_arguments(keeps_ranges=True)
        points = self.control.points
        rigid = arguments.pop("rigid")
        held = [
            (arguments["held_points"], arguments["held_normals"]),
            held_points.of_outline(self.surface, points, profile, deck, side),
        ]
        if ends == "stay":
            held += [held_points.all_ways(part) for part in rigid]
        else:
            held += [held_points.in_plane(part, points) for part in rigid]
        arguments["held_points"] = np.concatenate([part for part, _ in held])
        arguments["held_normals"] = np.concatenate([normals for _, normals in held])
        return arguments

    def kept_ranges(self):
        """[(aft, forward, fade)] in m of the sections that are kept."""
        settings = self.obj.hull.transform
        aft, forward = self.ends
        length = forward - aft
        fade = max(self._metres(settings.kept_fade) or 0.1 * length, _LEAST_FADE * length)
        kept_aft, kept_fore = self._metres(settings.kept_aft), self._metres(settings.kept_fore)
        found = []
        if kept_aft > 0.0:
            found.append((aft - length, aft + kept_aft, fade))
        if kept_fore > 0.0:
            found.append((forward - kept_fore, forward + length, fade))
        return found

    def _metres(self, value):
        length = units.as_typed(value) * self.scale
        return limits.within(length, "A length in m", 0.0, limits.LONGEST)

    def _kept_points(self):
        """Control points of the vertex group that is kept."""
        name = self.obj.hull.transform.kept_group
        if not name:
            return np.empty(0, dtype=np.int64)
        group = self.obj.vertex_groups.get(name)
        if group is None:
            raise ValueError(f"The vertex group {name} that is kept is not there: choose another")
        return np.flatnonzero(
            np.isin(self.control.vertex_ids, mesh_points.of_group(self.obj.data, group.index))
        )

    def _points_of_ranges(self):
        x = self.control.points[:, 0]
        kept = np.zeros(len(x), dtype=bool)
        for aft, forward, _ in self.kept_ranges():
            kept |= (x >= aft) & (x <= forward)
        return np.flatnonzero(kept)

    def moved_body(self, moves):
        """The hull_native.HullBody with moves (n, 3), m, of its control points; of its own."""
        hull_native, mesh = native.require(), self.surface.mesh
        surface = hull_native.LimitSurface(
            mesh.with_points(mesh.points + moves), self.surface.scheme
        )
        return hull_native.HullBody(
            surface, mirrored=self.body.mirrored, openings=self.body.openings
        )

    def write(self, scene, moves, known=None):
        """Moves the hull's control points by moves (n, 3), m; returns the HullState of what it is
        then. What it was is the form before; known: its marks, see form_before.note."""
        form_before.note(self.obj, self.surface, known)
        return self.moved(scene, moves)

    def moved(self, scene, moves):
        """The same, but the form before is that which it was."""
        moved = np.flatnonzero((moves != 0.0).any(axis=1))
        places = (self.control.points[moved] + moves[moved]) / self.scale
        mesh_points.write(self.obj.data, self.control.vertex_ids[moved], places)
        return hull_state.follow_edit(self.obj, scene, is_by_hand=False).checked()


def of_hull(obj, scene):
    """The Parent of a hull; ValueError with the reason where it has no surface."""
    hull_state.up_to_date(obj, scene)
    scale = units.metres_per_unit(scene)
    found = hull_mesh.read(obj)
    control = found.control(scale)
    source = ship.source_of(found, control)
    surface = source.new_surface()
    where = afloat.afloat(obj.hull, scale)
    return Parent(obj, scale, control, surface, source.new_body(surface), where)


def hydrostatics_of(state, where):
    """The hull_native.Hydrostatics at an Afloat of the hull of a HullState as a Parent has it:
    without its appendages, its own bodies added up."""
    source = state.ship.source
    found = source.own_ship() if source.is_joined else state.ship.as_it_is()
    return found.hydrostatics(where)
