# SPDX-License-Identifier: GPL-3.0-or-later
"""What the operators have in common: what they work on, and how they say no."""

import bpy
from bpy.props import FloatProperty

from ... import hull_io
from ..bridge import native
from ..bridge.blender import letters, sentence_units, view_depth
from ..bridge.objects import appendages, hull_objects
from ..properties.shared import length


def native_is_there(cls, context):
    if native.hull_native is None:
        cls.poll_message_set(native.missing_reason)
        return False
    return True


def has_hull(cls, context):
    """Whether the active object is a hull, or shows one, that can be worked on."""
    hull = hull_objects.hull_of(context.object)
    if hull is None:
        whose = appendages.hull_of(context.object)
        cls.poll_message_set(
            f"Select the hull first: {context.object.name} is an appendage of {whose.name}"
            if whose
            else "Select a hull first, or make this mesh one"
        )
        return False
    reason = hull_objects.refusal(hull)
    if reason:
        cls.poll_message_set(reason)
        return False
    return True


def can_change(cls, context):
    """Whether the hull at hand is not one that is linked from another file."""
    reason = hull_objects.locked(hull_objects.hull_of(context.object))
    if reason:
        cls.poll_message_set(reason)
    return not reason


def in_3d_view(cls, context):
    if context.region_data is None:
        cls.poll_message_set("Only in a 3D view")
        return False
    return True


def in_mesh_edit_mode(cls, context):
    if context.mode != "EDIT_MESH":
        cls.poll_message_set("Enter edit mode first (Tab)")
        return False
    return True


def in_object_mode(cls, context):
    if context.mode != "OBJECT":
        cls.poll_message_set("Leave edit mode first (Tab)")
        return False
    return True


def asked_length(name, description, default=0.0, minimum=None):
    """A length that an operator asks for anew each time; `minimum` None: it may be negative."""
    return length(name, description, default, minimum, update=None, options={"SKIP_SAVE"})


def asked_number(name, description, precision, step=10, minimum=0.0, **more):
    """A number that an operator asks for anew each time."""
    return FloatProperty(
        name=name,
        description=description,
        precision=precision,
        step=step,
        min=minimum,
        options={"SKIP_SAVE"},
        **more,
    )


def property_column(operator):
    """A column for an operator's properties, with their names to the left."""
    layout = operator.layout
    layout.use_property_split = True
    layout.use_property_decorate = False
    return layout.column()


def collection_for_new(context):
    """Where new objects go: the active collection; that of the scene where the active one is of
    another file, hidden or not in the view layer, so that what is made can be seen and selected."""
    layer = context.view_layer.active_layer_collection
    if layer.collection.library is None and layer.is_visible:
        return layer.collection
    return context.scene.collection


def set_active(context, obj):
    """Makes an object the active one. ValueError where it is not in the view layer."""
    try:
        context.view_layer.objects.active = obj
    except RuntimeError as error:
        raise ValueError(
            f'"{obj.name}" is not in this view layer: tick the box of its collection in the '
            "outliner"
        ) from error


def make_active(context, obj):
    """Selects exactly this object and makes it the active one; ValueError as set_active()."""
    set_active(context, obj)
    for selected in context.selected_objects:
        selected.select_set(False)
    obj.select_set(True)


def show_all(context):
    """Has all 3D views of the window show what is selected, seldom as large as what was in view."""
    if context.window is None:
        return
    context.view_layer.update()
    for area in context.window.screen.areas:
        if area.type != "VIEW_3D":
            continue
        region = next(each for each in area.regions if each.type == "WINDOW")
        with context.temp_override(area=area, region=region):
            if bpy.ops.view3d.view_selected.poll():
                view_depth.suit(area.spaces.active, context.object)
                bpy.ops.view3d.view_selected()


def suit_views(context):
    """Has all 3D views of the window begin and end so that the active object does not speckle."""
    if context.window is None:
        return
    context.view_layer.update()
    for area in context.window.screen.areas:
        if area.type == "VIEW_3D":
            view_depth.suit(area.spaces.active, context.object)


def enter_edit_mode(context, hull):
    """ValueError where the hull of a surface that is at hand can't be seen, and where Blender does
    not edit it: a script that changed objects' meshes in edit mode leaves such."""
    if hull.mode == "EDIT":
        return
    if not hull.visible_get(view_layer=context.view_layer):
        raise ValueError(
            f'"{hull.name}" cannot be edited here: it is hidden, or not in this view layer; '
            "show it in the outliner first"
        )
    if context.mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    context.view_layer.objects.active = hull
    try:
        bpy.ops.object.mode_set(mode="EDIT")
    except RuntimeError as error:
        raise ValueError(
            f'"{hull.name}" cannot be edited here: Blender holds its mesh for being edited '
            "already; save the file and open it again"
        ) from error


class BaseOperator:
    """Refused with the reason where one of `needs` is not met; cancelled with a report where there
    is something that a user can get wrong, else finished.

    Subclasses: run(context); needs: functions (cls, context) that say whether one can go on.
    """

    bl_options = {"REGISTER", "UNDO"}
    needs = (native_is_there,)

    @classmethod
    def poll(cls, context):
        return all(need(cls, context) for need in cls.needs)

    def execute(self, context):
        return self.reporting(self.run, context)

    def reporting(self, function, context):
        """What function(context) returns, or FINISHED; what it raises is reported."""
        try:
            return function(context) or {"FINISHED"}
        except hull_io.HullFileError as error:  # in the units of the file
            self.report({"ERROR"}, letters.taken(str(error)))
        except (ValueError, OSError) as error:
            self.tell("ERROR", str(error))
        return {"CANCELLED"}

    def tell(self, level, text):
        """Reports a sentence, in the units of the scene. level: "INFO", "WARNING" or "ERROR"."""
        text = sentence_units.in_scene_units(bpy.context.scene, text)
        self.report({level}, letters.taken(text))


class HullReader(BaseOperator):
    """Reads the hull at hand, which may be linked from another file, and leaves it as it is.
    Subclasses: run_on(hull, context)."""

    needs = (native_is_there, has_hull)

    def run(self, context):
        return self.run_on(hull_objects.hull_of(context.object), context)


class HullOperator(HullReader):
    """Changes the hull at hand. Subclasses: run_on(hull, context)."""

    needs = (*HullReader.needs, can_change)


class EditModeOperator(HullOperator):
    """Works on the hull whose mesh is being edited. Subclasses: run_on(hull, context)."""

    needs = (in_mesh_edit_mode, *HullOperator.needs)
