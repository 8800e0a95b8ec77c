# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull that comes is all in view, from the eye and not within it: from whatever it comes."""

import tempfile
from pathlib import Path

import bpy
from chine_boats import carlson, curves
from expect import assert_framed
from mathutils import Vector


def look_away(window):
    """At what is small and far from where hulls come to be."""
    view = window.space.region_3d
    view.view_location, view.view_distance = Vector((500.0, 400.0, 0.0)), 2.0


def arrived(window, bring):
    """What bring() makes the active object."""
    look_away(window)
    yield
    assert bring() == {"FINISHED"}
    yield
    yield
    assert_framed(bpy.context.view_layer.objects.active)


def imported(window, name, write):
    """A file of a sample, the active object, that write(path) makes is read again."""
    bpy.ops.hull.load_sample(name="coaster")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / name
        write(path)
        bpy.ops.object.select_all(action="SELECT")
        bpy.ops.object.delete()
        yield from arrived(window, lambda: bpy.ops.hull.import_hull(filepath=str(path)))


def test_a_sample_is_framed(window):
    yield from arrived(window, lambda: bpy.ops.hull.load_sample(name="container_ship"))


def test_a_small_boat_is_framed(window):
    yield from arrived(window, lambda: bpy.ops.hull.load_sample(name="planing_boat"))


def as_hull_file(path):
    assert bpy.ops.hull.export_hull(filepath=str(path)) == {"FINISHED"}


def as_freeship(path):
    assert bpy.ops.hull.export_freeship(filepath=str(path)) == {"FINISHED"}


def test_a_hull_file_is_framed(window):
    yield from imported(window, "coaster.hull.json", as_hull_file)


def test_a_freeship_file_is_framed(window):
    yield from imported(window, "coaster.fbm", as_freeship)


def test_a_file_of_chines_is_framed(window):
    yield from imported(window, "skiff.hul", lambda path: path.write_text(carlson(curves())))


def test_a_hull_is_framed_where_the_scene_is_in_feet(window):
    units = bpy.context.scene.unit_settings
    units.system, units.length_unit = "IMPERIAL", "FEET"
    units.scale_length = 0.3048
    try:
        yield from imported(window, "coaster.hull.json", as_hull_file)
    finally:
        units.system, units.scale_length = "METRIC", 1.0
