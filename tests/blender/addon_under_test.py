# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the installed add-on, whatever Blender calls it, and makes small hulls for the tests."""

import importlib
import importlib.util
from pathlib import Path

import bpy

ROOT = Path(__file__).resolve().parents[2]
SHARED = ROOT.parent / "shared"

LENGTH, HALF_BREADTH, DEPTH = 10.0, 2.0, 3.0


def module_name():
    """The name of the enabled add-on: a legacy one or an extension."""
    names = ("hull_tools", "bl_ext.user_default.hull_tools")
    return next(name for name in names if name in bpy.context.preferences.addons)


def part(path):
    """A module of the add-on's inner package, such as `features.hull.hull_state`."""
    return importlib.import_module(f"{module_name()}.hull_tools.{path}")


def hull_io(path=""):
    """The installed package of readers and writers, or a module of it, such as `new_hulls`."""
    return importlib.import_module(f"{module_name()}.hull_io{path and '.'}{path}")


def add_box(name="box"):
    """The port half of a box, open at the top and on the centre plane, active and not yet a hull.

    Creased at every edge, its surface is the box itself: every number of it has a closed form.
    """
    points = [(x, y, z) for x in (0.0, LENGTH) for y in (0.0, HALF_BREADTH) for z in (0.0, DEPTH)]
    side, bottom, aft, forward = (2, 3, 7, 6), (0, 2, 6, 4), (0, 1, 3, 2), (4, 6, 7, 5)
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, [], [side, bottom, aft, forward])
    edges = range(len(mesh.edges))
    part("bridge.blender.blender_versions").set_creases(mesh, edges, [])
    box = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(box)
    make_active(box)
    return box


def add_hull(name="box"):
    box = add_box(name)
    assert bpy.ops.hull.make_hull(half=True) == {"FINISHED"}
    return box


def sample(name="coaster"):
    """A sample hull, active."""
    bpy.ops.hull.load_sample(name=name)
    return bpy.context.view_layer.objects.active


def make_active(obj):
    for other in bpy.context.selected_objects:
        other.select_set(False)
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj


def state_of(obj):
    return part("features.hull.hull_state").state_of(obj)


def values(hull):
    """The hydrostatics.HydrostaticValues of a hull as it lies in the water."""
    return state_of(hull).hydrostatics.values


def compute(wanted):
    """Has pairs (name of a hull, analysis) computed in the thread, and waits for all of them."""
    live, worker = part("features.analyses.live_analyses"), part("bridge.background.worker")
    live.begin(wanted)
    worker.finish()
    live.take_finished()
    assert not worker.is_busy()


def mesh_points(obj):
    """Points (n, 3) of an object's mesh, as stored."""
    import numpy as np

    points = np.empty((len(obj.data.vertices), 3), dtype=np.float32)
    obj.data.vertices.foreach_get("co", points.reshape(-1))
    return points


def lined_hull():
    """A box with a line of every kind."""
    hull = add_hull()
    settings = hull.hull.lines
    hull.hull.length_pp, hull.hull.draft = LENGTH, 1.25
    settings.station_count, settings.waterline_spacing, settings.buttock_spacing = 4, 1.0, 0.75
    settings.diagonals = "2.5/45"
    plane = settings.planes.add()
    plane.normal, plane.point = (1.0, 1.0, 0.0), (5.0, 0.0, 0.0)
    bpy.context.view_layer.update()
    return hull


def shown_points(surface, hull):
    """The points in m that a hull's surface object has to show of a LimitSurface; both sides."""
    import numpy as np

    samples = part("features.surface.shown_surface").samples_of(hull, surface)
    points = surface.tessellate(samples).points
    if not hull.hull.half:
        return points
    on_plane = np.abs(points[:, 1]) < 1e-8
    points[on_plane, 1] = 0.0
    return np.concatenate([points, points[~on_plane] * [1.0, -1.0, 1.0]])


def fresh_surface_points(hull):
    """The hull's surface points in metres, computed anew from its mesh; both sides."""
    arrays, native = part("bridge.mesh.mesh_arrays"), part("bridge.native").require()
    control = arrays.control_arrays(arrays.read_mesh(hull.data), 1.0)
    surface = native.LimitSurface(native.ControlMesh(*control.arguments()))
    return shown_points(surface, hull)


def broaden(hull, by):
    """Moves the points of the port side outwards, in Blender's units."""
    for vertex in hull.data.vertices:
        vertex.co.y += by if vertex.co.y > 0.0 else 0.0
    hull.data.update_tag()
    bpy.context.view_layer.update()


def by_path(name):
    """The module of this name among the tests of plain Python."""
    spec = importlib.util.spec_from_file_location(name, ROOT / "tests" / "python" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
