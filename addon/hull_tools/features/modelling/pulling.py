# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface pulled by one of its points: the control points follow, moved as little as possible.

Least is the sum of squares of the control points' moves. Locked points and points of creases and
borders stay; those of flat regions stay in their planes, and those on the centre plane of a half
hull stay there. Only a point that is on a crease, or so near that others would be flung about,
takes the crease with it. With a radius the control points around follow by a falloff.
"""

from dataclasses import dataclass

import numpy as np

from ...bridge import native
from ...bridge.blender import units
from ...bridge.mesh import mesh_points
from ...bridge.mesh.single_rounding import rounded
from ...bridge.objects import hull_mesh
from ..constraints import move_limits
from ..lines import lines

# How many times as far as the surface control points may be moved, to spare creases or at all.
_FAR = 8.0
_UNREACHABLE = (
    "The surface cannot be pulled this way here: control points around are locked, of creases, or "
    "kept flat. Pull along the flat, let creases move, or unlock points"
)
_TOO_FAR = (
    "Control points would move {0:.0f} times as far as the surface: most around are locked, of "
    "creases or kept flat. Pull further away from these, along the flat, or release them"
)


@dataclass(frozen=True, eq=False)
class Grip:
    """A point of the surface that can be pulled: its place, and where it is in m.

    is_image: of the mirror image of a half hull; point (3,) and normal (3,) are there then. plane:
    the normal (3,) of the plane of the section line it is on, or None. indices (k,) Blender's, of
    the control points that count in it, and their weights (k,). moves_creases: whether points of
    creases move with it.
    """

    cell: int
    uv: np.ndarray
    point: np.ndarray
    normal: np.ndarray
    is_image: bool
    plane: object
    controls: np.ndarray
    weights: np.ndarray
    moves_creases: bool


class SurfacePull:
    """A hull's surface as it is, to be pulled. Nothing else may change the mesh meanwhile.

    hold_creases False: creases and borders move as all else. ValueError for a mesh with errors.
    """

    def __init__(self, obj, scene, hold_creases=True):
        hull_native = native.require()
        self.obj, self.is_half = obj, obj.hull.half
        self.scale = units.metres_per_unit(scene)
        found = hull_mesh.read(obj)
        control = found.control(self.scale)
        mesh = hull_native.ControlMesh(*control.arguments())
        self.surface = hull_native.LimitSurface(mesh, found.scheme)
        self._tree = hull_native.SurfaceTree(self.surface)
        self._ids = control.vertex_ids
        self._start = found.data.points.astype(np.float64)
        self._moved = np.empty(0, dtype=np.int64)
        self._is_crease = (mesh.vertex_kinds > 0) & hold_creases
        self._limits = move_limits.of_hull(obj, self._ids, control.points)
        self._moves = self._limits.reshape_arguments(self.surface)
        self._is_locked = np.zeros(len(self._ids), dtype=bool)
        self._is_locked[self._limits.locked] = True
        self._is_free = np.ones((len(self._ids), 3), dtype=bool)
        held, normals = self._limits.held_points, self._limits.held_normals
        np.logical_and.at(self._is_free, held, normals == 0.0)

    # Taking hold

    def grip(self, cell, uv, is_image=False, plane=None):
        """The Grip at a place of the surface."""
        hull_native = native.require()
        uv = np.clip(np.asarray(uv, dtype=np.float64), 0.0, 1.0)
        place = ([int(cell)], uv[None])
        _, controls, weights = hull_native.point_weights(self.surface, *place)
        is_free = ~self._is_locked[controls] & ~self._is_crease[controls]
        squares = (weights[is_free] ** 2).sum()
        largest = np.abs(weights[is_free]).max(initial=0.0)
        point, normal = self.surface.positions(*place)[0], self.surface.normals(*place)[0]
        if is_image:
            point, normal = lines.mirror_image(point), lines.mirror_image(normal)
        return Grip(
            int(cell),
            uv,
            point,
            normal,
            is_image,
            plane,
            controls,
            weights,
            bool(self._is_crease[controls].any() and largest >= _FAR * squares),
        )

    def nearest(self, point):
        """The Grip of the point of the surface that is nearest to a point (3,) in m."""
        point = np.asarray(point, dtype=np.float64)
        is_image = bool(self.is_half and point[1] < 0.0)
        found = self._tree.closest_points((lines.mirror_image(point) if is_image else point)[None])
        return self.grip(found.cells[0], found.uv[0], is_image)

    def hit(self, origin, direction):
        """The Grip where a ray, in m, first meets the surface or its mirror image; None if not."""
        rays = [(origin, direction)]
        if self.is_half:
            rays.append((lines.mirror_image(origin), lines.mirror_image(direction)))
        origins, directions = np.array(rays, dtype=np.float64).transpose(1, 0, 2)
        hits = self._tree.ray_hits(origins, directions)
        first = int(np.argmin(np.where(hits.cells < 0, np.inf, hits.distances)))
        if hits.cells[first] < 0:
            return None
        return self.grip(hits.cells[first], hits.uv[first], is_image=first == 1)

    def across(self, point, axis):
        """The Grip where the line through a point (3,), in m, along the axis 0, 1 or 2 meets the
        surface nearest to the point. ValueError where it does not."""
        origin = np.array(point, dtype=np.float64)
        wanted = origin[axis]
        is_image = bool(self.is_half and wanted < 0.0 and axis == 1) or bool(
            self.is_half and axis != 1 and origin[1] < 0.0
        )
        if is_image:
            origin = lines.mirror_image(origin)
        direction = np.zeros(3)
        direction[axis] = 1.0
        origin[axis] -= abs(wanted) + 10.0 * lines.size_of(self.surface)
        hits = self._tree.all_ray_hits(origin, direction)
        if not len(hits):
            raise ValueError(
                f"The line along {'xyz'[axis]} through this place does not meet the surface: "
                "give another place"
            )
        inside = -wanted if is_image and axis == 1 else wanted
        first = int(np.argmin(np.abs(hits.points[:, axis] - inside)))
        return self.grip(hits.cells[first], hits.uv[first], is_image)

    def on_plane(self, cell, uv, plane):
        """(2,) the place near uv of a cell where the surface is in a plane (4,), normal and
        offset."""
        normal, offset = np.array(plane[:3]), plane[3]
        for _ in range(8):
            point, du, dv = (part[0] for part in self.surface.evaluate([cell], uv[None], 1))
            slope = np.array([normal @ du, normal @ dv])
            square = slope @ slope
            if square == 0.0:
                break
            uv = np.clip(uv + (offset - normal @ point) * slope / square, 0.0, 1.0)
        return uv

    # Pulling

    def smallest_radius(self, grip):
        """The radius, in m, from which on more than the point's own control points follow."""
        points = self.surface.mesh.points[grip.controls]
        point = lines.mirror_image(grip.point) if grip.is_image else grip.point
        return float(np.linalg.norm(points - point, axis=1).max())

    def pull(self, grip, target, radius=0.0):
        """Moves the control points so that the grip's point comes to a target (3,), in m; returns
        how many, and the longest move in m. Those within a radius, in m, follow by a falloff.
        ValueError where they may not: nothing moves then."""
        target = np.asarray(target, dtype=np.float64)
        if grip.is_image:
            target = lines.mirror_image(target)
        locked = self._limits.locked
        if not grip.moves_creases:
            locked = np.union1d(locked, np.flatnonzero(self._is_crease))
        try:
            found = native.require().pull_surface(
                self.surface,
                [grip.cell],
                grip.uv[None],
                target[None],
                radius=radius,
                mirrored=self.is_half,
                **{**self._moves, "locked": locked},
            )
        except ValueError as error:
            raise ValueError(_UNREACHABLE) from error
        if found.reach > _FAR:
            raise ValueError(_TOO_FAR.format(found.reach))
        controls = found.points
        places = self._start[self._ids[controls]] + found.moves / self.scale
        weights = np.zeros(len(self._ids))
        weights[grip.controls] = grip.weights
        self._write(self._ids[controls], rounded(places, weights[controls], self._free(controls)))
        longest = float(np.linalg.norm(found.moves, axis=1).max(initial=0.0))
        return len(controls), longest

    def _free(self, controls):
        return self._is_free[controls]

    def restore(self):
        """Puts all control points where they were."""
        self._write(np.empty(0, dtype=np.int64), np.empty((0, 3)))

    def _write(self, indices, places):
        """Moves these points (k,) of the mesh to (k, 3), and others that were moved back."""
        everything = np.union1d(self._moved, indices).astype(np.int64)
        if not len(everything):
            return
        points = self._start[everything]
        points[np.searchsorted(everything, indices)] = places
        mesh_points.write(self.obj.data, everything, points)
        self._moved = np.asarray(indices, dtype=np.int64)
