# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.lines: which lines are shown in the 3D view, and where they lie. The lines plan and
the table of offsets are of the same."""

import bpy
from bpy.props import (
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    FloatVectorProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

from ..bridge import limits
from .shared import changed, length, switch


def _text(name, description):
    return StringProperty(name=name, description=description, update=changed)


class HullPlane(bpy.types.PropertyGroup):
    """A plane that the hull is cut by, in the mesh's axes and the scene's units."""

    name: StringProperty(name="Name", default="Plane", update=changed)
    is_shown: switch("Shown", "Show the section by this plane in the 3D view", True)
    normal: FloatVectorProperty(
        name="Normal",
        description="Direction across the plane",
        default=(1.0, 0.0, 0.0),
        subtype="XYZ",
        soft_min=-1.0,
        soft_max=1.0,
        precision=4,
        update=changed,
    )
    point: FloatVectorProperty(
        name="Through",
        description="A point of the plane: x, y, z in the mesh's axes",
        unit="LENGTH",
        subtype="XYZ",
        update=changed,
    )


class HullLines(bpy.types.PropertyGroup):
    """Lists are texts, in metres whatever the scene's units; one that is not blank counts before
    the spacing."""

    show_stations: switch("Stations", "Show sections across the ship in the 3D view", True)
    show_waterlines: switch("Waterlines", "Show sections along the water in the 3D view", True)
    show_buttocks: switch("Buttocks", "Show sections along the centre plane in the 3D view", True)
    show_diagonals: switch("Diagonals", "Show diagonals in the 3D view", True)
    show_planes: switch("Planes", "Show sections by planes of one's own in the 3D view", True)
    show_design_waterline: switch("Design waterline", "Show the waterline at the draft", True)
    show_flats: switch(
        "Flats", "Show the rims of flat sides, bottoms and transoms in the 3D view", True
    )
    show_features: switch("Knuckles, borders", "Show knuckles and borders in the 3D view", True)
    in_front: switch("Through the surface", "Show lines behind the surface too")

    station_count: IntProperty(
        name="Lpp /",
        description="Spaces between stations from the after to the forward perpendicular; "
        "0 draws none",
        default=20,
        min=0,
        max=limits.MOST_STATION_SPACES,
        update=changed,
    )
    stations: _text(
        "List",
        "Positions of stations with blanks between, ranges as first:last:step; blank: Lpp divided",
    )
    stations_in: EnumProperty(
        name="Stations in",
        description="What the positions of stations are given in",
        items=(("METRES", "in metres", "x from the after perpendicular"),
               ("FRAMES", "in frames", "Numbers of frames: by the ranges under Plates, or else "
                "evenly spaced from the after perpendicular")),
        update=changed,
    )  # fmt: skip
    frame_spacing: length("Frame spacing", "Distance of frames; 0: the ship has none")
    waterline_spacing: length("Spacing", "Distance between waterlines; 0 draws none")
    waterlines: _text(
        "List m", "Heights with blanks between, ranges as first:last:step; blank: by the spacing"
    )
    buttock_spacing: length("Spacing", "Distance between buttocks; 0 draws none")
    buttocks: _text(
        "List m",
        "Half-breadths with blanks between, ranges as first:last:step; blank: by the spacing",
    )
    diagonals: _text(
        "m/°",
        "Each a height at the centre plane in m, a slash, and the angle below the horizontal in "
        "degrees: 5.2/35 4/50",
    )
    planes: CollectionProperty(type=HullPlane)
    active_plane: IntProperty(name="Plane", description="The one chosen in the list")

    width: FloatProperty(
        name="Line width",
        description="Of the lines in the 3D view, in dots",
        default=1.5,
        min=0.5,
        max=10.0,
        precision=1,
        step=50,
        update=changed,
    )
    curves: PointerProperty(
        name="Lines", description="Where curves made of the lines are", type=bpy.types.Collection
    )


CLASSES = (HullPlane, HullLines)
