# SPDX-License-Identifier: GPL-3.0-or-later
"""New marks of transformations: faired out, and the way that leaves the fewest."""

import bpy
from bpy.props import BoolProperty, FloatProperty

from ..bridge.blender import units
from ..features.transformation import fair_changes, fewest_marks
from .displacement import MEASURES, NO_MEASURE, DisplacementTask, measure_property
from .shared import can_change, property_column
from .tasks import TaskOperator

_SKIP = {"SKIP_SAVE"}
# Those that stay while marks are faired out; the area amidships, and Cp with it, need not.
_KEPT_MEASURES = tuple(item for item in MEASURES if item[0] != "PRISMATIC")


def _per_mille():
    return FloatProperty(
        name="Deviation in ‰ of B",
        description="How far the surface may shift at most, root mean square, per mille of the "
        "beam; it shifts by no more than it takes",
        default=5.0,
        min=0.0,
        max=100.0,
        options=_SKIP,
    )


def _keep_parallel():
    return BoolProperty(
        name="Parallel body",
        description="Control points of the parallel middle body stay",
        default=True,
        options=_SKIP,
    )


class HULL_OT_fair_new_marks(bpy.types.Operator, TaskOperator):
    """Take out marks that the hull has and the form before the last transformation had not:
    control points move across the ship, and along it only where that leaves marks. Displacement
    and centre of buoyancy stay"""

    bl_idname = "hull.fair_new_marks"
    bl_label = "Fair New Marks"
    bl_options = {"REGISTER", "UNDO"}

    needs = (*TaskOperator.needs, can_change)

    per_mille: _per_mille()
    keep_parallel: _keep_parallel()

    def begin(self, hull, scene):
        most = 1e-3 * units.as_typed(self.per_mille)
        return fair_changes.FairingChange(hull, scene, fair_changes.Asked(most, self.keep_parallel))

    def outcome(self, found, scene):
        return fair_changes.summary(self._task.write(scene))


class HULL_OT_fewest_marks(bpy.types.Operator, DisplacementTask):
    """Bring the hull to the displacement and the centre of buoyancy that are wanted by shifts of
    its sections or by the least change, and fair out the marks that are new: the way that leaves
    the fewest is taken"""

    bl_idname = "hull.fewest_marks"
    bl_label = "Displacement and LCB, Fewest New Marks"
    bl_options = {"REGISTER", "UNDO"}

    needs = (*TaskOperator.needs, can_change)

    measure: measure_property(*_KEPT_MEASURES, NO_MEASURE)
    per_mille: _per_mille()
    keep_parallel: _keep_parallel()

    def draw(self, context):
        column = property_column(self)
        column.prop(self, "measure")
        self.draw_wanted(column)
        column.prop(self, "per_mille")
        column.prop(self, "keep_parallel")

    def begin(self, hull, scene):
        most = 1e-3 * units.as_typed(self.per_mille)
        asked = fewest_marks.Asked(*self.wanted(hull, scene), most, self.keep_parallel)
        return fewest_marks.FewestMarks(hull, scene, asked)

    def outcome(self, found, scene):
        return fewest_marks.summary(self._task.write(scene), scene)


CLASSES = (HULL_OT_fair_new_marks, HULL_OT_fewest_marks)
