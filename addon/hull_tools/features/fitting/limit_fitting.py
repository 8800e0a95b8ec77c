# SPDX-License-Identifier: GPL-3.0-or-later
"""Control points are moved until their limits, the places of the surface that they end in, lie on
another surface: after a change of the mesh's faces, on the one of before."""

import numpy as np

from ...bridge import native
from ...bridge.blender import units
from ...bridge.mesh import mesh_check, mesh_points
from ...bridge.objects import hull_mesh

# A limit is drawn by its own point by a half or so; this many steps leave a thousandth.
_STEPS = 12


def put_limits_on(surface, obj, scene, indices):
    """Moves points (k,) of a hull's mesh so that their limits lie on a hull_native.LimitSurface.

    Points that are not of the shell stay, and all do where the mesh has errors.
    """
    scale = units.metres_per_unit(scene)
    found = hull_mesh.read(obj)
    control = found.control(scale)
    _, mesh = mesh_check.check_control_mesh(found.data, control, found.half)
    own = np.flatnonzero(np.isin(control.vertex_ids, indices))
    if mesh is None or not len(own):
        return
    hull_native = native.require()
    tree = hull_native.SurfaceTree(surface)
    changed = hull_native.LimitSurface(mesh, surface.scheme)
    # The cell of a corner of a face begins at that corner.
    cells = np.array([np.flatnonzero(control.face_vertices == point)[0] for point in own])
    points = control.points.copy()
    for _ in range(_STEPS):
        (limits,) = changed.evaluate(cells, np.zeros((len(cells), 2)))
        points[own] += tree.closest_points(limits).points - limits
        changed.set_points(points)
    mesh_points.write(obj.data, control.vertex_ids[own], points[own] / scale)
