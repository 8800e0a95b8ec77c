# SPDX-License-Identifier: GPL-3.0-or-later
"""A row of control points taken away, and the points around fitted to the surface of before: the
reverse of row_insertion.

The faces on both sides of the row become one, and so do the edges across it, with their tags. The
surface changes by what fewer points cannot do; where that is more than is allowed the hull stays as
it is. All is tried on a copy.
"""

import contextlib
from dataclasses import dataclass

import bmesh
import bpy
import numpy as np

from ...bridge import limits, native
from ...bridge.blender import blender_versions, units
from ...bridge.mesh import mesh_points
from ...bridge.objects import hull_mesh
from ..constraints import flat_marks, point_locks
from ..hull import hull_state
from . import row_refitting


@dataclass(frozen=True)
class Removed:
    """How many points the row had; how far the surface is from that of before, m, at most: with the
    points around left where they were, and as fitted."""

    count: int
    bare_change: float
    change: float


def remove_row(obj, scene, tolerance):
    """Removes the selected row, in edit mode: edges that follow one another between faces, of a
    single edge the whole row that it is of. Returns what came of it. Locked points stay, flats stay
    flat.

    tolerance: how far the surface may be from that of before, m. ValueError when no row is
    selected, it is a knuckle or a border, has locked points or corners, or leaves the surface
    farther away: nothing changes then.
    """
    limits.within(tolerance, "Tolerance", 0.0, limits.LONGEST)
    state = hull_state.up_to_date(obj, scene)
    old = native.require().LimitSurface(state.ship.surface.mesh, state.ship.surface.scheme)
    scale = units.metres_per_unit(scene)
    with _copy(obj) as trial:
        bm = bmesh.new()
        try:
            bm.from_mesh(trial.data)
            count, beside, longest = _dissolve(bm, _row(bm))
            bm.to_mesh(trial.data)
        finally:
            bm.free()
        control = hull_mesh.read(trial).control(scale)
        mesh = native.require().ControlMesh(*control.arguments())
        surface = native.require().LimitSurface(mesh, old.scheme)
        bare = row_refitting.change(old, surface)
        rows = np.flatnonzero(np.isin(control.vertex_ids, beside))
        moved, points = row_refitting.refitted(trial, old, surface, control, rows, longest * scale)
        placed = control.points.copy()
        placed[moved] = points
        surface.set_points(placed)
        found = row_refitting.change(old, surface)
    if not found <= tolerance:
        raise ValueError(
            f"Without the row the surface would be {units.format_mm(found)} from where it is, more "
            f"than the tolerance of {units.format_mm(tolerance)}: all stays as it was"
        )
    edited = bmesh.from_edit_mesh(obj.data)
    _dissolve(edited, _row(edited))
    edited.normal_update()
    bmesh.update_edit_mesh(obj.data)
    mesh_points.write(obj.data, control.vertex_ids[moved], points / scale)
    hull_state.follow_edit(obj, scene, is_by_hand=False).checked()
    return Removed(count, bare, found)


@contextlib.contextmanager
def _copy(obj):
    """A copy of a hull in edit mode, in no scene, for as long as it is needed."""
    obj.update_from_editmode()
    trial = obj.copy()
    trial.data = obj.data.copy()
    try:
        yield trial
    finally:
        bpy.data.meshes.remove(trial.data)


def _row(bm):
    """The edges of the row that is selected."""
    chosen = [edge for edge in bm.edges if edge.select and not edge.hide]
    if not chosen:
        raise ValueError("Select the row: edges that follow one another, or one of them")
    row = _whole_row(chosen[0]) if len(chosen) == 1 else chosen
    crease_layer, corner_layer = blender_versions.find_crease_layers(bm)
    lock_layer = bm.verts.layers.int.get(point_locks.ATTRIBUTE)
    own = set(row)
    for edge in row:
        if len(edge.link_faces) != 2:
            raise ValueError("The row runs along a border, which cannot be taken away")
        if crease_layer is not None and edge[crease_layer] > 0.0:
            raise ValueError("The row is a knuckle: make it smooth first, or select another")
    for vertex in {vertex for edge in row for vertex in edge.verts}:
        rest = [edge for edge in vertex.link_edges if edge not in own]
        if len(vertex.link_edges) - len(rest) > 2:
            raise ValueError("Rows meet in the selection: select the edges of one row")
        if len(rest) != 2:
            continue
        if lock_layer is not None and vertex[lock_layer]:
            raise ValueError("Points of the row are locked: unlock them first")
        if corner_layer is not None and vertex[corner_layer] > 0.0:
            raise ValueError("A point of the row is a corner: make it smooth first")
        if crease_layer is not None and rest[0][crease_layer] != rest[1][crease_layer]:
            raise ValueError(
                "A knuckle ends at the row: let it end beside it first, or go on across"
            )
    return row


def _whole_row(edge):
    """The edges that go on across points of four faces, or come from a border, on both sides."""
    row, waiting = {edge}, list(edge.verts)
    while waiting:
        vertex = waiting.pop()
        if len(vertex.link_edges) != 4 or len(vertex.link_faces) != 4:
            continue
        own = [each for each in vertex.link_edges if each in row]
        if len(own) != 1:  # the row is closed
            continue
        beside = set(own[0].link_faces)
        following = [each for each in vertex.link_edges if beside.isdisjoint(each.link_faces)]
        if len(following) == 1 and following[0] not in row:
            row.add(following[0])
            waiting.append(following[0].other_vert(vertex))
    return list(row)


def _dissolve(bm, row):
    """Takes the row's edges away, and its points that are left with two edges: (how many, the
    indices of the points beside, the longest of the edges across)."""
    points = list(dict.fromkeys(vertex for edge in row for vertex in edge.verts))
    across = {edge for vertex in points for edge in vertex.link_edges}.difference(row)
    longest = max(edge.calc_length() for edge in across)
    ends = {vertex for edge in across for vertex in edge.verts}
    _release_beside(bm, row)
    bmesh.ops.dissolve_edges(bm, edges=row, use_verts=False, use_face_split=False)
    leaving = [vertex for vertex in points if vertex.is_valid and len(vertex.link_edges) == 2]
    count = len(leaving)
    bmesh.ops.dissolve_verts(bm, verts=leaving)
    # With faces that meet twice more goes than was asked for.
    staying = [vertex for vertex in ends if vertex.is_valid]
    bm.verts.index_update()
    row_refitting.select(bm, staying)
    return count, np.array([vertex.index for vertex in staying]), longest


def _release_beside(bm, row):
    """Lets faces go that would become one with another that is not of the same flat."""
    layer = bm.faces.layers.int.get(flat_marks.ATTRIBUTE)
    if layer is None:
        return
    for edge in row:
        if len({face[layer] for face in edge.link_faces}) > 1:
            for face in edge.link_faces:
                face[layer] = 0
