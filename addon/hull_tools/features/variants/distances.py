# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a hull's surface lies from that of the other hull, for the colours of its surface."""

from ...bridge import native
from ...bridge.blender import units
from ..surface.distances import OtherSurface
from . import other_hull

COLOURS = "DISTANCE"  # of Object.hull.fairness.colours


def follow(obj, scene, state):
    """Has the surface of a hull know which other one its distances are of, and coloured by them at
    a pause; returns whether anything is another."""
    shown, scale = state.shown, units.metres_per_unit(scene)
    before = shown.other, shown.distances
    if obj.hull.fairness.colours != COLOURS:
        shown.other = None
        return before != (shown.other, shown.distances)
    try:
        wanted = other_hull.of(obj, scale)
    except ValueError as error:
        shown.other = OtherSurface(None, None, str(error))
    else:
        if shown.other is None or shown.other.key != wanted.key:
            source = wanted.source
            field = native.require().DistanceField(source.new_surface(), mirrored=source.half)
            shown.other = OtherSurface(wanted.key, field)
    if state.ship.surface is not None:
        shown.follow_distances(obj, scale)
    return before != (shown.other, shown.distances)
