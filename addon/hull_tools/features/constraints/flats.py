# SPDX-License-Identifier: GPL-3.0-or-later
"""Regions of faces that are kept flat: flat side, flat bottom, transom, or any plane.

A region is a number that its faces have in the mesh (flat_marks), and its plane is in
Object.hull.flats. What keeps its points in the plane is flat_keeping. All is in the mesh's axes and
Blender's units; planes are (nx, ny, nz, d) as in `planes`: n · p = d, n of length 1.
"""

from dataclasses import dataclass

import numpy as np

from ...bridge.counts import counted_are
from ...bridge.mesh import mesh_points
from . import flat_marks, planes, region_entries

# Of a mesh's points, in metres or other units, from its origin.
_FARTHEST = 1e9


@dataclass(frozen=True, eq=False)
class Region:
    """faces (f,) and points (k,), each once, by their indices in the mesh; plane (4,)."""

    number: int
    faces: np.ndarray
    points: np.ndarray
    plane: np.ndarray

    @property
    def kind(self):
        """One of planes.KINDS."""
        return planes.kind_of(self.plane)


def regions(obj):
    """The Regions of a hull that its mesh has faces of."""
    flat = flat_marks.read(obj.data)
    if flat is None:
        return []
    entries = plane_entries(obj)
    return [
        Region(number, *flat.of_region(number), plane_of(entries[number]))
        for number in np.unique(flat.regions).tolist()
        if number in entries
    ]


def flat_planes(obj):
    """[(indices (k,) of points of the mesh, (nx, ny, nz, d))], one pair for each region of a hull
    that is kept flat. A point may be in several."""
    return [(region.points, tuple(region.plane.tolist())) for region in regions(obj)]


def mark(obj, faces, plane):
    """Makes faces (f,), by their indices in the mesh, a region of its own that is kept in a plane,
    and brings their points there; returns its number. Faces leave the region that they were of, and
    regions that they touch in the same plane become part of this one.

    Points of other regions stay in those planes too. ValueError without faces, or when a point
    would have to lie in two parallel planes: nothing is changed then.
    """
    faces = np.unique(np.asarray(faces, dtype=np.int64))
    if not len(faces):
        raise ValueError("Select the faces that should be flat")
    plane = planes.stored(plane)
    number = new_number(obj)
    before = flat_marks.read(obj.data)
    flat_marks.write(obj.data, faces, number)
    flat = flat_marks.read(obj.data)
    _, points = flat.of_region(number)
    of_points = planes_of_points(flat, {**_planes(obj), number: plane})
    here = mesh_points.read(obj.data, points)
    there = np.array([planes.into_planes(p, of_points[i]) for i, p in zip(points.tolist(), here)])
    apart = sum(
        np.abs(planes.heights(there, other)[i]) > planes.tolerance(there)
        for i, index in enumerate(points.tolist())
        for other in of_points[index]
    )
    if apart:
        _write_numbers(obj.data, faces, before)
        raise ValueError(
            f"{counted_are(apart, 'point')} kept in another plane that does not meet this one: "
            "release the other region first, or choose the same plane"
        )
    mesh_points.write(obj.data, points, there)
    store_plane(obj, number, plane)
    _join_touching(obj, number, plane)
    clear_unused(obj)
    return number


def _join_touching(obj, number, plane):
    """Makes regions in the same plane that share points with a region part of it, and so on."""
    others = [r for r in regions(obj) if r.number != number and np.array_equal(r.plane, plane)]
    points = set(flat_marks.read(obj.data).of_region(number)[1].tolist())
    while touching := [region for region in others if points.intersection(region.points.tolist())]:
        for region in touching:
            flat_marks.write(obj.data, region.faces, number)
            points.update(region.points.tolist())
            others.remove(region)


def _write_numbers(mesh, faces, flat):
    """Gives faces the numbers of an earlier FlatFaces back."""
    known = {} if flat is None else dict(zip(flat.faces.tolist(), flat.regions.tolist()))
    flat_marks.write(mesh, faces, [known.get(face, 0) for face in faces.tolist()])


def release(obj, faces):
    """These faces are not kept flat any longer."""
    flat_marks.write(obj.data, faces, 0)


def new_number(obj):
    """A number that no region has, here, in another hull or in a variant of one, so that hulls can
    be joined."""
    return region_entries.new_number("flats", _numbers(obj))


def _numbers(obj):
    flat = flat_marks.read(obj.data)
    return set() if flat is None else set(flat.regions.tolist())


def plane_entries(obj):
    """The entries of Object.hull.flats by the number of the region. Those that scripts or files
    have given no plane, or one that no point of a mesh reaches, are as if they were not there."""
    return {entry.region: entry for entry in obj.hull.flats if _tells_plane(entry)}


def _tells_plane(entry):
    numbers = (*entry.normal, entry.offset)
    return bool(np.isfinite(numbers).all() and any(entry.normal)) and abs(entry.offset) <= _FARTHEST


def plane_of(entry):
    """The plane (4,) of an entry."""
    normal = np.array(entry.normal, dtype=np.float64)
    return np.append(normal / np.linalg.norm(normal), entry.offset)


def _planes(obj):
    return {number: plane_of(entry) for number, entry in plane_entries(obj).items()}


def store_plane(obj, number, plane):
    """Keeps the plane of a region; no change where it is the same."""
    plane = planes.stored(plane)
    entry = plane_entries(obj).get(number)
    if entry is not None and np.array_equal(plane_of(entry), plane):
        return
    if entry is None:
        entry = next((other for other in obj.hull.flats if other.region == number), None)
    if entry is None:
        entry = obj.hull.flats.add()
        entry.region = number
    entry.normal, entry.offset = plane[:3], plane[3]


def clear_unused(obj):
    """Removes the planes of regions that have no face any longer. Undo in edit mode may bring such
    back: flat_keeping finds their planes then."""
    region_entries.keep_only(obj.hull.flats, _numbers(obj))


def planes_of_points(flat, plane_of_region):
    """{point: [planes that it is kept in]}, of the FlatFaces whose region has a plane."""
    found = {}
    for number in np.unique(flat.regions).tolist():
        if number in plane_of_region:
            for point in flat.of_region(number)[1].tolist():
                found.setdefault(point, []).append(plane_of_region[number])
    return found
