# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull's files, drawings and tables for others; and what all its exports have in common."""

import os

import bpy
from bpy.props import EnumProperty, StringProperty
from bpy_extras.io_utils import ExportHelper

from ..bridge.objects import hull_objects
from ..features import analyses
from ..features.exchange import endings, file_tasks, hull_files, program_files
from .shared import HullReader
from .tasks import TaskOperator


class ExportHull(HullReader, ExportHelper):
    """Subclasses write a file of a hull and return what is to be said then: write(hull, scene)."""

    bl_options = {"REGISTER"}

    def invoke(self, context, event):
        if not self.properties.is_property_set("filepath"):
            folder = bpy.path.abspath("//")
            name = bpy.path.clean_name(hull_objects.hull_of(context.object).name)
            name += self.name_part()
            self.filepath = bpy.path.ensure_ext(folder + name, self.filename_ext)
        return super().invoke(context, event)

    def run(self, context):
        endings.check_named(self.filepath)
        return super().run(context)

    def name_part(self):
        """What stands between the hull's name and the ending."""
        return ""

    def run_on(self, hull, context):
        self.tell("INFO", self.write(hull, context.scene))


class ExportByTask(TaskOperator, ExportHull):
    """An export whose work may take seconds. Subclasses: begin(hull, scene) → task; done: what is
    to be said then."""

    def invoke(self, context, event):
        self._is_in_window = not bpy.app.background
        return ExportHull.invoke(self, context, event)

    def outcome(self, result, scene):
        return self.done(), False


class HULL_OT_export_hull(bpy.types.Operator, ExportHull):
    """Write the hull with layers, marks, loads, targets and variants as a hull file, which can be
    imported again"""

    bl_idname = "hull.export_hull"
    bl_label = "Export Hull File"

    filename_ext = ".hull.json"
    check_extension = None  # Blender knows endings of one part only
    filter_glob: StringProperty(default="*.hull.json", options={"HIDDEN"})

    def check(self, context):
        """The ending is there when Blender looks whether such a file is there already."""
        before = self.filepath
        if os.path.basename(before):
            self.filepath = bpy.path.ensure_ext(before, self.filename_ext)
        return self.filepath != before

    def write(self, hull, scene):
        path = bpy.path.ensure_ext(self.filepath, self.filename_ext)
        hull_files.export_hull_file(hull, scene, path)
        return "Hull file written"


class HULL_OT_export_freeship(bpy.types.Operator, ExportHull):
    """Write the control mesh as a FREE!ship file, in feet where the scene's units are imperial"""

    bl_idname = "hull.export_freeship"
    bl_label = "Export FREE!ship"

    filename_ext = ".fbm"
    filter_glob: StringProperty(default="*.fbm", options={"HIDDEN"})

    def write(self, hull, scene):
        path = bpy.path.ensure_ext(self.filepath, self.filename_ext)
        for remark in program_files.export_freeship(hull, scene, path):
            self.tell("WARNING", remark)
        return "FREE!ship file written"


def formats(*items):
    """The choice of `format`; items: (ending, name, description) each."""
    return EnumProperty(
        name="Format",
        description="What the file is; the name's ending says the same",
        items=items,
        options={"SKIP_SAVE"},
    )


def _format(*kinds):
    """The choice of a file's form in its dialog; what the name ends in counts."""
    return formats(*((f".{kind}", kind.upper(), _FORMATS[kind]) for kind in kinds))


_FORMATS = {
    "pdf": "Paper to scale, as one opens and prints it",
    "svg": "Paper to scale, for drawing programs and web pages",
    "png": "A picture in dots",
    "dxf": "Splines at the ship's true size, for CAD systems",
}


class ExportDrawing(ExportHull):
    """The exports that have a choice of `format`, an ending."""

    filename_ext = ".pdf"
    check_extension = None

    def draw(self, context):
        self.layout.prop(self, "format", expand=True)

    def check(self, context):
        """The name's ending follows the choice, and the choice a name that is typed."""
        base, ending = os.path.splitext(self.filepath)
        if self.format == self._chosen and ending.lower() in self._endings():
            self.format = ending.lower()
        elif ending.lower() in self._endings():
            self.filepath = base + self.format
        else:
            self.filepath += self.format
        has_changed = self._chosen != self.format or not self.filepath.endswith(ending)
        self._chosen = self.format
        return has_changed

    def invoke(self, context, event):
        self._chosen = self.format
        return super().invoke(context, event)

    def _endings(self):
        return self.properties.bl_rna.properties["format"].enum_items.keys()


class HULL_OT_export_lines(bpy.types.Operator, ExportDrawing, ExportByTask):
    """Draw body plan, profile and half-breadth plan as PDF, SVG, PNG or DXF"""

    bl_idname = "hull.export_lines"
    bl_label = "Export Lines Plan"

    filter_glob: StringProperty(default="*.pdf;*.svg;*.png;*.dxf", options={"HIDDEN"})
    format: _format("pdf", "svg", "png", "dxf")

    def begin(self, hull, scene):
        return file_tasks.LinesDrawing(hull, scene, self.filepath)

    def done(self):
        return "Lines plan written"


