# SPDX-License-Identifier: GPL-3.0-or-later
"""The tags of a hull's control mesh, as the surface's rules read them, to be shown and selected."""

import weakref
from dataclasses import dataclass

import numpy as np

from ...bridge import native
from ...bridge.blender import units
from ...bridge.mesh import mesh_arrays
from ...bridge.objects import hull_objects
from ..constraints import flat_marks, kept_points, point_locks, ties
from . import hull_state

EDGE_KINDS = ("knuckle", "border", "deck_edge")
POINT_KINDS = ("corner", "automatic_corner", "dart", "irregular")

# hull_native.ControlMesh.vertex_kinds
_DART, _CORNER = 1, 3

_known = weakref.WeakKeyDictionary()  # by hull_native.LimitSurface: (marks of the deck edge, Tags)


@dataclass(frozen=True, eq=False)
class Tags:
    """Indices are those of control points and control faces; vertex_ids and face_ids are Blender's.

    edges: by kind of EDGE_KINDS, (k, 2); the deck edge is in no other kind. points: by kind of
    POINT_KINDS, (k,); an irregular point may be of another kind too. valences (k,): how many edges
    meet in each irregular point. odd_faces (k,): those that are no quadrilaterals, and
    odd_face_vertices a tuple with the vertices of each.
    """

    vertex_ids: np.ndarray
    face_ids: np.ndarray
    edges: dict
    points: dict
    valences: np.ndarray
    odd_faces: np.ndarray
    odd_face_vertices: tuple

    def blender_edges(self, kinds=EDGE_KINDS):
        """(k, 2) pairs of Blender's vertices."""
        return self.vertex_ids[np.concatenate([self.edges[kind] for kind in kinds])]


def of_state(state):
    """Tags of the last good mesh of a HullState; its points are those of the state's surface."""
    marks = state.ship.source.deck_edge
    known = _known.get(state.ship.surface)
    if known is None or known[0] != marks:
        known = marks, tags_of(state.ship.surface.mesh, state.ship.source.control)
        _known[state.ship.surface] = known
    return known[1]


def of_hull(obj, scene):
    """The same of a hull as it is now. ValueError when its mesh has errors."""
    state = hull_state.up_to_date(obj, scene)
    return of_state(state)


def of_broken(obj, scene):
    """(points in m, Tags) of a mesh that has errors, or is not known yet as it is now: what its
    edges and corners are tagged as."""
    data = mesh_arrays.read_mesh(obj.data)
    excluded = hull_objects.excluded_slots(obj)
    control = mesh_arrays.control_arrays(data, units.metres_per_unit(scene), excluded)
    none = np.empty(0, dtype=np.int32)
    tags = Tags(
        vertex_ids=control.vertex_ids,
        face_ids=control.face_ids,
        edges=_edges(control.creases, mesh_arrays.border_edges(control), control.deck_edge),
        points={kind: control.corners if kind == "corner" else none for kind in POINT_KINDS},
        valences=none,
        **_odd_faces(control),
    )
    return control.points, tags


def flat_faces(obj, tags):
    """Of each region that is kept flat, its faces: arrays of control points of `tags`."""
    if not obj.hull.flats:
        return []
    flat = flat_marks.read(obj.data)
    if flat is None:
        return []
    faces = np.split(_control_points(flat.vertices, tags), np.cumsum(flat.sizes)[:-1])
    known = {entry.region for entry in obj.hull.flats}
    found = {}
    for region, face in zip(flat.regions.tolist(), faces):
        if region in known and face.min() >= 0:
            found.setdefault(region, []).append(face)
    return list(found.values())


def locked_points(obj, tags):
    """(k,) the control points of `tags` that are locked."""
    points = _control_points(point_locks.locked_points(obj.data), tags)
    return points[points >= 0]


def kept_points_of(obj, tags):
    """Of the axes x, y and z, (k,) the control points of `tags` that are kept along them: in their
    stations, buttocks and waterlines."""
    found = kept_points.read(obj.data)
    points = (_control_points(found.along(axis), tags) for axis in range(3))
    return [part[part >= 0] for part in points]


def tied_points_of(obj, tags):
    """(k, 2) of points that are tied the control points of `tags`: the point, one it follows."""
    found = ties.pairs(obj.data)
    pairs = _control_points(found.reshape(-1), tags).reshape(-1, 2)
    return pairs[(pairs >= 0).all(axis=1)]


def _control_points(vertices, tags):
    """Of Blender's vertices, (k,) their control points; -1 for those that the shell has not."""
    if not len(tags.vertex_ids):
        return np.full(len(vertices), -1)
    places = np.searchsorted(tags.vertex_ids, vertices)
    places[places == len(tags.vertex_ids)] = 0
    return np.where(tags.vertex_ids[places] == vertices, places, -1)


def tags_of(mesh, control):
    """The Tags of a hull_native.ControlMesh, made of the ControlArrays `control`."""
    kinds, irregular = mesh.vertex_kinds, mesh.irregular_vertices
    tagged = np.zeros(len(kinds), dtype=bool)
    tagged[control.corners] = True
    return Tags(
        vertex_ids=control.vertex_ids,
        face_ids=control.face_ids,
        edges=_edges(mesh.creases, mesh.border_edges, control.deck_edge),
        points={
            "corner": np.flatnonzero(tagged),
            "automatic_corner": np.flatnonzero((kinds == _CORNER) & ~tagged),
            "dart": np.flatnonzero(kinds == _DART),
            "irregular": irregular,
        },
        valences=_valences(mesh)[irregular],
        **_odd_faces(control),
    )


def chains(surface):
    """The creases and borders of a hull_native.LimitSurface from end to end, each as the set of its
    edges: pairs of control points, the lower one first."""
    for curve in native.require().crease_curves(surface):
        points = curve.vertices.tolist()
        following = points[1:] + (points[:1] if curve.closed else [])
        yield {edge_key(a, b) for a, b in zip(points, following)}


def chains_through(obj, scene, edges):
    """The edges of all whole chains that some of `edges` belong to; pairs of Blender's vertices."""
    state = hull_state.up_to_date(obj, scene)
    ids = state.ship.source.control.vertex_ids.tolist()
    wanted = {edge_key(*edge) for edge in edges}
    through = set()
    for chain in chains(state.ship.surface):
        own = {edge_key(ids[a], ids[b]) for a, b in chain}
        if own & wanted:
            through |= own
    return sorted(through)


def edge_key(a, b):
    return (a, b) if a < b else (b, a)


def _edges(creases, borders, deck_edge):
    """`creases` may hold the borders or not."""
    keys = mesh_arrays.edge_keys
    is_border, is_deck = (np.isin(keys(creases), keys(other)) for other in (borders, deck_edge))
    return {
        "knuckle": creases[~is_border & ~is_deck],
        "border": borders[~np.isin(keys(borders), keys(deck_edge))],
        "deck_edge": np.asarray(deck_edge),
    }


def _odd_faces(control):
    ends = np.cumsum(control.face_sizes)
    odd = np.flatnonzero(control.face_sizes != 4)
    vertices = (control.face_vertices[ends[f] - control.face_sizes[f] : ends[f]] for f in odd)
    return {"odd_faces": odd, "odd_face_vertices": tuple(vertices)}


def _valences(mesh):
    """(n,) how many edges meet in each point: as many as faces, one more on a border."""
    valences = mesh.vertex_valences.copy()
    valences[np.unique(mesh.border_edges)] += 1
    return valences
