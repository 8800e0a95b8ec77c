# SPDX-License-Identifier: GPL-3.0-or-later
"""More and fewer control points that keep the surface: rows, and the whole mesh subdivided."""

import bpy
from bpy.props import FloatProperty

from ..bridge.blender import units
from ..bridge.counts import counted, counted_are
from ..features.modelling import exact_subdivision, row_insertion, row_removal, subdivision_reversal
from .shared import EditModeOperator, HullOperator


def _tolerance():
    return FloatProperty(
        name="Tolerance",
        description="How far the surface may be from where it was, at most",
        default=0.01,
        min=0.0,
        soft_max=1.0,
        precision=4,
        subtype="DISTANCE",
    )


class HULL_OT_insert_row(bpy.types.Operator, EditModeOperator):
    """Insert a row of control points across the selected edges, or along a strip of selected faces
    alone, and place the points around it so that the surface stays as nearly as may be. Blender's
    own loop cut changes the surface"""

    bl_idname = "hull.insert_row"
    bl_label = "Insert Row"

    def run_on(self, hull, context):
        found = row_insertion.insert_rows(hull, context.scene)
        text = (
            f"{counted(found.count, 'point')}: the surface changed by "
            f"{units.format_mm(found.change)} at "
            f"most; a cut alone changes it by {units.format_mm(found.cut_change)}"
        )
        if found.ends:
            text += f". {counted(found.ends, 'face')} beside the row have a point more"
        self.tell("INFO", text)


class HULL_OT_remove_row(bpy.types.Operator, EditModeOperator):
    """Take the selected row of control points away, and place the points around it so that the
    surface stays as nearly as may be. Where it would change by more than the tolerance all stays as
    it is"""

    bl_idname = "hull.remove_row"
    bl_label = "Remove Row"

    tolerance: _tolerance()

    def run_on(self, hull, context):
        scale = units.metres_per_unit(context.scene)
        found = row_removal.remove_row(hull, context.scene, scale * self.tolerance)
        self.tell(
            "INFO",
            f"{counted(found.count, 'point')} removed: the surface changed by "
            f"{units.format_mm(found.change)} at most; without placing the others anew by "
            f"{units.format_mm(found.bare_change)}",
        )


class HULL_OT_subdivide_exactly(bpy.types.Operator, HullOperator):
    """Replace the control mesh by the one subdivided once by the surface's own rules: four times
    the faces, and the surface stays exactly as it is. It is always the whole hull: in one place
    alone no points can be added that change nothing, where Insert Row comes within millimetres"""

    bl_idname = "hull.subdivide_exactly"
    bl_label = "Subdivide Exactly"

    def run_on(self, hull, context):
        made = exact_subdivision.subdivide(hull, context.scene)
        text = f"{made.points} points, {made.faces} faces: the surface is the same"
        if made.no_longer_flat:
            text += (
                f". {made.no_longer_flat} of them, at the rims of flats, are not kept flat: the "
                "surface leaves the plane there"
            )
        self.tell("INFO", text)


class HULL_OT_unsubdivide(bpy.types.Operator, HullOperator):
    """Take the control mesh back to the one that it was subdivided from: a quarter of the faces,
    and the same surface. Where points were moved since, the surface is the nearest one; where it
    would change by more than the tolerance all stays as it is"""

    bl_idname = "hull.unsubdivide"
    bl_label = "Un-Subdivide"

    tolerance: _tolerance()

    def run_on(self, hull, context):
        scale = units.metres_per_unit(context.scene)
        made = subdivision_reversal.take_back(hull, context.scene, scale * self.tolerance)
        text = (
            f"{made.points} points, {made.faces} faces: the surface changed by "
            f"{units.format_mm(made.change)} at most; points were "
            f"{units.format_mm(made.moved)} at most from subdivided ones"
        )
        if made.no_longer_flat:
            text += (
                f". {counted_are(made.no_longer_flat, 'face')} not kept flat any longer: points of "
                "them are not in the plane"
            )
        self.tell("INFO", text)


CLASSES = (HULL_OT_insert_row, HULL_OT_remove_row, HULL_OT_subdivide_exactly, HULL_OT_unsubdivide)
