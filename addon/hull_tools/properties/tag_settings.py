# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.tags: which tags of the control mesh are shown over it in edit mode."""

import bpy
from bpy.props import BoolProperty


def _shown(name, description):
    """Nothing is computed anew: the 3D view draws what is known."""
    return BoolProperty(name=name, description=description, default=True)


class HullTags(bpy.types.PropertyGroup):
    show: _shown("Show tags", "Show in edit mode what edges, points and faces are to the surface")
    show_knuckle: _shown("Knuckles", "Creases within the surface")
    show_border: _shown(
        "Borders", "Edges with a face on one side only; fine on the centre plane of a half hull"
    )
    show_deck_edge: _shown("Deck edge", "Edges that are marked as deck edge")
    show_corners: _shown(
        "Corners",
        "Points that the surface passes through with a kink: a bold square where tagged, a fine "
        "one where three creases or borders meet",
    )
    show_darts: _shown("Darts", "Points where a crease fades out: a diamond")
    show_irregular: _shown(
        "Irregular points",
        "Points around which the surface is no B-spline: a ring with the number of edges there",
    )
    show_odd_faces: _shown("Not quads", "Faces that have not four corners, with their number")
    show_flats: _shown("Kept flat", "Faces that are tagged to stay in a plane")
    show_developables: _shown(
        "Rulings", "Straight rulings of developable regions: red where they have too much warp"
    )
    show_locked: _shown("Locked points", "Points that stay when the surface is pulled")
    show_kept: _shown(
        "Kept points",
        "Points that stay in a plane: an upright bar for the station, a level one for the "
        "waterline, a slanted one for the buttock",
    )
    show_problems: _shown("Problems", "What the mesh check found, in red")


CLASSES = (HullTags,)
