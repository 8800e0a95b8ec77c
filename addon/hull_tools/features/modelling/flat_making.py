# SPDX-License-Identifier: GPL-3.0-or-later
"""The faces that are selected in edit mode are made flat: side, bottom, transom or any plane."""

from dataclasses import dataclass
from math import acos, degrees

import bmesh
import numpy as np

from ...bridge import native
from ...bridge.blender import blender_versions, units
from ...bridge.mesh import mesh_points
from ..constraints import flats, planes
from ..hull import hull_state
from ..lines import lines

# Where a plane lies, its direction being known.
PLACES = ("MOST", "OUTERMOST", "ACTIVE", "POSITION")

_AXES = {"SIDE": 1, "BOTTOM": 2, "TRANSOM": 0}


@dataclass(frozen=True)
class FlatMade:
    """is_flat: whether the surface of all the faces is flat now, to their rim. position: of a plane
    across an axis, in Blender's units; None for others."""

    message: str
    is_flat: bool
    position: object


def make_flat(obj, scene, kind, place="MOST", position=0.0, keep=True, crease_rim=False):
    """Brings the points of the selected faces into one plane; returns what came of it.

    kind: one of planes.KINDS. place: one of PLACES: where most of the points are, where the
    outermost is, through the point selected last, or (planes across an axis) at a position in
    Blender's units. keep: whether they are kept there. crease_rim: whether the edges around the
    faces become knuckles, so that the surface is flat up to them. ValueError without faces, when a
    plane can't be had of them, or one that is kept elsewhere is in the way.
    """
    faces, points = _selected(obj.data)
    places = mesh_points.read(obj.data, points)
    plane = planes.stored(_plane(obj, places, kind, place, position))
    if keep:
        flats.mark(obj, faces, plane)
    else:
        flats.release(obj, faces)
        there = [planes.into_planes(point, plane[None]) for point in places]
        mesh_points.write(obj.data, points, np.array(there))
    if crease_rim:
        _crease_rim(obj.data, faces)
    moved = np.linalg.norm(mesh_points.read(obj.data, points) - places, axis=1)
    return _outcome(obj, scene, faces, plane, moved)


def selected_faces(mesh):
    """(k,) the selected faces of a mesh in edit mode. ValueError without any."""
    return _selected(mesh)[0]


def _selected(mesh):
    """(faces, their points) that are selected, by index."""
    bm = bmesh.from_edit_mesh(mesh)
    bm.verts.index_update()
    chosen = [(i, face) for i, face in enumerate(bm.faces) if face.select and not face.hide]
    if not chosen:
        raise ValueError("Select the faces first")
    points = sorted({vertex.index for _, face in chosen for vertex in face.verts})
    return np.array([index for index, _ in chosen]), np.array(points)


def _plane(obj, points, kind, place, position):
    if place == "POSITION":
        if kind not in _AXES:
            raise ValueError("A position is for planes across an axis: choose another place")
        return planes.across_axis(_AXES[kind], position)
    plane = planes.fit(points, kind)
    if place == "OUTERMOST":
        everything = mesh_points.read(obj.data)
        middle = 0.5 * (everything.min(axis=0) + everything.max(axis=0))
        if obj.hull.half:
            middle[1] = 0.0
        heights = planes.heights(points, planes.through(plane, middle))
        return planes.through(plane, points[np.argmax(np.abs(heights))])
    if place == "ACTIVE":
        active = mesh_points.active(obj.data)
        if active is None:
            raise ValueError("No point was selected last: select points, not faces, that one last")
        return planes.through(plane, mesh_points.read(obj.data, [active])[0])
    return plane


def _crease_rim(mesh, faces):
    """Makes the edges around faces creases; borders are such anyway."""
    bm = bmesh.from_edit_mesh(mesh)
    edge_layer, _ = blender_versions.ensure_crease_layers(bm)
    bm.faces.ensure_lookup_table()
    inside = {bm.faces[index] for index in faces.tolist()}
    for face in inside:
        for edge in face.edges:
            if len(edge.link_faces) > 1 and not inside.issuperset(edge.link_faces):
                edge[edge_layer] = 1.0
    bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)


