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
_has_followed = False


def after_changes(changed, scene, has_other_members):
    """Follows the networks of changed objects; all, where objects came, went, or changed
    collections."""
    concerned = {}
    if has_other_members:
        concerned = {network: set() for network in networks.all_networks()}
        if concerned or _has_followed:  # in most files there is nothing to be loaded for
            network_state.forget_deleted()
    for obj in changed:
        network = networks.network_of(obj)
        if network is not None:
            concerned.setdefault(network, set()).add(obj.name)
    _follow(concerned, scene)


def follow_all():
    """All networks of the file, each in its first scene, whatever their surface objects show."""
    found = networks.all_networks()
    if found or _has_followed:
        network_state.forget_deleted()
        for _, state in network_state.known_networks():
            state.surface.forget()
    for network in found:
        _follow({network: None}, networks.scene_of(network))


def forget_all():
    _pause.stop()
    if _has_followed:
        network_state.forget_all()


def _follow(concerned, scene):
    """concerned: names of changed objects, None for all, by network."""
    global _is_following, _has_followed
    if _is_following or not concerned:
        return
    _is_following = _has_followed = True
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
