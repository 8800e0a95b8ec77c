# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls between parents: made, moved by weights, fitted again, taken out of their family."""

import bpy
from bpy.props import StringProperty

from ..bridge.objects import hull_objects
from ..features.morphing import (
    local_parents,
    making,
    members,
    pairs,
    parents,
    refitting,
    wanted,
    weights,
)
from .shared import HullOperator, can_change, in_object_mode, make_active, native_is_there
from .targets import TargetsTask
from .tasks import TaskOperator


def _has_two_hulls(cls, context):
    if len(making.selected_parents(context.object, context.selected_objects)) < 2:
        cls.poll_message_set("Select two hulls or more: they become the parents")
        return False
    return True


def is_member(cls, context):
    """A need of operators: a hull of a family."""
    if not parents.is_member(hull_objects.hull_of(context.object)):
        cls.poll_message_set("The hull is of no family: Make Morph of two hulls first")
        return False
    return True


class HULL_OT_make_morph(bpy.types.Operator, TaskOperator):
    """Make a hull between the selected ones, which become its parents. One control mesh, the active
    hull's or that of the hull chosen as Layout, is fitted to all of them"""

    bl_idname = "hull.make_morph"
    bl_label = "Make Morph"
    bl_options = {"REGISTER", "UNDO"}

    layout: StringProperty(
        name="Layout",
        description="The name of the hull whose control mesh is taken; blank: as the panel has it",
        options={"HIDDEN", "SKIP_SAVE"},
    )
    needs = (in_object_mode, *TaskOperator.needs, _has_two_hulls)

    def run_on(self, hull, context):
        self._hulls = making.selected_parents(context.object, context.selected_objects)
        return super().run_on(hull, context)

    def begin(self, hull, scene):
        layout = making.layout_of(hull)
        if self.layout:
            layout = scene.objects.get(self.layout)
            if not hull_objects.is_hull(layout):
                raise ValueError(f'There is no hull "{self.layout}" in this scene')
        return making.Morphing(hull, self._hulls, layout, scene)

    def outcome(self, alike, scene):
        self._made = self._task.write(scene)
        return self._task.told

    def show(self, context):
        make_active(context, self._made)


class HULL_OT_pair_again(bpy.types.Operator, TaskOperator):
    """Fit the parents, as they are now, again, with the pairs of lines as the lists have them. The
    weights stay"""

    bl_idname = "hull.pair_again"
    bl_label = "Pair Again"
    bl_options = {"REGISTER", "UNDO"}

    needs = (in_object_mode, *TaskOperator.needs, can_change, is_member)

    def begin(self, hull, scene):
        return refitting.Refitting(hull, scene)

    def outcome(self, alike, scene):
        self._task.write(scene)
        return self._task.told


class HULL_OT_add_pair(bpy.types.Operator, HullOperator):
    """Pair the two lines that are chosen: from the next fit on the one is laid along the other.
    Pairs that either was in go"""

    bl_idname = "hull.add_pair"
    bl_label = "Pair"

    needs = (*HullOperator.needs, is_member)

    def run_on(self, hull, context):
        pairs.add(hull)


class HULL_OT_remove_pair(bpy.types.Operator, HullOperator):
    """Hold the two lines of the chosen pair apart from the next fit on"""

    bl_idname = "hull.remove_pair"
    bl_label = "Hold Apart"

    needs = (*HullOperator.needs, is_member)

    def run_on(self, hull, context):
        pairs.remove(hull)


class HULL_OT_forget_pairs(bpy.types.Operator, HullOperator):
    """Forget which lines were paired or held apart by hand: from the next fit on role, order and
    place decide alone"""

    bl_idname = "hull.forget_pairs"
    bl_label = "Forget Corrections"

    needs = (*HullOperator.needs, is_member)

    def run_on(self, hull, context):
        pairs.forget_corrections(hull)


class HULL_OT_add_local_parent(bpy.types.Operator, HullOperator):
    """Make the hull the chosen parent around the field that is chosen in the panel Fields"""

    bl_idname = "hull.add_local_parent"
    bl_label = "Add Local Parent"

    needs = (*HullOperator.needs, is_member)

    def run_on(self, hull, context):
        local_parents.add(hull)


class HULL_OT_remove_local_parent(bpy.types.Operator, HullOperator):
    """Let the weights of the whole hull count where the chosen local parent does"""

    bl_idname = "hull.remove_local_parent"
    bl_label = "Remove Local Parent"

    needs = (*HullOperator.needs, is_member)

    def run_on(self, hull, context):
        local_parents.remove(hull)


def _has_target(cls, context):
    if not hull_objects.hull_of(context.object).hull.targets.rows:
        cls.poll_message_set("There is no target: add one")
        return False
    return True


class HULL_OT_find_weights(bpy.types.Operator, TargetsTask):
    """Find the weights with which the hull has the wanted numbers of the panel Targets, at the
    least change, and where dimensions are free there their factors. Its draft stays"""

    bl_idname = "hull.find_weights"
    bl_label = "Find Weights"
    bl_options = {"REGISTER", "UNDO"}

    needs = (*TaskOperator.needs, can_change, is_member, _has_target)

    def begin(self, hull, scene):
        return wanted.Finding(hull, scene)


class HULL_OT_set_weights(bpy.types.Operator, HullOperator):
    """Make the hull the member of its family with given weights, or with equal ones"""

    bl_idname = "hull.set_weights"
    bl_label = "Set Weights"

    weights: StringProperty(
        name="Weights",
        description="One for each parent, such as 0.3 0.7; they sum to 1. Blank: all the same",
        options={"SKIP_SAVE"},
    )
    needs = (*HullOperator.needs, is_member)

    def run_on(self, hull, context):
        count = len(hull.hull.morph.parents)
        given = weights.numbers(self.weights) or [1.0 / count] * count
        members.set_weights(hull, context.scene, given)


class HULL_OT_leave_family(bpy.types.Operator, HullOperator):
    """Take the hull out of its family: its mesh stays as it is, and its parents are forgotten"""

    bl_idname = "hull.leave_family"
    bl_label = "Make It a Hull of Its Own"

    needs = (*HullOperator.needs, is_member)

    def run_on(self, hull, context):
        members.make_own(hull)
        self.tell("INFO", f'"{hull.name}" is a hull of its own')


class HULL_OT_back_to_family(bpy.types.Operator, HullOperator):
    """Make the mesh the family's again, as the weights have it: what was changed by hand is lost"""

    bl_idname = "hull.back_to_family"
    bl_label = "Back to Family"

    # Of a hull that is refused too, as for shape keys.
    needs = (native_is_there, in_object_mode)

    @classmethod
    def poll(cls, context):
        hull = hull_objects.hull_of(context.object)
        if hull is None:
            cls.poll_message_set("Select a hull first")
            return False
        return super().poll(context) and can_change(cls, context) and is_member(cls, context)

    def run_on(self, hull, context):
        members.back_to_family(hull, context.scene).checked()


CLASSES = (
    HULL_OT_make_morph,
    HULL_OT_pair_again,
    HULL_OT_add_pair,
    HULL_OT_remove_pair,
    HULL_OT_forget_pairs,
    HULL_OT_add_local_parent,
    HULL_OT_remove_local_parent,
    HULL_OT_find_weights,
    HULL_OT_set_weights,
    HULL_OT_leave_family,
    HULL_OT_back_to_family,
)
