# SPDX-License-Identifier: GPL-3.0-or-later
"""The hull fitted to a shape, and shapes read from STL files."""

from pathlib import Path

import bpy
from bpy.props import FloatProperty, StringProperty
from bpy_extras.io_utils import ImportHelper

from ... import hull_io
from ..bridge.blender import units
from ..bridge.counts import counted
from ..bridge.objects import hull_objects
from ..features.fitting import fitting
from ..properties.shared import metric_field
from .shared import HullOperator, HullReader, can_change, collection_for_new, property_column
from .tasks import TaskOperator


class HULL_OT_fit(bpy.types.Operator, TaskOperator):
    """Move the control points so that the surface comes to lie on the target. Locked points stay,
    flats stay flat, and points on the centre plane stay there"""

    bl_idname = "hull.fit"
    bl_label = "Fit"
    bl_options = {"REGISTER", "UNDO"}

    needs = (*TaskOperator.needs, can_change)

    def begin(self, hull, scene):
        return fitting.Fitting(hull, scene)

    def outcome(self, fit, scene):
        report = self._task.write(scene)
        return fitting.summary(report), bool(fitting.warning(report)) or not report.settled


class HULL_OT_show_fit_worst(bpy.types.Operator, HullReader):
    """Set the 3D cursor where the surface is farthest from the target, and bring it into view"""

    bl_idname = "hull.show_fit_worst"
    bl_label = "Show Largest"

    def run_on(self, hull, context):
        fitting.mark_worst(hull, context.scene, context.region_data)


class HULL_OT_load_stl(bpy.types.Operator, HullOperator, ImportHelper):
    """Read the triangles of an STL file as an object, and fit to that"""

    bl_idname = "hull.load_stl"
    bl_label = "Load STL"

    filter_glob: StringProperty(default="*.stl", options={"HIDDEN"})
    metres: FloatProperty(
        name="Metres per unit",
        description="How many metres 1 in the file is: 0.001 for millimetres",
        default=1.0,
        min=1e-6,
        max=1e6,
        precision=4,
    )

    def draw(self, context):
        metric_field(property_column(self), self, "metres", "m")

    def run_on(self, hull, context):
        path = Path(self.filepath)
        points, triangles = hull_io.read_stl(path)
        points *= units.as_typed(self.metres) / units.metres_per_unit(context.scene)
        shape = fitting.shape_object(path.stem, points, triangles, collection_for_new(context))
        shape.location = hull.matrix_world.translation
        hull_objects.hull_of(context.object).hull.fit.target = shape
        self.tell("INFO", f"{shape.name}: {counted(len(triangles), 'triangle')} read")


CLASSES = (HULL_OT_fit, HULL_OT_show_fit_worst, HULL_OT_load_stl)
