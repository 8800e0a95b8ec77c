# SPDX-License-Identifier: GPL-3.0-or-later
"""The studio: hulls of any size fill the frame, nothing of it is left when it goes."""

import json
from math import pi

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import add_box, add_hull, lined_hull, make_active, part, state_of
from bpy_extras.object_utils import world_to_camera_view
from mathutils import Vector

BLOCKS = (
    "actions", "cameras", "collections", "curves", "lights", "materials", "meshes", "objects",
    "worlds",
)  # fmt: skip
VIEWS = ("PROFILE", "PLAN", "BODY", "BOW", "STERN", "TURNTABLE", "UNDERWATER")


def studio():
    return part("features.studio")


def scene():
    return bpy.context.scene


def collection():
    return studio().find(scene())


def set_up(hull, **choices):
    for name, value in choices.items():
        setattr(hull.hull.studio, name, value)
    assert bpy.ops.hull.make_studio() == {"FINISHED"}
    bpy.context.view_layer.update()
    return collection()


def blocks():
    return {kind: {one.name for one in getattr(bpy.data, kind)} for kind in BLOCKS}


def scene_settings():
    settings = part("features.studio.scene_settings")
    trial = bpy.data.collections.new("trial")
    settings.note(trial, scene())
    found = json.loads(trial["settings"])
    bpy.data.collections.remove(trial)
    return found, scene().camera, scene().world


def shown_in_pictures():
    return {obj.name for obj in scene().objects if not obj.hide_render}


def surface_points(hull):
    surface = hull.hull.surface_object
    points = part("features.studio.place").points_of(surface.data)
    return points + np.array(surface.matrix_world.translation)


def seen(points, camera):
    """(n, 3) where points are in the picture, 0 to 1 from the left and from below, and how far
    away."""
    return np.array([world_to_camera_view(scene(), camera, Vector(p))[:] for p in points])


def scaled_hull(factor):
    box = add_box()
    for vertex in box.data.vertices:
        vertex.co *= factor
    assert bpy.ops.hull.make_hull(half=True) == {"FINISHED"}
    return box


@pytest.mark.parametrize("factor", (0.3, 1.0, 40.0))
@pytest.mark.parametrize("size", ((1600, 900), (600, 800)))
def test_the_hull_fills_the_picture(factor, size):
    hull = scaled_hull(factor)
    hull.location = (7.0, -3.0, 5.0)
    bpy.context.view_layer.update()
    set_up(hull)
    scene().render.resolution_x, scene().render.resolution_y = size
    points = surface_points(hull)
    for view in VIEWS:
        assert bpy.ops.hull.studio_view(view=view) == {"FINISHED"}
        bpy.context.view_layer.update()
        camera = scene().camera
        shown = points
        if view == "UNDERWATER":
            shown = points[points[:, 2] <= 5.0 + hull.hull.draft]
        places = seen(shown, camera)
        assert (places[:, :2] > 0.0).all() and (places[:, :2] < 1.0).all(), view
        assert (places[:, 2] > camera.data.clip_start).all()
        assert (places[:, 2] < camera.data.clip_end).all()
        low, high = places[:, :2].min(axis=0), places[:, :2].max(axis=0)
        assert low + high == pytest.approx([1.0, 1.0], abs=0.3 if view == "TURNTABLE" else 1e-3)
        # As large as it may be, with the same room around it in every view.
        if view == "TURNTABLE":
            continue
        assert (high - low).max() == pytest.approx(1.0 / 1.08, abs=0.02), view


def test_without_water_all_of_the_hull_is_seen_from_below():
    hull = add_hull()
    set_up(hull, ground="FLOOR")
    assert bpy.ops.hull.studio_view(view="UNDERWATER") == {"FINISHED"}
    bpy.context.view_layer.update()
    places = seen(surface_points(hull), scene().camera)[:, :2]
    assert (places > 0.0).all() and (places < 1.0).all()


def test_the_turntable_shows_the_hull_from_all_sides():
    hull = add_hull()
    set_up(hull)
    assert bpy.ops.hull.studio_view(view="TURNTABLE") == {"FINISHED"}
    points, widest = surface_points(hull), 0.0
    for frame in range(1, 121, 15):
        scene().frame_set(frame)
        places = seen(points, scene().camera)[:, :2]
        assert (places > 0.0).all() and (places < 1.0).all()
        widest = max(widest, np.ptp(places, axis=0).max())
    assert widest > 0.85


