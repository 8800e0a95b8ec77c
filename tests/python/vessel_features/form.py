# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull as one asks about its form: breadths, bottoms, ends, knuckles and flats of the exact
surface.

Lengths in m, angles in degrees. Where a hull has no such point, answers are NaN.
"""

from functools import cached_property

import hull_native as hn
import numpy as np
import vessels

# Of the hull's size: how far beside the centre plane rays run that look for its contour, so that
# they meet faces and not the border; and what lies in a plane.
_BESIDE, IN_PLANE = 1e-7, 1e-12
# Of the hull's size: what is one place.
SAME = 1e-9
# Of a control edge: how far after a control point one side of a knuckle is looked at.
_AFTER = 1e-6


class Form:
    """The exact surface of a HullData."""

    def __init__(self, data):
        self.data = data
        self.given = data.particulars
        self.surface = vessels.surface_of(data)
        self.mesh = self.surface.mesh
        self.size = self.mesh.size
        points = self.surface.tessellate(4).points
        self.low, self.high = points.min(axis=0), points.max(axis=0)

    @cached_property
    def tree(self):
        return hn.SurfaceTree(self.surface)

    @cached_property
    def knuckles(self):
        """Creases within the surface."""
        return [Knuckle(self, curve) for curve in self.lines if curve.kind == "crease"]

    @cached_property
    def lines(self):
        return hn.crease_curves(self.surface)

    @cached_property
    def afloat(self):
        given = self.given
        body = hn.HullBody(self.surface, mirrored=self.data.half)
        return hn.hydrostatics(
            body,
            draft=given.draft,
            length_pp=given.length_pp,
            beam=given.beam,
            design_draft=given.draft,
        )

    def breadths(self, x, heights):
        """Half breadths of a station: its outermost points at these heights."""
        return self._hits("y", -1.0, x=x, z=heights)

    def inner_breadths(self, x, heights):
        """The same of innermost points: those of a demihull that look to the centre plane."""
        return self._hits("y", 1.0, x=x, z=heights)

    def bottoms(self, x, offsets):
        """Heights of a station's lowest points at these distances from the centre plane."""
        return self._hits("z", 1.0, x=x, y=offsets)

    def stem(self, heights):
        """x of the foremost points of the contour in the centre plane."""
        return self._hits("x", -1.0, y=_BESIDE * self.size, z=heights)

    def stern(self, heights):
        """x of the aftmost points of the contour in the centre plane."""
        return self._hits("x", 1.0, y=_BESIDE * self.size, z=heights)

    def _hits(self, axis, direction, **places):
        """The first points met along an axis from without, at the places on the other two."""
        column = "xyz".index(axis)
        count = max(np.size(place) for place in places.values())
        origins, directions = np.zeros((2, count, 3))
        for letter, place in places.items():
            origins[:, "xyz".index(letter)] = place
        edge = self.high if direction < 0.0 else self.low
        origins[:, column] = edge[column] - direction * 0.01 * self.size
        directions[:, column] = direction
        return self.tree.ray_hits(origins, directions).points[:, column]

    def in_plane(self, normal, offset):
        """Regions of the surface in the plane normal · point = offset; normal of any length."""
        scale = np.linalg.norm(normal)
        plane = np.array([*normal, offset]) / scale
        return hn.flat_regions(self.surface, plane=plane, tolerance=IN_PLANE * self.size)

    def faces_of(self, layer):
        """Faces of the control mesh in a layer, by its name."""
        number = [found.name for found in self.data.layers].index(layer)
        return np.flatnonzero(np.array(self.data.face_layers) == number)

    def cell_faces(self, cells):
        """The control faces that cells lie in."""
        return np.repeat(np.arange(self.mesh.face_count), self.mesh.face_sizes)[cells]

    def points_of(self, faces):
        """Points (k, 3) of the surface all over some faces of the control mesh."""
        cells = np.isin(self.cell_faces(np.arange(self.surface.cell_count)), faces)
        return self.surface.evaluate_grid(8)[0][cells].reshape(-1, 3)

    def on_centre(self, points):
        return np.abs(points[:, 1]) <= SAME * self.size


class Knuckle:
    """A chain of creases. Samples are even over its control edges, both ends included."""

    def __init__(self, form, curve, samples=16):
        self.form, self.curve = form, curve
        self.t = np.linspace(0.0, curve.edge_count, samples * curve.edge_count + 1)
        self.points = curve.evaluate(self.t)[0]

    @cached_property
    def angles(self):
        """Between the tangent planes on both sides, just beside control points: on one, the faces
        of a side may have no tangent plane of their own."""
        t = np.minimum(self.t + _AFTER, self.curve.edge_count - _AFTER)
        left, right = (
            self.form.surface.normals(*side(t)) for side in (self.curve.left, self.curve.right)
        )
        across = np.linalg.norm(np.cross(left, right), axis=1)
        return np.degrees(np.arctan2(across, (left * right).sum(axis=1)))

    @property
    def fades(self):
        """Whether its first and last point are darts: the surface is smooth there and beyond."""
        kinds = self.form.mesh.vertex_kinds[self.curve.vertices[[0, -1]]]
        return tuple(kinds == 1)
