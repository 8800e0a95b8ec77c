# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface faired around the selected control points, and rows of these smoothed."""

from dataclasses import replace

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty

from ..bridge.blender import units
from ..bridge.counts import counted
from ..features.fairing import region_fairing, row_choice, row_fairing
from ..properties.shared import field_or, metric_field
from .shared import EditModeOperator, property_column
from .tasks import TaskOperator

_QUADRATIC = (
    ("LENGTHWISE", "Bend along the ship", "Sections keep their own bend, as bilges"),
    ("BLEND", "Beside the blend", "What one row has that the others have not: waves along bilges"),
    ("THIN_PLATE", "Bend all ways", "Flatter in sections, too"),
)


def _deviation(by_which):
    return FloatProperty(
        name="Deviation (mm)",
        description=f"Root of the mean square by which {by_which}",
        default=5.0,
        min=0.0,
        max=1e5,
        soft_max=100.0,
        precision=2,
    )


def _keep_stations():
    return BoolProperty(name="Keep stations", description="Points stay at their x", default=True)


class _Settings:
    """What both operators ask for."""

    deviation_mm: _deviation("the surface around the points shifts")
    largest_mm: FloatProperty(
        name="Largest (mm)",
        description="The surface shifts nowhere by more; 0: by any",
        min=0.0,
        max=1e5,
        soft_max=100.0,
        precision=2,
    )
    keep_stations: _keep_stations()
    keep_creases: BoolProperty(
        name="Hold creases",
        description="Points of creases and borders stay",
        default=True,
    )
    along_normals: BoolProperty(
        name="Along normals",
        description="Points move across the surface, and do not slide along it",
        default=True,
    )
    refuse_more: BoolProperty(
        name="Refuse more marks",
        description="Nothing moves if there were more inflections or extrema of curvature then",
    )

    keep_volume: BoolProperty(
        name="Keep displacement", description="The displacement stays, at the draft and trim set"
    )
    keep_lcb: BoolProperty(
        name="Keep LCB", description="The centre of buoyancy stays where it is along the ship"
    )

    own = ("energy",)

    def draw(self, context):
        column = property_column(self)
        for name in self.own:
            column.prop(self, name)
        metric_field(column, self, "deviation_mm")
        field_or(column, self, "largest_mm", "by any")
        for name in (
            "keep_stations",
            "keep_creases",
            "along_normals",
            "keep_volume",
            "keep_lcb",
            "refuse_more",
        ):
            column.prop(self, name)

    def asked(self, energy):
        return region_fairing.Asked(
            1e-3 * units.as_typed(self.deviation_mm),
            1e-3 * units.as_typed(self.largest_mm),
            energy,
            self.keep_stations,
            self.keep_creases,
            self.along_normals,
            self.refuse_more,
            self.keep_volume,
            self.keep_lcb,
        )


class HULL_OT_fair_region(bpy.types.Operator, _Settings, EditModeOperator):
    """Move the selected points so that the surface around them bends as little as can be, within
    a deviation. Locked points stay, flats stay flat"""

    bl_idname = "hull.fair_region"
    bl_label = "Fair Region"

    energy: EnumProperty(
        name="Least",
        description="What is made the least",
        items=_QUADRATIC,
    )

    def run_on(self, hull, context):
        asked = self.asked(self.energy)
        report = region_fairing.fair_selected(hull, context.scene, asked)
        text = region_fairing.summary(report)
        self.tell("WARNING" if report.has_more_marks else "INFO", text)


class HULL_OT_fair_curvature(bpy.types.Operator, _Settings, TaskOperator):
    """The same by the surface's own curvature, or by the marks that are seen, which takes longer"""

    bl_idname = "hull.fair_curvature"
    bl_label = "Fair Curvature"
    bl_options = {"REGISTER", "UNDO"}

    needs = EditModeOperator.needs
    own = ("energy", "by_marks")

    energy: EnumProperty(
        name="Least",
        description="What is made the least",
        items=(
            ("VARIATION", "Variation", "Changes of curvature: spheres and cylinders stay"),
            ("CURVATURE", "Curvature", "Curvature itself: flatter all in all"),
            *_QUADRATIC,
        ),
    )
    by_marks: BoolProperty(
        name="By marks",
        description="Try deviations up to the one given, count the marks that are seen around and "
        "not accepted, and take the middle of those with the fewest",
    )

    def begin(self, hull, scene):
        asked = replace(self.asked(self.energy), by_marks=self.by_marks)
        return region_fairing.Fairing(hull, scene, asked)

    def outcome(self, result, scene):
        report = self._task.write(scene)
        return region_fairing.summary(report), report.has_more_marks or not report.settled


class HULL_OT_show_rows(bpy.types.Operator, EditModeOperator):
    """Show combs and inflections of the rows of control points through the selected edges and
    points: a mesh that looks good gives a surface that looks good"""

    bl_idname = "hull.show_rows"
    bl_label = "Show Rows"

    add: BoolProperty(name="Add", description="Besides the rows that are shown already")

    def run_on(self, hull, context):
        count = row_choice.show(hull, context.scene, self.add)
        self.tell("INFO", f"{counted(count, 'row')} shown")


class FairRow(EditModeOperator):
    """Smooths the rows of what is selected."""

    deviation_mm: _deviation("the points move that may move")
    keep_ends: BoolProperty(
        name="Keep ends", description="The first and the last of the points stay", default=True
    )
    keep_stations: _keep_stations()

    def draw(self, context):
        column = property_column(self)
        metric_field(column, self, "deviation_mm")
        for name in ("keep_ends", "keep_stations"):
            column.prop(self, name)

    def run_on(self, hull, context):
        deviation = 1e-3 * units.as_typed(self.deviation_mm)
        asked = row_fairing.Asked(deviation, self.keep_ends, self.keep_stations)
        report = row_fairing.fair_rows(hull, context.scene, asked)
        text = row_fairing.summary(report)
        self.tell("WARNING" if report.has_more_marks else "INFO", text)


class HULL_OT_fair_row(bpy.types.Operator, FairRow):
    """Move the selected points of a row so that the curve through the row is as smooth as can be,
    within a mean deviation. With a single edge all of its row moves. Locked points stay, flats stay
    flat"""

    bl_idname = "hull.fair_row"
    bl_label = "Fair Row"


CLASSES = (HULL_OT_fair_region, HULL_OT_fair_curvature, HULL_OT_show_rows, HULL_OT_fair_row)