def test_the_turntable_turns_evenly_and_once():
    hull = add_hull()
    set_up(hull, turntable_frames=90)
    assert bpy.ops.hull.studio_turntable() == {"FINISHED"}
    pivot = scene().camera.parent
    turns = []
    for frame in range(1, 92):
        scene().frame_set(frame)
        turns.append(pivot.rotation_euler.z)
    assert np.diff(turns) == pytest.approx(2.0 * pi / 90.0, abs=1e-6)
    assert (scene().frame_start, scene().frame_end) == (1, 90)


def test_nothing_is_left_of_it():
    hull = lined_hull()
    other = bpy.data.objects.new("other", bpy.data.meshes.new("other"))
    hidden = bpy.data.objects.new("hidden", None)
    lens = bpy.data.objects.new("mine", bpy.data.cameras.new("mine"))
    for obj in (other, hidden, lens):
        bpy.context.collection.objects.link(obj)
    hidden.hide_render = True
    scene().camera, scene().world = lens, bpy.data.worlds.new("mine")
    scene().world.use_fake_user = True
    scene().render.resolution_x, scene().frame_end = 640, 77
    hull.hull.surface_object.hide_render = True
    make_active(hull)
    before = blocks(), scene_settings(), shown_in_pictures(), hull.hull.samples
    for ground, light in (("WATER", "SUN"), ("FLOOR", "STUDIO"), ("NONE", "SUN")):
        made = set_up(hull, ground=ground, light=light)
        assert made.name == f"Studio of {hull.name}"
        assert blocks() != before[0] and scene_settings() != before[1]
        assert {other.name, hull.name} & shown_in_pictures() == set()
        assert hull.hull.surface_object.name in shown_in_pictures()
        assert bpy.ops.hull.remove_studio() == {"FINISHED"}
        after = blocks(), scene_settings(), shown_in_pictures(), hull.hull.samples
        assert after == before
    assert hull.hull.surface_object.material_slots[0].link == "DATA"
    assert not bpy.ops.hull.remove_studio.poll()


def test_a_second_studio_takes_the_place_of_the_first():
    first, second = add_hull("first"), add_hull("second")
    before = scene_settings()
    make_active(first)
    set_up(first)
    count = {kind: len(names) for kind, names in blocks().items()}
    set_up(first)
    assert {kind: len(names) for kind, names in blocks().items()} == count
    make_active(second)
    set_up(second)
    assert collection().name == "Studio of second" and studio().hull_of(scene()) == second
    assert first.hull.surface_object.hide_render and first.hide_render
    bpy.ops.hull.remove_studio()
    assert scene_settings() == before
    assert not first.hull.surface_object.hide_render and first.hide_render


def test_what_the_user_put_into_the_collection_stays():
    hull = add_hull()
    mine = bpy.data.objects.new("mine", None)
    set_up(hull).objects.link(mine)
    bpy.ops.hull.remove_studio()
    assert mine.name in scene().objects


def test_a_deckhouse_on_the_hull_is_shown():
    hull = add_hull()
    house = bpy.data.objects.new("house", bpy.data.meshes.new("house"))
    house.parent = hull
    bpy.context.collection.objects.link(house)
    set_up(hull)
    assert not house.hide_render


def test_the_studio_goes_when_its_hull_is_gone():
    hull = add_hull()
    before = scene_settings()
    set_up(hull)
    bpy.data.objects.remove(hull.hull.surface_object)
    bpy.data.objects.remove(hull)
    assert studio().hull_of(scene()) is None
    assert bpy.ops.hull.remove_studio() == {"FINISHED"}
    assert collection() is None and scene_settings() == before


def test_colours_of_curvature_come_back():
    hull = add_hull()
    hull.hull.fairness.colours = "SLOPE"
    bpy.context.view_layer.update()
    slot = hull.hull.surface_object.material_slots[0]
    was = slot.material
    assert slot.link == "OBJECT"
    set_up(hull)
    assert slot.material != was
    bpy.ops.hull.remove_studio()
    assert slot.link == "OBJECT" and slot.material == was
    set_up(hull, paint=False)
    assert slot.material == was


