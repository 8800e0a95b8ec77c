# SPDX-License-Identifier: GPL-3.0-or-later
"""The centre line of a whole hull whose sides have points of their own there: joined."""

import bmesh

from ...bridge.blender import blender_versions
from ...bridge.mesh import mesh_check
from ...bridge.mesh.mesh_editing import check_single_user, editing
from ..hull import hull_state


def join(obj, scene):
    """Makes one of the doubled points of a whole hull's centre line; returns how many there were
    twice. The joined edges become creases, which borders are, so that the surface stays the same
    along them. ValueError without any."""
    check_single_user(obj.data)
    control = hull_state.up_to_date(obj, scene).ship.source.control
    found = [] if obj.hull.half else mesh_check.slits(control)
    if not len(found):
        raise ValueError("No points of the centre line are there twice")
    with editing(obj.data) as bm:
        layer, _ = blender_versions.ensure_crease_layers(bm)  # before any vertex is held
        bm.verts.ensure_lookup_table()
        ids = control.vertex_ids
        target = _targets([(bm.verts[ids[a]], bm.verts[ids[b]]) for a, b in found.tolist()])
        kept = set(target.values())
        borders = {edge for vertex in kept for edge in vertex.link_edges if edge.is_boundary}
        ends = [tuple(edge.verts) for edge in borders]
        bmesh.ops.weld_verts(bm, targetmap=target)
        for edge in map(bm.edges.get, ends):
            if edge is not None and len(edge.link_faces) == 2:
                edge[layer] = 1.0
    hull_state.follow_edit(obj, scene)
    return len(kept)


def _targets(pairs):
    """{vertex: the one that it becomes}; a place may have more than two."""
    target = {}
    for kept, gone in pairs:
        target[gone] = target.get(kept, kept)
    return target
