# SPDX-License-Identifier: GPL-3.0-or-later
"""Which collections are networks of curves, and what belongs to them.

A network is a collection; its curves are the curve objects in it, and one mesh object there may
show its surface.
"""

import bpy

from .. import limits


def is_network(collection):
    return collection is not None and collection.hull_network.is_network


def all_networks():
    return [one for one in bpy.data.collections if one.hull_network.is_network]


def named(name):
    """The network of that name, or None."""
    return next((network for network in all_networks() if network.name == name), None)


def network_of(obj):
    """The network that an object belongs to; None for any other."""
    if obj is None:
        return None
    return next((one for one in obj.users_collection if is_network(one)), None)


def at_hand(context):
    """The network of the active object, or else the only one of the scene; None without one."""
    found = network_of(context.object)
    if found is not None:
        return found
    networks = [one for one in context.scene.collection.children_recursive if is_network(one)]
    return networks[0] if len(networks) == 1 else None


def curves_of(network):
    """The curve objects of a network, by name; ValueError where they are too many to be joined."""
    curves = sorted((o for o in network.objects if o.type == "CURVE"), key=lambda o: o.name)
    limits.at_most(len(curves), f'curves of "{network.name}"', limits.MOST_NETWORK_CURVES)
    return curves


def surface_of(network):
    """The object that shows a network's surface; None where there is none, or it was deleted, or
    is another network's, as that of a copy."""
    shown = network.hull_network.surface_object
    if shown is None or shown.type != "MESH" or shown.name not in network.objects:
        return None
    return shown


def locked(network):
    """Why a network cannot be changed, as a sentence; "" when it can."""
    blocks = [network]
    for obj in network.objects:
        blocks += [obj, obj.data] if obj.data is not None else [obj]
    for block in blocks:
        if block.library is not None or block.override_library is not None:
            return f'"{block.name}" is linked from another file: make it local first'
    return ""


def is_left_out(network, view_layer):
    """Whether a view layer leaves a network out: nothing of it can be selected there."""
    left = [view_layer.layer_collection]
    while left:
        layer = left.pop()
        if layer.collection == network and not layer.exclude:
            return False
        left += layer.children
    return True


def scene_of(network):
    """The first scene that has a network; None where none has."""
    for scene in bpy.data.scenes:
        if network in scene.collection.children_recursive:
            return scene
    return None