def test_a_hull_that_is_faulty_has_no_studio():
    hull = add_hull()
    set_up(hull)
    before = blocks()
    bm = bmesh.new()
    bm.from_mesh(hull.data)
    bm.faces.ensure_lookup_table()
    bmesh.ops.reverse_faces(bm, faces=bm.faces[:1])
    bm.to_mesh(hull.data)
    bm.free()
    hull.data.update()
    with pytest.raises(RuntimeError):
        bpy.ops.hull.make_studio()
    # The studio of before stays.
    assert blocks() == before


def water():
    return next(obj for obj in collection().objects if obj.name.startswith("Studio water"))


def area(obj):
    return sum(polygon.area for polygon in obj.data.polygons)


def test_water_is_at_the_draft_and_not_inside():
    hull = add_hull()
    hull.hull.draft = 1.25
    set_up(hull)
    sheet = water()
    assert sheet.matrix_world.translation.z == pytest.approx(1.25)
    for (x, y), is_wet in {
        (5.0, 0.0): False, (9.9, 1.9): False, (0.1, -1.9): False, (5.0, 2.1): True,
        (-0.1, 0.0): True, (50.0, 40.0): True, (-3000.0, 2500.0): True,
    }.items():  # fmt: skip
        hit = sheet.ray_cast((x, y, 1.0), (0.0, 0.0, -1.0))[0]
        assert hit == is_wet, (x, y)
    normals = np.array([polygon.normal[:] for polygon in sheet.data.polygons])
    assert ((normals[:, 2] > 0.99) | (normals[:, 2] == 0.0)).all()


def deck():
    return next(obj for obj in collection().objects if obj.name.startswith("Studio deck"))


def test_a_deck_closes_the_hull():
    hull = add_hull()
    set_up(hull)
    assert area(deck()) == pytest.approx(10.0 * 4.0)
    assert {round(v.co.z, 6) for v in deck().data.vertices} == {3.0}


def test_each_hull_of_a_catamaran_has_its_deck():
    box = add_box()
    bm = bmesh.new()
    bm.from_mesh(box.data)
    # Closed towards the centre plane too, and away from it.
    bm.verts.ensure_lookup_table()
    bm.faces.new([bm.verts[i] for i in (0, 4, 5, 1)])
    bmesh.ops.translate(bm, verts=bm.verts, vec=(0.0, 3.0, 0.0))
    bm.to_mesh(box.data)
    bm.free()
    part("bridge.blender.blender_versions").set_creases(box.data, range(len(box.data.edges)), [])
    assert bpy.ops.hull.make_hull(half=True) == {"FINISHED"}
    assert not state_of(box).status
    set_up(box)
    assert area(deck()) == pytest.approx(2.0 * 10.0 * 2.0)
    sides = np.array([v.co.y for v in deck().data.vertices])
    assert (np.abs(sides) > 2.9).all()


def test_paint_changes_at_the_waterline():
    """The height at which the paint's nodes change colour is the draft."""
    hull = add_hull()
    hull.hull.draft = 1.25
    set_up(hull)
    material = hull.hull.surface_object.material_slots[0].material
    limits = [
        node.inputs[1].links[0].from_node.outputs[0].default_value
        for node in material.node_tree.nodes
        if node.type == "MATH" and node.operation == "GREATER_THAN" and node.inputs[1].links
    ]
    assert 1.25 in limits


def test_lines_are_on_the_surface():
    hull = lined_hull()
    set_up(hull)
    curves = [obj for obj in collection().objects if obj.type == "CURVE"]
    assert {obj.name for obj in curves} == {
        "Studio stations", "Studio waterlines", "Studio design waterline",
        "Studio knuckles and borders",
    }  # fmt: skip
    for obj in curves:
        points = np.array([p.co[:] for s in obj.data.splines for p in s.bezier_points])
        x, y, z = points.T
        off = np.min([np.abs(x), np.abs(x - 10.0), np.abs(np.abs(y) - 2.0), np.abs(z)], axis=0)
        assert off.max() < 1e-5
        assert y.min() < -1.9 and y.max() > 1.9
    set_up(hull, lines="NONE")
    assert not [obj for obj in collection().objects if obj.type == "CURVE"]


