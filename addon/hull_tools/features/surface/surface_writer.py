# SPDX-License-Identifier: GPL-3.0-or-later
"""What writes a surface object's mesh: points, faces, exact normals, colours."""

from ...bridge import native
from . import colours, surface_mesh

# On the surface object's mesh: what its faces were made for, and a digest of them as they were
# left. They are saved and undone with the mesh.
FACES, FACES_LEFT = "hull_faces", "hull_faces_left"


class SurfaceWriter:
    """Writes the mesh of the object `shown`: hull_native.ShownPoints of a surface, with faces of
    which the stamp tells, and what goes with them."""

    def __init__(self, shown, surface, samples, points, stamp):
        self._shown, self._surface, self._samples = shown, surface, samples
        self._points, self._stamp = points, stamp
        self._known_tessellation = None

    def write_points(self, is_known):
        """Whether the faces were made anew, without normals. is_known: the object shows what it was
        left with."""
        mesh, coordinates = self._shown.data, self._points.coordinates
        has_faces = mesh.get(FACES) == self._stamp
        if has_faces and (is_known or self._has_faces_left(mesh, coordinates)):
            surface_mesh.move_surface(mesh, coordinates)
            return False
        quads, _ = surface_mesh.surface_faces(self._tessellation(), self._points.shared)
        surface_mesh.write_surface(mesh, coordinates, quads)
        mesh[FACES], mesh[FACES_LEFT] = self._stamp, surface_mesh.faces_digest(mesh)
        return True

    @staticmethod
    def _has_faces_left(mesh, coordinates):
        is_of_size = len(mesh.vertices) == len(coordinates)
        return is_of_size and mesh.get(FACES_LEFT) == surface_mesh.faces_digest(mesh)

    def write_normals(self):
        """Returns a digest of the normals as Blender keeps them."""
        _, normals = surface_mesh.surface_faces(self._tessellation(), self._points.shared)
        surface_mesh.write_normals(self._shown.data, normals)
        return surface_mesh.normals_digest(self._shown.data)

    def distances(self, field):
        """hull_native.SurfaceDistances from a hull_native.DistanceField."""
        return native.require().surface_distances(self._surface, self._tessellation(), field)

    def write_colours(self, choice, values=None):
        """Gives the surface object its colours; returns their scale, or None. values: distances."""
        if choice is None:
            colours.remove_colours(self._shown)
            return None
        tessellation = self._tessellation()
        scale, of_normals = colours.coloured(self._surface, tessellation, choice, values)
        corners = colours.linear(of_normals)[tessellation.normal_indices]
        shared = self._points.shared
        colours.write_colours(self._shown, surface_mesh.both_sides(tessellation, shared, corners))
        return scale

    def _tessellation(self):
        if self._known_tessellation is None:
            self._known_tessellation = self._surface.tessellate(self._samples)
        return self._known_tessellation
