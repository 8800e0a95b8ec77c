# SPDX-License-Identifier: GPL-3.0-or-later
"""The control mesh taken back to the one that it was subdivided from: the reverse of
exact_subdivision, and of Blender's own subdivision as far as its points allow.

Where points were moved since, the coarser mesh is the nearest one; the surface changes by what its
points cannot do, and where that is more than is allowed the hull stays as it is. Tags, layers,
marks, locks and weights of the points that stay come along; of edges and faces in one, what all of
them have.
"""

from dataclasses import dataclass

import bmesh
import numpy as np

from ...bridge import limits, native
from ...bridge.blender import blender_versions, units
from ...bridge.mesh import deck_edge_marks, mesh_arrays
from ...bridge.mesh.mesh_editing import check_single_user, editing
from ...bridge.objects import hull_mesh
from ..constraints import flat_marks, flats, planes
from ..hull import hull_state
from . import row_refitting

# Of the size: what single precision of the finer points leaves of zeros, as on the centre plane.
_ROUNDING = 2.4e-7


@dataclass(frozen=True)
class Reversed:
    """How many points and faces the mesh has now; how far the surface is from that of before, m, at
    most, and the points from subdivided ones. no_longer_flat: how many faces are not kept flat any
    longer, as parts of them were not."""

    points: int
    faces: int
    change: float
    moved: float
    no_longer_flat: int


def take_back(obj, scene, tolerance):
    """Takes a hull's control mesh back to the one it was subdivided from, in edit mode or not;
    returns what came of it.

    tolerance: how far the surface may be from that of before, m. ValueError where faces or creases
    are no subdivided ones, the surface would be farther away, or anything hangs on points that go:
    nothing changes then.
    """
    limits.within(tolerance, "Tolerance", 0.0, limits.LONGEST)
    check_single_user(obj.data)
    state = hull_state.up_to_date(obj, scene)
    found, scale = hull_mesh.read(obj), units.metres_per_unit(scene)
    control = found.control(scale)
    old = _surface(found.data, control, scale, state.ship.surface.scheme)
    coarse = old.coarsened_mesh()
    change = row_refitting.change(old, native.require().LimitSurface(coarse.mesh, old.scheme))
    if not change <= tolerance:
        raise ValueError(
            f"Taken back the surface would be {units.format_mm(change)} from where it is, more "
            f"than the tolerance of {units.format_mm(tolerance)}: points were moved since it was "
            f"subdivided, the farthest is number {coarse.largest_point}"
        )
    points = coarse.mesh.points
    points = np.where(np.abs(points) <= _ROUNDING * old.mesh.size, 0.0, points) / scale
    with editing(obj.data) as bm:
        parents = _parents(bm, control, coarse)
        _refuse_what_hangs_on(parents)
        for vertex, number in _kept_points(parents, coarse):
            vertex.co = points[number]
        _join(bm, parents)
        released = _mark_flats(obj, bm, parents)
        bm.normal_update()
    hull_state.follow_edit(obj, scene, is_by_hand=False).checked()
    data = mesh_arrays.read_mesh(obj.data)
    return Reversed(len(data.points), len(data.face_sizes), change, coarse.largest, released)


def _surface(data, control, scale, scheme):
    """Of the shell, whose points have Blender's numbers."""
    hull_native, ids = native.require(), control.vertex_ids
    mesh = hull_native.ControlMesh(
        data.points.astype(np.float64) * scale,
        control.face_sizes,
        ids[control.face_vertices],
        ids[control.creases],
        ids[control.corners],
    )
    return hull_native.LimitSurface(mesh, scheme)


@dataclass(frozen=True)
class _Parent:
    """A face that its cells, BMFaces at its corners, become; middle: their common BMVert; halves:
    both BMEdges from each corner to the next by the BMVert between them; flats: the cells' numbers
    of flats."""

    cells: tuple
    corners: tuple
    middle: object
    halves: dict
    flats: tuple


def _parents(bm, control, coarse):
    bm.verts.ensure_lookup_table()
    bm.faces.ensure_lookup_table()
    layer = bm.faces.layers.int.get(flat_marks.ATTRIBUTE)
    cells = [bm.faces[index] for index in control.face_ids[coarse.faces].tolist()]
    corners = [bm.verts[index] for index in coarse.points[coarse.mesh.face_vertices].tolist()]
    parents, first = [], 0
    for size in coarse.mesh.face_sizes.tolist():
        own, at = cells[first : first + size], corners[first : first + size]
        loops = [_loop_at(cell, corner) for cell, corner in zip(own, at)]
        halves = {
            loop.link_loop_next.vert: (loop.edge, following.link_loop_prev.edge)
            for loop, following in zip(loops, loops[1:] + loops[:1])
        }
        middle = loops[0].link_loop_next.link_loop_next.vert
        numbers = tuple(cell[layer] if layer else 0 for cell in own)
        parents.append(_Parent(tuple(own), tuple(at), middle, halves, numbers))
        first += size
    return parents


