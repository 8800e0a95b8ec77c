# SPDX-License-Identifier: GPL-3.0-or-later
"""From a half hull to a whole one and back, in object mode.

A half hull's borders in the centre plane are creases of the whole one, so that surface and numbers
stay the same.

Points nearer to the centre plane than a millionth of the hull's size are put on it, and are shared
by both sides. Tags, layers, marks, flat regions and the planes of kept points come along.
"""

from dataclasses import dataclass

import bmesh
import numpy as np
from mathutils import kdtree

from ....hull_io.sides import lies_to_starboard
from ...bridge.blender import blender_versions
from ...bridge.counts import counted
from ...bridge.mesh import mesh_check, mesh_points
from ...bridge.mesh.mesh_editing import check_single_user, editing
from ...bridge.objects import hull_mesh
from ..constraints import flat_marks, flats, kept_points, planes, ties
from ..hull import hull_state

# Points of both sides that are nearer than this part of the hull's size are alike.
ALIKE = 1e-5

# A connected part of the mesh that reaches across the centre plane by less than this share of its
# reach to the one side belongs to that side.
_ACROSS_A_LITTLE = 0.1

# The sides by the sign of y.
SIDES = {"PORT": 1.0, "STARBOARD": -1.0}


@dataclass(frozen=True)
class HalfMade:
    """difference: how far, in Blender's units, a point of the side that went was from the mirror
    image of this one, at most. smooth_edges: how many edges in the centre plane were no crease, so
    that the surface is another there. overlap: how far the side that went reached across the centre
    plane, where it was a part of its own, at most."""

    difference: float
    smooth_edges: int
    overlap: float


def to_whole(obj, scene):
    """Gives a half hull its other side: the same ship, modelled whole. ValueError when it is
    whole, points are on the other side already, or the two sides would not join."""
    if not obj.hull.half:
        raise ValueError("The hull is whole already")
    check_single_user(obj.data)
    for problem in hull_state.refresh(obj, scene).ship.check.problems:
        if problem.remedy == "CENTRE":
            raise ValueError(f"{problem.message}. Put on Centre Plane does that")
    with editing(obj.data) as bm:
        _put_on_centre_plane(bm)
        astray = sum(vertex.co.y < 0.0 for vertex in bm.verts if vertex.link_faces)
        if astray:
            raise ValueError(
                f"{counted(astray, 'point')} of the half hull to starboard (y < 0): move to port"
            )
        numbers = _numbers_of_other_side(obj)
        image = _add_other_side(bm, numbers)
    ties.mirror(obj.data, image)
    for number, (other, plane) in numbers.items():
        if other != number:
            flats.store_plane(obj, other, plane)
    obj.hull.half = False
    hull_state.follow_edit(obj, scene)


def to_half(obj, scene, side="PORT", cut=False):
    """Leaves one of SIDES of a whole hull, turned to port; returns a HalfMade.

    cut: whether faces that reach across the centre plane are cut there, which changes the surface;
    else ValueError for such. What belongs to the other side goes whole, for what a cut would leave
    of it are slivers.
    """
    if obj.hull.half:
        raise ValueError("The hull is a half already")
    check_single_user(obj.data)
    with editing(obj.data) as bm:
        # Before any vertex is held.
        edge_layer, _ = blender_versions.ensure_crease_layers(bm)
        _put_on_centre_plane(bm)
        going = _parts_of_other_side(bm, SIDES[side])
        _cut_at_centre_plane(bm, cut, going)
        made = _leave(bm, SIDES[side], going, edge_layer)
    if side == "STARBOARD":
        _mirror_planes(obj)
    flats.clear_unused(obj)
    obj.hull.half = True
    hull_state.follow_edit(obj, scene)
    return made


def to_port(obj, scene):
    """Mirrors a half hull that lies to starboard. ValueError for any other."""
    check_single_user(obj.data)
    shell = hull_mesh.read(obj).control(1.0)
    if not (obj.hull.half and lies_to_starboard(shell.points[:, 1])):
        raise ValueError("The hull is no half that lies to starboard (y < 0)")
    with editing(obj.data) as bm:
        for vertex in bm.verts:
            vertex.co.y = -vertex.co.y
        kept_points.mirror(bm, bm.verts)
        bmesh.ops.reverse_faces(bm, faces=bm.faces)
    _mirror_planes(obj)
    hull_state.follow_edit(obj, scene)


def put_centre_line_on_plane(obj, scene):
    """Puts the points of a half hull's centre line that are beside the centre plane, but were
    probably meant to be on it, there; returns how many. ValueError when it has no surface."""
    state = hull_state.up_to_date(obj, scene)
    indices = state.ship.source.control.vertex_ids[state.ship.surface.mesh.near_centre_line]
    points = mesh_points.read(obj.data)[indices]
    points[:, 1] = 0.0
    mesh_points.write(obj.data, indices, points)
    hull_state.follow_edit(obj, scene, is_by_hand=False)
    return len(indices)


def _put_on_centre_plane(bm):
    """Points that are as good as there."""
    places = np.array([vertex.co for vertex in bm.verts]).reshape(-1, 3)
    bm.verts.ensure_lookup_table()
    for index in np.flatnonzero(mesh_check.on_centre_plane(places)).tolist():
        bm.verts[index].co.y = 0.0


