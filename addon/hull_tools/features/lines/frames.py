# SPDX-License-Identifier: GPL-3.0-or-later
"""The frames of a hull: their table, by the ranges that Object.hull.plates has."""

from ...bridge import native


def frame_table(settings, metres_per_unit):
    """The hull_native.FrameTable of an Object.hull, None without ranges. ValueError as
    hull_native.frame_table."""
    plates = settings.plates
    ranges, first = [], plates.first_frame
    for each in plates.ranges:
        ranges.append((first, each.last, round(each.spacing, 6)))
        first = each.last
    if not ranges:
        return None
    return native.require().frame_table(
        ranges,
        numbered_from=plates.numbered_from,
        length=settings.length_pp * metres_per_unit or None,
        in_roman=plates.in_roman,
    )
