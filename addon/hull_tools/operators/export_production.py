# SPDX-License-Identifier: GPL-3.0-or-later
"""Models for printers and mills, panels for programs that compute waves and motions, plates."""

import bpy
from bpy.props import EnumProperty, FloatProperty, IntProperty, StringProperty

from ..bridge.objects import hull_objects
from ..features.exchange import plate_files, production_files
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


class HULL_OT_export_model(bpy.types.Operator, ExportWithNumbers):
    """Write the closed hull as a model for printers and mills: STL, 3MF or OBJ, or CLI in layers.
    Lengths in the file are millimetres"""

    bl_idname = "hull.export_model"
    bl_label = "Export Model"

    filename_ext = ".stl"
    filter_glob: StringProperty(default="*.stl;*.3mf;*.obj;*.cli", options={"HIDDEN"})
    format: EnumProperty(
        name="Format",
        description="What the file is; the name's ending says the same",
        items=[
            (".stl", "STL", "Triangles, binary"),
            (".3mf", "3MF", "Triangles with their unit"),
            (".obj", "OBJ", "Triangles as a text"),
            (".cli", "CLI", "Contours of layers"),
        ],
        options={"SKIP_SAVE"},
    )
    scale: FloatProperty(
        name="Scale 1 :",
        description="How many times smaller than the ship the model is",
        default=100.0,
        min=0.1,
        max=10000.0,
    )
    tolerance: FloatProperty(
        name="Tolerance mm",
        description="How far the model's triangles may be from the surface, on the model",
        default=0.05,
        min=0.0005,
        max=10.0,
        precision=4,
    )
    layer: FloatProperty(
        name="Layers mm",
        description="Thickness of the layers, on the model",
        default=0.2,
        min=0.001,
        max=1000.0,
        precision=3,
    )

    def numbers(self):
        return ("scale", "tolerance", "layer") if self.format == ".cli" else ("scale", "tolerance")

    def begin(self, hull, scene):
        return production_files.ModelFile(
            hull,
            scene,
            self.filepath,
            scale=self.scale,
            tolerance=self.tolerance,
            layer=self.layer,
        )


class HULL_OT_export_panels(bpy.types.Operator, ExportWithNumbers):
    """Write the hull below the water, at its draft, trim and heel, as panels for WAMIT or Nemoh, or
    as OBJ. They end exactly at the waterline"""

    bl_idname = "hull.export_panels"
    bl_label = "Export Panels"

    filename_ext = ".gdf"
    filter_glob: StringProperty(default="*.gdf;*.dat;*.obj", options={"HIDDEN"})
    format: EnumProperty(
        name="Format",
        description="What the file is; the name's ending says the same",
        items=[
            (".gdf", "WAMIT", "Low-order panels of WAMIT"),
            (".dat", "Nemoh", "A mesh of Nemoh"),
            (".obj", "OBJ", "Faces as a text"),
        ],
        options={"SKIP_SAVE"},
    )
    along: IntProperty(
        name="Panels along",
        description="How many of the largest panels the length between perpendiculars has",
        default=60,
        min=4,
        max=1000,
    )
    grading: FloatProperty(
        name="At water and ends",
        description="Size of panels at the water's surface and at the ends, of that of the largest",
        default=0.5,
        min=0.1,
        max=1.0,
    )

    def numbers(self):
        return ("along", "grading")

    def begin(self, hull, scene):
        return production_files.PanelFile(
            hull, scene, self.filepath, along=self.along, grading=self.grading
        )


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


CLASSES = (HULL_OT_export_model, HULL_OT_export_panels, HULL_OT_export_plates)