def _numbers_of_other_side(obj):
    """{number of a flat region: (that of its mirror image, its plane)}; a plane that is its own
    mirror image keeps the number."""
    found, following = {}, flats.new_number(obj)
    for region in flats.regions(obj):
        other = region.number
        if region.plane[1] != 0.0:
            other, following = following, following + 1
        found[region.number] = (other, _image(region.plane))
    return found


def _image(plane):
    return planes.stored(plane * [1.0, -1.0, 1.0, 1.0])


def _add_other_side(bm, numbers):
    """Returns {index of a vertex: that of its mirror image}."""
    edge_layer, _ = blender_versions.ensure_crease_layers(bm)
    faces = [face for face in bm.faces if not _is_on_centre_plane(face)]
    edges = {edge for face in faces for edge in face.edges}
    vertices = {vertex for face in faces for vertex in face.verts}
    keel = [tuple(edge.verts) for edge in edges if _is_on_centre_plane(edge)]
    shared = [vertex for vertex in vertices if vertex.co.y == 0.0]
    made = bmesh.ops.duplicate(bm, geom=[*vertices, *edges, *faces])
    new_faces = [part for part in made["geom"] if isinstance(part, bmesh.types.BMFace)]
    new_vertices = [part for part in made["geom"] if isinstance(part, bmesh.types.BMVert)]
    for vertex in new_vertices:
        vertex.co.y = -vertex.co.y
    kept_points.mirror(bm, new_vertices)
    layer = bm.faces.layers.int.get(flat_marks.ATTRIBUTE)
    if layer is not None:
        for face in new_faces:
            if face[layer] in numbers:
                face[layer] = numbers[face[layer]][0]
    bmesh.ops.reverse_faces(bm, faces=new_faces)
    image = made["vert_map"]
    bmesh.ops.weld_verts(bm, targetmap={image[vertex]: vertex for vertex in shared})
    for pair in keel:
        bm.edges.get(pair)[edge_layer] = 1.0
    bm.verts.index_update()
    on_plane = set(shared)
    return {v.index: v.index if v in on_plane else image[v].index for v in vertices}


def _parts_of_other_side(bm, sign):
    """The vertices of the connected parts of a mesh that belong to the other side than `sign`."""
    found, seen = set(), set()
    for vertex in bm.verts:
        if vertex in seen:
            continue
        part = _connected(vertex)
        seen |= part
        reaches = [sign * one.co.y for one in part]
        if min(reaches) < 0.0 and max(reaches) < -_ACROSS_A_LITTLE * min(reaches):
            found |= part
    return found


def _connected(vertex):
    part, left = {vertex}, [vertex]
    while left:
        at = left.pop()
        others = {edge.other_vert(at) for edge in at.link_edges} - part
        part |= others
        left += others
    return part


def _cut_at_centre_plane(bm, cut, going):
    across = [
        face
        for face in bm.faces
        if face.verts[0] not in going
        and min(vertex.co.y for vertex in face.verts)
        < 0.0
        < max(vertex.co.y for vertex in face.verts)
    ]
    if across and not cut:
        raise ValueError(
            f"{len(across)} faces reach across the centre plane: have them cut, or give them an "
            "edge there first"
        )
    if across:
        parts = {part for face in across for part in (face, *face.edges, *face.verts)}
        bmesh.ops.bisect_plane(
            bm, geom=list(parts), plane_co=(0.0, 0.0, 0.0), plane_no=(0.0, 1.0, 0.0)
        )
        _put_on_centre_plane(bm)


def _leave(bm, sign, going, edge_layer):
    """Removes the other side and turns this one to port; returns a HalfMade."""
    others = [vertex for vertex in bm.verts if sign * vertex.co.y < 0.0 or vertex in going]
    overlap = max((sign * vertex.co.y for vertex in going), default=0.0)
    if all(vertex.co.y == 0.0 for vertex in set(bm.verts).difference(others)):
        raise ValueError("There is nothing on that side: choose the other")
    difference = _furthest_from_image(bm, others)
    keel = [edge for edge in bm.edges if len(edge.link_faces) > 1 and _is_on_centre_plane(edge)]
    bmesh.ops.delete(bm, geom=others, context="VERTS")
    if sign < 0.0:
        for vertex in bm.verts:
            vertex.co.y = -vertex.co.y
        kept_points.mirror(bm, bm.verts)
        bmesh.ops.reverse_faces(bm, faces=bm.faces)
    borders = [edge for edge in keel if edge.is_boundary]
    smooth_edges = sum(edge[edge_layer] < 1.0 for edge in borders)
    for edge in borders:
        edge[edge_layer] = 0.0  # a border is a crease by itself
    return HalfMade(difference, smooth_edges, max(overlap, 0.0))


def _is_on_centre_plane(part):
    return all(vertex.co.y == 0.0 for vertex in part.verts)


def _furthest_from_image(bm, vertices):
    """How far the mirror image of any of these vertices is from the nearest other one at most."""
    others = list(set(bm.verts).difference(vertices))
    tree = kdtree.KDTree(len(others))
    for index, vertex in enumerate(others):
        tree.insert(vertex.co, index)
    tree.balance()
    places = (vertex.co for vertex in vertices)
    return max((tree.find((x, -y, z))[2] for x, y, z in places), default=0.0)


def _mirror_planes(obj):
    for region in flats.regions(obj):
        flats.store_plane(obj, region.number, _image(region.plane))
