# SPDX-License-Identifier: GPL-3.0-or-later
"""Which networks follow what Blender tells of."""

from ...bridge.background import timers
from ...bridge.blender.redraw import redraw
from ...bridge.objects import networks
from . import network_state

# Until surfaces are finished: all patches, exact normals.
_PAUSE_SECONDS = 0.4

# Writing to curves makes Blender tell of them in turn.
_is_following = False


def after_changes(changed, scene, has_other_members):
    """Follows the networks of changed objects; all, where objects came, went, or changed
    collections."""
    concerned = {}
    if has_other_members:
        network_state.forget_deleted()
        concerned = {network: set() for network in networks.all_networks()}
    for obj in changed:
        network = networks.network_of(obj)
        if network is not None:
            concerned.setdefault(network, set()).add(obj.name)
    _follow(concerned, scene)


def follow_all():
    """All networks of the file, each in its first scene, whatever their surface objects show."""
    network_state.forget_deleted()
    for network, state in network_state.known_networks():
        state.surface.forget()
    for network in networks.all_networks():
        _follow({network: None}, networks.scene_of(network))


def forget_all():
    _pause.stop()
    network_state.forget_all()


def _follow(concerned, scene):
    """concerned: names of changed objects, None for all, by network."""
    global _is_following
    if _is_following:
        return
    _is_following = True
    try:
        for network, changed in concerned.items():
            if scene is not None and network in scene.collection.children_recursive:
                state = network_state.follow(network, scene, changed)
                if not state.surface.is_finished:
                    _pause.put_off()
    finally:
        _is_following = False


def finish():
    """Finishes what is shown of all networks."""
    for network, state in network_state.known_networks():
        state.surface.finish(network, state)
    redraw()


_pause = timers.Timer(_PAUSE_SECONDS, finish)
