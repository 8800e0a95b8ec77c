# SPDX-License-Identifier: GPL-3.0-or-later
"""What a studio shows follows its hull: at the next pause after a change, and before a picture.

What is there is written anew in place; what the user has removed stays away, and a camera that he
has moved stays where it is. Of what kind ground, light and lines are is chosen at the set-up alone.
"""

import hashlib
import threading
from dataclasses import dataclass

import bpy

from ...bridge.background import timers
from ...bridge.blender import units
from ...bridge.objects import shown_objects
from ..hull import hull_state
from . import cameras, deck, lines_on_hull, paint, water_or_floor
from .place import MARK, find, hull_of, place_of

_PAUSE_SECONDS = 0.4
# A picture waits so long for a change that is on its way.
_PATIENCE_SECONDS = 5.0
# Plan.key of what a studio shows, and of what its cameras were framed to, on its collection: saved
# with it.
_SHOWN, _FRAMED = "drawn to", "framed to"

_is_at_rest = threading.Event()
_is_at_rest.set()


def ask(hulls, scene):
    """Has the studio of a scene follow at the next pause, if it is that of one of these hulls; each
    call puts it off."""
    if bpy.app.background or not _is_main_thread() or hull_of(scene) not in hulls:
        return
    _is_at_rest.clear()
    _pause.put_off()


def stop():
    _pause.stop()
    _is_at_rest.set()


def _follow_all():
    try:
        for scene in bpy.data.scenes:
            follow(scene)
    finally:
        _is_at_rest.set()


_pause = timers.Timer(_PAUSE_SECONDS, _follow_all)


def before_picture(scene):
    """Has a picture show the hull as it is. Blender's window calls this in the picture's thread:
    what is on its way is left to the main one."""
    if not _is_main_thread():
        _is_at_rest.wait(_PATIENCE_SECONDS)
        hull = hull_of(scene)
        if hull is not None and hull.mode == "EDIT":
            return  # the mesh that is edited is the main thread's
    follow(scene)


def _is_main_thread():
    return threading.current_thread() is threading.main_thread()


def forget():
    """Nothing is known of what studios show, after undo has changed them and the hulls."""
    for scene in bpy.data.scenes:
        collection = find(scene)
        if collection is not None:
            collection.pop(_SHOWN, None)
            collection.pop(_FRAMED, None)


def follow(scene):
    """Brings the studio of a scene up to date with its hull, where it is not; a hull that has no
    surface as it is leaves the studio as it was."""
    hull = hull_of(scene)
    if hull is None or hull.name not in scene.objects:
        return
    state = hull_state.refresh(hull, scene)
    if state.status or shown_objects.surface_of(hull) is None:
        return
    try:
        plan = Plan.of(hull, state, scene, find(scene)[MARK].get("lines", "NONE"))
        if not plan.is_shown(find(scene)):
            plan.draw(place_of(hull, scene), state)
    except ValueError:
        return  # lines that cannot be drawn: the panel of lines says why
    # Who looks through a camera while he edits keeps his view.
    if hull.mode != "EDIT" and not plan.is_framed(find(scene)):
        plan.frame(place_of(hull, scene))


@dataclass(frozen=True)
class Plan:
    """What a studio is to show of its hull. cuts: see lines_on_hull; key: equal for what looks the
    same."""

    cuts: dict
    key: str

    @classmethod
    def of(cls, hull, state, scene, lines):
        """ValueError for lines that cannot be drawn."""
        scale, settings = units.metres_per_unit(scene), hull.hull
        cuts = lines_on_hull.wanted_cuts(hull, state, lines, scale)
        heights = settings.draft, settings.studio.boot_top_height
        seen = state.ship.geometry_key, settings.samples, heights, cuts
        return cls(cuts, hashlib.blake2b(repr(seen).encode(), digest_size=16).hexdigest())

    def is_shown(self, collection):
        return collection.get(_SHOWN) == self.key

    def is_framed(self, collection):
        return collection.get(_FRAMED) == self.key

    def draw(self, here, state):
        """Deck, water, lines and paint of the hull as it is. ValueError: see Plan.of."""
        groups = lines_on_hull.find(here.hull, state, self.cuts)
        outlines = lines_on_hull.waterlines(here.hull, state, here.metres_per_unit)
        deck.follow(here)
        water_or_floor.follow(here, outlines)
        lines_on_hull.follow(here, state.ship.surface, groups)
        paint.follow(here, here.hull.hull.studio)
        here.collection[_SHOWN] = self.key

    def frame(self, here):
        """All of the hull, for cameras that the user has not moved."""
        cameras.follow(here)
        camera = here.scene.camera
        if camera is not None and here.find(camera.get(MARK)) == camera:
            lines_on_hull.draw_thin(here, cameras.width_at(here, camera))
        here.collection[_FRAMED] = self.key
