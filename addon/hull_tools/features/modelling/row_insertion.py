# SPDX-License-Identifier: GPL-3.0-or-later
"""A row of control points inserted, and the control points around fitted to the surface of before.

Uniform B-splines have no knot insertion in one place: a row that is cut into the mesh halves the
knot spans there, and draws the surface to another shape. What the same points can do when they are
placed anew is nearly the old surface.
"""

from dataclasses import dataclass

import bmesh
import numpy as np

from ...bridge import native
from ...bridge.blender import blender_versions, units
from ...bridge.mesh import mesh_points
from ...bridge.mesh.mesh_editing import editing
from ...bridge.objects import hull_mesh
from ..constraints import point_locks
from ..hull import hull_state
from . import row_refitting

# A row of a large hull has less than a hundred; fitting many more takes longer than a press may.
MOST_POINTS = 200


@dataclass(frozen=True)
class Inserted:
    """How many points the rows have; how far the surface is from that of before, m, at most: as
    cut, and as fitted. ends: how many faces beside the chosen ones got a point more."""

    count: int
    cut_change: float
    change: float
    ends: int


def insert_rows(obj, scene):
    """Inserts a row across each ring of edges that has a selected one; where faces are selected
    across these alone, along the longest way through them. In edit mode; returns what came of it.
    Locked points stay, flats stay flat.

    ValueError when nothing is selected, the mesh has errors, no ring leads through quads, the
    selected faces do not tell which way, or more than MOST_POINTS would come.
    """
    return _insert(obj, scene, _rings_selected)


def _rings_selected(bm):
    rings = _rings_of_faces(bm)
    if rings:
        _refuse_many(rings)
        return rings
    _refuse_many(_rings_of_edges(bm))
    # Cutting one makes edges that the next one crosses.
    return _rings_of_edges(bm)


def _refuse_many(rings):
    edges = set()
    for ring in rings:
        edges.update(ring.edges)
        if len(edges) > MOST_POINTS:
            raise ValueError(
                f"The rows would have more than {MOST_POINTS} points: select fewer edges, or use "
                "Subdivide Exactly, which has the surface stay as it is"
            )


def insert_near(obj, scene, place):
    """Inserts a row near a place (3,), m, on the surface: across the longer edges of the face
    there. In edit mode or not; returns what came of it. ValueError where the mesh has errors, or no
    ring leads through quads there."""
    ship = hull_state.up_to_date(obj, scene).ship
    cell = int(native.require().SurfaceTree(ship.surface).closest_points([place]).cells[0])
    # A face has a cell at each of its corners.
    sizes = ship.source.control.face_sizes
    face = int(ship.source.control.face_ids[np.repeat(np.arange(len(sizes)), sizes)[cell]])

    def rings(bm):
        bm.faces.ensure_lookup_table()
        edges = bm.faces[face].edges
        if len(edges) != 4:
            raise ValueError("Where the points are too far apart is no face of four sides to cut")
        pairs = ((edges[0], edges[2]), (edges[1], edges[3]))
        longer = max(pairs, key=lambda pair: sum(edge.calc_length() for edge in pair))
        return (_ring(longer[0], None),)

    return _insert(obj, scene, rings)


def _insert(obj, scene, rings):
    """rings: BMesh → the _Rings to cut."""
    state = hull_state.up_to_date(obj, scene)
    old = native.require().LimitSurface(state.ship.surface.mesh, state.ship.surface.scheme)
    with editing(obj.data) as bm:
        new, longest, ends = _cut_rings(bm, rings(bm))
        bm.normal_update()
    scale = units.metres_per_unit(scene)
    control = hull_mesh.read(obj).control(scale)
    surface = native.require().LimitSurface(
        native.require().ControlMesh(*control.arguments()), old.scheme
    )
    before = row_refitting.change(old, surface)
    rows = np.flatnonzero(np.isin(control.vertex_ids, new))
    moved, points = row_refitting.refitted(obj, old, surface, control, rows, longest * scale)
    mesh_points.write(obj.data, control.vertex_ids[moved], points / scale)
    state = hull_state.follow_edit(obj, scene, is_by_hand=False).checked()
    return Inserted(len(new), before, row_refitting.change(old, state.ship.surface), ends)


