# SPDX-License-Identifier: GPL-3.0-or-later
"""What the yard gets: plates, their nesting, templates and maps of stretch; frames."""

import bpy
from bpy.props import BoolProperty, FloatProperty, StringProperty

from ..bridge.counts import counted
from ..bridge.objects import hull_objects
from ..features.production import frame_files, plate_drawings, plate_files
from ..properties import plate_settings
from .export_hull import formats
from .export_numbers import (
    ALL,
    PAGES,
    SHEET,
    ExportWithNumbers,
    filter_choice,
    in_sheets_choice,
    paper_choice,
)


def _names():
    return StringProperty(
        name="Plates", description="Names as in the list, P7 P8, blanks between; empty: all"
    )


def _has_rules(context):
    hull = hull_objects.hull_of(context.object)
    return hull is not None and bool(hull.hull.plates.rules)


class ExportPlates(ExportWithNumbers):
    """Exports of plates by the rules of the panel, or without any by the numbers of FREE."""

    FREE = ("strake", "plate_length", "thickness", "frame_spacing")

    strake: FloatProperty(
        name="Strakes m",
        description="Girth from seam to seam, along frames from the deck edge, in metres",
        default=2.4,
        min=0.05,
        max=100.0,
    )
    plate_length: FloatProperty(
        name="Plates m",
        description="Distance of a strake's butts, in metres",
        default=10.0,
        min=0.1,
        max=1000.0,
    )
    thickness: plate_settings.thickness()
    frame_spacing: FloatProperty(
        name="Frames m",
        description="Spacing of frames marked on the plates, from x = 0, in metres; 0: none",
        default=0.6,
        min=0.0,
        max=100.0,
    )

    def draw(self, context):
        super().draw(context)
        if _has_rules(context):
            self.layout.label(text="Seams, thickness and frames: panel Plates")

    def numbers(self):
        free = () if _has_rules(bpy.context) else self.FREE
        return (*self.NAMES, *free)

    def outcome(self, result, scene):
        return f"{self.bl_label}: {result.text}", bool(result.unsettled)

    def sizes(self, hull):
        """How plates are made, as plate_files.PlateTask takes it."""
        settings = hull.hull.plates
        has_own = settings.rules and not self.properties.is_property_set("thickness")
        return {
            "strake": self.strake,
            "plate_length": self.plate_length,
            "thickness": (settings.thickness if has_own else self.thickness) / 1000.0,
            "frame_spacing": self.frame_spacing,
        }


class HULL_OT_export_plates(bpy.types.Operator, ExportPlates):
    """Divide the half hull's shell into plates by the rules under Plates, or else by strakes from
    the deck edge and staggered butts, lay them out flat, and write drawings, or the list"""

    bl_idname = "hull.export_plates"
    bl_label = "Export Plates"

    NAMES = ("in_sheets", "paper", "plates")
    filename_ext = ".pdf"
    filter_glob: filter_choice(".pdf", ".svg", ".dxf", ".csv")
    format: formats(PAGES, SHEET, ALL, (".csv", "CSV", "The list: sizes, weights, stretch"))
    in_sheets: in_sheets_choice()
    paper: paper_choice()
    plates: _names()

    def begin(self, hull, scene):
        return plate_files.PlateFile(
            hull,
            scene,
            self.filepath,
            in_sheets=self.in_sheets,
            paper=self.paper,
            names=self.plates,
            **self.sizes(hull),
        )


class HULL_OT_export_templates(bpy.types.Operator, ExportPlates):
    """Write the templates of plates: what stands upright on a plate at each frame that crosses it,
    from one base plane"""

    bl_idname = "hull.export_templates"
    bl_label = "Export Templates"

    NAMES = ("in_sheets", "paper", "plates", "height")
    filename_ext = ".pdf"
    filter_glob: filter_choice(".pdf", ".svg", ".dxf")
    format: formats(PAGES, SHEET, ALL)
    in_sheets: in_sheets_choice()
    paper: paper_choice()
    plates: _names()
    height: FloatProperty(
        name="Height mm",
        description="Of the templates, where they are lowest",
        default=150.0,
        min=1.0,
        max=5000.0,
        precision=0,
    )

    def name_part(self):
        return "-templates"

    def begin(self, hull, scene):
        return plate_drawings.TemplateFile(
            hull,
            scene,
            self.filepath,
            names=self.plates,
            height=self.height / 1000.0,
            in_sheets=self.in_sheets,
            paper=self.paper,
            **self.sizes(hull),
        )


