# SPDX-License-Identifier: GPL-3.0-or-later
"""What the studio shows follows the hull: before a picture, and at a pause after a change."""

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, lined_hull, part

TINY = (16, 9)


def studio():
    return part("features.studio")


def scene():
    return bpy.context.scene


def shown(name):
    collection = studio().find(scene())
    return next(obj for obj in collection.objects if obj.get("hull_studio") == name)


def set_up(hull, **choices):
    for name, value in {"engine": "CYCLES", **choices}.items():
        setattr(hull.hull.studio, name, value)
    assert bpy.ops.hull.make_studio() == {"FINISHED"}


def take_picture():
    render = scene().render
    render.resolution_x, render.resolution_y = TINY
    scene().cycles.samples = 1
    assert bpy.ops.render.render() == {"FINISHED"}
    bpy.context.view_layer.update()


def move(hull, shift, chosen=lambda co: True):
    for vertex in hull.data.vertices:
        if chosen(vertex.co):
            vertex.co += type(vertex.co)(shift)
    hull.data.update()


def points(name):
    return np.array([v.co[:] for v in shown(name).data.vertices])


def line_points(name):
    return np.array([p.co[:] for s in shown(name).data.splines for p in s.bezier_points])


def number(obj, name):
    return obj.material_slots[0].material.node_tree.nodes[name].outputs[0].default_value


def is_wet(x, y):
    return shown("Studio water").ray_cast((x, y, 1.0), (0.0, 0.0, -1.0))[0]


def test_a_picture_shows_the_points_that_were_moved():
    hull = add_hull()
    set_up(hull)
    assert not is_wet(5.0, 1.9)
    # Wider, and higher forward.
    move(hull, (0.0, 1.0, 0.0), lambda co: co.y > 0.0)
    move(hull, (0.0, 0.0, 0.5), lambda co: co.z > 0.0)
    take_picture()
    assert not is_wet(5.0, 2.9) and is_wet(5.0, 3.1)
    deck = points("Studio deck")
    assert deck[:, 2] == pytest.approx(3.5) and np.abs(deck[:, 1]).max() == pytest.approx(3.0)
    for name in ("stations", "waterlines", "design waterline"):
        drawn = line_points(f"Studio {name}")
        assert drawn[:, 1].max() == pytest.approx(3.0, abs=1e-5), name
        assert drawn[:, 1].min() == pytest.approx(-3.0, abs=1e-5), name


def test_a_picture_shows_the_new_draft():
    hull = add_hull()
    hull.hull.draft = 1.25
    set_up(hull, boot_top_height=0.2)
    surface = hull.hull.surface_object
    hull.hull.draft = 2.0
    take_picture()
    assert shown("Studio water").location.z == pytest.approx(2.0)
    assert number(surface, "Draft") == pytest.approx(2.0)
    assert number(surface, "Boot top ends") == pytest.approx(2.2)
    assert number(shown("Studio deck"), "Draft") == pytest.approx(2.0)
    assert line_points("Studio design waterline")[:, 2] == pytest.approx(2.0)


def test_a_picture_in_edit_mode_shows_what_is_edited():
    hull = add_hull()
    set_up(hull)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.transform.translate(value=(0.0, 0.0, 0.25))
    take_picture()
    assert points("Studio deck")[:, 2] == pytest.approx(3.25)
    bpy.ops.object.mode_set(mode="OBJECT")


def test_the_floor_stays_under_the_keel():
    hull = add_hull()
    set_up(hull, ground="FLOOR")
    before = shown("Studio floor").location.z
    move(hull, (0.0, 0.0, -1.0))
    take_picture()
    assert shown("Studio floor").location.z == pytest.approx(before - 1.0)


def test_cameras_follow_until_the_user_moves_them():
    hull = add_hull()
    set_up(hull)
    cameras = [shown("Bow quarter"), shown("Profile")]
    cameras[1].location.x += 1.0
    bpy.context.view_layer.update()
    before = [camera.matrix_basis.copy() for camera in cameras]
    move(hull, (20.0, 0.0, 0.0), lambda co: co.x > 1.0)
    take_picture()
    assert cameras[0].matrix_basis != before[0] and cameras[1].matrix_basis == before[1]


def test_nothing_is_written_where_nothing_has_changed():
    hull = add_hull()
    set_up(hull)
    deck = shown("Studio deck")
    deck.data.vertices[0].co.z = 7.0
    take_picture()
    assert deck.data.vertices[0].co.z == 7.0
    hull.hull.draft *= 1.1
    take_picture()
    assert points("Studio deck")[:, 2] == pytest.approx(3.0)


def test_what_the_user_removed_stays_away():
    hull = lined_hull()
    set_up(hull)
    for name in ("Studio deck", "Studio stations", "Studio water"):
        bpy.data.objects.remove(shown(name))
    move(hull, (0.0, 0.5, 0.0), lambda co: co.y > 0.0)
    count = len(studio().find(scene()).objects)
    take_picture()
    assert len(studio().find(scene()).objects) == count
    assert line_points("Studio waterlines")[:, 1].max() == pytest.approx(2.5, abs=1e-5)


def test_a_hull_without_a_surface_leaves_the_studio_as_it_was():
    hull = add_hull()
    set_up(hull)
    hull.data.polygons[0].flip()
    hull.data.update()
    take_picture()
    assert points("Studio deck")[:, 2] == pytest.approx(3.0)


def test_it_follows_undo():
    hull = add_hull()
    set_up(hull)
    bpy.ops.ed.undo_push(message="studio")
    move(hull, (0.0, 0.0, 0.5))
    bpy.ops.ed.undo_push(message="moved")
    studio().follow(scene())
    assert points("Studio deck")[:, 2] == pytest.approx(3.5)
    for undo, height in ((bpy.ops.ed.undo, 3.0), (bpy.ops.ed.redo, 3.5)):
        undo()
        take_picture()
        assert points("Studio deck")[:, 2] == pytest.approx(height)


def test_it_follows_a_hull_that_floats_up():
    """Without any draft there is no underwater body, and no division by it."""
    hull = add_hull()
    set_up(hull)
    hull.hull.draft = 0.0
    take_picture()
    assert is_wet(5.0, 0.0)
    hull.hull.draft = 1.0
    take_picture()
    assert not is_wet(5.0, 0.0) and shown("Studio water").location.z == pytest.approx(1.0)
