# SPDX-License-Identifier: GPL-3.0-or-later
"""How finely a 3D view tells what is nearer to the eye: what it does not tell apart speckles."""

# Distances up to the eye that a 3D view tells apart are steps of a number of 24 bits.
_STEPS = 2.0**24
# What lies on a surface is drawn nearer than it by so many steps: its own places and the surface's
# are each rounded, and flat faces of the surface cut into it.
_SAFE_STEPS = 4.0
# Of a hull's size: closer no eye needs to come, and further away no hull is looked at.
_NEAREST, _FARTHEST = 1e-3, 30.0


def least_step(distance, clip_start):
    """What a perspective view tells apart at a distance from the eye, in its units."""
    return distance * distance / (clip_start * _STEPS)


def nearer_by(wanted, distance, clip_start):
    """By how much a line on a surface is to be drawn nearer: what is wanted, or as much more as the
    view needs to tell it from the surface."""
    return max(wanted, _SAFE_STEPS * least_step(distance, clip_start))


def suit(space, obj):
    """Has a 3D view begin and end so that an object is in it and does not speckle. Only what would
    not suit is changed."""
    size = max(obj.dimensions)
    if size <= 0.0:
        return
    space.clip_start = max(space.clip_start, _NEAREST * size)
    space.clip_end = max(space.clip_end, _FARTHEST * size)
