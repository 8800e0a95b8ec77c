# SPDX-License-Identifier: GPL-3.0-or-later
"""Surface and floating body of a hull, which follow its control mesh.

Points that moved are handed to the surface and the body that are there. Of a mesh with errors the
last good surface stays; where there is none, it is that of its part that makes one.
"""

from dataclasses import dataclass, field, replace

import numpy as np

from ...bridge import native
from ...bridge.mesh import mesh_arrays, mesh_check, moves, valid_part
from . import ship
from .appendages import native_bodies

# Of the box around the hull: volume that bodies have in common by rounding; and how little stays
# counted twice, as a rudder's end within the hull: all that moves the hull's points has it twice.
_NOTHING, _SLIGHT = 1e-12, 1e-4


@dataclass
class LiveShip:
    """check: of the mesh as it is. surface: hull_native.LimitSurface; moved: its moves.Moves; body:
    its hull_native.HullBody. All three change with the next edit, so that only `source`, the
    ship.ShipSource of them, is for threads. is_part: the mesh has errors, and the surface is of
    what makes one. memory: see ship.Ship. not_joined: why appendages do not count, else "". waits:
    they do not, and own bodies that overlap add up, until points rest; see `follow`. overlap: what
    is said of own bodies that do; added_up: why they are not counted once, else "". idle_cuts:
    names of tunnels and the like that lie beside the hull.

    topology_key: equal where surfaces differ by the places of points only; geometry_key: where
    surfaces are equal, None while there is none; key: where ships are.
    """

    check: mesh_check.MeshCheck = mesh_check.MeshCheck()
    is_part: bool = False
    surface: object = None
    moved: object = None
    body: object = None
    source: object = None
    memory: dict = field(default_factory=dict)
    not_joined: str = ""
    waits: bool = False
    overlap: str = ""
    added_up: str = ""
    idle_cuts: tuple = ()
    topology_key: tuple = None
    geometry_key: tuple = None
    key: tuple = None
    _control_key: tuple = None
    appendages_key: tuple = ()

    def as_it_is(self):
        """The ship.Ship that follows the edits."""
        return ship.Ship(self.body, self.source.deck_edge, self.moved, self.memory)

    def follow(self, found, scale, may_wait=False):
        """Brings all up to date with a hull_mesh.HullMesh; returns whether the surface is its.

        may_wait: where points have moved, appendages are left out, and bodies that overlap not
        looked at, since joining them takes too long for each step of a drag; that is done by a call
        without it.
        """
        geometry_key = (found.topology_key, found.points_digest, scale)
        marks = found.data.deck_edge().tobytes()
        has_moved = self.geometry_key not in (None, geometry_key)
        self.waits = may_wait and (self.waits or has_moved)
        self.waits = self.waits and (bool(found.appendages) or self._has_bodies_near())
        bodies = () if self.waits else found.appendages
        key = (geometry_key, found.openings, marks, bodies, self.waits)
        if self.key != key:
            self._renew(found, scale, geometry_key, (found.topology_key, marks), bodies)
            self.key = key
        if self.waits and found.appendages:
            self.not_joined = "they are joined when the points rest"
        return self.surface is not None and self.geometry_key == geometry_key

    def _has_bodies_near(self):
        """Whether the mesh has several bodies, and they may overlap."""
        return self.body is not None and self.body.may_overlap

    def remarks(self):
        """What a user may expect of bodies and is not so, as sentences."""
        texts = [
            f"{name} cuts nothing out of the hull, beside which it lies: move it into the hull, or "
            "take it out of the count"
            for name in self.idle_cuts
        ]
        if self.added_up:
            texts.append(f"{self.overlap}, which count twice: {self.added_up}")
        return texts

    def _renew(self, found, scale, geometry_key, control_key, bodies):
        if self._control_key == control_key:
            control = mesh_arrays.moved_arrays(self.source.control, found.data, scale)
            before = self.surface.mesh
        else:
            control, before = found.control(scale), None
        self.check, mesh = mesh_check.check_control_mesh(found.data, control, found.half, before)
        is_whole = mesh is not None
        if not is_whole and self._can_be_parted(control, found.half):
            control, mesh = valid_part.valid_part(control)
        if mesh is None:
            return
        self.is_part = not is_whole
        source = ship.source_of(found, control, self._bodies(bodies, scale, control.points))
        has_others = self.appendages_key != bodies
        self._make_body(mesh, source, found.topology_key, geometry_key, has_others)
        self.appendages_key = bodies
        self._control_key = control_key if is_whole else None

    def _can_be_parted(self, control, half):
        """Whether a part of a mesh with errors is looked for: where there is no last good surface
        of the whole."""
        is_wanted = self.surface is None or self.is_part
        return is_wanted and not mesh_check.is_too_fine(control, half)

    def _bodies(self, bodies, scale, points):
        """hull_native.Appendage of AppendageBody, none where one of them is no body."""
        self.not_joined = ""
        try:
            return native_bodies(bodies, scale, points)
        except ValueError as error:
            self.not_joined = str(error)
            return []

    def _make_body(self, mesh, source, topology_key, geometry_key, has_others):
        """Surface and body of a source: those that are there where only points have moved.
        has_others: other appendages than before."""
        surface, body = self.surface, self.body
        has_moved = self.geometry_key != geometry_key
        if surface is None or self.topology_key != topology_key or self._is_of_others(source):
            surface, body = native.require().LimitSurface(mesh, source.scheme), None
            self.moved = moves.Moves.of(surface, geometry_key)
        elif has_moved:
            # Until all of them have the points that the surface has, there is no body.
            before, self.geometry_key, self.body = self.geometry_key, None, None
            surface.set_points(source.control.points)
            self.moved = self.moved.further(before, geometry_key)
        has_others = has_others or self._was_joined_otherwise(source)
        if body is None or body.openings != source.openings or has_others:
            body = source.live_body(surface)
            self.memory.clear()
            if source.appendages:
                source = self._tried(source, lambda: source.join_to(body))
        elif has_moved:
            source = self._tried(source, body.update)
        self.idle_cuts = tuple(body.idle_cuts)
        source, body = self._counted_once(source, body)
        self.surface, self.body, self.source = surface, body, source
        self.topology_key, self.geometry_key = topology_key, geometry_key

    def _was_joined_otherwise(self, source):
        """Whether own bodies are counted once, or appendages are not, which may be joined by
        now."""
        before = self.source
        return before is not None and (
            before.once or bool(source.appendages) != bool(before.appendages)
        )

    def _is_of_others(self, source):
        """Whether a source has other faces than the surface, though the mesh's are the same: which
        part of a mesh with errors makes a surface depends on where its points are."""
        before, control = self.source.control, source.control
        return before.face_vertices is not control.face_vertices and not all(
            np.array_equal(getattr(before, name), getattr(control, name))
            for name in ("face_sizes", "face_vertices", "creases", "corners")
        )

    def _tried(self, source, join):
        """Source without its appendages where joining raises; then the body is the hull alone."""
        try:
            join()
        except ValueError as error:
            self.not_joined = str(error)
            return replace(source, appendages=())
        return source

    def _counted_once(self, source, body):
        """(source, body) with own bodies counted once where they overlap."""
        self.overlap = self.added_up = ""
        if self.waits or not body.may_overlap:
            return source, body
        if body.joined_volume is not None:  # with appendages: they have their part in that
            self.overlap = ship.overlap_words(body.own_overlaps)
            return replace(source, once=bool(self.overlap)), body
        try:
            body.join([])
        except ValueError as error:
            self.overlap = ship.overlap_words(body.own_overlaps)
            self.added_up = str(error) if self.overlap else ""  # they may only touch
            return source, body
        lost, around = -body.joined_volume, np.prod(np.ptp(source.control.points, axis=0))
        if lost > _NOTHING * around:
            self.overlap = ship.words_of_overlap(lost)
        if lost <= _SLIGHT * around:
            return source, source.live_body(body.surface)
        self.memory.clear()
        return replace(source, once=True), body