def _loop_at(face, vertex):
    return next(loop for loop in face.loops if loop.vert is vertex)


def _kept_points(parents, coarse):
    """Pairs of a BMVert that stays and its number in the coarser mesh."""
    corners = [corner for parent in parents for corner in parent.corners]
    return zip(corners, coarse.mesh.face_vertices.tolist())


def _refuse_what_hangs_on(parents):
    shell = {cell for parent in parents for cell in parent.cells}
    for parent in parents:
        for vertex in (parent.middle, *parent.halves):
            beside = vertex is parent.middle and not shell.issuperset(vertex.link_faces)
            if beside or any(shell.isdisjoint(edge.link_faces) for edge in vertex.link_edges):
                raise ValueError(
                    f"Edges or faces outside the shell hang on point {vertex.index}, which would "
                    "go: take them away first"
                )


def _join(bm, parents):
    """Makes one face of the cells of each parent: in the order of parents, before all others."""
    halves = {vertex: pair for parent in parents for vertex, pair in parent.halves.items()}
    chosen = _chosen(bm, parents, halves)
    _agree(bm, halves.values())
    bmesh.ops.dissolve_verts(bm, verts=[parent.middle for parent in parents])
    bmesh.ops.dissolve_verts(bm, verts=list(halves))
    for number, parent in enumerate(parents):
        bm.faces.get(parent.corners).index = number - len(parents)
    bm.faces.sort(key=lambda face: face.index)
    for parts in (bm.verts, bm.edges, bm.faces):
        parts.index_update()
    _select(bm, chosen)


def _agree(bm, pairs):
    """Gives two edges that will be one the marks that both have."""
    crease_layer = blender_versions.find_crease_layers(bm)[0]
    layers = (crease_layer, bm.edges.layers.int.get(deck_edge_marks.ATTRIBUTE))
    for first, second in pairs:
        first.seam = second.seam = first.seam and second.seam
        first.smooth = second.smooth = first.smooth or second.smooth
        for layer in layers:
            if layer is not None:
                first[layer] = second[layer] = min(first[layer], second[layer])


def _chosen(bm, parents, halves):
    """What will be selected, as tuples of points: those that stay, edges both of whose halves are
    selected, faces all of whose cells are."""
    cells = {cell for parent in parents for cell in parent.cells}
    parted = {edge for pair in halves.values() for edge in pair}
    goes = {*halves, *(parent.middle for parent in parents)}
    chosen = [(vertex,) for vertex in bm.verts if vertex.select and vertex not in goes]
    for edge in bm.edges:
        if edge.select and edge not in parted and goes.isdisjoint(edge.verts):
            chosen.append(tuple(edge.verts))
    for vertex, (first, second) in halves.items():
        if first.select and second.select:
            chosen.append((first.other_vert(vertex), second.other_vert(vertex)))
    for face in bm.faces:
        if face.select and face not in cells:
            chosen.append(tuple(vertex for vertex in face.verts if vertex not in goes))
    chosen += [p.corners for p in parents if all(cell.select for cell in p.cells)]
    return chosen


def _select(bm, chosen):
    for parts in (bm.faces, bm.edges, bm.verts):
        for part in parts:
            part.select_set(False)
    for points in chosen:
        if len(points) == 1:
            points[0].select_set(True)
        else:
            (bm.edges if len(points) == 2 else bm.faces).get(points).select_set(True)
    bm.select_flush_mode()


def _mark_flats(obj, bm, parents):
    """A face is kept flat where a part of it was and all its points are in that plane; returns how
    many are not any longer."""
    layer = bm.faces.layers.int.get(flat_marks.ATTRIBUTE)
    if layer is None:
        return 0
    regions = flats.plane_entries(obj)
    near = planes.tolerance(np.array([vertex.co for vertex in bm.verts], dtype=np.float64))
    released = 0
    for parent in parents:
        numbers = set(parent.flats).intersection(regions)
        number = numbers.pop() if len(numbers) == 1 else 0
        points = np.array([vertex.co for vertex in parent.corners], dtype=np.float64)
        if number:
            off = np.abs(planes.heights(points, flats.plane_of(regions[number])))
            number = number if off.max() <= near else 0
        released += any(parent.flats) and not number
        bm.faces.get(parent.corners)[layer] = number
    return released
