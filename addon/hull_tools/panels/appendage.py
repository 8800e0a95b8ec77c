# SPDX-License-Identifier: GPL-3.0-or-later
"""What an appendage is, where one is the active object."""

import bpy

from ..bridge.objects import appendages
from ..features.hull import hull_state
from .shared import HullTab, label_wrapped

_FIELDS = {
    "CYLINDER": ("radius", "end_radius", "length"),
    "FOIL": ("section", "span", "sweep", "chord", "tip_chord", "thickness", "tip_thickness"),
    "BULB": ("section", "length", "radius"),
}


class HULL_PT_appendage(HullTab, bpy.types.Panel):
    """A keel, rudder, shaft, tunnel: its form, and how it counts"""

    bl_label = "Appendage"

    @classmethod
    def poll(cls, context):
        return appendages.is_appendage(context.object)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        settings = context.object.hull.appendage
        column = layout.column(align=True)
        for name in _FIELDS[settings.shape]:
            column.prop(settings, name)
        column = layout.column()
        for name in ("counts", "is_cut", "is_mirrored"):
            column.prop(settings, name)
        hull = appendages.hull_of(context.object)
        state = None if hull is None else hull_state.state_of(hull)
        if hull is None:
            label_wrapped(
                layout, context, "It has no hull: make it a hull's child (Ctrl P)", "ERROR"
            )
        elif state is not None and state.ship.not_joined:
            label_wrapped(layout, context, state.ship.not_joined, "ERROR")


CLASSES = (HULL_PT_appendage,)
