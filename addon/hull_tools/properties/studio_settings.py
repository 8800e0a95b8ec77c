# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.studio: what the studio is that is set up around the hull."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatVectorProperty, IntProperty

from .shared import length


def _colour(name, description, default):
    return FloatVectorProperty(
        name=name, description=description, default=default, subtype="COLOR", min=0.0, max=1.0
    )


class HullStudio(bpy.types.PropertyGroup):
    ground: EnumProperty(
        name="Ground",
        description="What the hull floats in or stands on",
        items=(
            ("WATER", "Water", "Water at the draft, out to the horizon"),
            ("FLOOR", "Floor", "A floor under the keel"),
            ("NONE", "Nothing", "The hull hangs before the background"),
        ),
    )
    light: EnumProperty(
        name="Light",
        description="What the hull is lit by",
        items=(
            ("SUN", "Sun and sky", "A sun to starboard, and blue sky"),
            ("STUDIO", "Studio lights", "A lamp and soft boxes before a grey backdrop"),
        ),
    )
    lines: EnumProperty(
        name="Lines",
        description="Lines drawn on the hull",
        items=(
            ("SECTIONS", "Sections, waterlines", "Stations, waterlines and that of the draft"),
            ("SHOWN", "As in the view", "The lines that are shown in the 3D view"),
            ("NONE", "No lines", "The hull is painted only"),
        ),
    )
    deck: BoolProperty(
        name="Close the deck",
        description="Lay a deck over the hull, and close what else is open",
        default=True,
    )
    paint: BoolProperty(
        name="Paint",
        description="Paint the hull by the height above the waterline; "
        "else the surface keeps its material or its colours of curvature",
        default=True,
    )
    topside: _colour("Topsides", "Paint above the boot top", (0.34, 0.40, 0.46))
    boot_top: _colour("Boot top", "Paint of the stripe at the waterline", (0.80, 0.80, 0.78))
    antifouling: _colour("Antifouling", "Paint under water", (0.33, 0.028, 0.014))
    boot_top_height: length(
        "Height", "Of the boot top above the water; 0: a small part of the freeboard"
    )
    engine: EnumProperty(
        name="Renderer",
        description="What makes the picture",
        items=(
            ("CYCLES", "Cycles", "Traces light: shadows and mirror images as they are"),
            ("EEVEE", "EEVEE", "Drawn by the graphics card, in a second"),
        ),
    )
    turntable_frames: IntProperty(
        name="Frames",
        description="Pictures in one turn of the turntable",
        default=120,
        min=4,
        soft_max=1000,
    )


CLASSES = (HullStudio,)
