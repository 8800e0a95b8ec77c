# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a hull is several beside one another, which methods for one take for one."""

from .. import _core

# The broadest of so many stations of one hull has the waterline's breadth but for 2 %, though a
# tunnel or a well may lie at others; two hulls have not so much of it even where they nearly touch.
_STATIONS, _ONE_HULL = 25, 0.9


def is_side_by_side(body, water, draft, trim, draft_at):
    """Whether no station of a HullBody has most of the waterline's breadth as water within the
    ship. water: its hydrostatics() at that draft and trim."""
    ends = water.waterline_aft, water.waterline_forward
    stations = [ends[0] + (ends[1] - ends[0]) * (i + 0.5) / _STATIONS for i in range(_STATIONS)]
    found = _core.section_areas(body, stations, draft=draft, trim=trim, draft_at=draft_at)
    return max(found.breadths) < _ONE_HULL * water.waterline_beam
