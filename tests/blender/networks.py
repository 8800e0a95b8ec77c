# SPDX-License-Identifier: GPL-3.0-or-later
"""Small networks for the tests, and what is known of them."""

import bpy
import numpy as np
from addon_under_test import part


def new_network(**settings):
    assert bpy.ops.hull.new_network(**settings) == {"FINISHED"}
    return part("bridge.objects.networks").all_networks()[-1]


def add(kind, points=None, **more):
    """The object of a curve added by the operator."""
    if points is not None:
        more["points"] = "; ".join(" ".join(f"{v:.9g}" for v in point) for point in points)
    assert bpy.ops.hull.add_network_curve(kind=kind, **more) == {"FINISHED"}
    return bpy.context.view_layer.objects.active


def height(x, y):
    return 0.02 * x * y


def grid_network(count=3, show_surface=False):
    """Curves at x, y = 0 … 10 of a surface z = 0.02 x y, tied."""
    network = new_network()
    at = np.linspace(0.0, 10.0, count)
    for x in at:
        add("STATION", [(x, y, height(x, y)) for y in at], position=x)
    for y in at:
        add("BUTTOCK", [(x, y, height(x, y)) for x in at], position=y)
    if show_surface:
        network.hull_network.show_surface = True
    bpy.context.view_layer.update()
    return network


def state_of(network):
    return part("features.networks.network_state").state_of(network)


def points_of(obj):
    """(n, 3) of a curve object in the world."""
    return part("bridge.objects.bezier_curves").read(obj).points


def move_point(obj, index, by):
    """Moves a point with its handles, as Blender's G does, and lets all follow."""
    knot = obj.data.splines[0].bezier_points[index]
    for name in ("co", "handle_left", "handle_right"):
        place = getattr(knot, name)
        setattr(knot, name, [a + b for a, b in zip(place, by)])
    obj.data.update_tag()
    bpy.context.view_layer.update()


def finish():
    part("features.networks.following").finish()


def surface_points(network):
    mesh = network.hull_network.surface_object.data
    points = np.empty((len(mesh.vertices), 3), dtype=np.float32)
    mesh.vertices.foreach_get("co", points.reshape(-1))
    return points


def patch_points(network):
    """What the surface object has to show, by the native module alone."""
    native, found = state_of(network).network, []
    for region in range(native.region_count):
        patch = native.patch(region)
        found.append(patch.evaluate(patch.grid(network.hull_network.samples)[0])[0])
    return np.concatenate(found)
