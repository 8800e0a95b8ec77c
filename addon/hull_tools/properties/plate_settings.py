# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.plates: how the shell is divided into plates, and its frames."""

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    IntProperty,
    PointerProperty,
)

from .shared import changed, switch

_RULES = (
    ("strakes", "Strakes", "Seams at multiples of a girth from the deck edge down"),
    ("from_deck", "From Deck", "A seam at a girth along frames from the deck edge"),
    ("from_centre", "From Centre", "A seam at a girth along frames from the centre line"),
    ("waterline", "Height", "A seam in a level plane"),
    ("buttock", "Breadth", "A seam in an upright plane along the ship"),
    ("station", "Station", "A butt all around, in a plane across the ship"),
    ("butts", "Butts", "Staggered butts so far apart, those of neighbouring strakes by half of it"),
    ("projected", "Projected", "A seam by a mesh or curve object, projected across the ship"),
    ("openings", "Openings", "A seam around each tunnel or tube, at a distance; others end there"),
)


def thickness():
    return FloatProperty(
        name="Thickness mm",
        description="Of plates whose layer has no thickness of its own, for weights and frames",
        default=10.0,
        min=0.01,
        max=1000.0,
    )


def _is_line(_self, obj):
    return obj.type in ("MESH", "CURVE")


class HullSeamRule(bpy.types.PropertyGroup):
    kind: EnumProperty(name="Seams by", description="What the rule makes", items=_RULES)
    value: FloatProperty(
        name="Metres",
        description="Girth, height, breadth, place along the ship or distance, in metres",
        default=2.4,
        min=-1000.0,
        max=1000.0,
        precision=2,
    )
    line: PointerProperty(
        name="Line",
        description="The object whose edges, one after the other, are projected",
        type=bpy.types.Object,
        poll=_is_line,
    )
    on: BoolProperty(name="On", description="Whether the rule counts", default=True)


class HullFrameRange(bpy.types.PropertyGroup):
    last: IntProperty(
        name="To frame",
        description="The last frame of the range",
        default=100,
        min=-999,
        max=1999,
        update=changed,
    )
    spacing: FloatProperty(
        name="Spacing m",
        description="Distance of its frames, in metres",
        default=0.6,
        min=0.01,
        max=100.0,
        precision=3,
        update=changed,
    )


class HullPlates(bpy.types.PropertyGroup):
    rules: CollectionProperty(type=HullSeamRule)
    along_knuckles: BoolProperty(
        name="Seams along knuckles", description="Plates are not bent sharply", default=True
    )
    across_centre: BoolProperty(
        name="Keel plates across centre",
        description="Plates that end in the centre plane without a knuckle, and face up, down or "
        "along the ship, are one with their mirror images",
        default=True,
    )
    show_seams: switch("Seams in view", "Show seams, butts and names of the plates laid out", True)
    thickness: thickness()
    mark_waterlines: BoolProperty(
        name="Waterlines", description="Mark the waterlines of Sections on plates and frames"
    )
    mark_buttocks: BoolProperty(
        name="Buttocks", description="Mark the buttocks of Sections on plates"
    )
    first_frame: IntProperty(
        name="First frame",
        description="The number of the table's first frame; 0 is at the perpendicular",
        default=-5,
        min=-999,
        max=0,
        update=changed,
    )
    ranges: CollectionProperty(type=HullFrameRange)
    numbered_from: EnumProperty(
        name="Frame 0 at",
        description="From which perpendicular frames are numbered",
        items=(
            ("AP", "AP", "The after perpendicular, x = 0: numbers rise forward"),
            ("FP", "FP", "The forward perpendicular, x = Lpp: numbers rise aft"),
        ),
        update=changed,
    )
    in_roman: BoolProperty(name="Roman numerals", description="Of the frames' numbers")


CLASSES = (HullSeamRule, HullFrameRange, HullPlates)
