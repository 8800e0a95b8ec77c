# SPDX-License-Identifier: GPL-3.0-or-later
"""Load cases, openings and wind areas come and go."""

import bpy

from ..bridge.objects import hull_objects
from ..features.hull import loading
from .shared import HullOperator


class AddEntry(HullOperator):
    """Subclasses add an entry: add(hull, scene)."""

    def run_on(self, hull, context):
        self.add(hull, context.scene)


def _has_entry(cls, context):
    if not loading.entries_of(hull_objects.hull_of(context.object), cls.entries):
        cls.poll_message_set(cls.none_there)
        return False
    return True


class RemoveEntry(HullOperator):
    """Removes the chosen one of the list `entries`; none_there says that there is none."""

    needs = (*HullOperator.needs, _has_entry)

    def run_on(self, hull, context):
        loading.remove(hull, self.entries)


class HULL_OT_add_load_case(bpy.types.Operator, AddEntry):
    """Add a load case: at first the ship as she is afloat, later what you make of it"""

    bl_idname = "hull.add_load_case"
    bl_label = "Add Load Case"

    def add(self, hull, scene):
        loading.add_load_case(hull, scene)


class HULL_OT_remove_load_case(bpy.types.Operator, RemoveEntry):
    """Remove the load case that is chosen in the list"""

    bl_idname = "hull.remove_load_case"
    bl_label = "Remove Load Case"

    entries, none_there = "load_cases", "There is no load case"


class HULL_OT_add_downflooding_point(bpy.types.Operator, AddEntry):
    """Add an opening that floods the ship: at first amidships at the side of the deck"""

    bl_idname = "hull.add_downflooding_point"
    bl_label = "Add Opening"

    def add(self, hull, scene):
        loading.add_downflooding_point(hull)


class HULL_OT_remove_downflooding_point(bpy.types.Operator, RemoveEntry):
    """Remove the opening that is chosen in the list"""

    bl_idname = "hull.remove_downflooding_point"
    bl_label = "Remove Opening"

    entries, none_there = "downflooding_points", "There is no opening"


class HULL_OT_add_wind_area(bpy.types.Operator, AddEntry):
    """Add an area that the wind meets beside the hull: a deckhouse, deck cargo"""

    bl_idname = "hull.add_wind_area"
    bl_label = "Add Wind Area"

    def add(self, hull, scene):
        loading.add_wind_area(hull)


class HULL_OT_remove_wind_area(bpy.types.Operator, RemoveEntry):
    """Remove the wind area that is chosen in the list"""

    bl_idname = "hull.remove_wind_area"
    bl_label = "Remove Wind Area"

    entries, none_there = "areas", "There is no wind area"


class HULL_OT_add_weight(bpy.types.Operator, AddEntry):
    """Add a part of the ship to her weights: engine, outfit, mast"""

    bl_idname = "hull.add_weight"
    bl_label = "Add Weight"

    def add(self, hull, scene):
        loading.add_weight(hull)


class HULL_OT_remove_weight(bpy.types.Operator, RemoveEntry):
    """Remove the weight that is chosen in the list"""

    bl_idname = "hull.remove_weight"
    bl_label = "Remove Weight"

    entries, none_there = "items", "There is no weight"


CLASSES = (
    HULL_OT_add_load_case,
    HULL_OT_remove_load_case,
    HULL_OT_add_downflooding_point,
    HULL_OT_remove_downflooding_point,
    HULL_OT_add_wind_area,
    HULL_OT_remove_wind_area,
    HULL_OT_add_weight,
    HULL_OT_remove_weight,
)
