# SPDX-License-Identifier: GPL-3.0-or-later
"""Models for printers and mills, panels and named parts for programs that compute waves and flow:
written, or made for their figures."""

from types import SimpleNamespace

import bpy
from bpy.props import StringProperty

from ..bridge.objects import hull_objects
from ..features.production import made_models, model_figures, production_files
from ..properties import production_settings as settings
from .export_hull import formats
from .export_numbers import ExportWithNumbers
from .tasks import TaskOperator


class ExportAsSet(ExportWithNumbers):
    """Exports whose numbers are those of the sidebar unless told otherwise: own(hull) → the group
    that has them, by the same names."""

    def invoke(self, context, event):
        hull = hull_objects.hull_of(context.object)
        for name in self.NAMES:
            if not self.properties.is_property_set(name):
                setattr(self, name, getattr(self.own(hull), name))
        return super().invoke(context, event)

    def told(self, hull):
        """What has the numbers: those given, the rest the hull's."""
        own = self.own(hull)
        is_set = self.properties.is_property_set
        return SimpleNamespace(
            **{name: getattr(self if is_set(name) else own, name) for name in self.NAMES}
        )

    def outcome(self, result, scene):
        text, remark = result
        return _with_remark(f"{self.bl_label}: {text}", remark)


def _with_remark(text, remark):
    """An outcome: what is said, and whether that is a warning."""
    return (f"{text}. {remark}", True) if remark else (text, False)


class HULL_OT_export_model(bpy.types.Operator, ExportAsSet):
    """Write the closed hull as a model for printers and mills: STL, 3MF or OBJ, or CLI in layers,
    solid or with a wall, whole or in segments. Lengths in the file are millimetres"""

    bl_idname = "hull.export_model"
    bl_label = "Export Model"

    NAMES = (
        *("scale", "tolerance", "wall", "in_segments"),
        *("machine_x", "machine_y", "machine_z", "dowel", "layer"),
    )
    filename_ext = ".stl"
    filter_glob: StringProperty(default="*.stl;*.3mf;*.obj;*.cli", options={"HIDDEN"})
    format: formats(
        (".stl", "STL", "Triangles, binary; segments are a file each"),
        (".3mf", "3MF", "Triangles with their unit; segments in one file"),
        (".obj", "OBJ", "Triangles as a text; segments are a file each"),
        (".cli", "CLI", "Contours of layers"),
    )
    scale: settings.scale(options={"SKIP_SAVE"})
    tolerance: settings.tolerance(options={"SKIP_SAVE"})
    wall: settings.wall(options={"SKIP_SAVE"})
    in_segments: settings.in_segments(options={"SKIP_SAVE"})
    machine_x: settings.machine("X", 300.0, options={"SKIP_SAVE"})
    machine_y: settings.machine("Y", 200.0, options={"SKIP_SAVE"})
    machine_z: settings.machine("Z", 100.0, options={"SKIP_SAVE"})
    dowel: settings.dowel(options={"SKIP_SAVE"})
    layer: settings.layer(options={"SKIP_SAVE"})

    def own(self, hull):
        return hull.hull.model

    def numbers(self):
        names = ["scale", "tolerance", "wall"]
        if self.format == ".cli":
            return (*names, "layer")
        names.append("in_segments")
        if self.in_segments:
            names += ["machine_x", "machine_y", "machine_z", "dowel"]
        return tuple(names)

    def begin(self, hull, scene):
        told = self.told(hull)
        return production_files.ModelFile(
            hull, scene, self.filepath, made_models.model_options(told), told.layer
        )


class HULL_OT_export_panels(bpy.types.Operator, ExportAsSet):
    """Write the hull below the water, at its draft, trim and heel, as panels for WAMIT or Nemoh, or
    as OBJ. They end exactly at the waterline"""

    bl_idname = "hull.export_panels"
    bl_label = "Export Panels"

    NAMES = ("along", "grading")
    filename_ext = ".gdf"
    filter_glob: StringProperty(default="*.gdf;*.dat;*.obj", options={"HIDDEN"})
    format: formats(
        (".gdf", "WAMIT", "Low-order panels of WAMIT"),
        (".dat", "Nemoh", "A mesh of Nemoh"),
        (".obj", "OBJ", "Faces as a text"),
    )
    along: settings.along(options={"SKIP_SAVE"})
    grading: settings.grading(options={"SKIP_SAVE"})

    def own(self, hull):
        return hull.hull.panel_mesh

    def begin(self, hull, scene):
        options = made_models.panel_options(self.told(hull))
        return production_files.PanelFile(hull, scene, self.filepath, options)


class HULL_OT_export_parts(bpy.types.Operator, ExportAsSet):
    """Write the closed hull in named parts, as hull, transom and deck and by its layers, as one STL
    text of many solids in metres: for snappyHexMesh and other meshers of flow"""

    bl_idname = "hull.export_parts"
    bl_label = "Export Named Parts"

    NAMES = ("part_tolerance",)
    filename_ext = ".stl"
    filter_glob: StringProperty(default="*.stl", options={"HIDDEN"})
    format: formats((".stl", "STL", "A text with a solid for each part"))
    part_tolerance: settings.part_tolerance(options={"SKIP_SAVE"})

    def name_part(self):
        return "-parts"

    def own(self, hull):
        return hull.hull.panel_mesh

    def begin(self, hull, scene):
        tolerance = self.told(hull).part_tolerance / 1000.0
        return production_files.PartsFile(hull, scene, self.filepath, tolerance)


class HULL_OT_make_model(bpy.types.Operator, TaskOperator):
    """Make the model without writing it, for its size, triangles, volume and segments"""

    bl_idname = "hull.make_model"
    bl_label = "Make Model"

    def begin(self, hull, scene):
        return model_figures.ModelMaking(hull, scene)

    def outcome(self, result, scene):
        return _with_remark(f"Model: {result.told()}", result.remark())


class HULL_OT_make_panels(bpy.types.Operator, TaskOperator):
    """Make the panels without writing them, for their number and how far their volume is off"""

    bl_idname = "hull.make_panels"
    bl_label = "Make Panels"

    def begin(self, hull, scene):
        return model_figures.PanelMaking(hull, scene)

    def outcome(self, result, scene):
        return _with_remark(f"Panels: {result.told()}", result.remark)


CLASSES = (
    HULL_OT_export_model,
    HULL_OT_export_panels,
    HULL_OT_export_parts,
    HULL_OT_make_model,
    HULL_OT_make_panels,
)
