# SPDX-License-Identifier: GPL-3.0-or-later
"""What is kept of a hull or a network is found by itself and goes with it: not by a name, which is
another's tomorrow, and not for good."""

import gc
from types import SimpleNamespace

import bpy
import pytest
from addon_under_test import add_hull, make_active, part, state_of
from networks import grid_network
from networks import state_of as state_of_network


def follow():
    bpy.context.view_layer.update()
    gc.collect()


def remove(obj):
    bpy.data.objects.remove(obj)
    bpy.context.view_layer.objects.active = None
    follow()


@pytest.fixture
def net_of(monkeypatch):
    """(HullState → what the graphics card has of its control net, without one; how many it got)."""
    net, made = part("overlays.net"), []
    versions = part("bridge.blender.blender_versions")
    monkeypatch.setattr(versions, "builtin_shader", lambda name: None)
    monkeypatch.setattr(net, "batch_of_strokes", lambda strokes, shader: made.append(1) or object())
    monkeypatch.setattr(part("overlays.buffers"), "batch", lambda *unused, **points: object())
    net._batches.clear()

    def net_of_state(state):
        return net._batches_of(state, b"", lambda: net.edges_of(state.ship.surface.mesh))

    yield net_of_state, made
    net._batches.clear()


def test_nets_of_hulls_are_made_once_whatever_their_name(net_of):
    net, made = net_of
    hulls = [add_hull("one"), add_hull("other")]
    follow()
    known = [net(state_of(hull)) for hull in hulls]
    hulls[0].name, hulls[1].name = "third", "one"
    follow()
    assert [net(state_of(hull)) for hull in hulls] == known
    hulls[0].data.vertices[0].co.x -= 1.0
    hulls[0].data.update_tag()
    follow()
    assert net(state_of(hulls[0])) != known[0] and len(made) == 3
    kept = part("overlays.net")._batches
    assert len(kept) == 2
    for hull in hulls:
        remove(hull)
    assert not kept


def test_arrays_of_a_network_go_with_it():
    arrays = part("overlays.network_arrays")
    network = grid_network()
    arrays.of_network(network, state_of_network(network))
    assert len(arrays._known) == 1
    for obj in list(network.objects):
        bpy.data.objects.remove(obj)
    bpy.data.collections.remove(network)
    part("features.networks.network_state").forget_deleted()
    follow()
    assert not arrays._known


def test_a_conversion_asked_for_is_of_the_hull_whatever_its_name(monkeypatch):
    conversions, begun = part("features.conversion.conversions"), []
    hulls = [add_hull("one"), add_hull("other")]
    follow()
    with_window = SimpleNamespace(app=SimpleNamespace(background=False), context=bpy.context)
    monkeypatch.setattr(conversions, "bpy", with_window)
    monkeypatch.setattr(conversions, "begin", lambda obj, scene: begun.append(obj))
    conversions.request(hulls[0])
    hulls[0].name, hulls[1].name = "third", "one"
    follow()
    conversions._begin_requested()
    assert begun == [hulls[0]]
    conversions._begin_requested()
    assert begun == [hulls[0]]


def test_what_is_on_its_way_of_a_hull_is_asked_for_once(monkeypatch):
    worker, begun = part("bridge.background.worker"), []
    gates = [SimpleNamespace(cancel=lambda: False, done=lambda: False) for _ in range(3)]

    def submit(work):
        begun.append(work)
        return gates[len(begun) - 1]

    monkeypatch.setattr(worker, "_queue", SimpleNamespace(submit=submit))
    monkeypatch.setattr(worker, "_jobs", [])
    for key in ("a", "a", "b", "b", "a"):
        worker.ask("levers", key, key)
    assert begun == ["a", "b", "a"]


def test_ghosts_wait_for_the_pause_of_a_timer(monkeypatch):
    """Of which each change begins anew; what goes by them comes after."""
    following, timers = part("features.variants.following"), part("bridge.background.timers")
    app = SimpleNamespace(background=False, timers=bpy.app.timers)
    for module in (following, timers):
        monkeypatch.setattr(module, "bpy", SimpleNamespace(app=app, context=bpy.context))
    done, is_another = [], [True]
    monkeypatch.setattr(following, "_follow_all", lambda: done.append("ghosts") or is_another[0])
    try:
        following.ask(lambda: done.append("plots"))
        following.ask(lambda: done.append("plots of now"))
        assert following._pause.is_running() and not done
        assert following._pause._called() is None
        assert done == ["ghosts", "plots of now"]
        is_another[0] = False
        following._pause._called()
        assert done == ["ghosts", "plots of now", "ghosts"]
    finally:
        following.stop()
    assert not following._pause.is_running()


def test_what_fairing_prepared_is_kept_of_each_hull():
    fairing = part("features.fairing.region_fairing")
    hulls = [add_hull("one"), add_hull("other")]
    follow()
    kept = [state_of(hull).of(fairing.Prepared) for hull in hulls]
    assert kept[0] is not kept[1] and kept[0].last is None
    make_active(hulls[0])
    remove(hulls[1])
    assert state_of(hulls[0]).of(fairing.Prepared) is kept[0]
