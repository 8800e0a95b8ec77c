# SPDX-License-Identifier: GPL-3.0-or-later
"""The control points that are kept in their station, waterline or buttock: of each the axes along
which it may not move, and where it is kept on these.

Both are attributes of the mesh's points, so that they survive saving, undo, copying and joining:
the places, and for each axis a check, a whole number that goes with the place. Blender makes means
of both where it divides edges; a mean counts only where all that it was made of are kept in the
same plane: a new point between two points of a station is kept there, any other new one is free.
"""

from dataclasses import dataclass

import bmesh
import numpy as np

from ...bridge.mesh import mesh_points, own_attributes

ATTRIBUTE, PLACE_ATTRIBUTE = "hull_kept", "hull_kept_at"

# The planes that a point can be kept in, by the axis that they are across.
PLANES = {"STATION": 0, "BUTTOCK": 1, "WATERLINE": 2}

_LARGEST_CHECK = 2**22  # single precision has a bit to spare for means of equal ones
_NO_AXIS = (False, False, False)
_KIND = "FLOAT_VECTOR", "POINT"  # of the attributes


@dataclass(frozen=True, eq=False)
class KeptPoints:
    """indices (k,) of points of the mesh, rising; is_kept (k, 3): along which axes; places (k, 3)
    float32 in Blender's units, 0 along the others."""

    indices: np.ndarray
    is_kept: np.ndarray
    places: np.ndarray

    def __len__(self):
        return len(self.indices)

    def planes(self):
        """{index: [planes (4,) that the point is kept in]}, as constraints.planes has them."""
        found = {}
        for index, axes, place in zip(self.indices.tolist(), self.is_kept, self.places.tolist()):
            found[index] = [np.append(np.eye(3)[c], place[c]) for c in np.flatnonzero(axes)]
        return found

    def along(self, axis):
        """(m,) indices of the points that are kept along an axis."""
        return self.indices[self.is_kept[:, axis]]


def read(mesh):
    """The KeptPoints of a Blender mesh, in edit mode or not."""
    indices, checks, places = _read_edited(mesh) if mesh.is_editmode else _read_stored(mesh)
    if not len(indices):  # as of nearly all hulls, at each step of the mouse
        return KeptPoints(indices, np.zeros((0, 3), dtype=bool), places)
    places = places + np.float32(0.0)  # no -0
    is_kept = (checks != 0.0) & (np.rint(checks) == _checks(places))
    is_any = is_kept.any(axis=1)
    return KeptPoints(indices[is_any], is_kept[is_any], np.where(is_kept, places, 0.0)[is_any])


def _checks(places):
    """(k, 3) whole numbers from 1 on, of places (k, 3) float32."""
    mixed = np.ascontiguousarray(places).view(np.uint32) * np.uint64(0x9E3779B97F4A7C15)
    mixed = (mixed ^ mixed >> np.uint64(29)) * np.uint64(0xBF58476D1CE4E5B9)
    return (1 + (mixed >> np.uint64(40)) % np.uint64(_LARGEST_CHECK)).astype(np.float32)


def _vectors(count=0):
    return np.zeros((count, 3), dtype=np.float32)


_NONE = np.empty(0, dtype=np.int64), _vectors(), _vectors()


def _read_edited(mesh):
    """(indices, checks, places) of points that have checks."""
    bm = bmesh.from_edit_mesh(mesh)
    checks, places = _layers(bm)
    if checks is None or places is None:
        return _NONE
    found = [(i, *v[checks], *v[places]) for i, v in enumerate(bm.verts) if any(v[checks])]
    if not found:
        return _NONE
    table = np.array(found)
    indices, vectors = table[:, 0].astype(np.int64), table[:, 1:].astype(np.float32)
    return indices, vectors[:, :3], vectors[:, 3:]


def _layers(bm):
    layers = bm.verts.layers.float_vector
    return layers.get(ATTRIBUTE), layers.get(PLACE_ATTRIBUTE)


