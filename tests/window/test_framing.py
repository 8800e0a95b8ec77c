# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull that comes is all in view, from the eye and not within it."""

import bpy
from mathutils import Vector


def test_a_sample_is_framed(window):
    bpy.ops.hull.load_sample(name="container_ship")
    yield
    yield
    hull = bpy.context.view_layer.objects.active
    area = next(area for area in bpy.context.window.screen.areas if area.type == "VIEW_3D")
    view = area.spaces.active.region_3d
    eye = view.view_matrix.inverted().translation
    low, high = (Vector(f(c[i] for c in hull.bound_box) for i in range(3)) for f in (min, max))
    assert not all(low[i] < eye[i] < high[i] for i in range(3))
    for corner in hull.bound_box:
        x, y, z, w = view.perspective_matrix @ Vector((*corner, 1.0))
        assert w > 0.0 and abs(x) <= 1.05 * w and abs(y) <= 1.05 * w
