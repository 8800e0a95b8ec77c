# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies of a hull's own mesh that overlap are counted once, and that is told."""

import math
import re

import bpy
import pytest
from addon_under_test import add_hull, by_path, make_active, part, sample, state_of

boxes_of_points = by_path("boxes_of_points")


def boxes(*ends):
    """A whole hull of boxes (low, high), all edges knuckles; water at z = 2."""
    points, faces = boxes_of_points.points_and_faces(ends)
    mesh = bpy.data.meshes.new("boxes")
    mesh.from_pydata(points, [], faces)
    part("bridge.blender.blender_versions").set_creases(mesh, range(len(mesh.edges)), [])
    hull = bpy.data.objects.new("boxes", mesh)
    bpy.context.collection.objects.link(hull)
    make_active(hull)
    assert bpy.ops.hull.make_hull(half=False) == {"FINISHED"}
    hull.hull.draft = 2.0
    bpy.context.view_layer.update()
    return hull


HULL, SPONSON = ((0, -2, 0), (10, 2, 3)), ((4, 1, 1), (7, 3, 2.5))


def volume(hull):
    bpy.context.view_layer.update()
    return state_of(hull).hydrostatics.values.displaced_volume


def test_counted_once_and_told():
    hull = boxes(HULL, SPONSON)
    assert volume(hull) == pytest.approx(80.0 + 3.0, rel=1e-7)
    ship = state_of(hull).ship
    assert ship.overlap == "Bodies of the hull's mesh overlap by 4.5 m³" and not ship.added_up
    # Analyses in threads have the same, so have tables.
    assert ship.source.once
    body = ship.source.new_ship().body
    assert body.immersion((0.0, 0.0, 1.0), 2.0).volume == pytest.approx(83.0, abs=1e-9)
    assert ship.source.alone.new_ship().body.joined_volume == pytest.approx(-4.5, abs=1e-9)


def test_a_hull_of_one_body_is_not_looked_at(monkeypatch):
    """Nor is its body joined; a hull of two that are apart neither."""
    for hull in (add_hull(), boxes(HULL, ((4, 6, 1), (7, 8, 2.5)))):
        volume(hull)
        ship = state_of(hull).ship
        assert not ship.body.may_overlap and ship.body.joined_volume is None
        assert not ship.overlap and not ship.source.once


def test_so_little_stays_as_it_is():
    """The yacht's rudder in her hull: told, and counted as transformations count it."""
    hull = sample("sailing_yacht")
    ship = state_of(hull).ship
    assert ship.overlap == "Bodies of the hull's mesh overlap by 0.00344 m³"
    assert not ship.source.once and ship.body.joined_volume is None and not ship.added_up


def test_points_that_move():
    """Out of the hull it adds up by itself, back in it is counted once."""
    hull = boxes(HULL, SPONSON)
    volume(hull)
    for shift, displaced in ((1.0, 86.0), (-0.5, 84.5), (-0.5, 83.0)):
        for vertex in hull.data.vertices[8:]:
            vertex.co.y += shift
        hull.data.update()
        hull.update_tag()
        assert volume(hull) == pytest.approx(displaced, rel=1e-7)
        assert bool(state_of(hull).ship.overlap) == (displaced < 86.0)


def test_drags_wait():
    """While points are dragged bodies add up; at a pause they are counted once again."""
    hull = boxes(HULL, SPONSON)
    hull_state, scene = part("features.hull.hull_state"), bpy.context.scene
    volume(hull)
    for vertex in hull.data.vertices[8:]:
        vertex.co.x += 0.5
    state = hull_state.follow_edit(hull, scene, may_wait=True)
    assert state.ship.waits and not state.ship.source.once
    assert state.hydrostatics.values.displaced_volume == pytest.approx(86.0, rel=1e-7)
    hull_state.follow_edit(hull, scene, may_wait=True)
    assert state.ship.waits
    part("features.hull.late_joining").join()
    assert not state.ship.waits and state.ship.source.once
    assert volume(hull) == pytest.approx(83.0, rel=1e-7)


def test_surfaces_in_one_another_add_up_and_say_so():
    """Decks at one height."""
    hull = boxes(HULL, ((4, 1, 1), (7, 3, 3)))
    assert volume(hull) == pytest.approx(86.0, rel=1e-7)
    (told,) = [remark for remark in state_of(hull).remarks if "overlap" in remark]
    assert re.match(
        r"Bodies of the hull's mesh overlap by about 6(\.\d+)? m³, which count twice", told
    )
    assert "let them cross at an angle" in told
    assert not state_of(hull).ship.source.once


@pytest.mark.parametrize(
    "call, name", [("export_model", "a.stl"), ("export_panels", "a.gdf"), ("export_parts", "b.stl")]
)
def test_files_say_what_they_have_twice(tmp_path, capfd, call, name):
    boxes(HULL, SPONSON)
    assert getattr(bpy.ops.hull, call)(filepath=str(tmp_path / name)) == {"FINISHED"}
    told = capfd.readouterr().out
    assert "overlap by 4.5 m³ and are in it twice: model them as one body" in told


def test_a_tunnel_through_both():
    """Appendages count with them."""
    hull = boxes(HULL, SPONSON)
    make_active(hull)
    bpy.ops.hull.add_appendage(kind="TUNNEL", x=2.0, z=1.0, radius=0.4)

    assert volume(hull) == pytest.approx(83.0 - math.pi * 0.4**2 * 4.0, rel=1e-6)
    assert state_of(hull).ship.source.once