def _cut_rings(bm, rings):
    """(indices of the new points, the longest of the edges cut in Blender's units, how many faces
    beside the chosen ones got a point more)."""
    new, longest, ends = [], 0.0, 0
    done = set()
    for ring in rings:
        # One ring after the other: the first may cut edges of the next.
        if not done.isdisjoint(ring.edges) or len(ring.edges) < 2:
            continue
        longest = max(longest, *(edge.calc_length() for edge in ring.edges))
        done |= set(ring.edges)
        ends += ring.ends()
        new += _cut(bm, ring)
    if not new:
        raise ValueError("Beside the selected edges there are no faces with four sides to cut")
    bm.verts.index_update()
    row_refitting.select(bm, new)
    return np.array([vertex.index for vertex in new]), longest, ends


@dataclass(frozen=True)
class _Ring:
    """Edges that lie across quads from one another, and these quads."""

    edges: list
    quads: set

    def ends(self):
        """How many faces beside the quads have one of the edges."""
        return len({face for edge in self.edges for face in edge.link_faces} - self.quads)


def _rings_of_edges(bm):
    chosen = [edge for edge in bm.edges if edge.select and not edge.hide]
    if not chosen:
        raise ValueError("Select an edge that the row is to run across, or faces")
    return (_ring(edge, None) for edge in chosen)


def _rings_of_faces(bm):
    """The rings through selected faces alone that are longest in faces; [] without such faces."""
    chosen = {face for face in bm.faces if face.select and not face.hide and len(face.verts) == 4}
    rings, seen = [], set()
    for face in chosen:
        for edge in face.edges[:2]:
            if (face, edge) in seen:
                continue
            ring = _ring(edge, chosen, face)
            seen |= {(quad, each) for quad in ring.quads for each in ring.edges}
            rings.append(ring)
    if not rings:
        return []
    longest = max(len(ring.quads) for ring in rings)
    found = [ring for ring in rings if len(ring.quads) == longest]
    if sum(len(ring.quads) for ring in found) > len(chosen):
        raise ValueError(
            "The selected faces are as many one way as the other: select a strip of them, along "
            "which the row is to run"
        )
    return found


def _ring(edge, within, through=None):
    """The _Ring of an edge, in faces `within` alone unless None; `through`: of these, one."""
    edges, quads, waiting, seen = [], set(), [edge], {edge}
    while waiting:
        edges.append(waiting.pop())
        for face in edges[-1].link_faces:
            if within is not None and face not in within:
                continue
            other = _opposite(face, edges[-1])
            if other is None:
                continue
            quads.add(face)
            if other not in seen:
                seen.add(other)
                waiting.append(other)
    return _Ring(edges, quads)


def _opposite(face, edge):
    """The edge across from one of a quad; None of other faces."""
    if len(face.verts) != 4:
        return None
    (other,) = (each for each in face.edges if not set(each.verts) & set(edge.verts))
    return other


def _cut(bm, ring):
    """Halves the edges of a ring and joins the halves' points across faces; returns the points."""
    _, corner_layer = blender_versions.find_crease_layers(bm)
    lock_layer = bm.verts.layers.int.get(point_locks.ATTRIBUTE)
    new = []
    for edge in ring.edges:
        _, vertex = bmesh.utils.edge_split(edge, edge.verts[0], 0.5)
        # Between a corner and another point Blender puts half a corner.
        if corner_layer is not None:
            vertex[corner_layer] = 0.0
        if lock_layer is not None:
            vertex[lock_layer] = 0
        new.append(vertex)
    fresh = set(new)
    for face in ring.quads:
        ends = [vertex for vertex in face.verts if vertex in fresh]
        if len(ends) == 2:
            bmesh.utils.face_split(face, *ends)
    return new
