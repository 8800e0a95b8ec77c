# SPDX-License-Identifier: GPL-3.0-or-later
"""What stays of a hull's outlines while its points are moved to something that is wanted, as
constraints.held_points has it."""

from bpy.props import BoolProperty


def keep_profile(default):
    return BoolProperty(
        name="Profile",
        description="Points on the centre plane stay: stem, keel and stern",
        default=default,
    )


def keep_deck(default):
    return BoolProperty(
        name="Deck edge",
        description="Points of the surface's borders stay, the deck edge and openings",
        default=default,
    )


def keep_side(default):
    return BoolProperty(
        name="Greatest beam",
        description="The hull stays as wide as it is where it is widest, and becomes no wider",
        default=default,
    )


class KeptOutline:
    """A mix-in of settings and operators that keep all of it."""

    keep_profile: keep_profile(True)
    keep_deck: keep_deck(True)
    keep_side: keep_side(True)
