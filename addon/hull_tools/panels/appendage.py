# SPDX-License-Identifier: GPL-3.0-or-later
"""Which bodies belong to a hull, and what each is."""

import bpy

from ..bridge.objects import appendages
from ..features.hull import hull_state
from ..properties.shared import field_or
from .shared import HullTab, label_wrapped

_FIELDS = {
    "CYLINDER": ("radius", "end_radius", "length"),
    "FOIL": (
        "section",
        "span",
        "sweep",
        "lean",
        "chord",
        "tip_chord",
        "thickness",
        "tip_thickness",
    ),
    "BULB": ("section", "length", "radius"),
}
# What counts where a field is zero.
_ZEROS = {
    "end_radius": "as at the start",
    "tip_chord": "as at the root",
    "thickness": "by the section's name",
    "tip_thickness": "by the section's name",
}


class HULL_PT_appendages(HullTab, bpy.types.Panel):
    """Keels, rudders, shafts, tunnels: which of them count, and the form of the active one"""

    bl_label = "Appendages"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        return appendages.hull_at_hand(context.object) is not None or appendages.is_appendage(
            context.object
        )

    def draw(self, context):
        layout = self.layout
        hull = appendages.hull_at_hand(context.object)
        if hull is None:
            label_wrapped(
                layout, context, "It has no hull: make it a hull's child (Ctrl P)", "ERROR"
            )
        else:
            self._draw_list(layout, context, hull)
        if appendages.is_appendage(context.object):
            self._draw_form(layout, context.object.hull.appendage)

    def _draw_list(self, layout, context, hull):
        layout.menu("HULL_MT_add_appendage", text="Add", icon="ADD")
        bodies = appendages.of_hull(hull)
        if not bodies:
            return
        column = layout.column(align=True)
        for obj in bodies:
            row = column.row(align=True)
            row.prop(obj.hull.appendage, "counts", text="")
            select = row.operator(
                "hull.select_appendage", text=obj.name, depress=obj == context.object
            )
            select.name = obj.name
        if context.object != hull:
            layout.operator(
                "hull.select_appendage", text=f"Back to {hull.name}", icon="LOOP_BACK"
            ).name = ""
        state = hull_state.state_of(hull)
        if state is not None and state.ship.not_joined:
            label_wrapped(layout, context, state.ship.not_joined, "ERROR")

    def _draw_form(self, layout, settings):
        layout.use_property_split = True
        layout.use_property_decorate = False
        column = layout.column(align=True)
        for name in _FIELDS[settings.shape]:
            if name in _ZEROS:
                field_or(column, settings, name, _ZEROS[name])
            else:
                column.prop(settings, name)
        column = layout.column()
        for name in ("is_cut", "is_mirrored"):
            column.prop(settings, name)


CLASSES = (HULL_PT_appendages,)
