# SPDX-License-Identifier: GPL-3.0-or-later
"""The intact criteria of the 2008 IS Code, Part A, 2.2, for the load of the stability panel."""

from math import degrees

from ...bridge import native
from . import loads

LABEL = "IS Code criteria"
IS_LIVE = False


def inputs(settings, metres_per_unit):
    return loads.load_inputs(settings, metres_per_unit)


def compute(ship, given):
    """A hull_native.StabilityReport."""
    load = loads.load(ship.body, given)
    return native.require().stability_criteria(
        ship.body, **load.arguments(given), downflooding_points=given.flooding_points or None
    )


def shown(value, unit):
    """(value, unit) as people read them: degrees instead of radians."""
    if unit == "rad":
        return (None if value is None else degrees(value)), "deg"
    return value, unit.replace("·", " ")


def header(result):
    # Paragraphs by themselves would pass for dates.
    return ["paragraph of the 2008 IS Code", "criterion", "value [see unit]",
            "limit: not less than [see unit]", "unit", "outcome", "note"]  # fmt: skip


def rows(result):
    for one in result.criteria:
        value, unit = shown(one.value, one.unit)
        limit, _ = shown(one.limit, one.unit)
        yield [f"Part A {one.paragraph}", one.name, value, limit, unit, one.outcome, one.note]
