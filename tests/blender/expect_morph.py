# SPDX-License-Identifier: GPL-3.0-or-later
"""Families for tests, and what a member of one has to be."""

import bpy
import numpy as np
from addon_under_test import add_hull, mesh_points, part, shown_points, state_of


def boxes(*factors):
    """Box hulls with factors of length, breadth and depth."""
    made = []
    for number, factor in enumerate(factors):
        box = add_hull(f"box {number}")
        for vertex in box.data.vertices:
            vertex.co = [float(part) * own for part, own in zip(vertex.co, factor)]
        box.data.update()
        settings = box.hull
        for name, own in zip(("length_pp", "beam", "depth", "draft"), (*factor, factor[2])):
            setattr(settings, name, getattr(settings, name) * own)
        settings.loading.kg *= factor[2]
        box.update_tag(refresh={"DATA"})
        made.append(box)
    bpy.context.view_layer.update()
    return made


def ships(*names):
    """Samples, loaded one after the other."""
    found = []
    for name in names:
        assert bpy.ops.hull.load_sample(name=name) == {"FINISHED"}
        found.append(bpy.context.object)
    return found


def select(*objects):
    """Selects exactly these; the first is the active one."""
    for obj in bpy.context.selected_objects:
        obj.select_set(False)
    for obj in objects:
        obj.select_set(True)
    bpy.context.view_layer.objects.active = objects[0]


def morph_of(*hulls):
    select(*hulls)
    assert bpy.ops.hull.make_morph() == {"FINISHED"}
    bpy.context.view_layer.update()
    return bpy.context.object


def set_weight(hull, number, weight):
    hull.hull.morph.parents[number].weight = weight
    bpy.context.view_layer.update()


def exact_member(hull, weights):
    """Points of a member in single precision, by NumPy from the stored parents."""
    total = np.zeros((len(hull.hull.morph.parents[0].mesh.vertices), 3))
    for entry, weight in zip(hull.hull.morph.parents, weights):
        points = np.empty(3 * len(entry.mesh.vertices), dtype=np.float32)
        entry.mesh.vertices.foreach_get("co", points)
        total += weight * points.reshape(-1, 3).astype(np.float64)
    return total.astype(np.float32)


def assert_is_member(hull):
    """Mesh, surface object and status are those of the weights."""
    members = part("features.morphing.members")
    weights = part("features.morphing.weights").read(hull.hull.morph)
    assert abs(sum(weights) - 1.0) < 1e-12
    wanted = exact_member(hull, weights)
    if hull.mode == "OBJECT":
        own = mesh_points(hull)
    else:
        own = part("bridge.mesh.mesh_points").read(hull.data).astype(np.float32)
    size = np.ptp(wanted, axis=0).max()
    assert np.abs(own - wanted).max() <= 2e-7 * size
    assert members.is_of_family(hull) and members.told(hull).is_of_family
    state = state_of(hull)
    assert state.status == "" and state.ship.surface is not None
    surface = hull.hull.surface_object
    if surface is not None and hull.mode == "OBJECT":
        scale = part("bridge.blender.units").metres_per_unit(bpy.context.scene)
        shown = shown_points(state.ship.surface, hull) / scale
        assert np.abs(mesh_points(surface) - shown).max() <= 1e-5 * size
