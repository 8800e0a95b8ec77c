# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.plates as hull_native's seam rules and frame tables."""

from ...bridge import native
from ...bridge.blender import units
from ..hull import plating_data
from ..lines import frames

# Seams of a new list of rules: so many strakes of the depth and the half-breadth, butts of the
# length.
_STRAKES, _BUTTS, _KEEL = 5, 8, 0.35


def suggested(ship):
    """[(kind, metres)] for half a ship with length_pp, beam, depth in m."""
    strake = round(max((ship[2] + 0.5 * ship[1]) / _STRAKES, 0.05), 2)
    return [
        ("strakes", strake),
        ("butts", round(max(ship[0] / _BUTTS, 0.1), 1)),
    ]


def seam_rules(obj, scene):
    """hull_native.SeamRules of a hull. ValueError for a projected one without a line."""
    hull_native, made = native.require(), []
    for number, rule in enumerate(obj.hull.plates.rules, 1):
        if not rule.on:
            continue
        line = None
        if rule.kind == "projected":
            if rule.line is None:
                raise ValueError(f"Rule {number} has no line: choose a mesh or curve object")
            line = plating_data.points_of(rule.line, obj) * units.metres_per_unit(scene)
        made.append(hull_native.SeamRule(rule.kind, round(rule.value, 6), line))
    return made


def seams_of(source, surface, rules, along_knuckles):
    """hull_native.seams_by_rules on a surface of a flotation.ship.ShipSource."""
    return native.require().seams_by_rules(
        surface, rules, knuckles=along_knuckles, appendages=source.appendages
    )


def frame_table(obj, scene):
    """The hull_native.FrameTable of a hull, None without ranges."""
    return frames.frame_table(obj.hull, units.metres_per_unit(scene))
