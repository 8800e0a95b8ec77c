# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls are kept under a name, and come back."""

import bpy
from bpy.props import BoolProperty, StringProperty

from ..bridge.objects import hull_objects
from ..features.variants import kept_hulls
from .shared import HullOperator, HullReader, in_object_mode, make_active


def _has_variant(cls, context):
    if not hull_objects.hull_of(context.object).hull.variants.kept:
        cls.poll_message_set("There is no variant: keep the hull as one first")
        return False
    return True


def _which():
    return StringProperty(
        name="Variant",
        description="The name of the variant; blank: the one chosen in the list",
        options={"HIDDEN", "SKIP_SAVE"},
    )


class HULL_OT_keep_variant(bpy.types.Operator, HullOperator):
    """Keep the hull as it is under a name: mesh, marks, particulars, drafts, loads. It can come
    back, be shown behind the hull and be compared with it"""

    bl_idname = "hull.keep_variant"
    bl_label = "Keep as Variant"

    name: StringProperty(
        name="Name",
        description="What the variant is called; blank: a free name",
        options={"HIDDEN", "SKIP_SAVE"},
    )
    note: StringProperty(
        name="Note",
        description="What sets it apart from the others",
        options={"HIDDEN", "SKIP_SAVE"},
    )

    def run_on(self, hull, context):
        entry = kept_hulls.keep(hull, self.name, self.note)
        self.tell("INFO", f'Kept as "{entry.name}"')


class HULL_OT_remove_variant(bpy.types.Operator, HullOperator):
    """Remove the variant that is chosen in the list. The hull stays as it is"""

    bl_idname = "hull.remove_variant"
    bl_label = "Remove Variant"

    variant: _which()
    needs = (*HullOperator.needs, _has_variant)

    def run_on(self, hull, context):
        kept_hulls.remove(hull, kept_hulls.named(hull, self.variant))


class HULL_OT_go_back_to_variant(bpy.types.Operator, HullOperator):
    """Make the hull what the chosen variant is: mesh, marks, particulars, drafts, loads. What the
    hull is now is lost, unless it is kept first"""

    bl_idname = "hull.go_back_to_variant"
    bl_label = "Go Back"

    variant: _which()
    keep_present: BoolProperty(
        name="Keep the present hull",
        description="Keep what the hull is now as a variant first",
        default=False,
        options={"SKIP_SAVE"},
    )
    needs = (in_object_mode, *HullOperator.needs, _has_variant)

    def run_on(self, hull, context):
        entry = kept_hulls.named(hull, self.variant)
        name = entry.name
        state = kept_hulls.go_back(hull, context.scene, entry, self.keep_present)
        self.tell("INFO", f'The hull is "{name}" again')
        if state.status:
            self.tell("WARNING", state.status)


class HULL_OT_duplicate_variant(bpy.types.Operator, HullReader):
    """Make the chosen variant a hull object of its own, where the hull stands"""

    bl_idname = "hull.duplicate_variant"
    bl_label = "As Own Hull"

    variant: _which()
    needs = (in_object_mode, *HullReader.needs, _has_variant)

    def run_on(self, hull, context):
        entry = kept_hulls.named(hull, self.variant)
        make_active(context, kept_hulls.duplicate(hull, context.scene, entry))


CLASSES = (
    HULL_OT_keep_variant,
    HULL_OT_remove_variant,
    HULL_OT_go_back_to_variant,
    HULL_OT_duplicate_variant,
)
