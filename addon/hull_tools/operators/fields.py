# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape fields come and go, and the hull is changed by them."""

import bpy
from bpy.props import EnumProperty

from ..bridge.blender import units
from ..bridge.counts import counted
from ..bridge.objects import field_faces, hull_objects
from ..features.fields import copying, field_list, preview, recipes, shaping
from ..properties.field_settings import BASES, RECIPES, ROLES
from .shared import HullOperator, in_mesh_edit_mode, in_object_mode


def _has_field(cls, context):
    if not hull_objects.hull_of(context.object).hull.fields.fields:
        cls.poll_message_set("There is no field")
        return False
    return True


class FieldOperator(HullOperator):
    """Works on the field that is chosen."""

    needs = (*HullOperator.needs, _has_field)


class HULL_OT_add_field(bpy.types.Operator, HullOperator):
    """Add a shape field at the points selected in edit mode, else at the 3D cursor"""

    bl_idname = "hull.add_field"
    bl_label = "Add Field"

    role: EnumProperty(name="Role", description="What the field does", items=ROLES)
    base: EnumProperty(name="Base", description="From what distances are measured", items=BASES)

    def run_on(self, hull, context):
        field_list.add(hull, context.scene, self.role, self.base)


class HULL_OT_add_field_recipe(bpy.types.Operator, HullOperator):
    """Add shape fields that are often wanted, in sizes that suit the hull: preview them, and change
    what they shift"""

    bl_idname = "hull.add_field_recipe"
    bl_label = "Recipe"

    recipe: EnumProperty(name="Recipe", description="What is to become of it", items=RECIPES)

    def run_on(self, hull, context):
        recipes.add(hull, context.scene, self.recipe)


class HULL_OT_remove_field(bpy.types.Operator, FieldOperator):
    """Remove the shape field that is chosen in the list"""

    bl_idname = "hull.remove_field"
    bl_label = "Remove Field"

    def run_on(self, hull, context):
        field_list.remove(hull)


class HULL_OT_duplicate_field(bpy.types.Operator, FieldOperator):
    """Add a copy of the chosen shape field"""

    bl_idname = "hull.duplicate_field"
    bl_label = "Duplicate Field"

    def run_on(self, hull, context):
        field_list.duplicate(hull)


def _others(context):
    """The hulls that are selected besides the active one."""
    active = hull_objects.hull_of(context.object)
    return [hull for hull in hull_objects.hulls(context.selected_objects) if hull != active]


def _has_others(cls, context):
    if not _others(context):
        cls.poll_message_set("Select the hulls that are to have the fields too")
        return False
    return True


class HULL_OT_copy_fields(bpy.types.Operator, FieldOperator):
    """Add the shape fields of this hull to the other selected hulls, in proportion to their length,
    breadth and height"""

    bl_idname = "hull.copy_fields"
    bl_label = "Copy to Selected Hulls"

    needs = (*FieldOperator.needs, in_object_mode, _has_others)

    def run_on(self, hull, context):
        others = _others(context)
        for other in others:
            reason = hull_objects.refusal(other) or hull_objects.locked(other)
            if reason:
                raise ValueError(f"{other.name}: {reason}")
        for other in others:
            copying.copy(hull, other)
        self.tell("INFO", f"Fields copied to {counted(len(others), 'hull')}")


class HULL_OT_move_field(bpy.types.Operator, FieldOperator):
    """Move the chosen shape field within the list"""

    bl_idname = "hull.move_field"
    bl_label = "Move Field"

    direction: EnumProperty(
        name="Direction",
        description="Where to",
        items=(("UP", "Up", "Towards the top"), ("DOWN", "Down", "Towards the bottom")),
    )

    def run_on(self, hull, context):
        field_list.move(hull, -1 if self.direction == "UP" else 1)


