# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh as scans are, to make a hull of."""

import bpy
import numpy as np
from addon_under_test import part


def lay_scan(window):
    """Leaves nothing in the scene but a mesh "scan" of a sample's surface, active."""
    with window.in_view():
        bpy.ops.hull.load_sample(name="coaster")
        hull = bpy.context.view_layer.objects.active
        state = part("features.hull.hull_state").up_to_date(hull, bpy.context.scene)
        grid = state.ship.surface.tessellate(4)
        points, quads = np.array(grid.points).tolist(), np.array(grid.quads).tolist()
        bpy.ops.object.select_all(action="SELECT")
        bpy.ops.object.delete()
    mesh = bpy.data.meshes.new("scan")
    mesh.from_pydata(points, [], quads)
    scan = bpy.data.objects.new("scan", mesh)
    bpy.context.collection.objects.link(scan)
    scan.select_set(True)
    bpy.context.view_layer.objects.active = scan
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="scan")
