# SPDX-License-Identifier: GPL-3.0-or-later
"""Add > Mesh > Ship Appendage: keels, rudders, shafts, tunnels, placed on the hull at hand."""

import bpy
from bpy.props import EnumProperty, FloatProperty, StringProperty

from ..bridge.blender import units
from ..bridge.objects import appendages, hull_objects
from ..features.hull import appendage_kinds
from .shared import (
    BaseOperator,
    asked_length,
    collection_for_new,
    in_object_mode,
    make_active,
    native_is_there,
)


def _has_hull(cls, context):
    hull = appendages.hull_at_hand(context.object)
    if hull is None:
        cls.poll_message_set("Select the hull first that it belongs to")
        return False
    reason = hull_objects.refusal(hull) or hull_objects.locked(hull)
    if reason:
        cls.poll_message_set(reason)
    return not reason


def _take_kind(self, context):
    """Another kind comes with its own place and sizes."""
    hull = appendages.hull_at_hand(context.object)
    if hull is None:
        return
    usual = appendage_kinds.usual(self.kind, hull)
    for name in appendage_kinds.NUMBERS:
        setattr(self, name, usual.get(name, 0.0))
    self.section = usual.get("section", "")


class HULL_OT_add_appendage(bpy.types.Operator, BaseOperator):
    """Add a body that counts in hydrostatics and stability, each point of space once"""

    bl_idname = "hull.add_appendage"
    bl_label = "Add Ship Appendage"

    kind: EnumProperty(
        name="Kind",
        description="What is added; another kind comes with its own place and sizes",
        items=[(key, kind.name, kind.description) for key, kind in appendage_kinds.KINDS.items()],
        update=_take_kind,
        options={"SKIP_SAVE"},
    )
    section: StringProperty(
        name="Section",
        description=appendage_kinds.SECTIONS,
        options={"SKIP_SAVE"},
    )
    x: asked_length("x", "Forward of the after perpendicular: of the leading edge, axis or start")
    y: asked_length("y", "To port of the centre plane; beside it both sides get one")
    z: asked_length("z", "Of the axis above the base line")
    chord: asked_length("Root chord", "Length of the section at the hull", minimum=0.0)
    tip_chord: asked_length("Tip chord", "Length of the section at the tip", minimum=0.0)
    span: asked_length("Span", "From the hull to the tip", minimum=0.0)
    sweep: asked_length("Sweep", "How far the tip's leading edge is abaft the root's")
    overlap: asked_length(
        "Within hull", "How far the body reaches into the hull, which it must cross", minimum=0.0
    )
    radius: asked_length("Radius", "Of the cylinder, or the bulb's largest", minimum=0.0)
    length: asked_length("Length", "Of the shaft or bulb", minimum=0.0)
    angle: FloatProperty(
        name="Angle",
        description="Of a shaft: down aft; of a bracket: outwards from straight down",
        unit="ROTATION",
        min=-1.5,
        max=1.5,
        options={"SKIP_SAVE"},
    )

    needs = (native_is_there, in_object_mode, _has_hull)

    def run(self, context):
        hull = appendages.hull_at_hand(context.object)
        usual = appendage_kinds.usual(self.kind, hull)
        for name, value in usual.items():
            if not self.properties.is_property_set(name):
                setattr(self, name, value)
        values = {name: getattr(self, name) for name in appendage_kinds.NUMBERS}
        scale = units.metres_per_unit(context.scene)
        made = appendage_kinds.add(
            self.kind, hull, values, self.section, scale, collection_for_new(context)
        )
        make_active(context, made[0])
        self.tell("INFO", ", ".join(obj.name for obj in made))

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(self, "kind")
        kind = appendage_kinds.KINDS[self.kind]
        column = layout.column(align=True)
        for name in kind.asked:
            column.prop(self, name)


class HULL_OT_select_appendage(bpy.types.Operator, BaseOperator):
    """Select this body of the hull, to change its form; or the hull"""

    bl_idname = "hull.select_appendage"
    bl_label = "Select Appendage"

    name: StringProperty(
        name="Name", description="Of the body; none: the hull itself", options={"SKIP_SAVE"}
    )

    needs = (in_object_mode,)

    def run(self, context):
        hull = appendages.hull_at_hand(context.object)
        found = [obj for obj in appendages.of_hull(hull) if obj.name == self.name] if hull else []
        if hull is None or (self.name and not found):
            raise ValueError(f'The hull has no appendage "{self.name}": select one that it has')
        chosen = found[0] if found else hull
        if chosen.name not in context.view_layer.objects:
            raise ValueError(f'"{chosen.name}" is not in this view layer: link it first')
        make_active(context, chosen)


CLASSES = (HULL_OT_add_appendage, HULL_OT_select_appendage)
