# SPDX-License-Identifier: GPL-3.0-or-later
"""Networks of curves: made, taken from a hull or from curves, tied, and their problems."""

import bpy
from bpy.props import EnumProperty, IntProperty, StringProperty

from ...hull_io import number_lists
from ..bridge.blender import units, view_target
from ..bridge.counts import counted
from ..bridge.objects import networks
from ..features.networks import crossings, from_hull, making, network_state, problems
from ..properties.network_settings import ROLES
from ..properties.shared import field_or, length
from .shared import (
    BaseOperator,
    asked_length,
    in_object_mode,
    make_active,
    native_is_there,
    property_column,
    suit_views,
)
from .tasks import TaskOperator


def has_network(cls, context):
    if networks.at_hand(context) is None:
        cls.poll_message_set("Select a curve of a network first, or make a network")
        return False
    return True


class NetworkTask(TaskOperator):
    """A task of the network at hand, which stays as it is: begin(network, scene)."""

    needs = (native_is_there, has_network)

    def run(self, context):
        return self.run_on(networks.at_hand(context), context)


def can_change_network(cls, context):
    reason = _why_not_changed(networks.at_hand(context), context.view_layer)
    if reason:
        cls.poll_message_set(reason)
    return not reason


def _why_not_changed(network, view_layer):
    """Why a network can't be changed from here, or nothing."""
    reason = networks.locked(network)
    if not reason and networks.is_left_out(network, view_layer):
        reason = f'The view layer leaves "{network.name}" out: tick its box in the outliner'
    return reason


class NetworkOperator(BaseOperator):
    """Changes the network at hand. Subclasses: run_on(network, context)."""

    needs = (native_is_there, has_network, can_change_network)

    def run(self, context):
        return self.run_on(networks.at_hand(context), context)


def selected_curves(network, context):
    """The selected curve objects of a network; ValueError without any."""
    own = [o for o in context.selected_objects if o.type == "CURVE" and o.name in network.objects]
    if not own:
        raise ValueError("Select curves of the network first")
    return own


def _size(name, description, default):
    return length(name, description, default, 1e-3, update=None)


class HULL_OT_new_network(bpy.types.Operator, BaseOperator):
    """Make a network of curves, still empty. Its sizes are what first curves reach"""

    bl_idname = "hull.new_network"
    bl_label = "New Network"

    name: StringProperty(name="Name", description="Of the collection", default="Network")
    length: _size("Length", "Along the ship, from the after perpendicular", 20.0)
    half_breadth: _size("Half Breadth", "To the side", 2.5)
    depth: _size("Depth", "Up from the base line", 3.0)

    needs = (native_is_there, in_object_mode)

    def run(self, context):
        network = making.new(context.scene, self.name or "Network")
        settings = network.hull_network
        for name in ("length", "half_breadth", "depth"):
            setattr(settings, name, units.as_typed(getattr(self, name)))
        for obj in context.selected_objects:
            obj.select_set(False)
        context.view_layer.objects.active = None
        network_state.follow(network, context.scene)
        self.tell("INFO", f'"{network.name}" is a network: add curves')


class HULL_OT_network_from_hull(bpy.types.Operator, TaskOperator):
    """Make a network of the hull's stations, waterlines and buttocks, as the panel Sections has
    them, and of its knuckles and borders"""

    bl_idname = "hull.network_from_hull"
    bl_label = "Network from Hull"
    bl_options = {"REGISTER", "UNDO"}

    stations: StringProperty(
        name="Stations", description="Positions in m, such as 0:80:10; blank: the panel's"
    )
    waterlines: StringProperty(name="Waterlines", description="Heights in m; blank: the panel's")
    buttocks: StringProperty(name="Buttocks", description="Distances in m; blank: the panel's")

    needs = (in_object_mode, *TaskOperator.needs)

    def begin(self, hull, scene):
        given = [
            number_lists.numbers(text, name)
            for text, name in (
                (self.stations, "Stations"),
                (self.waterlines, "Waterlines"),
                (self.buttocks, "Buttocks"),
            )
        ]
        return from_hull.Taking(hull, scene, given if any(map(len, given)) else None)

    def outcome(self, lines, scene):
        network = self._task.write(scene)
        self._made = network
        state = network_state.state_of(network)
        count = sum(not one.is_note for one in state.problems)
        text = f'"{network.name}" has {counted(len(state.curves), "curve")}'
        return (f"{text}, {counted(count, 'problem')}" if count else text), bool(count)

    def show(self, context):
        curves = networks.curves_of(self._made)
        make_active(context, curves[0])
        suit_views(context)


