# SPDX-License-Identifier: GPL-3.0-or-later
"""Points that are there twice made one: of a whole hull's centre line, where each side has its own,
and of borders that lie on one another. Nothing moves."""

from dataclasses import dataclass

import bmesh

from ...bridge.blender import blender_versions
from ...bridge.mesh import mesh_check
from ...bridge.mesh.mesh_editing import check_single_user, editing
from ..hull import hull_state

# Layers of points and edges whose values go along; 0 stands for none in all that the add-on has.
_KINDS = ("bool", "crease", "float", "float_vector", "int")  # "crease" up to Blender 3.6


@dataclass(frozen=True)
class Joined:
    """points: how many were there twice. knuckles: how many edges, borders before, became creases;
    smooth: how many did not."""

    points: int
    knuckles: int
    smooth: int


def join_centre_line(obj, scene):
    """Joins the sides of a whole hull; returns a Joined. The joined edges become creases, which
    borders are, so that the surface stays the same along them. ValueError without any."""
    control = _control(obj, scene)
    found = [] if obj.hull.half else mesh_check.slits(control)
    if not len(found):
        raise ValueError("No points of the centre line are there twice")
    return _join(obj, scene, control, found)


def join_points(obj, scene, smooth=False):
    """Joins the borders that lie on one another away from the centre line; returns a Joined.

    The joined edges become creases as above; smooth: only those that were tagged so, as of one
    sheet that was torn apart. ValueError without any."""
    control = _control(obj, scene)
    found = mesh_check.doubled(control, obj.hull.half)
    if not len(found):
        raise ValueError("No points of borders are there twice")
    return _join(obj, scene, control, found, smooth)


def _control(obj, scene):
    check_single_user(obj.data)
    return hull_state.up_to_date(obj, scene).ship.source.control


def _join(obj, scene, control, pairs, smooth=False):
    with editing(obj.data) as bm:
        creases, _ = blender_versions.ensure_crease_layers(bm)  # before any vertex is held
        bm.verts.ensure_lookup_table()
        ids = control.vertex_ids
        target = _targets([(bm.verts[ids[a]], bm.verts[ids[b]]) for a, b in pairs.tolist()])
        points = len(set(target.values()))
        for gone, kept in target.items():
            _take_over(_layers(bm.verts), gone, kept)
        joined = _joined_edges(bm, target)
        bmesh.ops.weld_verts(bm, targetmap=target)
        edges = [edge for edge in map(bm.edges.get, joined) if edge is not None]
        edges = [edge for edge in edges if len(edge.link_faces) == 2]
        untagged = [edge for edge in edges if edge[creases] < 1.0]
        for edge in () if smooth else untagged:
            edge[creases] = 1.0
    hull_state.follow_edit(obj, scene)
    return Joined(points, 0 if smooth else len(untagged), len(untagged) if smooth else 0)


def _targets(pairs):
    """{vertex: the one that it becomes}; a place may have more than two."""
    target = {}
    for kept, gone in pairs:
        target[gone] = target.get(kept, kept)
    return target


def _joined_edges(bm, target):
    """Pairs of vertices that stay, of the borders that become one edge; each of the two has the
    tags of the other, since either may be the one that stays."""
    of_ends = {}
    for edge in bm.edges:
        ends = frozenset(target.get(vertex, vertex) for vertex in edge.verts)
        if edge.is_boundary and len(ends) == 2:
            of_ends.setdefault(ends, []).append(edge)
    layers = _layers(bm.edges)
    twice = {ends: edges for ends, edges in of_ends.items() if len(edges) == 2}
    for one, other in twice.values():
        _take_over(layers, one, other)
        _take_over(layers, other, one)
        one.seam = other.seam = one.seam or other.seam
    return [tuple(ends) for ends in twice]


def _layers(elements):
    """What points or edges of a BMesh carry, creases among it."""
    found = [getattr(elements.layers, kind, None) for kind in _KINDS]
    return [layer for of_kind in found if of_kind is not None for layer in of_kind.values()]


def _take_over(layers, source, target):
    """Gives a point or an edge what it has not, and the other one has."""
    for layer in layers:
        value = target[layer]
        if not (any(value) if hasattr(value, "__len__") else value):
            target[layer] = source[layer]