def _position_of(plane):
    kind = planes.kind_of(plane)
    return float(plane[3] * plane[_AXES[kind]]) if kind in _AXES else None


def describe(scene, plane):
    """A plane as short text: the axis it is across and where, or its angle to the base line."""
    position = _position_of(plane)
    if position is not None:
        axis = "xyz"[_AXES[planes.kind_of(plane)]]
        metres = position * units.metres_per_unit(scene)
        return f"{axis} = {units.format_value(scene, metres, 'm')}"
    return f"slope {degrees(acos(min(abs(plane[2]), 1.0))):.1f}°"


def _outcome(obj, scene, faces, plane, moved):
    text = f"{np.count_nonzero(moved)} of {len(moved)} points moved into the plane "
    text += describe(scene, plane)
    if moved.any():
        furthest = moved.max() * units.metres_per_unit(scene)
        text += f", by up to {units.format_value(scene, furthest, 'm')}"
    bend = _bend(hull_state.follow_edit(obj, scene), faces)
    if bend:
        bend_text = units.format_value(scene, bend, "m")
        text += f". Near the rim the surface bends by up to {bend_text}"
    return FlatMade(text, not bend, _position_of(plane))


def _bend(state, faces):
    """How far, in m, the surface of faces is from flat; 0 where it is, or nothing to be said."""
    if state.status:
        return 0.0
    own = np.flatnonzero(np.isin(state.ship.source.control.face_ids, faces))
    if not len(own):
        return 0.0
    allowed = lines.flat_tolerance(state.ship.surface)
    try:
        found = native.require().flatness(state.ship.surface, faces=own, tolerance=allowed)
    except ValueError:  # the faces were pressed into a line
        return 0.0
    return found.surface_distance if found.surface_distance > allowed else 0.0


def select_regions(obj):
    """Selects, in edit mode, all faces of the regions that selected faces are of, or without any
    of all regions; returns how many regions."""
    bm = bmesh.from_edit_mesh(obj.data)
    chosen = {index for index, face in enumerate(bm.faces) if face.select}
    found = flats.regions(obj)
    touched = [region for region in found if chosen.intersection(region.faces.tolist())] or found
    wanted = {face for region in touched for face in region.faces.tolist()}
    for sequence in (bm.faces, bm.edges, bm.verts):
        for element in sequence:
            element.select_set(False)
    for index, face in enumerate(bm.faces):
        if index in wanted and not face.hide:
            face.select_set(True)
    bm.select_flush_mode()
    bmesh.update_edit_mesh(obj.data, loop_triangles=False, destructive=False)
    return len(touched)


def faces_at_selection(mesh):
    """(k,) the selected faces, or where there are none those of the selected points."""
    bm = bmesh.from_edit_mesh(mesh)
    bm.faces.index_update()
    faces = {face.index for face in bm.faces if face.select and not face.hide}
    if not faces:
        points = [vertex for vertex in bm.verts if vertex.select and not vertex.hide]
        faces = {face.index for vertex in points for face in vertex.link_faces}
    if not faces:
        raise ValueError("Select the faces or points to release first")
    return np.array(sorted(faces), dtype=np.int64)


def release_selected(obj):
    """Faces that are selected, or else those at selected points, are not kept flat any longer;
    returns how many were."""
    own = selected_of(obj, flats.regions(obj))
    if not len(own):
        raise ValueError("None of the selected faces is kept flat")
    flats.release(obj, own)
    return len(own)


def selected_of(obj, regions):
    """The faces of regions that are selected, or else that are at selected points."""
    kept = np.concatenate([region.faces for region in regions] or [[]])
    return np.intersect1d(faces_at_selection(obj.data), kept).astype(np.int64)
