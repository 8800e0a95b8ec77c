# SPDX-License-Identifier: GPL-3.0-or-later
"""What stays of a hull's outlines while its points are moved to something that is wanted."""

from bpy.props import BoolProperty


class KeptOutline:
    """As constraints.held_points has it; a mix-in of settings and operators."""

    keep_profile: BoolProperty(
        name="Profile",
        description="Points on the centre plane stay: stem, keel and stern",
        default=True,
    )
    keep_deck: BoolProperty(
        name="Deck edge",
        description="Points of the surface's borders stay, the deck edge and openings",
        default=True,
    )
    keep_side: BoolProperty(
        name="Greatest beam",
        description="The hull stays as wide as it is where it is widest, and becomes no wider",
        default=True,
    )