class HULL_OT_place_field(bpy.types.Operator, FieldOperator):
    """Place the chosen shape field at the points selected in edit mode, else at the 3D cursor"""

    bl_idname = "hull.place_field"
    bl_label = "Place Field"

    def run_on(self, hull, context):
        field_list.put(field_list.chosen(hull), hull, context.scene)


class HULL_OT_take_field_faces(bpy.types.Operator, FieldOperator):
    """Make the faces selected in edit mode the base of the chosen shape field"""

    bl_idname = "hull.take_field_faces"
    bl_label = "Take Faces"

    needs = (in_mesh_edit_mode, *FieldOperator.needs)

    def run_on(self, hull, context):
        field_faces.choose(hull, field_list.chosen(hull))
        preview.follow(hull, context.scene)


def _is_previewed(cls, context):
    if not hull_objects.hull_of(context.object).hull.fields.is_previewed:
        cls.poll_message_set("The fields are not previewed")
        return False
    return True


class HULL_OT_preview_fields(bpy.types.Operator, FieldOperator):
    """Show the hull as the shape fields make it, while they are changed"""

    bl_idname = "hull.preview_fields"
    bl_label = "Preview Fields"

    def run_on(self, hull, context):
        if not hull.hull.fields.is_previewed:
            preview.begin(hull, context.scene)


class HULL_OT_subdivide_for_fields(bpy.types.Operator, FieldOperator):
    """Subdivide the control mesh exactly, so that it has more points to follow the shape fields,
    and go on with the preview: a Cancel afterwards leaves the finer mesh, with the same surface"""

    bl_idname = "hull.subdivide_for_fields"
    bl_label = "Subdivide Exactly"

    needs = (*HullOperator.needs, _is_previewed)

    def run_on(self, hull, context):
        made = preview.subdivide(hull, context.scene)
        self.tell("INFO", f"{made.points} points and {made.faces} faces, the same surface")


class HULL_OT_insert_row_for_fields(bpy.types.Operator, FieldOperator):
    """Insert a row of control points where they are farthest from following the shape fields, and
    go on with the preview: the hull of before changes by as much as is told"""

    bl_idname = "hull.insert_row_for_fields"
    bl_label = "Insert Row"

    needs = (*HullOperator.needs, _is_previewed)

    def run_on(self, hull, context):
        made = preview.insert_row(hull, context.scene)
        self.tell(
            "INFO",
            f"{counted(made.count, 'point')} more: the hull of before changed by "
            f"{units.format_mm(made.change)} at most",
        )


class HULL_OT_cancel_fields(bpy.types.Operator, FieldOperator):
    """Put all points back where they were before the preview"""

    bl_idname = "hull.cancel_fields"
    bl_label = "Cancel Fields"

    needs = (*HullOperator.needs, _is_previewed)

    def run_on(self, hull, context):
        preview.end(hull, context.scene, is_kept=False)


class HULL_OT_apply_fields(bpy.types.Operator, FieldOperator):
    """Move the control points so that the surface follows the shape fields that are on"""

    bl_idname = "hull.apply_fields"
    bl_label = "Apply Fields"

    def run_on(self, hull, context):
        if hull.hull.fields.is_previewed:
            shown = preview.of_hull(hull)
            preview.end(hull, context.scene, is_kept=True)
            applied = None if shown is None else shown.applied
            if applied is None:
                return
        else:
            applied = shaping.apply(hull, context.scene)
        self.tell("INFO" if applied.is_followed else "WARNING", shaping.summary(applied))


CLASSES = (
    HULL_OT_add_field,
    HULL_OT_add_field_recipe,
    HULL_OT_remove_field,
    HULL_OT_duplicate_field,
    HULL_OT_copy_fields,
    HULL_OT_move_field,
    HULL_OT_place_field,
    HULL_OT_take_field_faces,
    HULL_OT_preview_fields,
    HULL_OT_subdivide_for_fields,
    HULL_OT_insert_row_for_fields,
    HULL_OT_cancel_fields,
    HULL_OT_apply_fields,
)
