# SPDX-License-Identifier: GPL-3.0-or-later
"""Plates; and what exports with numbers in their dialogs have in common."""

import bpy
from bpy.props import EnumProperty, FloatProperty, StringProperty

from ..bridge.objects import hull_objects
from ..features.exchange import plate_files
from .export_hull import ExportByTask, ExportDrawing


class ExportWithNumbers(ExportDrawing, ExportByTask):
    """Exports whose dialogs have numbers below the choice of `format`: numbers() → their names."""

    def draw(self, context):
        super().draw(context)
        column = self.layout.column()
        column.use_property_split = True
        for name in self.numbers():
            column.prop(self, name)

    def outcome(self, result, scene):
        return f"{self.bl_label}: {result}", False


class HULL_OT_export_plates(bpy.types.Operator, ExportWithNumbers):
    """Divide the half hull's shell into plates by the rules under Plates, or else by strakes from
    the deck edge and staggered butts, lay them out flat, and write drawings, or the list"""

    bl_idname = "hull.export_plates"
    bl_label = "Export Plates"

    filename_ext = ".pdf"
    filter_glob: StringProperty(default="*.pdf;*.dxf;*.csv", options={"HIDDEN"})
    format: EnumProperty(
        name="Format",
        description="What the file is; the name's ending says the same",
        items=[
            (".pdf", "PDF", "A page for each plate"),
            (".dxf", "DXF", "All plates at true size, in mm"),
            (".csv", "CSV", "The list: sizes, weights, stretch"),
        ],
        options={"SKIP_SAVE"},
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
    thickness: FloatProperty(
        name="Thickness mm",
        description="Of the plates, for their weights",
        default=10.0,
        min=0.01,
        max=1000.0,
    )
    frame_spacing: FloatProperty(
        name="Frames m",
        description="Spacing of frames marked on the plates, from x = 0, in metres; 0: none",
        default=0.6,
        min=0.0,
        max=100.0,
    )

    def numbers(self):
        return ("strake", "plate_length", "thickness", "frame_spacing")

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