def _read_stored(mesh):
    found = [own_attributes.found(mesh, name, *_KIND) for name in (ATTRIBUTE, PLACE_ATTRIBUTE)]
    if None in found:
        return _NONE
    checks, places = (_values(mesh, attribute) for attribute in found)
    indices = np.flatnonzero(checks.any(axis=1))
    return indices, checks[indices], places[indices]


def _values(mesh, attribute):
    values = _vectors(len(mesh.vertices))
    attribute.data.foreach_get("vector", values.reshape(-1))
    return values


def write(mesh, indices, is_kept, places):
    """Keeps points (k,) of a Blender mesh along axes (k, 3) at places (k, 3), in edit mode or not;
    those kept along no axis are free. In edit mode every BMVert that the caller holds may become
    invalid."""
    indices = np.asarray(indices, dtype=np.int64).reshape(-1)
    checks, places = _stored(is_kept, places)
    if mesh.is_editmode:
        _write_edited(mesh, indices, checks, places)
    else:
        for name, values in ((ATTRIBUTE, checks), (PLACE_ATTRIBUTE, places)):
            _write_stored(mesh, name, indices, values)
        mesh.update_tag()


def _stored(is_kept, places):
    """(checks, places), both (k, 3), as the attributes have them."""
    places = np.asarray(places, dtype=np.float32).reshape(-1, 3)
    places = np.where(is_kept, places, np.float32(0.0)) + np.float32(0.0)
    return np.where(is_kept, _checks(places), np.float32(0.0)), places


def _write_edited(mesh, indices, checks, places):
    bm = bmesh.from_edit_mesh(mesh)
    for name in (ATTRIBUTE, PLACE_ATTRIBUTE):
        if bm.verts.layers.float_vector.get(name) is None:
            bm.verts.layers.float_vector.new(name)
    of_checks, of_places = _layers(bm)
    bm.verts.ensure_lookup_table()
    for index, check, place in zip(indices.tolist(), checks.tolist(), places.tolist()):
        bm.verts[index][of_checks], bm.verts[index][of_places] = check, place
    bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)


def _write_stored(mesh, name, indices, values):
    attribute = own_attributes.made(mesh, name, *_KIND)
    stored = _values(mesh, attribute)
    stored[indices] = values
    attribute.data.foreach_set("vector", stored.reshape(-1))


def set_axes(mesh, indices, axes, is_kept):
    """Keeps points (k,) of a Blender mesh along axes where they are now, or frees them along these;
    returns how many were otherwise before. Other axes stay as they are."""
    indices = np.unique(np.asarray(indices, dtype=np.int64))
    present = read(mesh)
    before, places = np.zeros((len(indices), 3), dtype=bool), mesh_points.read(mesh, indices)
    is_known = np.isin(indices, present.indices)
    at = np.searchsorted(present.indices, indices[is_known])
    before[is_known] = present.is_kept[at]
    places[is_known] = np.where(present.is_kept[at], present.places[at], places[is_known])
    after = before.copy()
    after[:, list(axes)] = is_kept
    changed = (after != before).any(axis=1)
    if changed.any():
        write(mesh, indices[changed], after[changed], places[changed])
    return int(changed.sum())


def set_selected(obj, axes, is_kept):
    """set_axes for the points that are selected in edit mode. ValueError when none is."""
    indices = mesh_points.selected(obj.data)
    if not len(indices):
        raise ValueError("Select the points first")
    return set_axes(obj.data, indices, axes, is_kept)


def free(mesh, indices):
    """Points (k,) of a Blender mesh are kept along no axis any longer."""
    write(mesh, indices, _NO_AXIS, _vectors(len(indices)))


def mirror(bm, vertices):
    """Takes along the places of vertices of a BMesh that were mirrored on the centre plane."""
    of_checks, of_places = _layers(bm)
    if of_checks is None or of_places is None:
        return
    for vertex in vertices:
        check, place = vertex[of_checks].copy(), vertex[of_places].copy()
        here = np.array([place], dtype=np.float32) + np.float32(0.0)
        if round(check.y) != _checks(here)[0, 1]:
            continue
        here[0, 1] = -here[0, 1] + np.float32(0.0)
        place.y, check.y = here[0, 1], _checks(here)[0, 1]
        vertex[of_checks], vertex[of_places] = check, place
