# SPDX-License-Identifier: GPL-3.0-or-later
"""Plates; and what exports with numbers in their dialogs have in common."""

import bpy
from bpy.props import FloatProperty, StringProperty

from ..bridge.objects import hull_objects
from ..features.exchange import plate_files
from ..properties import plate_settings
from .export_hull import ExportByTask, ExportDrawing, formats


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
            column.prop(self, name)


class HULL_OT_export_plates(bpy.types.Operator, ExportWithNumbers):
    """Divide the half hull's shell into plates by the rules under Plates, or else by strakes from
    the deck edge and staggered butts, lay them out flat, and write drawings, or the list"""

    bl_idname = "hull.export_plates"
    bl_label = "Export Plates"

    NAMES = ("strake", "plate_length", "thickness", "frame_spacing")
    filename_ext = ".pdf"
    filter_glob: StringProperty(default="*.pdf;*.dxf;*.csv", options={"HIDDEN"})
    format: formats(
        (".pdf", "PDF", "A page for each plate"),
        (".dxf", "DXF", "All plates at true size, in mm"),
        (".csv", "CSV", "The list: sizes, weights, stretch"),
    )
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
        if not hull_objects.hull_of(context.object).hull.plates.rules:
            super().draw(context)
            return
        ExportDrawing.draw(self, context)
        self.layout.label(text="Seams, thickness and frames: panel Plates")

    def outcome(self, result, scene):
        return f"{self.bl_label}: {result.text}", bool(result.unsettled)

    def begin(self, hull, scene):
        settings = hull.hull.plates
        has_own = settings.rules and not self.properties.is_property_set("thickness")
        return plate_files.PlateFile(
            hull,
            scene,
            self.filepath,
            strake=self.strake,
            plate_length=self.plate_length,
            thickness=(settings.thickness if has_own else self.thickness) / 1000.0,
            frame_spacing=self.frame_spacing,
        )


CLASSES = (HULL_OT_export_plates,)
