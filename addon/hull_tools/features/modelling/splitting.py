# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of a mesh that make no one surface with the rest: split from it, or set aside as a layer
that does not belong to the shell."""

from dataclasses import dataclass

import numpy as np

from ....hull_io import splitting
from ...bridge.mesh import corner_layers, mesh_arrays
from ...bridge.mesh.mesh_editing import editing
from ...bridge.mesh.valid_part import faces_of
from ...bridge.objects import hull_objects
from ..hull import hull_state
from . import layering

SET_ASIDE = "Set aside"


@dataclass(frozen=True)
class Parted:
    """points, edges: how many were split. standing: how many faces stand on others."""

    points: int
    edges: int
    standing: int


def split(obj, scene):
    """Splits the points and edges where faces of the shell join without making one surface; returns
    what was done. ValueError where there is nothing to split."""
    shell = _shell(obj)
    made = splitting.split(*shell)
    if len(made.origins) == len(shell[0]):
        raise ValueError(
            "There is nothing to split: no point joins faces that share no edge, and no edge has "
            "more than two faces"
        )
    standing = sum(map(len, splitting.standing_parts(*shell)))
    with editing(obj.data) as bm:
        _write(bm, made)
    hull_state.follow_edit(obj, scene)
    return Parted(len(made.points), len(made.edges), standing)


def set_aside(obj, scene, faces=None):
    """Puts faces, by default all that stand on others as a bulkhead on the shell, into a layer that
    does not belong to the shell; returns how many. ValueError without any."""
    if faces is None:
        faces = sum(splitting.standing_parts(*_shell(obj)), [])
        if not faces:
            raise ValueError(
                "No face stands on others: select the faces of the part in edit mode first"
            )
    if len(faces) >= len(mesh_arrays.read_mesh(obj.data).face_sizes):
        raise ValueError("These are all faces: select those of the part only")
    slot = _slot_aside(obj)
    with editing(obj.data) as bm:
        bm.faces.ensure_lookup_table()
        for index in faces:
            bm.faces[index].material_index = slot
    hull_state.follow_edit(obj, scene)
    return len(faces)


def _shell(obj):
    """(points, faces, layers, indices of the shell's faces) as hull_io.splitting takes them."""
    data = mesh_arrays.read_mesh(obj.data)
    excluded = np.array(sorted(hull_objects.excluded_slots(obj)), dtype=np.int32)
    shell = np.flatnonzero(~np.isin(data.face_slots, excluded)).tolist()
    faces = faces_of(data.face_sizes, data.face_vertices)
    return data.points.astype(np.float64), faces, data.face_slots.tolist(), shell


def _write(bm, made):
    """Makes a BMesh that of a hull_io.splitting.Split; attributes and tags are those of before."""
    bm.verts.ensure_lookup_table()
    bm.faces.ensure_lookup_table()
    count = len(bm.verts)
    vertices = list(bm.verts)
    for origin in made.origins[count:]:
        vertices.append(bm.verts.new(vertices[origin].co, vertices[origin]))
    replaced = [(face, new) for face, new in zip(list(bm.faces), made.faces) if max(new) >= count]
    layers = corner_layers.of(bm)
    for face, new in replaced:
        _replace(bm, face, [vertices[index] for index in new], layers)
    edges = {edge for face, _ in replaced for edge in face.edges}
    for face, _ in replaced:
        bm.faces.remove(face)
    for edge in edges:
        if not edge.link_faces:
            bm.edges.remove(edge)
    bm.verts.index_update()
    bm.normal_update()


def _replace(bm, face, corners, layers):
    """A copy of a face between other points at the same places."""
    old = list(face.loops)
    for loop, (a, b) in zip(old, zip(corners, corners[1:] + corners[:1])):
        if bm.edges.get((a, b)) is None:
            bm.edges.new((a, b), loop.edge)
    copy = bm.faces.new(corners, face)
    for loop, source in zip(copy.loops, old):
        corner_layers.copy(layers, source, loop)
    copy.select, copy.hide = face.select, face.hide


def _slot_aside(obj):
    """The material slot of the layer for what is set aside; made where there is none."""
    layers = obj.hull.layers
    for layer in layers:
        if not layer.in_hydrostatics and layer.name == SET_ASIDE:
            for index, slot in enumerate(obj.material_slots):
                if slot.material is not None and slot.material == layer.material:
                    return index
    return layering.add_layer(obj, SET_ASIDE, in_hydrostatics=False)
