# SPDX-License-Identifier: GPL-3.0-or-later
"""What hydrostatics and stability are computed of: surface, floating body, and what is marked."""

from dataclasses import dataclass, field, replace
from functools import cached_property

from ...bridge import native
from ...bridge.mesh.mesh_arrays import ControlArrays
from . import hydrostatics

# Of the whole: the tolerance of bodies whose numbers follow the mouse.
LIVE = 1e-8


@dataclass(frozen=True, eq=False)
class Ship:
    """body: hull_native.HullBody; its surface is that of the hull. deck_edge: the edges that are
    marked, pairs of the surface's control points; without any the borders along the ship. moved:
    the moves.Moves of a surface that follows edits, else None. memory: what analyses know of the
    body as it is, or was; by what it is. progress: is told the share of long work that is done;
    what it raises ends the work."""

    body: object
    deck_edge: tuple
    moved: object = None
    memory: dict = field(default_factory=dict)
    progress: object = None

    def tell(self, done, count):
        """So many of a count of steps are done."""
        if self.progress is not None:
            self.progress(done / count)

    def hydrostatics(self, where):
        """The hull_native.Hydrostatics at an Afloat; ValueError as hydrostatics.computed."""
        key = (self.moved and self.moved.after, where)
        known_key, known = self.memory.get("hydrostatics", (None, None))
        if known_key != key:
            kept = None if self.moved is None else self.kept_stations
            known = hydrostatics.computed(self.body, where, kept)
            self.memory["hydrostatics"] = key, known
        return known

    @property
    def kept_stations(self):
        """The hull_native.KeptStations of a body that follows edits."""
        body, kept = self.memory.get("kept stations", (None, None))
        if body is not self.body:
            kept = native.require().KeptStations(self.body)
            self.memory["kept stations"] = self.body, kept
        return kept


@dataclass(frozen=True, eq=False)
class ShipSource:
    """All that a Ship is made of. It never changes: a thread may have it while the hull is edited.

    openings: as hull_native.HullBody takes them. appendages: hull_native.Appendage that are joined
    to its body. once: its own bodies overlap, and are counted once there.
    """

    control: ControlArrays
    scheme: str
    half: bool
    openings: str
    deck_edge: tuple
    appendages: tuple = ()
    once: bool = False

    def new_surface(self):
        """A hull_native.LimitSurface of the caller's own."""
        hull_native = native.require()
        return hull_native.LimitSurface(
            hull_native.ControlMesh(*self.control.arguments()), self.scheme
        )

    @property
    def alone(self):
        """The same without appendages."""
        return replace(self, appendages=())

    @property
    def is_joined(self):
        """Whether the body is another than that of the hull alone, its own bodies added up."""
        return bool(self.appendages) or self.once

    def own_ship(self):
        """The Ship of the hull alone, of which targets and transformations are."""
        return Ship(self.bare_body(self.new_surface()), self.deck_edge)

    def new_ship(self, progress=None):
        return Ship(self.new_body(self.new_surface()), self.deck_edge, progress=progress)

    @cached_property
    def ship(self):
        """A Ship that no edit reaches; for one thread at a time."""
        return self.new_ship()

    def new_body(self, surface, **how):
        """The hull_native.HullBody of a surface of these control points. ValueError where
        appendages cannot be joined to it."""
        body = self.bare_body(surface, **how)
        if self.appendages or self.once:
            self.join_to(body)
        return body

    def join_to(self, body):
        """Joins the appendages to a bare_body or live_body. What cuts nothing out of the hull is
        told in the panel, by its name in the scene."""
        body.join(list(self.appendages), warn=False)

    def bare_body(self, surface, **how):
        """The same without appendages, all of its own bodies added up."""
        return native.require().HullBody(surface, mirrored=self.half, openings=self.openings, **how)

    def live_body(self, surface):
        """One for numbers that follow the mouse, to some 1e-8 of the whole, without appendages."""
        return self.bare_body(surface, tolerance=LIVE)


def overlap_words(overlaps):
    """Of HullBody.own_overlaps: what is said of them, without an end; nothing where there are
    none."""
    if not overlaps:
        return ""
    about = "" if all(countable for *_, countable in overlaps) else "about "
    return words_of_overlap(sum(volume for _, _, volume, _ in overlaps), about)


def words_of_overlap(volume, about=""):
    """The same of a volume, m³."""
    return f"Bodies of the hull's mesh overlap by {about}{volume:.3g} m³"


def source_of(found, control, joined=()):
    """The ShipSource of a hull_mesh.HullMesh; control: ControlArrays of it, or of a part of it.
    joined: hull_native.Appendage; without any it is the hull alone."""
    deck_edge = tuple(map(tuple, control.deck_edge.tolist()))
    return ShipSource(control, found.scheme, found.half, found.openings, deck_edge, tuple(joined))
