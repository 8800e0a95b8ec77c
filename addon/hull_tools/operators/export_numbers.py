# SPDX-License-Identifier: GPL-3.0-or-later
"""What exports with numbers in their dialogs have in common, and choices of several of them."""

from bpy.props import BoolProperty, EnumProperty, StringProperty

from ..properties import output_settings
from ..properties.shared import metric_field
from .export_hull import ExportByTask, ExportDrawing

PAGES = ".pdf", "PDF", "A page each, reduced to fit A3; at true size: in sheets"
SHEET = ".svg", "SVG", "At true size, a file each"
ALL = ".dxf", "DXF", "At true size, in mm"


def in_sheets_choice():
    return BoolProperty(
        name="1:1, a file each",
        description="At true size, a file for each drawing, PDF over as many sheets of paper as "
        "that takes; otherwise all are in one file",
    )


def paper_choice():
    return EnumProperty(
        name="Paper",
        description="Of the sheets at true size",
        items=output_settings.PAPERS,
        default="A1",
    )


def filter_choice(*endings):
    return StringProperty(default=";".join(f"*{ending}" for ending in endings), options={"HIDDEN"})


class ExportWithNumbers(ExportDrawing, ExportByTask):
    """Exports whose dialogs have numbers below the choice of `format`: NAMES, or those of them that
    numbers() says."""

    def numbers(self):
        return self.NAMES

    def draw(self, context):
        super().draw(context)
        column = self.layout.column()
        column.use_property_split = True
        for name in self.numbers():
            metric_field(column, self, name)
