# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.table, plots and plan: the range of tables, which plots are shown, the lines plan."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, StringProperty

from .shared import changed, length, switch

PAPERS = (
    ("A4", "A4", "297 × 210 mm"),
    ("A3", "A3", "420 × 297 mm"),
    ("A2", "A2", "594 × 420 mm"),
    ("A1", "A1", "841 × 594 mm"),
    ("A0", "A0", "1189 × 841 mm"),
)


class HullTable(bpy.types.PropertyGroup):
    draft_from: length("From", "First draft of the table; 0: the first step", minimum=0.0)
    draft_to: length("To", "Last draft of the table; 0: the hull's draft", minimum=0.0)
    draft_step: length("Step", "Between drafts; 0: a tenth of the range", minimum=0.0)
    trims: StringProperty(
        name="Trims m",
        description="Trims by the stern in metres between perpendiculars, with blanks between: "
        "-1 0 1",
        default="0",
        update=changed,
    )


def _switch(name):
    return switch(name, "Show this plot over the 3D view")


class HullPlots(bpy.types.PropertyGroup):
    """Each switch has the name of its analysis."""

    hydrostatic_table: _switch("Hydrostatic curves")
    sectional_areas: _switch("Sectional areas")
    bonjean_curves: _switch("Bonjean curves")
    righting_levers: _switch("Righting levers GZ")
    cross_curves: _switch("Cross curves KN")
    resistance_curves: _switch("Resistance")
    wave_pattern: _switch("Wave pattern")
    wave_spectrum: _switch("Wave spectrum")
    knuckle_angles: _switch("Angles of knuckles")
    corner: EnumProperty(
        name="Corner",
        description="The corner of the 3D view that the plots start from",
        items=(
            ("BOTTOM_LEFT", "Bottom left", "Plots start at the bottom, on the left"),
            ("BOTTOM_RIGHT", "Bottom right", "Plots start at the bottom, on the right"),
            ("TOP_LEFT", "Top left", "Plots start at the top, on the left"),
            ("TOP_RIGHT", "Top right", "Plots start at the top, on the right"),
        ),
        update=changed,
    )
    size: FloatProperty(
        name="Size",
        description="Of each plot in the 3D view; 1 is 125 × 88 mm. Texts keep theirs",
        default=0.75,
        min=0.6,
        max=2.0,
        precision=2,
        step=5,
        update=changed,
    )


def _text(name, description):
    return StringProperty(name=name, description=description, update=changed)


def _view(name):
    return switch(name, "Draw this view", True)


def _side(name, default):
    return FloatProperty(
        name=name,
        description="Of a sheet of one's own, in mm",
        default=default,
        min=100.0,
        max=10000.0,
        precision=0,
        update=changed,
    )


class HullPlan(bpy.types.PropertyGroup):
    """The sheet of the lines plan; its lines are those of Object.hull.lines."""

    paper: EnumProperty(
        name="Sheet",
        description="The sheet of paper, its long side across",
        items=(
            *PAPERS,
            ("OWN", "Own size", "Width and height as given below"),
        ),
        default="A3",
        update=changed,
    )
    width: _side("Width", 600.0)
    height: _side("Height", 400.0)
    scale: FloatProperty(
        name="Scale 1:",
        description="100 for 1:100; 0: the largest usual scale that fits",
        min=0.0,
        precision=0,
        update=changed,
    )
    offsets: BoolProperty(
        name="Table of offsets",
        description="Draw the table of offsets on the sheet",
        default=True,
        update=changed,
    )
    profile: _view("Profile")
    half_breadth: _view("Half-breadth plan")
    body_plan: _view("Body plan")
    drawn: _text("Drawn", "For the title block")
    date: _text("Date", "For the title block")
    number: _text("Drawing no.", "For the title block")
    dxf_unit: EnumProperty(
        name="DXF in",
        description="The unit of a DXF file, which is at the ship's true size",
        items=(
            ("m", "Metres", "1 in the file is 1 m"),
            ("mm", "Millimetres", "1 in the file is 1 mm"),
        ),
        update=changed,
    )


CLASSES = (HullTable, HullPlots, HullPlan)
