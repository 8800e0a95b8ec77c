# SPDX-License-Identifier: GPL-3.0-or-later
"""Lids on the openings of a hull's surface: its deck, an open transom.

What is open from side to side is closed by straight lines across the ship, and so has the sheer and
no camber; an opening of its own, as of one hull of a catamaran, is filled.
"""

import bmesh
import bpy
import numpy as np

_NAME = "Studio deck"


def add_deck(here, material):
    """A deck, still empty."""
    deck = bpy.data.meshes.new(_NAME)
    deck.materials.append(material)
    here.add_scenery(_NAME, deck)


def follow(here):
    """Has the deck, if there is one, close the openings of the surface as it is now."""
    deck = here.find(_NAME)
    if deck is None:
        return
    lids = bmesh.new()
    try:
        for edges in _openings(here.surface):
            _close(lids, here.points, edges)
        lids.to_mesh(deck.data)
    finally:
        lids.free()


def _openings(mesh):
    """Lists of the edges (pairs of vertices) that go round each opening."""
    edges = np.empty((len(mesh.loops)), dtype=np.int32)
    mesh.loops.foreach_get("edge_index", edges)
    vertices = np.empty((len(mesh.edges), 2), dtype=np.int32)
    mesh.edges.foreach_get("vertices", vertices.reshape(-1))
    borders = vertices[np.bincount(edges, minlength=len(vertices)) == 1].tolist()
    edges_at = {}
    for edge in borders:
        for vertex in edge:
            edges_at.setdefault(vertex, []).append(edge)
    seen = set()
    for vertex in edges_at:
        opening, waiting = [], [vertex]
        while waiting:
            one = waiting.pop()
            if one not in seen:
                seen.add(one)
                opening += [edge for edge in edges_at[one] if edge[0] == one]
                waiting += [other for edge in edges_at[one] for other in edge]
        if opening:
            yield opening


def _close(lids, points, edges):
    corners = {index: tuple(points[index]) for edge in edges for index in edge}
    index_at = {corner: index for index, corner in corners.items()}
    images = {i: index_at.get((x, -y, z)) for i, (x, y, z) in corners.items()}
    vertices = {index: lids.verts.new(corner) for index, corner in corners.items()}
    if None in images.values():
        outline = [lids.edges.new((vertices[i], vertices[j])) for i, j in edges]
        bmesh.ops.triangle_fill(lids, use_beauty=True, edges=outline)
        return
    for i, j in edges:
        if corners[i][1] + corners[j][1] > 0.0:
            around = dict.fromkeys(
                (vertices[i], vertices[j], vertices[images[j]], vertices[images[i]])
            )
            if len(around) > 2:
                lids.faces.new(tuple(around))