def test_it_is_kept_in_the_file(tmp_path):
    hull = add_hull()
    before = blocks(), scene_settings()
    set_up(hull)
    path = str(tmp_path / "studio.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    assert studio().hull_of(scene()).name == "box"
    assert bpy.ops.hull.studio_view(view="STERN") == {"FINISHED"}
    assert bpy.ops.hull.remove_studio() == {"FINISHED"}
    assert (blocks(), scene_settings()) == before


def test_a_ship_in_millimetres_looks_the_same():
    hull = add_hull()
    set_up(hull)
    stations = next(obj for obj in collection().objects if obj.name == "Studio stations")
    size, thin = stations.dimensions[:], stations.data.bevel_depth
    place = scene().camera.matrix_world.translation[:]
    bpy.ops.hull.remove_studio()
    scene().unit_settings.system, scene().unit_settings.scale_length = "METRIC", 0.001
    bpy.context.view_layer.update()
    set_up(hull)
    stations = next(obj for obj in collection().objects if obj.name == "Studio stations")
    assert stations.dimensions[:] == pytest.approx(size, rel=1e-5)
    assert stations.data.bevel_depth == pytest.approx(thin, rel=1e-6)
    assert scene().camera.matrix_world.translation[:] == pytest.approx(place, rel=1e-5)


def test_set_up_and_removal_are_one_step_of_undo_each():
    hull = add_hull()
    bpy.ops.ed.undo_push(message="before")
    before = blocks()
    set_up(hull)
    bpy.ops.ed.undo_push(message="studio")
    with_studio = blocks()
    bpy.ops.hull.remove_studio()
    bpy.ops.ed.undo_push(message="removed")
    assert blocks() == before
    bpy.ops.ed.undo()
    assert blocks() == with_studio and collection() is not None
    bpy.ops.hull.remove_studio()
    assert blocks() == before


def test_a_turntable_without_its_empty_is_refused():
    set_up(add_hull())
    bpy.data.objects.remove(next(obj for obj in collection().objects if obj.type == "EMPTY"))
    with pytest.raises(RuntimeError, match="set up the studio anew"):
        bpy.ops.hull.studio_turntable()


def test_settings_of_another_blender_do_not_keep_the_studio():
    before = scene().render.resolution_x
    set_up(add_hull())
    kept = json.loads(collection()["settings"])
    collection()["settings"] = json.dumps({**kept, "render.engine": "ANOTHER_BLENDERS"})
    assert bpy.ops.hull.remove_studio() == {"FINISHED"}
    assert collection() is None and scene().render.resolution_x == before


def test_collections_that_the_user_put_into_it_stay():
    hull = add_hull()
    mine, own = bpy.data.objects.new("mine", None), bpy.data.collections.new("own")
    set_up(hull).children.link(own)
    own.objects.link(mine)
    bpy.ops.hull.remove_studio()
    assert mine.name in scene().objects and own.name in scene().collection.children


def test_a_surface_without_a_slot_is_painted():
    hull = add_hull()
    shown = hull.hull.surface_object
    shown.data.materials.clear()
    set_up(hull)
    assert shown.material_slots[0].material.name.startswith("Studio hull paint")
    assert bpy.ops.hull.remove_studio() == {"FINISHED"}
    assert shown.material_slots[0].link == "DATA"


@pytest.mark.parametrize("first_goes_first", (True, False))
def test_two_scenes_have_studios_of_one_hull(first_goes_first):
    hull, other = add_hull(), bpy.data.scenes.new("other")
    shown, beside = hull.hull.surface_object, bpy.data.objects.new("beside", None)
    bpy.context.collection.objects.link(beside)
    for obj in (hull, shown, beside):
        other.collection.objects.link(obj)
    hull.hull.samples = 5
    hull.hide_render = False
    slot, make, remove = shown.material_slots[0], studio().make, studio().remove
    before = blocks(), slot.link, slot.material
    make(hull, scene())
    make(hull, other)
    scenes = [scene(), other] if first_goes_first else [other, scene()]
    assert remove(scenes[0])
    assert hull.hull.samples == 12 and hull.hide_render and beside.hide_render
    assert slot.material == studio().find(scenes[1])["paint"]
    assert remove(scenes[1])
    assert hull.hull.samples == 5 and not hull.hide_render and not beside.hide_render
    assert (blocks(), slot.link, slot.material) == before


def test_a_turntable_that_is_set_again_leaves_nothing():
    hull = add_hull()
    before = blocks()
    set_up(hull)
    for frames in (90, 120):
        hull.hull.studio.turntable_frames = frames
        assert bpy.ops.hull.studio_turntable() == {"FINISHED"}
    bpy.ops.hull.remove_studio()
    assert blocks() == before
