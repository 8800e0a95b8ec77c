# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact shape: flat regions, points in planes and at coordinates."""

import bpy

from ..bridge.blender import units
from ..bridge.objects import hull_objects
from ..features.constraints import flats
from ..features.hull import hull_state
from ..features.modelling import developable_making, flat_making
from .shared import HullPanel, label_value, label_wrapped

_KINDS = {
    "SIDE": "Flat side",
    "BOTTOM": "Flat bottom",
    "TRANSOM": "Transom",
    "RAKED": "Raked plane",
    "BEST": "Plane",
}


class HULL_PT_shape(HullPanel, bpy.types.Panel):
    """Make faces flat and keep them so, put points in planes, type coordinates"""

    bl_label = "Shape"
    bl_context = "mesh_edit"

    def draw(self, context):
        self._draw_flats(context)
        self._draw_developables(context)
        self._draw_points()

    def _draw_flats(self, context):
        layout = self.layout
        layout.label(text="Make faces flat")
        column = layout.column(align=True)
        row = column.row(align=True)
        for kind, name in (("SIDE", "Side"), ("BOTTOM", "Bottom"), ("TRANSOM", "Transom")):
            row.operator("hull.make_flat", text=name).kind = kind
        row = column.row(align=True)
        for kind, name in (("RAKED", "Raked"), ("BEST", "Best Plane")):
            row.operator("hull.make_flat", text=name).kind = kind
        found = flats.regions(hull_objects.hull_of(context.object))
        if not found:
            return
        column = layout.column(align=True)
        column.scale_y = 0.8
        for region in found:
            place = flat_making.describe(context.scene, region.plane)
            label_value(column, _KINDS[region.kind], place)
        row = layout.row(align=True)
        row.operator("hull.select_flat", text="Select")
        row.operator("hull.release_flat", text="Release")

    def _draw_developables(self, context):
        layout = self.layout
        column = layout.column(align=True)
        column.operator("hull.make_developable", icon="MOD_SIMPLEDEFORM")
        column.operator("hull.developable_strip", icon="MESH_PLANE")
        hull = hull_objects.hull_of(context.object)
        found = developable_making.warps(hull, hull_state.state_of(hull))
        if not found:
            return
        column = layout.column(align=True)
        for each in found:
            count = len(each.region.faces)
            name = f"Developable, {count} face{'s' if count > 1 else ''}"
            if each.problem:
                column.label(text=name, icon="ERROR")
                label_wrapped(column, context, each.problem)
                continue
            most = each.region.warp / units.metres_per_unit(context.scene)
            is_over = each.warp > 1.0005 * most
            row = column.row()
            row.alert = is_over
            label_value(row, name, f"{each.warp:.3g} of {most:.3g}°/m")
        layout.operator("hull.release_developable", text="Release Developable")

    def _draw_points(self):
        layout = self.layout
        layout.label(text="Put points in one")
        row = layout.row(align=True)
        for plane in ("STATION", "WATERLINE", "BUTTOCK"):
            row.operator("hull.put_in_plane", text=plane.capitalize()).plane = plane
        layout.operator("hull.set_coordinates", text="Coordinates …", icon="SPREADSHEET")
        row = layout.row(align=True)
        row.operator("hull.insert_row", icon="MOD_EDGESPLIT")
        row.operator("hull.remove_row")
        column = layout.column(align=True)
        column.operator("hull.subdivide_exactly", icon="MOD_SUBSURF")
        column.operator("hull.unsubdivide")
        layout.operator("hull.reduce_valence", icon="STICKY_UVS_DISABLE")


CLASSES = (HULL_PT_shape,)
