# SPDX-License-Identifier: GPL-3.0-or-later
"""On which side of the centre plane a hull is modelled: pure numbers, m or any other unit.

The one rule for readers, checks and buttons; native/analysis/sections/port_side.h has the same for
scripts that measure what nobody has checked.
"""

# Sides are both there where the smaller reach is at least this part of the larger one. A centre
# line may lie well across the centre plane, as a skeg does, without making a side.
BOTH_SIDES = 0.5

# A whole hull of which one side reaches less than this part of the other lacks it. A proa's or an
# outrigger's smaller side reaches further.
ONE_SIDE = 0.1


def reaches(low, high):
    """(to port, to starboard) of what lies from y = low to high; 0 where it does not reach."""
    return max(high, 0.0), max(-low, 0.0)


def lies_to_starboard(y):
    """Whether the points of a half hull with these y (n,) are the half that is not to be."""
    if not len(y):
        return False
    port, starboard = reaches(float(min(y)), float(max(y)))
    return port < BOTH_SIDES * starboard


def has_both(low, high):
    """Whether a hull from y = low to high has both sides."""
    small, large = sorted(reaches(low, high))
    return small >= BOTH_SIDES * large > 0.0


def has_one(low, high):
    """Whether a hull from y = low to high has one side only."""
    small, large = sorted(reaches(low, high))
    return large > 0.0 and small < ONE_SIDE * large
