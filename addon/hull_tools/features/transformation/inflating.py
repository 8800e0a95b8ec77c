# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections inflated or deflated along their normals to a wanted area."""

from ...bridge import native
from . import parents


def section_area(obj, scene, place):
    """Of the immersed section at x = place, m; m²."""
    parent = parents.of_hull(obj, scene)
    return _area(parent, place)


def inflate(obj, scene, place, area=None, percent=0.0, extent=None):
    """Brings the immersed section at x = place, m, to an area, m², or changes it by so many
    percent; sections beside go with it up to extent, m, on either side, None: all by as much.
    Returns hull_native.Inflated; ValueError where it cannot be."""
    parent = parents.of_hull(obj, scene)
    if area is None:
        area = (1.0 + 0.01 * percent) * _area(parent, place)
    result = native.require().inflate(
        parent.body,
        place,
        area,
        **parent.position(),
        extent=extent,
        limits=parent.limits(keeps_ranges=True),
    )
    parent.write(scene, result.moves)
    return result


def _area(parent, place):
    found = native.require().section_areas(parent.body, [place], **parent.position())
    return float(found.areas[0])
