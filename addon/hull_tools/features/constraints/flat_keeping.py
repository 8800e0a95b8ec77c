# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeping flat what is to be flat, while its points are moved.

`keep` is called before a hull's mesh is read. Points that left the plane of their region go back to
the nearest place in it, those of two regions to the nearest in both, and so do all of a region
whose plane was set to another one. A region that moved as a whole and is plane still takes its
plane along. A change of the mesh's faces moves no point: faces that lie elsewhere then, as those
that were extruded from a region, are not of the region any longer.
"""

import numpy as np

from ...bridge.mesh import mesh_points
from ...bridge.objects import hull_objects
from . import flat_marks, flats, planes

# So many meshes a hull's faces are remembered of, so that undo does not count as a change of them.
_MOST_KNOWN = 256


class Memory:
    """What `keep` has seen of one hull: the keys of the FlatFaces whose tags were looked through,
    and where the points and the planes were last."""

    def __init__(self):
        self.known = {}
        self.last_key = None
        self.last_points = None
        self.last_planes = None

    def learn(self, key):
        self.known[key] = None
        while len(self.known) > _MOST_KNOWN:
            del self.known[next(iter(self.known))]


def keep(obj, memory):
    """Brings the points of a hull's flat regions back into their planes; returns whether any point
    was moved. The Memory is for this hull alone."""
    flat = flat_marks.read(obj.data)
    if flat is None or hull_objects.locked(obj):
        return False
    key = flat.key()
    entries = flats.plane_entries(obj)
    is_known = key in memory.known or not memory.known
    if key not in memory.known or not entries.keys() >= set(flat.regions.tolist()):
        _look_through(obj, flat, entries, is_known)
        flat = flat_marks.read(obj.data)
        if flat is None:
            return False
        memory.learn(key)
        key = flat.key()
        memory.learn(key)
        entries = flats.plane_entries(obj)
    indices = np.unique(flat.vertices)
    points = mesh_points.read(obj.data, indices)
    has_moved = None
    if key == memory.last_key:
        has_moved = (points != memory.last_points).any(axis=1)
    is_due = has_moved is None or has_moved.any() or _values_of(entries) != memory.last_planes
    is_changed = is_due and _restore(obj, flat, entries, indices, points, has_moved)
    memory.last_key, memory.last_points = key, points
    memory.last_planes = _values_of(entries)
    return is_changed


def _values_of(entries):
    """Equal where the planes of entries by number are the same."""
    return {number: (*entry.normal, entry.offset) for number, entry in entries.items()}


def _restore(obj, flat, entries, indices, points, has_moved):
    """Lets planes follow and brings points (k, 3) back, in place too; returns whether any was."""
    known = {number: flats.plane_of(entry) for number, entry in entries.items()}
    following = _planes_that_follow(flat, known, indices, points, has_moved)
    while True:
        held = {**known, **following}
        places = _brought_back(flat, held, indices, points)
        # A region that shares points with one that stays behind can't leave it.
        torn = [
            number
            for number, plane in following.items()
            if not _lie_in(places[_own(flat, number, indices)], plane)
        ]
        if not torn:
            break
        for number in torn:
            del following[number]
    for number, plane in following.items():
        flats.store_plane(obj, number, plane)
    changed = np.flatnonzero((places != points).any(axis=1))
    if len(changed):
        points[changed] = places[changed]
        mesh_points.write(obj.data, indices[changed], points[changed])
    return bool(len(changed))


def _own(flat, number, indices):
    """Where in the points `indices` those of a region are."""
    return np.searchsorted(indices, flat.of_region(number)[1])


def _lie_in(points, plane):
    return np.abs(planes.heights(points, plane)).max() <= planes.tolerance(points)


def _look_through(obj, flat, entries, is_known):
    """Numbers of regions that nobody knows get a plane, and faces out of their plane lose theirs.

    is_known: the faces are as once before, or the hull was not seen before, so that it is points
    that may have moved, which are not judged by.
    """
    places = mesh_points.read(obj.data)
    for number in np.unique(flat.regions).tolist():
        faces, points = flat.of_region(number)
        plane = common_plane(places[points])
        entry = entries.get(number)
        if entry is None:
            if plane is None:
                flats.release(obj, faces)
            else:
                flats.store_plane(obj, number, plane)
            continue
        if is_known:
            continue
        astray = _astray(flat, number, places, flats.plane_of(entry))
        if len(astray) < len(faces):
            if len(astray):
                flats.release(obj, astray)
        elif plane is not None:
            flats.store_plane(obj, number, plane)
        else:
            flats.release(obj, faces)


def _astray(flat, number, places, plane):
    """The faces of a region that are not in its plane, or have no area, as just extruded."""
    found = []
    starts = np.cumsum(flat.sizes) - flat.sizes
    for index in np.flatnonzero(flat.regions == number).tolist():
        corners = places[flat.vertices[starts[index] : starts[index] + flat.sizes[index]]]
        allowed = planes.tolerance(corners)
        spokes = corners - corners[0]
        area = np.linalg.norm(np.cross(spokes[1:-1], spokes[2:]).sum(axis=0))
        is_off = np.abs(planes.heights(corners, plane)).max() > allowed
        if is_off or area <= allowed * np.abs(spokes).max():
            found.append(flat.faces[index])
    return np.array(found, dtype=np.int64)


def common_plane(points):
    """The plane that all the points lie in, None when they do in none or in many."""
    try:
        plane = planes.stored(planes.fit(points, "BEST"))
    except ValueError:
        return None
    heights = planes.heights(points, plane)
    plane[3] += np.median(heights)
    is_plane = np.abs(planes.heights(points, plane)).max() <= planes.tolerance(points)
    return planes.stored(plane) if is_plane else None


def _planes_that_follow(flat, known, indices, points, has_moved):
    """{number: plane} of the regions that moved as a whole and are plane still.

    known: the planes by number. has_moved (k,): which of the points moved since the last time; None
    when nobody knows.
    """
    following = {}
    for number in np.unique(flat.regions).tolist():
        if number not in known:
            continue
        own, plane = _own(flat, number, indices), known[number].copy()
        places = points[own]
        if _lie_in(places, plane) or (has_moved is not None and not has_moved[own].any()):
            continue  # it is the plane that is another, if they do not
        heights = planes.heights(places, plane)
        if np.ptp(heights) <= planes.tolerance(places):
            plane[3] += np.median(heights)
            following[number] = planes.stored(plane)
        elif has_moved is None or np.count_nonzero(has_moved[own]) > len(own) / 2:
            # Turned, unless a few points were pulled out of it by as much.
            turned = common_plane(places)
            if turned is not None:
                following[number] = turned
    return following


def _brought_back(flat, held, indices, points):
    """(k, 3) the points, those that are out of the planes by number that they are held in moved
    there, as Blender keeps them."""
    places = points.copy()
    of_points = flats.planes_of_points(flat, held)
    for place, index in enumerate(indices.tolist()):
        own = of_points.get(index, ())
        if own and not planes.lies_in(points[place], own):
            places[place] = planes.into_planes(points[place], own).astype(np.float32)
    return places
