# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface object of a hull follows its surface: points, faces, exact normals, colours; each
only when it is due.

What it shows is known only as long as its mesh is as it was left: who makes it selectable may edit
it, join it or give it another mesh. Then it is made anew, once it is not edited any longer.
"""

import hashlib

import numpy as np

from ...bridge import limits, native
from ...bridge.objects import shown_objects
from . import colours, surface_object

_KEYS = ("shown surface", "normals", "normals left", "colours")
# On the surface object's mesh: what its faces were made for, and a digest of them as they were
# left. They are saved and undone with the mesh.
_FACES, _FACES_LEFT = "hull_faces", "hull_faces_left"
# More corners than these get their normals only when the hull leaves edit mode: the time it takes
# would be felt.
_MOST_AT_A_PAUSE = 200_000


def forget(state):
    """Nothing is known of what a surface object shows, after it changed by itself."""
    for key in _KEYS:
        state.keys.pop(key, None)


def is_as_left(obj, state):
    """Whether the surface object of a hull is as `follow` has left it: points, faces, shading and
    colours; while the hull is edited, at every step of the mouse, points alone."""
    shown = shown_objects.surface_of(obj)
    if shown is None:
        return True
    if "shown surface" not in state.keys or not _has_points_left(shown, state):
        return False
    return obj.mode == "EDIT" or _has_looks_left(shown.data, state)


def _has_points_left(shown, state):
    mesh = shown.data
    if not shown_objects.is_free(shown) or mesh.get(_FACES) != state.keys.get("sharing"):
        return False
    if state.shown_points is None:  # the hull has other faces now: all is made anew
        return True
    left = state.shown_points.coordinates
    points = surface_object.points_of(mesh)
    # By their bits: not even what is no number may differ from itself.
    return points.shape == left.shape and np.array_equal(points.view("i4"), left.view("i4"))


def _has_looks_left(mesh, state):
    if mesh.get(_FACES_LEFT) != surface_object.faces_digest(mesh):
        return False
    left = state.keys.get("normals left")
    if left is not None and left != surface_object.normals_digest(mesh):
        return False
    _, choice = state.keys.get("colours", (None, None))
    return choice is None or colours.has_colours(mesh)


def follow(obj, state, scale, geometry_key):
    """Brings the surface object of a hull up to date with the surface of its HullState.

    While the mesh is edited the exact normals wait for follow_normals, and a surface that is hidden
    in views and renders waits until it is seen. One that is worked on itself waits for the end of
    that.
    """
    shown = shown_objects.surface_of(obj)
    if shown is None:
        state.colour_scale = None
        return
    if shown_objects.is_worked_on(shown):
        forget(state)
        return
    if obj.mode == "EDIT" and shown.hide_render and not shown.visible_get():
        return
    if not _has_points_left(shown, state):
        forget(state)
        shown_objects.set_free(shown)
    choice = colours.wanted(obj.hull.fairness)
    place_key = (geometry_key, samples_of(obj, state), shown.name_full)
    are_normals_due = state.keys.get("normals") != place_key and obj.mode != "EDIT"
    colours_key = (None if choice is None else place_key, choice)
    are_colours_due = state.keys.get("colours") != colours_key
    is_due = state.keys.get("shown surface") != place_key
    if not (is_due or are_normals_due or are_colours_due):
        return
    writer = _Writer(obj, state, shown, scale, geometry_key[0])
    if is_due:
        are_normals_due |= writer.write_points()
        state.keys["shown surface"] = place_key
    if are_normals_due:
        writer.write_normals()
        state.keys["normals"] = place_key
    if are_colours_due:
        state.colour_scale = writer.write_colours(choice)
        state.keys["colours"] = colours_key


def samples_of(obj, state):
    """How many faces along each side of a cell the surface object of a hull has."""
    return limits.samples(obj.hull.samples, state.surface.cell_count, 1 + obj.hull.half)


def follow_normals(obj, state, scale):
    """Gives the surface object its exact normals when the user pauses; large ones wait for the end
    of edit mode."""
    shown = shown_objects.surface_of(obj)
    place_key = state.keys.get("shown surface")
    if shown is None or place_key is None or state.keys.get("normals") == place_key:
        return
    if len(shown.data.loops) > _MOST_AT_A_PAUSE or not _has_points_left(shown, state):
        return
    _Writer(obj, state, shown, scale, place_key[0][0]).write_normals()
    state.keys["normals"] = place_key


class _Writer:
    """Writes the mesh of the object `shown`."""

    def __init__(self, obj, state, shown, scale, topology_key):
        self._settings, self._state, self._shown = obj.hull, state, shown
        self._scale, self._topology_key = scale, topology_key
        self._samples = samples_of(obj, state)
        self._known_tessellation = None

    def write_points(self):
        """Whether the faces were made anew, without normals."""
        is_known = "shown surface" in self._state.keys
        self._state.keys.pop("normals left", None)
        points, mesh = self._points(), self._shown.data
        stamp = self._stamp(points)
        coordinates = points.coordinates
        if mesh.get(_FACES) == stamp and (is_known or self._has_faces_left(mesh, coordinates)):
            surface_object.move_surface(mesh, coordinates)
            return False
        quads, _ = surface_object.surface_faces(self._tessellation(), points.shared)
        surface_object.write_surface(mesh, coordinates, quads)
        mesh[_FACES], mesh[_FACES_LEFT] = stamp, surface_object.faces_digest(mesh)
        return True

    @staticmethod
    def _has_faces_left(mesh, coordinates):
        is_of_size = len(mesh.vertices) == len(coordinates)
        return is_of_size and mesh.get(_FACES_LEFT) == surface_object.faces_digest(mesh)

    def write_normals(self):
        _, normals = surface_object.surface_faces(self._tessellation(), self._points().shared)
        surface_object.write_normals(self._shown.data, normals)
        self._state.keys["normals left"] = surface_object.normals_digest(self._shown.data)

    def write_colours(self, choice):
        """Gives the surface object its colours; returns their scale, or None."""
        if choice is None:
            colours.remove_colours(self._shown)
            return None
        tessellation = self._tessellation()
        scale, of_normals = colours.coloured(self._state.surface, tessellation, choice)
        corners = colours.linear(of_normals)[tessellation.normal_indices]
        shared = self._points().shared
        colours.write_colours(self._shown, surface_object.both_sides(tessellation, shared, corners))
        return scale

    def _points(self):
        """The hull_native.ShownPoints of the surface as it is now."""
        state, settings = self._state, self._settings
        key = (self._samples, settings.half, self._scale)
        if state.shown_points is None or state.keys.get("shown points") != key:
            state.shown_points = native.require().ShownPoints(
                state.surface,
                self._samples,
                mirrored=settings.half,
                metres_per_unit=self._scale,
            )
            state.keys["shown points"] = key
            state.keys["sharing"] = None
        elif not state.shown_points.update():
            state.keys["sharing"] = None
        return state.shown_points

    def _stamp(self, points):
        """Equal for meshes of equal faces; as text, which Blender keeps with the mesh."""
        known = self._state.keys.get("sharing")
        if known is not None:
            return known
        digest = hashlib.blake2b(repr(self._topology_key).encode(), digest_size=16)
        digest.update(repr(self._samples).encode())
        digest.update(points.shared.tobytes())
        self._state.keys["sharing"] = digest.hexdigest()
        return self._state.keys["sharing"]

    def _tessellation(self):
        if self._known_tessellation is None:
            surface = self._state.surface
            self._known_tessellation = surface.tessellate(self._samples)
        return self._known_tessellation
