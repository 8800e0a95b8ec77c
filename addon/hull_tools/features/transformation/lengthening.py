# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls made longer or shorter, by parallel middle body or by stretching a range."""

from ...bridge import limits, native
from . import parents


def lengthen(obj, scene, place, length, stretched=None):
    """Inserts a length of parallel middle body at x = place, or takes it out where it is below
    zero; or stretches the range `stretched`, (aft, forward). All in m. Lpp grows by it where the
    place is between the perpendiculars. Returns hull_native.Lengthened; ValueError where it cannot
    be."""
    limits.within(abs(length), "A length in m", 0.0, limits.LONGEST)
    parent = parents.of_hull(obj, scene)
    result = native.require().lengthen(
        parent.body,
        place,
        length,
        **parent.position(),
        stretched=stretched,
        limits=parent.limits(),
    )
    middle = 0.5 * sum(result.range)
    settings = obj.hull
    if 0.0 < middle < parent.where.length_pp:
        new_length = parent.where.length_pp + length
        limits.within(new_length, "Lpp in m", 1e-3, limits.LONGEST)
        settings.length_pp = new_length / parent.scale
    parent.write(scene, result.moves)
    return result
