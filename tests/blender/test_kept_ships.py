# SPDX-License-Identifier: GPL-3.0-or-later
"""Surface and body are kept from edit to edit, and yet their numbers are those of fresh ones."""

import random

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, make_active, part, state_of

pytestmark = pytest.mark.once

SEED = 5


def coaster():
    assert bpy.ops.hull.load_sample(name="coaster") == {"FINISHED"}
    return bpy.context.object


def fresh_body(hull):
    """The live HullBody of a hull as it is now, made of nothing that was kept."""
    arrays, scale = part("bridge.mesh.mesh_arrays"), bpy.context.scene.unit_settings.scale_length
    excluded = part("bridge.objects.hull_objects").excluded_slots(hull)
    control = arrays.control_arrays(arrays.read_mesh(hull.data), scale, excluded)
    settings = hull.hull
    openings = "closed" if settings.deck_closed else "open"
    source = part("features.flotation.ship").ShipSource(
        control, settings.scheme, settings.half, openings, ()
    )
    return source.live_body(source.new_surface())


def assert_is_fresh(hull):
    state = state_of(hull)
    assert not state.status
    where = part("features.flotation.afloat").afloat(
        hull.hull, bpy.context.scene.unit_settings.scale_length
    )
    body = fresh_body(hull)
    ship = part("features.flotation.ship").Ship(body, ())
    assert state.hydrostatics.values == part("features.flotation.hydrostatics").at(ship, where)
    assert np.array_equal(state.ship.surface.mesh.points, body.surface.mesh.points)
    assert (state.ship.body.openings, state.ship.body.mirrored) == (body.openings, body.mirrored)
    assert state.ship.body.shell_area == body.shell_area
    exact = state.ship.source.new_ship().body
    assert exact.shell_area == pytest.approx(body.shell_area, rel=1e-8)
    for kept in (state.ship.body, exact):
        assert kept.surface.scheme == hull.hull.scheme


def move(hull, choice):
    """Moves one point, in edit mode or not."""
    amount = choice.uniform(0.01, 0.1)
    if hull.mode == "EDIT":
        bm = bmesh.from_edit_mesh(hull.data)
        bm.verts.ensure_lookup_table()
        bm.verts[choice.randrange(len(bm.verts))].co.z += amount
        bmesh.update_edit_mesh(hull.data)
    else:
        hull.data.vertices[choice.randrange(len(hull.data.vertices))].co.z += amount
        hull.data.update_tag()
    bpy.context.view_layer.update()


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_moved_points_reach_the_surface_that_is_there(mode):
    hull, choice = coaster(), random.Random(SEED)
    bpy.ops.object.mode_set(mode=mode)
    surface, body = state_of(hull).ship.surface, state_of(hull).ship.body
    for _ in range(5):
        before = state_of(hull).hydrostatics.values
        move(hull, choice)
        assert state_of(hull).ship.surface is surface and state_of(hull).ship.body is body
        assert state_of(hull).hydrostatics.values != before
        assert_is_fresh(hull)


def test_tags_and_faces_make_it_anew():
    hull, choice = coaster(), random.Random(SEED)
    move(hull, choice)
    surface = state_of(hull).ship.surface
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.hull.tag_smooth()
    bpy.context.view_layer.update()
    assert state_of(hull).ship.surface is not surface
    assert_is_fresh(hull)
    surface = state_of(hull).ship.surface
    bpy.ops.mesh.subdivide()
    bpy.context.view_layer.update()
    assert state_of(hull).ship.surface is not surface
    assert_is_fresh(hull)
    move(hull, choice)
    assert_is_fresh(hull)


def test_settings_make_anew_what_depends_on_them():
    hull, choice = coaster(), random.Random(SEED)
    surface, body = state_of(hull).ship.surface, state_of(hull).ship.body
    hull.hull.deck_closed = False
    bpy.context.view_layer.update()
    assert state_of(hull).ship.surface is surface and state_of(hull).ship.body is not body
    assert_is_fresh(hull)
    move(hull, choice)
    hull.hull.scheme = "catmull_clark"
    bpy.context.view_layer.update()
    assert_is_fresh(hull)
    hull.hull.deck_closed = True
    move(hull, choice)
    assert_is_fresh(hull)
    bpy.context.scene.unit_settings.scale_length = 0.5
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    assert_is_fresh(hull)


def test_undo_and_redo_of_moves_and_tags():
    hull, choice = coaster(), random.Random(SEED)
    name = hull.name
    volumes = []

    def push():
        bpy.ops.ed.undo_push(message="step")
        volumes.append(state_of(bpy.data.objects[name]).hydrostatics.values.displaced_volume)

    push()
    move(hull, choice)
    push()
    part("bridge.mesh.deck_edge_marks").store_marks(
        hull.data, np.ones(len(hull.data.edges), dtype=bool)
    )
    part("bridge.blender.blender_versions").set_creases(hull.data, range(len(hull.data.edges)), [])
    hull.data.update_tag()
    bpy.context.view_layer.update()
    push()
    move(hull, choice)
    push()
    assert len(set(volumes)) == 4
    back, forth = bpy.ops.ed.undo, bpy.ops.ed.redo
    for step, volume in zip((back, back, back, forth, forth, forth), (2, 1, 0, 1, 2, 3)):
        step()
        hull = bpy.data.objects[name]
        assert_is_fresh(hull)
        assert state_of(hull).hydrostatics.values.displaced_volume == volumes[volume]


def test_a_mesh_with_errors_and_back():
    hull, choice = add_hull(), random.Random(SEED)
    bpy.ops.object.mode_set(mode="EDIT")
    before = state_of(hull).hydrostatics.values
    bm = bmesh.from_edit_mesh(hull.data)
    far = bm.verts.new((5.0, 4.0, 0.0))
    bm.verts.ensure_lookup_table()
    bm.faces.new((bm.verts[2], bm.verts[6], far))
    bmesh.update_edit_mesh(hull.data)
    bpy.context.view_layer.update()
    assert state_of(hull).status and state_of(hull).hydrostatics.values == before
    bm.verts.ensure_lookup_table()
    bm.verts.remove(bm.verts[8])
    move(hull, choice)
    assert_is_fresh(hull)


def test_renamed_hulls_keep_what_is_theirs():
    first, second = add_hull("first"), add_hull("second")
    second.hull.draft = 1.0
    bpy.context.view_layer.update()
    states = state_of(first), state_of(second)
    first.name = "third"
    second.name = "first"
    bpy.context.view_layer.update()
    assert (state_of(first), state_of(second)) == states
    for hull in (first, second):
        part("features.hull.hull_state").refresh(hull, bpy.context.scene)
        assert_is_fresh(hull)


def test_nothing_is_kept_of_what_is_no_hull_any_longer():
    kept = part("features.hull.hull_state")._states
    kept.clear()
    first, second = add_hull("first"), add_hull("second")
    assert len(kept) == 2
    first.hull.is_hull = False
    bpy.context.view_layer.update()
    make_active(second)
    bpy.ops.ed.undo_push(message="two")
    bpy.ops.object.delete()
    bpy.context.view_layer.update()
    assert len(kept) == 0
    bpy.ops.ed.undo_push(message="deleted")
    bpy.ops.ed.undo()
    assert_is_fresh(bpy.data.objects["second"])
    bpy.ops.ed.redo()
    assert len(kept) == 0
