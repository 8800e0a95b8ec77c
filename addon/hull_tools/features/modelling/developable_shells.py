# SPDX-License-Identifier: GPL-3.0-or-later
"""Developable surfaces from selected chains of edges, as mesh objects with their rulings: the strip
between two, a cone to the 3D cursor, a cylinder along a direction."""

import bpy
import numpy as np

from ...bridge import native
from ...bridge.blender import units
from ...bridge.counts import counted_are
from ...bridge.mesh import selection
from ...bridge.objects import hull_objects
from ..hull import hull_state

# By the form: how the object is called, and how many chains it takes.
FORMS = {"STRIP": ("Developable strip", 2), "CONE": ("Cone", 1), "CYLINDER": ("Cylinder", 1)}


def make_shell(obj, scene, form, shift, count):
    """Makes the developable surface of a form of FORMS from the selected edges of a hull in edit
    mode, with about so many rulings. shift: of a CYLINDER, Blender's units along the hull's axes.
    Returns (the new object, a text). ValueError for edges that are not as many open chains of the
    shell, and where there is no such surface."""
    state, scale = hull_state.up_to_date(obj, scene), units.metres_per_unit(scene)
    name, wanted = FORMS[form]
    found = chains(selection.selected(obj, "edge"))
    if len(found) != wanted:
        words = "two chains of edges that do not touch" if wanted == 2 else "one chain of edges"
        raise ValueError(f"Select {words}: {counted_are(len(found), 'chain')} selected")
    curves = [_curve(state, chain) for chain in found]
    hull_native = native.require()
    if form == "STRIP":
        made = hull_native.strip_between(*curves, count)
    elif form == "CONE":
        cursor = hull_objects.from_world(obj) @ scene.cursor.location
        made = hull_native.cone_to(*curves, np.array(cursor) * scale, count)
    else:
        made = hull_native.cylinder_along(*curves, np.array(shift) * scale, count)
    text = f"{name}: {len(made.first)} rulings, {units.format_value(scene, made.area, 'm2')}"
    return _object_of(obj, name, made, scale), text


def chains(edges):
    """Lists of points of edges (pairs), each an open chain in order. ValueError where edges branch
    or go round."""
    around = {}
    for a, b in edges:
        around.setdefault(a, []).append(b)
        around.setdefault(b, []).append(a)
    if any(len(others) > 2 for others in around.values()):
        raise ValueError("The selected edges branch: select chains without side branches")
    found, left = [], dict(around)
    for start in sorted(point for point, others in around.items() if len(others) == 1):
        if start not in left:
            continue
        chain = [start]
        while True:
            del left[chain[-1]]
            onward = [one for one in around[chain[-1]] if one in left]
            if not onward:
                break
            chain += onward
        found.append(chain)
    if left:
        raise ValueError("The selected edges go round in a ring: leave one of them out")
    return found


def _curve(state, chain):
    """Bézier points, m, of the surface's curve along a chain of the mesh's points."""
    ids = state.ship.source.control.vertex_ids
    if not np.isin(chain, ids).all():
        raise ValueError("A selected edge is not of the hull's surface: take edges of its faces")
    return native.require().edge_curve(state.ship.surface, np.searchsorted(ids, chain))


def _object_of(obj, name, made, scale):
    """A mesh object with quadrilaterals between rulings, triangles where one end stays."""
    count = len(made.first)
    points = np.concatenate([made.first, made.second]) / scale
    size = np.linalg.norm(np.ptp(points, axis=0))
    _, first_of, numbers = np.unique(
        np.round(points / (1e-9 * size)), axis=0, return_index=True, return_inverse=True
    )
    numbers = numbers.reshape(-1)
    k = np.arange(count - 1)
    corners = numbers[np.stack([k, k + 1, k + 1 + count, k + count], axis=1)]
    faces = [list(dict.fromkeys(face)) for face in corners.tolist()]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points[first_of].tolist(), [], [face for face in faces if len(face) > 2])
    shown = bpy.data.objects.new(name, mesh)
    shown.parent = obj
    for collection in obj.users_collection:
        collection.objects.link(shown)
    return shown
