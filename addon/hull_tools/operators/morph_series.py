# SPDX-License-Identifier: GPL-3.0-or-later
"""Series of members of a family: tables of their numbers, and a file of each."""

import bpy
from bpy.props import BoolProperty, EnumProperty, IntProperty, StringProperty

from ..bridge.counts import counted
from ..features.morphing import series_files, weights
from .export_hull import ExportByTask
from .morph import is_member
from .tasks import TaskOperator


def _weights(which):
    return StringProperty(
        name=f"{which} Weights",
        description="One for each parent, such as 0.3 0.7; blank: as the panel has it",
        options={"SKIP_SAVE", "HIDDEN"},
    )


class SeriesOperator:
    """What a series is of, for scripts; in the panel it is from parent to parent."""

    def asked(self):
        return {
            "first": weights.numbers(self.first_weights) or None,
            "last": weights.numbers(self.last_weights) or None,
            "steps": self.steps or None,
        }


def _steps():
    return IntProperty(
        name="Steps",
        description="From the first member to the last; 0: as the panel has it",
        min=0,
        options={"SKIP_SAVE", "HIDDEN"},
    )


class HULL_OT_export_series_table(bpy.types.Operator, SeriesOperator, ExportByTask):
    """Write all particulars of a series of members as CSV, and beside it their sectional areas"""

    bl_idname = "hull.export_series_table"
    bl_label = "Table of Series"

    needs = (*ExportByTask.needs, is_member)
    filename_ext = ".csv"
    filter_glob: StringProperty(default="*.csv", options={"HIDDEN"})
    first_weights: _weights("First")
    last_weights: _weights("Last")
    steps: _steps()

    def name_part(self):
        return "-series"

    def begin(self, hull, scene):
        return series_files.SeriesTables(hull, scene, self.filepath, **self.asked())

    def done(self):
        return "Tables of the series written: particulars and areas"


class HULL_OT_export_series(bpy.types.Operator, SeriesOperator, TaskOperator):
    """Write each member of a series to a file of its own in a folder"""

    bl_idname = "hull.export_series"
    bl_label = "Export Series"

    needs = (*TaskOperator.needs, is_member)
    directory: StringProperty(
        name="Folder", description="Where the files are written", subtype="DIR_PATH"
    )
    file_format: EnumProperty(
        name="Files",
        description="What each member is written as; blank: as the panel has it",
        items=(
            ("PANEL", "As in the Panel", "What the panel says"),
            ("HULL", "Hull Files", "Hull files (.hull.json)"),
            ("STEP", "STEP", "As the panel Export has it"),
            ("IGES", "IGES", "As the panel Export has it"),
        ),
        options={"SKIP_SAVE", "HIDDEN"},
    )
    filter_folder: BoolProperty(
        name="Folders", description="Show folders", default=True, options={"HIDDEN", "SKIP_SAVE"}
    )
    first_weights: _weights("First")
    last_weights: _weights("Last")
    steps: _steps()

    def invoke(self, context, event):
        self._is_in_window = not bpy.app.background
        if not self.properties.is_property_set("directory"):
            self.directory = bpy.path.abspath("//")
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def begin(self, hull, scene):
        chosen = self.file_format
        if chosen == "PANEL":
            chosen = hull.hull.morph.series_format
        if not self.directory:
            raise ValueError("No folder is named: choose the one that the files go to")
        folder = bpy.path.abspath(self.directory)
        return series_files.SeriesFiles(hull, scene, folder, chosen, **self.asked())

    def outcome(self, paths, scene):
        return f"Series written: {counted(len(paths), 'file')}", False


CLASSES = (HULL_OT_export_series_table, HULL_OT_export_series)
