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
def nets(monkeypatch):
    """(the overlay of control nets, how many went to the graphics card), without one."""
    net, made = part("overlays.net"), []
    monkeypatch.setattr(net, "batch_of_strokes", lambda strokes, shader: made.append(1) or object())
    net._batches.clear()
    yield net, made
    net._batches.clear()


def test_nets_of_hulls_are_made_once_whatever_their_name(nets):
    net, made = nets
    hulls = [add_hull("one"), add_hull("other")]
    follow()
    known = [net._batch_of(state_of(hull), None) for hull in hulls]
    hulls[0].name, hulls[1].name = "third", "one"
    follow()
    assert [net._batch_of(state_of(hull), None) for hull in hulls] == known
    hulls[0].data.vertices[0].co.x -= 1.0
    hulls[0].data.update_tag()
    follow()
    assert net._batch_of(state_of(hulls[0]), None) is not known[0] and len(made) == 3
    assert len(net._batches) == 2
    for hull in hulls:
        remove(hull)
    assert not net._batches


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


def test_what_fairing_prepared_is_kept_of_each_hull():
    fairing = part("features.fairing.region_fairing")
    hulls = [add_hull("one"), add_hull("other")]
    follow()
    kept = [state_of(hull).of(fairing.Prepared) for hull in hulls]
    assert kept[0] is not kept[1] and kept[0].last is None
    make_active(hulls[0])
    remove(hulls[1])
    assert state_of(hulls[0]).of(fairing.Prepared) is kept[0]