class HULL_OT_export_sections(bpy.types.Operator, ExportDrawing):
    """Write the stations for programs that know hulls by sections"""

    bl_idname = "hull.export_sections"
    bl_label = "Export Sections"

    filename_ext = ".gf"
    filter_glob: StringProperty(default="*.gf;*.hll;*.mlt;*.txt", options={"HIDDEN"})
    format: formats(
        (".gf", "GHS", "The stations, in feet where the scene's units are imperial"),
        (".hll", "Archimedes", "The stations of both sides, in metres"),
        (".mlt", "Michlet", "Half-breadths below the water, and the speeds of Resistance"),
        (".txt", "Text", "The stations as plain text, in metres, for PIAS and others"),
    )

    def write(self, hull, scene):
        ending = os.path.splitext(self.filepath)[1].lower()
        path = self.filepath if ending in self._endings() else self.filepath + self.format
        program_files.export_sections(hull, scene, path)
        return "Sections written"


def _analysis_items(names):
    return tuple((name, *analyses.WORDS[name]) for name in names)


class ExportAnalysis:
    """Of the exports of tables and plots: `analysis` says which; files are named after both."""

    def name_part(self):
        return f"-{self.analysis}"

    def label(self):
        return analyses.WORDS[self.analysis][0]


class HULL_OT_export_table(bpy.types.Operator, ExportAnalysis, ExportByTask):
    """Write a table as CSV, which a spreadsheet opens"""

    bl_idname = "hull.export_table"
    bl_label = "Export Table"

    filename_ext = ".csv"
    filter_glob: StringProperty(default="*.csv", options={"HIDDEN"})
    analysis: EnumProperty(
        name="Table", description="What the table is of", items=_analysis_items(analyses.ANALYSES)
    )

    def begin(self, hull, scene):
        return file_tasks.Table(hull, scene, self.analysis, self.filepath)

    def done(self):
        return f"{self.label()}: table written"


class HULL_OT_export_plot(bpy.types.Operator, ExportAnalysis, ExportDrawing, ExportByTask):
    """Draw a plot on paper as PDF, SVG or PNG"""

    bl_idname = "hull.export_plot"
    bl_label = "Export Plot"

    filter_glob: StringProperty(default="*.pdf;*.svg;*.png", options={"HIDDEN"})
    format: _format("pdf", "svg", "png")
    analysis: EnumProperty(
        name="Plot", description="What the plot is of", items=_analysis_items(analyses.PLOTTED)
    )

    def begin(self, hull, scene):
        return file_tasks.Plot(hull, scene, self.analysis, self.filepath)

    def done(self):
        return f"{self.label()}: plot written"


def draw_export_menu(self, context):
    layout = self.layout
    layout.operator(HULL_OT_export_hull.bl_idname, text="Ship hull (.hull.json)")
    layout.operator(HULL_OT_export_freeship.bl_idname, text="FREE!ship hull (.fbm)")
    layout.operator(HULL_OT_export_sections.bl_idname, text="Hull sections (.gf, .hll, .mlt, .txt)")
    layout.operator("hull.export_step", text="Hull surface (.step)")
    layout.operator("hull.export_iges", text="Hull surface (.igs)")
    layout.operator(HULL_OT_export_lines.bl_idname, text="Hull lines plan (.pdf, .svg, .png, .dxf)")
    layout.operator("hull.export_view", text="Hull view (.pdf, .svg, .dxf)")
    layout.operator("hull.export_curvature", text="Hull curvature (.pdf, .svg, .png)")
    layout.operator("hull.export_curves", text="Hull lines in space (.dxf)")
    layout.operator("hull.export_figures", text="Hull figures (.png, .pdf, .svg)")
    layout.operator("hull.export_model", text="Hull model (.stl, .3mf, .obj, .cli)")
    layout.operator("hull.export_panels", text="Hull panels (.gdf, .dat, .obj)")
    layout.operator("hull.export_parts", text="Hull in named parts (.stl)")
    layout.operator("hull.export_plates", text="Hull plates (.pdf, .svg, .dxf, .csv)")
    layout.operator("hull.export_templates", text="Templates of plates (.pdf, .svg, .dxf)")
    layout.operator("hull.export_stretch", text="Stretch of plates (.pdf, .dxf)")
    layout.operator("hull.export_nesting", text="Nesting of plates (.pdf, .dxf, .csv)")
    layout.operator("hull.export_frames", text="Hull frames (.pdf, .svg, .dxf)")
    layout.operator("hull.export_frame_table", text="Table of frames (.csv)")
    layout.operator_menu_enum("hull.export_table", "analysis", text="Hull table (.csv)")
    layout.operator_menu_enum("hull.export_plot", "analysis", text="Hull plot (.pdf, .svg, .png)")


CLASSES = (
    HULL_OT_export_hull,
    HULL_OT_export_freeship,
    HULL_OT_export_sections,
    HULL_OT_export_lines,
    HULL_OT_export_table,
    HULL_OT_export_plot,
)