class HULL_OT_export_stretch(bpy.types.Operator, ExportPlates):
    """Write maps of stretch of doubly curved plates: lines along which the hull's area is so many
    thousandths larger than the flat plate's"""

    bl_idname = "hull.export_stretch"
    bl_label = "Export Stretch"

    NAMES = ("plates",)
    filename_ext = ".pdf"
    filter_glob: filter_choice(".pdf", ".dxf")
    format: formats((".pdf", "PDF", "A page each, reduced to fit A3"), ALL)
    plates: _names()

    def name_part(self):
        return "-stretch"

    def begin(self, hull, scene):
        return plate_drawings.StretchFile(
            hull, scene, self.filepath, names=self.plates, **self.sizes(hull)
        )


class HULL_OT_export_nesting(bpy.types.Operator, ExportPlates):
    """Lay all plates of both sides on plates of the mill by their rectangles, and write drawings,
    or the list to order by"""

    bl_idname = "hull.export_nesting"
    bl_label = "Export Nesting"

    NAMES = ("stock_length", "stock_breadth", "margin")
    filename_ext = ".pdf"
    filter_glob: filter_choice(".pdf", ".dxf", ".csv")
    format: formats(
        (".pdf", "PDF", "A page for each plate of the mill"),
        ALL,
        (".csv", "CSV", "The list: which plate lies where"),
    )
    stock_length: FloatProperty(
        name="Length m", description="Of plates of the mill", default=12.0, min=0.1, max=100.0
    )
    stock_breadth: FloatProperty(
        name="Breadth m", description="Of plates of the mill", default=3.0, min=0.1, max=100.0
    )
    margin: FloatProperty(
        name="Margin mm",
        description="Left around each plate",
        default=20.0,
        min=0.0,
        max=1000.0,
        precision=0,
    )

    def name_part(self):
        return "-nesting"

    def begin(self, hull, scene):
        self._nesting = plate_drawings.NestingFile(
            hull,
            scene,
            self.filepath,
            stock=(self.stock_length, self.stock_breadth),
            margin=self.margin / 1000.0,
            **self.sizes(hull),
        )
        return self._nesting

    def outcome(self, result, scene):
        pieces = sum(len(stock.laid) for stock in self._nesting.used)
        text = f"{pieces} pieces on {counted(len(self._nesting.used), 'plate')} of the mill"
        return f"{self.bl_label}: {text}", bool(result.unsettled)


class HULL_OT_export_frames(bpy.types.Operator, ExportWithNumbers):
    """Draw the frames of the table: the inner side of the plating, with seams, and waterlines where
    they are marked"""

    bl_idname = "hull.export_frames"
    bl_label = "Frame Drawings"

    NAMES = ("in_sheets", "paper", "frames", "inside")
    filename_ext = ".pdf"
    filter_glob: filter_choice(".pdf", ".svg", ".dxf")
    format: formats(PAGES, SHEET, ALL)
    in_sheets: in_sheets_choice()
    paper: paper_choice()
    frames: StringProperty(
        name="Frames",
        description="Numbers with blanks between, or first:last:step; empty: all on the hull",
    )
    inside: BoolProperty(
        name="Inside of plating",
        description="Draw the inner side of plates of the panel's thickness, too",
        default=True,
    )

    def name_part(self):
        return "-frames"

    def begin(self, hull, scene):
        thickness = hull.hull.plates.thickness / 1000.0
        return frame_files.FrameFile(
            hull,
            scene,
            self.filepath,
            frames=self.frames,
            thickness=thickness if self.inside else 0.0,
            in_sheets=self.in_sheets,
            paper=self.paper,
        )

    def outcome(self, result, scene):
        return f"{counted(result, 'frame')} written", False


class HULL_OT_export_frame_table(bpy.types.Operator, ExportWithNumbers):
    """Write the table of frames: numbers, places, spacings, and the hull's breadth, heights and
    girth at each"""

    bl_idname = "hull.export_frame_table"
    bl_label = "Frame Table"

    NAMES = ()
    filename_ext = ".csv"
    filter_glob: filter_choice(".csv")
    format: formats((".csv", "CSV", "A table, which a spreadsheet opens"))

    def name_part(self):
        return "-frame-table"

    def begin(self, hull, scene):
        return frame_files.FrameTableFile(hull, scene, self.filepath)

    def outcome(self, result, scene):
        return f"{counted(result, 'frame')} listed", False


CLASSES = (
    HULL_OT_export_plates,
    HULL_OT_export_templates,
    HULL_OT_export_stretch,
    HULL_OT_export_nesting,
    HULL_OT_export_frames,
    HULL_OT_export_frame_table,
)
