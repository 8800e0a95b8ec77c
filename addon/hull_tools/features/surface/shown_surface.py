# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface object of a hull follows its surface: points, faces, exact normals, colours; each
only when it is due.

What it shows is known only as long as its mesh is as it was left: who makes it selectable may edit
it, join it or give it another mesh. Then it is made anew, once it is not edited any longer.
"""

import hashlib
from dataclasses import dataclass

import numpy as np

from ...bridge import limits, native
from ...bridge.objects import shown_objects
from . import colours, surface_mesh, surface_writer

# More corners than these get their normals only when the hull does not move any longer: the time it
# takes would be felt.
_MOST_AT_A_PAUSE = 200_000


def samples_of(obj, surface):
    """How many faces along each side of a cell the surface object of a hull has: fewer where it has
    to follow each step of the mouse."""
    most = limits.MOST_MOVING_FACES if may_move(obj) else limits.MOST_SHOWN_FACES
    return _samples(obj, surface, most)


def _samples(obj, surface, most_faces):
    return limits.samples(obj.hull.samples, surface.cell_count, 1 + obj.hull.half, most_faces)


def may_move(obj):
    """Whether a hull may be another one at each step of the mouse: in edit mode, and while its
    shape fields are previewed."""
    return obj.mode == "EDIT" or obj.hull.fields.is_previewed


@dataclass
class _Left:
    """What the surface object shows, by what it was made from; None what is not known.

    place, normals: (key of the surface, samples, name of the object) that points and normals are
    of. normals_digest: of the normals as they were written, None where there are none since the
    faces were. colours: (place or None, choice).
    """

    place: tuple = None
    normals: tuple = None
    normals_digest: str = None
    colours: tuple = None


class ShownSurface:
    """points: the hull_native.ShownPoints of the surface, None before they are shown. colour_scale:
    the hull_native.ColourScale of the surface object's colours, None when it has none.
    colour_field: what they are of, which the setting may have left while the mesh has errors.
    other: the distances.OtherSurface that distances are from, None while none is wanted; distances:
    the hull_native.SurfaceDistances that are shown, or None. is_sliding: whether a slider moves the
    hull, so that it may be another one at each step of the mouse in object mode too."""

    def __init__(self):
        self.points = None
        self.colour_scale = None
        self.colour_field = ""
        self.other = self.distances = None
        self.is_sliding = False
        self._surface = None
        self._points_key = None
        self._stamp = None  # of the faces of `points`, see surface_writer
        self._left = _Left()
        self._are_looks_unseen = False  # the mesh was changed while its points alone were looked at

    def forget(self):
        """Nothing is known of what the surface object shows, after it changed by itself."""
        self._left = _Left()

    @property
    def is_known(self):
        """Whether anything is known of what the surface object shows."""
        return self._left.place is not None

    def is_as_left(self, obj):
        """Whether the surface object of a hull is as `follow` has left it: points, faces, shading
        and colours; while the hull may move, at every step of the mouse, points alone."""
        shown = shown_objects.surface_of(obj)
        if shown is None:
            return True
        if not self.is_known or not self._has_points_left(shown):
            return False
        if self.may_move(obj):
            self._are_looks_unseen = True
            return True
        return self._has_looks_left(shown.data)

    def may_move(self, obj):
        """Whether the hull may be another one at each step of the mouse."""
        return may_move(obj) or self.is_sliding

    def _has_points_left(self, shown):
        mesh = shown.data
        if not shown_objects.is_free(shown) or mesh.get(surface_writer.FACES) != self._stamp:
            return False
        if self.points is None:  # the hull has other faces now: all is made anew
            return True
        left = self.points.coordinates
        points = surface_mesh.points_of(mesh)
        # By their bits: not even what is no number may differ from itself.
        return points.shape == left.shape and np.array_equal(points.view("i4"), left.view("i4"))

    def _has_looks_left(self, mesh):
        if mesh.get(surface_writer.FACES_LEFT) != surface_mesh.faces_digest(mesh):
            return False
        left = self._left.normals_digest
        if left is not None and left != surface_mesh.normals_digest(mesh):
            return False
        _, choice = self._left.colours or (None, None)
        return choice is None or colours.has_colours(mesh)

    def follow(self, obj, ship, scale):
        """Brings the surface object of a hull up to date with its flotation.live_ship.LiveShip.

        While the hull may move the exact normals wait for follow_normals. While the mesh is edited
        a surface that is hidden in views and renders waits until it is seen. One that is worked on
        itself waits for the end of that.
        """
        if ship.surface is not self._surface:
            self._surface, self.points = ship.surface, None
        shown = shown_objects.surface_of(obj)
        if shown is None:
            self.colour_scale = None
            return
        if shown_objects.is_worked_on(shown):
            self.forget()
            return
        if obj.mode == "EDIT" and shown.hide_render and not shown.visible_get():
            return
        if not self._has_points_left(shown):
            self.forget()
            shown_objects.set_free(shown)
        if self._are_looks_unseen and not self.may_move(obj):
            self._are_looks_unseen = False
            if not self._has_looks_left(shown.data):
                self.forget()
        self._write_what_is_due(obj, shown, ship.geometry_key, scale)

    def _write_what_is_due(self, obj, shown, geometry_key, scale):
        left, choice = self._left, self._choice(obj)
        place = (geometry_key, samples_of(obj, self._surface), shown.name_full)
        is_due = left.place != place
        if is_due:  # normals are of points that go, even where these come back
            left.normals = left.normals_digest = None
        are_normals_due = left.normals != place and not self.may_move(obj)
        colours_key = (None if choice is None else place, choice)
        are_colours_due = left.colours != colours_key
        if not (is_due or are_normals_due or are_colours_due):
            return
        writer = self._writer(obj, shown, scale, geometry_key)
        has_new_faces = False
        if is_due:
            has_new_faces = writer.write_points(is_known=self.is_known)
            left.place = place
        are_normals_due |= has_new_faces
        are_colours_due &= has_new_faces or not self._waits(obj, choice)
        if are_normals_due:
            self._write_normals(writer, place)
        if are_colours_due:
            self._write_colours(writer, choice, colours_key)

    def _choice(self, obj):
        """What decides on the colours; None when there are none, as of distances from nothing."""
        choice = colours.wanted(obj.hull.fairness)
        if choice is None or choice[0] != "distance":
            return choice
        is_there = self.other is not None and self.other.field is not None
        return (*choice, self.other.key) if is_there else None

    def _waits(self, obj, choice):
        """Whether colours wait for a pause: distances while the mesh is edited."""
        return obj.mode == "EDIT" and choice is not None and choice[0] == "distance"

    def _write_colours(self, writer, choice, colours_key):
        self.distances = None
        if choice is not None and choice[0] == "distance":
            self.distances = writer.distances(self.other.field)
        values = None if self.distances is None else self.distances.values
        self.colour_scale = writer.write_colours(choice, values)
        self.colour_field = "" if choice is None else choice[0]
        self._left.colours = colours_key

    def remarks(self, obj):
        """What a user may expect to see and does not, as sentences."""
        shown, wanted = samples_of(obj, self._surface), obj.hull.samples
        if shown >= wanted:
            return []
        afterwards = _samples(obj, self._surface, limits.MOST_SHOWN_FACES)
        found = []
        if shown < afterwards:
            found.append(f"Samples: {shown} are shown for {afterwards} while points can be moved")
        if afterwards < wanted:
            found.append(
                f"Samples: {afterwards} are shown for {wanted}: Blender would take long for more "
                "faces"
            )
        return found

    def follow_normals(self, obj, scale):
        """Gives the surface object its exact normals when the user pauses; large ones wait until
        the hull does not move any longer."""
        shown, place = shown_objects.surface_of(obj), self._left.place
        if shown is None or place is None or self._left.normals == place:
            return
        is_large = len(shown.data.loops) > _MOST_AT_A_PAUSE
        if (is_large and may_move(obj)) or not self._has_points_left(shown):
            return
        self._write_normals(self._writer(obj, shown, scale, place[0]), place)

    def follow_distances(self, obj, scale):
        """Colours the surface object by its distances from `other` as it is now, at a pause."""
        shown, place = shown_objects.surface_of(obj), self._left.place
        if shown is None or place is None or not self._has_points_left(shown):
            return
        choice = self._choice(obj)
        key = (None if choice is None else place, choice)
        if self._left.colours != key:
            self._write_colours(self._writer(obj, shown, scale, place[0]), choice, key)

    def _write_normals(self, writer, place):
        self._left.normals_digest, self._left.normals = writer.write_normals(), place

    def _writer(self, obj, shown, scale, geometry_key):
        samples = samples_of(obj, self._surface)
        self._update_points(samples, obj.hull.half, scale)
        if self._stamp is None:
            self._stamp = _stamp(geometry_key[0], samples, self.points.shared)
        return surface_writer.SurfaceWriter(shown, self._surface, samples, self.points, self._stamp)

    def _update_points(self, samples, mirrored, scale):
        key = (samples, mirrored, scale)
        if self.points is None or self._points_key != key:
            self.points = native.require().ShownPoints(
                self._surface, samples, mirrored=mirrored, metres_per_unit=scale
            )
            self._points_key, self._stamp = key, None
        elif not self.points.update():
            self._stamp = None


def _stamp(topology_key, samples, shared):
    """Equal for meshes of equal faces; as text, which Blender keeps with the mesh."""
    digest = hashlib.blake2b(repr(topology_key).encode(), digest_size=16)
    digest.update(repr(samples).encode())
    digest.update(shared.tobytes())
    return digest.hexdigest()