class HULL_OT_curves_to_network(bpy.types.Operator, BaseOperator):
    """Take the selected curve objects, drawn or imported, into a network: a curve for each of their
    splines, of a kind by its plane"""

    bl_idname = "hull.curves_to_network"
    bl_label = "Curves to Network"

    target: StringProperty(
        name="Network", description="The network that takes them; blank: the one at hand, or a new "
        "one"
    )  # fmt: skip
    needs = (native_is_there, in_object_mode)

    def run(self, context):
        given = bpy.data.collections.get(self.target) if self.target else None
        if self.target and not networks.is_network(given):
            raise ValueError(f'There is no network "{self.target}"')
        network = given or networks.at_hand(context)
        reason = _why_not_changed(network, context.view_layer) if network is not None else ""
        if reason:
            raise ValueError(reason)
        if not any(obj.type == "CURVE" for obj in context.selected_objects):
            raise ValueError("Select curve objects first")
        made = making.take(context.selected_objects, network, context.scene)
        make_active(context, made[0])
        suit_views(context)
        network = networks.network_of(made[0])
        self.tell("INFO", f'"{network.name}" took {counted(len(made), "curve")}')


class HULL_OT_tie_curves(bpy.types.Operator, NetworkOperator):
    """Give curves that cross, or pass within the reach, a point of each in the same place: from
    then on it moves in all of them"""

    bl_idname = "hull.tie_curves"
    bl_label = "Tie at Crossings"

    reach: asked_length("Reach", "Curves that are nearer are tied; 0: the network's tolerance")

    needs = (*NetworkOperator.needs, in_object_mode)

    def draw(self, context):
        field_or(property_column(self), self, "reach", "the network's tolerance")

    def run_on(self, network, context):
        reach = units.as_typed(self.reach) or network.hull_network.tolerance
        if reach < 0.0:
            raise ValueError("The reach is below zero")
        count = crossings.tie(network, context.scene, reach)
        self.tell("INFO", f"Curves are tied at {counted(count, 'place')}")


class HULL_OT_select_network_problem(bpy.types.Operator, NetworkOperator):
    """Select the curves of this problem, and bring the 3D cursor and the view to its place"""

    bl_idname = "hull.select_network_problem"
    bl_label = "Select"

    index: IntProperty(name="Number", description="In the list, from 0", default=0)

    needs = (native_is_there, has_network)

    def run_on(self, network, context):
        state = network_state.state_of(network)
        problem = problems.numbered(network, state, self.index)
        if context.mode != "OBJECT":
            bpy.ops.object.mode_set(mode="OBJECT")
        place = problems.select(context.view_layer, network, problem)
        if place is None:
            return
        context.scene.cursor.location = place
        view_target.look_at(context.region_data, place)


class HULL_OT_remove_from_network(bpy.types.Operator, NetworkOperator):
    """Take the selected curves out of the network, without deleting them"""

    bl_idname = "hull.remove_from_network"
    bl_label = "Take Out"

    needs = (*NetworkOperator.needs, in_object_mode)

    def run_on(self, network, context):
        for obj in selected_curves(network, context):
            if len(obj.users_collection) == 1:
                context.scene.collection.objects.link(obj)
            network.objects.unlink(obj)
        network_state.follow(network, context.scene)


class HULL_OT_set_curve_role(bpy.types.Operator, NetworkOperator):
    """Give all selected curves a role"""

    bl_idname = "hull.set_curve_role"
    bl_label = "Role of Selected"

    role: EnumProperty(name="Role", description="What the surface does along them", items=ROLES)

    def run_on(self, network, context):
        for obj in selected_curves(network, context):
            obj.hull.curve.role = self.role
        network_state.follow(network, context.scene)


CLASSES = (
    HULL_OT_new_network,
    HULL_OT_network_from_hull,
    HULL_OT_curves_to_network,
    HULL_OT_tie_curves,
    HULL_OT_select_network_problem,
    HULL_OT_remove_from_network,
    HULL_OT_set_curve_role,
)
