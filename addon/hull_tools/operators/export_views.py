# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings of a hull beside its lines plan: the view, curvature along a section, lines in space,
and the figures that present it."""

from math import radians

import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, FloatProperty, StringProperty

from ..bridge import native
from ..bridge.blender import units
from ..features.exchange import figure_files, view_files
from .export_hull import ExportByTask, ExportDrawing, formats
from .export_numbers import ExportWithNumbers


def _largest_view(context):
    """The RegionView3D of the largest 3D view, as an operator of File › Export is in none; None in
    the background, which has none to look at."""
    if bpy.app.background:
        return None
    areas = (area for window in context.window_manager.windows for area in window.screen.areas)
    views = [area for area in areas if area.type == "VIEW_3D"]
    if not views:
        return None
    return max(views, key=lambda area: area.width * area.height).spaces.active.region_3d


class HULL_OT_export_view(bpy.types.Operator, ExportWithNumbers):
    """Draw the hull as the 3D view shows it, with the lines of Sections, knuckles and outlines, and
    what is hidden left out: PDF, SVG or DXF"""

    bl_idname = "hull.export_view"
    bl_label = "Export View"

    NAMES = ("hidden",)
    filter_glob: StringProperty(default="*.pdf;*.svg;*.dxf", options={"HIDDEN"})
    format: formats(
        (".pdf", "PDF", "Paper to scale, one sheet of A3"),
        (".svg", "SVG", "Paper to scale, for drawing programs and web pages"),
        (".dxf", "DXF", "At true size, in mm"),
    )
    hidden: BoolProperty(name="Hidden dashed", description="Draw what is behind, too, dashed")
    azimuth: FloatProperty(
        name="Azimuth",
        description="Without a 3D view: from where the hull is seen, from ahead to port",
        default=radians(-40.0),
        subtype="ANGLE",
    )
    elevation: FloatProperty(
        name="Elevation",
        description="Without a 3D view: how far above the hull that is",
        default=radians(15.0),
        subtype="ANGLE",
    )

    def name_part(self):
        return "-view"

    def run_on(self, hull, context):
        self._view = self._seen(hull, context)
        return super().run_on(hull, context)

    def _seen(self, hull, context):
        shown = context.region_data or _largest_view(context)
        if shown is None:
            axes = native.require().view_axes(self.azimuth, self.elevation)
            return view_files.View(axes)
        matrix = np.array(shown.view_matrix @ hull.matrix_world)
        axes = matrix[:3, :3] / np.linalg.norm(matrix[:3, :3], axis=1)[:, None]
        if not shown.is_perspective:
            return view_files.View(axes)
        middle = np.array(hull.bound_box).mean(axis=0)
        away = -(matrix[:3, :3] @ middle + matrix[:3, 3])[2]
        return view_files.View(axes, float(away * units.metres_per_unit(context.scene)))

    def begin(self, hull, scene):
        return view_files.ViewFile(hull, scene, self.filepath, self._view, self.hidden)

    def done(self):
        return "View written"


class HULL_OT_export_curvature(bpy.types.Operator, ExportWithNumbers):
    """Draw the curvature along a station, buttock or waterline over its girth, with a circle's
    and that of the hull that this one is compared with: PDF, SVG or PNG"""

    bl_idname = "hull.export_curvature"
    bl_label = "Export Curvature"

    NAMES = ("axis", "position", "radius", "with_other")
    filter_glob: StringProperty(default="*.pdf;*.svg;*.png", options={"HIDDEN"})
    format: formats(
        (".pdf", "PDF", "Paper, as one opens and prints it"),
        (".svg", "SVG", "For drawing programs and web pages"),
        (".png", "PNG", "A picture in dots"),
    )
    axis: EnumProperty(
        name="Section",
        description="What the curvature is along",
        items=(
            ("x", "Station", "Across the ship"),
            ("y", "Buttock", "Along the ship, upright"),
            ("z", "Waterline", "Along the ship, level"),
        ),
    )
    position: FloatProperty(
        name="At m", description="Where the section is, in m", default=0.0, precision=3
    )
    radius: FloatProperty(
        name="Circle m", description="Radius of a circle to compare with, in m; 0: none", min=0.0
    )
    with_other: BoolProperty(
        name="Compared hull", description="Draw that of the hull chosen in Variants, too"
    )

    def name_part(self):
        return "-curvature"

    def begin(self, hull, scene):
        return view_files.CurvatureFile(
            hull,
            scene,
            self.filepath,
            axis=self.axis,
            position=self.position,
            radius=self.radius,
            with_other=self.with_other,
        )

    def done(self):
        return "Curvature written"


class HULL_OT_export_curves(bpy.types.Operator, ExportWithNumbers):
    """Write all lines of Sections, knuckles and borders, of both sides, as splines in space at true
    size: DXF"""

    bl_idname = "hull.export_curves"
    bl_label = "Export Lines in Space"

    NAMES = ("unit",)
    filename_ext = ".dxf"
    filter_glob: StringProperty(default="*.dxf", options={"HIDDEN"})
    format: formats((".dxf", "DXF", "Splines in space"))
    unit: EnumProperty(
        name="Unit",
        description="The unit of the file's numbers",
        items=(
            ("m", "Metres", "1 in the file is 1 m"),
            ("mm", "Millimetres", "1 in the file is 1 mm"),
        ),
    )

    def name_part(self):
        return "-lines"

    def begin(self, hull, scene):
        return view_files.CurvesFile(hull, scene, self.filepath, self.unit)

    def outcome(self, result, scene):
        return f"{result} lines written", False


class HULL_OT_export_figures(bpy.types.Operator, ExportDrawing, ExportByTask):
    """Write five figures that present the hull, a file each, named after this one: with paint,
    sections and waterlines, its reflections, control mesh, lines plan and sections plan"""

    bl_idname = "hull.export_figures"
    bl_label = "Export Figures"

    filename_ext = ".png"
    filter_glob: StringProperty(default="*.png;*.pdf;*.svg", options={"HIDDEN"})
    format: formats(
        (".png", "PNG", "Pictures in dots"),
        (".pdf", "PDF", "Pages, as one opens and prints them"),
        (".svg", "SVG", "For drawing programs and web pages"),
    )

    def begin(self, hull, scene):
        return figure_files.FigureFiles(hull, scene, self.filepath)

    def outcome(self, result, scene):
        return f"{result} figures written", False


CLASSES = (
    HULL_OT_export_view,
    HULL_OT_export_curvature,
    HULL_OT_export_curves,
    HULL_OT_export_figures,
)
