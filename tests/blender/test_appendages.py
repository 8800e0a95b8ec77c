# SPDX-License-Identifier: GPL-3.0-or-later
"""Appendages in Blender: what they take off and add is what closed forms say, wherever they are."""

import math

import bpy
import pytest
from addon_under_test import add_hull, make_active, part, sample

RADIUS = 0.4


def add(hull, kind, **values):
    make_active(hull)
    assert bpy.ops.hull.add_appendage(kind=kind, **values) == {"FINISHED"}
    bpy.context.view_layer.update()
    return bpy.context.view_layer.objects.active


def volume(hull):
    bpy.context.view_layer.update()
    return part("features.hull.hull_state").state_of(hull).hydrostatics.values.displaced_volume


def not_joined(hull):
    return part("features.hull.hull_state").state_of(hull).ship.not_joined


@pytest.fixture
def box():
    hull = add_hull()
    hull.hull.draft = 2.5
    return hull


def test_tunnel(box):
    """πr²B less; moved out of the hull it takes nothing off, deleted likewise."""
    whole, hole = volume(box), math.pi * RADIUS**2 * 4.0
    tunnel = add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    assert tunnel.parent == box and tunnel.hull.appendage.is_cut
    assert volume(box) == pytest.approx(whole - hole, rel=1e-7)
    tunnel.location.x = 20.0
    assert volume(box) == pytest.approx(whole, rel=1e-7)
    tunnel.location.x = 5.0
    tunnel.hull.appendage.radius = 0.5
    assert volume(box) == pytest.approx(whole - math.pi * 0.5**2 * 4.0, rel=1e-7)
    tunnel.hull.appendage.counts = False
    assert volume(box) == pytest.approx(whole, rel=1e-7)
    tunnel.hull.appendage.counts = True
    assert volume(box) < whole - 3.0
    bpy.data.objects.remove(tunnel)
    assert volume(box) == pytest.approx(whole, rel=1e-7)


@pytest.mark.parametrize(
    "kind", ["FIN_KEEL", "BULB_KEEL", "RUDDER", "SKEG", "SHAFT", "BRACKET", "CYLINDER"]
)
def test_kinds_on_a_sample(kind):
    """Each is placed where it meets the hull, and adds less than its own volume."""
    hull = sample("coaster")
    before = volume(hull)
    first = add(hull, kind)
    native = part("features.flotation.appendages")
    bodies = part("bridge.objects.appendages").read(hull)
    own = sum((1 + b.is_mirrored) * native.native_body(b, 1.0).volume for b in bodies)
    assert not_joined(hull) == ""
    assert 0.0 < volume(hull) - before < own
    assert len(first.data.polygons) > 100
    assert first.hull.appendage.is_mirrored == (kind in ("SHAFT", "BRACKET"))


def test_moved_points_keep_appendages(box):
    add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    before = volume(box)
    for vertex in box.data.vertices:
        vertex.co.y *= 1.25
    box.data.update()
    box.update_tag()
    assert volume(box) == pytest.approx(1.25 * before, rel=1e-7)


def test_bad_sections_are_told_of(box):
    keel = add(box, "FIN_KEEL")
    with_keel = volume(box)
    keel.hull.appendage.section = "0012x"
    assert "is no section that is known" in not_joined(box) and keel.name in not_joined(box)
    assert volume(box) < with_keel
    assert len(keel.data.polygons) == 0
    keel.hull.appendage.section = "0012"
    assert not_joined(box) == "" and volume(box) != pytest.approx(100.0)


def test_off_the_hull(box):
    make_active(box)
    with pytest.raises(RuntimeError, match="There is no hull over"):
        bpy.ops.hull.add_appendage(kind="FIN_KEEL", x=30.0)
    assert len(box.children) == 1  # the surface


def test_saved_and_read(box, tmp_path):
    add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    name, before = box.name, volume(box)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "box.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "box.blend"))
    assert volume(bpy.data.objects[name]) == pytest.approx(before, rel=1e-9)


def test_step_file(box, tmp_path):
    add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    box.hull.export.extent = "SOLID"
    make_active(box)
    path = tmp_path / "box.step"
    assert bpy.ops.hull.export_step(filepath=str(path)) == {"FINISHED"}
    report = part("bridge.native").require().read_cad_report(str(path))
    assert report["valid"] and report["solids"] == 1
    assert report["volume"] == pytest.approx(120.0 - math.pi * RADIUS**2 * 4.0, rel=1e-8)
