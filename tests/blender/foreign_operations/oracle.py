# SPDX-License-Identifier: GPL-3.0-or-later
"""What is shown of every hull, beside what is computed afresh of its control mesh."""

import bpy
import numpy as np
from addon_under_test import mesh_points, part, state_of

from . import preview_oracle

# Integrals of a surface that followed edits are to 1e-8 of the whole.
_INTEGRAL_TOLERANCE = 1e-7
# Blender keeps corner normals as two angles of 16 bits.
_NORMAL_TOLERANCE = 1e-3
# The cosine between faces that lie on one another.
_FOLD = -0.9999


class Fresh:
    """Surface, lines and numbers of a hull, of nothing but its mesh and settings."""

    def __init__(self, hull, scene):
        arrays, objects = part("bridge.mesh.mesh_arrays"), part("bridge.objects.hull_objects")
        ship, lines = part("features.flotation.ship"), part("features.lines.lines")
        native, settings = part("bridge.native").require(), hull.hull
        scale = part("bridge.blender.units").metres_per_unit(scene)
        # seen_normals: those shown that were found to be right.
        self.surface, self.status, self.seen_normals = None, objects.refusal(hull), None
        if self.status:
            return
        data = arrays.read_mesh(hull.data)
        control = arrays.control_arrays(data, scale, objects.excluded_slots(hull))
        check, mesh = part("bridge.mesh.mesh_check").check_control_mesh(
            data, control, settings.half
        )
        if check.errors:
            self.status = check.errors[0].message
            return
        self.surface = native.LimitSurface(mesh, settings.scheme)
        samples = part("features.surface.shown_surface").samples_of(hull, self.surface)
        self.shown = native.ShownPoints(
            self.surface, samples, mirrored=settings.half, metres_per_unit=scale
        )
        self.quads, self.normals = part("features.surface.surface_mesh").surface_faces(
            self.surface.tessellate(samples), self.shown.shared
        )
        openings = "closed" if settings.deck_closed else "open"
        source = ship.ShipSource(control, settings.scheme, settings.half, openings, ())
        try:
            where = part("features.flotation.afloat").afloat(settings, scale)
            body = _with_appendages(source.live_body(self.surface), hull, scale, control.points)
            if body.joined_volume is None and body.may_overlap:
                body = _counted_once(body, source, control.points)
            own = ship.Ship(body, ())
            self.hydrostatics = part("features.flotation.hydrostatics").at(own, where)
        except ValueError as error:
            self.hydrostatics = str(error)
        moved = part("bridge.mesh.moves").Moves(None, "fresh")
        try:
            cuts = lines.wanted_cuts(settings, self.surface.mesh.points, scale)
            self.lines = lines.groups({}, self.surface, cuts, settings.half, moved)
        except ValueError as error:
            self.lines = str(error)


def _with_appendages(body, hull, scale, points):
    """A HullBody with the hull's appendages joined to it, where they can be."""
    bodies = part("bridge.objects.appendages").read(hull)
    try:
        joined = part("features.flotation.appendages").native_bodies(bodies, scale, points)
        if joined:
            body.join(joined, warn=False)
    except ValueError:
        pass  # they are told, and the hull counts alone
    return body


def _counted_once(body, source, points):
    """The HullBody with its own bodies counted once where they overlap by more than a little, and
    can be joined."""
    try:
        body.join([])
    except ValueError:
        return body  # that is told, and they add up
    little = part("features.flotation.live_ship")._SLIGHT * np.prod(np.ptp(points, axis=0))
    return body if -body.joined_volume > little else source.live_body(body.surface)


_latest = {}  # by the name of a hull: (what it is computed of, the Fresh of that)


def _fresh(hull, scene):
    """A Fresh of the hull as it is; the latest one where it would be of the same again."""
    inputs = _inputs(hull, scene)
    if hull.name not in _latest or _latest[hull.name][0] != inputs:
        _latest[hull.name] = inputs, Fresh(hull, scene)
    return _latest[hull.name][1]


def _inputs(hull, scene):
    """All that a Fresh is made of."""
    arrays, objects = part("bridge.mesh.mesh_arrays"), part("bridge.objects.hull_objects")
    mesh = dict(vars(arrays.read_mesh(hull.data)))
    ties = mesh.pop("ties")
    mesh = [array.tobytes() for array in mesh.values()]
    if ties is not None:
        mesh += [array.tobytes() for array in (ties.points, ties.kinds, ties.leaders, ties.numbers)]
    scale = part("bridge.blender.units").metres_per_unit(scene)
    bodies = part("bridge.objects.appendages").read(hull)
    slots, may_move = objects.excluded_slots(hull), hull.mode == "EDIT"
    return mesh, scale, objects.refusal(hull), slots, bodies, may_move, _values(hull.hull)


def _values(settings):
    """The values of all properties of a property group."""
    found = {}
    for rna in settings.rna_type.properties:
        if rna.identifier == "rna_type":
            continue
        value = getattr(settings, rna.identifier)
        if rna.type == "COLLECTION":
            value = [_values(row) for row in value]
        elif isinstance(value, bpy.types.PropertyGroup):
            value = _values(value)
        elif rna.type == "POINTER":
            value = value.name if isinstance(value, bpy.types.ID) else None
        elif getattr(rna, "is_array", False):
            value = tuple(value)
        found[rna.identifier] = value
    return found


def differences():
    """Sentences on what is not as it is computed afresh, of the hulls that are seen."""
    scene, view_layer = bpy.context.scene, bpy.context.view_layer
    found = []
    for hull in part("bridge.objects.hull_objects").hulls(view_layer.objects):
        if hull.visible_get() and hull.mode != "SCULPT":
            texts = _of_hull(hull, scene) + preview_oracle.differences(hull, scene)
            found += [f"{hull.name}: {text}" for text in texts]
    return found


def _of_hull(hull, scene):
    state = state_of(hull)
    if state is None:
        return ["nothing was computed"]
    fresh = _fresh(hull, scene)
    if state.status != fresh.status:
        return [f'status "{state.status}", afresh "{fresh.status}"']
    if fresh.surface is None:
        return []
    if not np.array_equal(state.ship.surface.mesh.points, fresh.surface.mesh.points):
        return ["the surface's points are not those of the mesh"]
    return [
        *_of_shown(hull, fresh),
        *_of_hydrostatics(state, fresh.hydrostatics),
        *_of_lines(state, fresh.lines),
    ]


def _of_shown(hull, fresh):
    shown = part("bridge.objects.shown_objects").surface_of(hull)
    if shown is None:
        return ["it has no surface object of its own"] if hull.hull.surface_object else []
    if shown.data.is_editmode or shown.mode != "OBJECT":
        return []
    if hull.mode == "EDIT" and shown.hide_render and not shown.visible_get():
        return []  # it comes when it is seen, or when the edit ends
    mesh, wanted = shown.data, fresh.shown.coordinates
    points = mesh_points(shown)
    if points.shape != wanted.shape:
        return [f"{len(points)} points shown, afresh {len(wanted)}"]
    if not np.array_equal(points, wanted):
        return [f"shown up to {np.abs(points - wanted).max()} beside the surface"]
    corners = np.empty(len(mesh.loops), dtype=np.int32)
    mesh.loops.foreach_get("vertex_index", corners)
    if not np.array_equal(corners, fresh.quads.reshape(-1)):
        return ["other faces are shown than those of the surface"]
    if part("features.surface.shown_surface").may_move(hull) or hull.data.is_editmode:
        return []  # they come at a pause
    return _of_normals(mesh, fresh)


def _of_normals(mesh, fresh):
    if not mesh.has_custom_normals:
        return ["the exact normals are missing"]
    shown, wanted = _corner_normals(mesh), fresh.normals.reshape(-1, 3)
    if fresh.seen_normals is not None and np.array_equal(shown, fresh.seen_normals):
        return []
    # Where the surface has no normal it is as Blender has it. Beside a side without length Blender
    # may have none, and from time to time another one, as its threads come by.
    exact = (np.linalg.norm(wanted, axis=1) > 0.5) & ~_beside_no_length(mesh, fresh.quads)
    apart = np.abs(shown - wanted).max(axis=1)
    if apart[exact].max(initial=0.0) > _NORMAL_TOLERANCE:
        apart = np.minimum(apart, np.abs(shown - _as_kept(mesh, fresh.normals)).max(axis=1))
        exact &= ~_beside_folds(mesh, fresh.quads)
    apart = apart[exact].max(initial=0.0)
    if apart > _NORMAL_TOLERANCE:
        return [f"normals shown are off by {apart}"]
    fresh.seen_normals = shown
    return []


def _beside_no_length(mesh, quads):
    """Which corners (4 q,) of faces (q, 4) are on a face with a side that has no length in single
    precision."""
    points = part("features.surface.surface_mesh").points_of(mesh)
    corners = points[quads]
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    least = np.finfo(np.float32).eps * np.abs(points).max(initial=0.0)
    return np.repeat((sides <= least).any(axis=1), 4)


def _beside_folds(mesh, quads):
    """Which corners (4 q,) of faces (q, 4) are at an end of an edge along which the surface turns
    right back. Blender's own normal there, to which it keeps ours, is the sum of two that cancel:
    rounding in the order in which its threads come by, or none."""
    corners = part("features.surface.surface_mesh").points_of(mesh)[quads].astype(float)
    normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    normals /= np.maximum(np.linalg.norm(normals, axis=1), np.finfo(float).tiny)[:, None]
    edges = np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2)
    edges.sort(axis=1)
    order = np.lexsort(edges.T)
    edges, faces = edges[order], order // 4
    folds = (edges[1:] == edges[:-1]).all(axis=1)
    folds &= (normals[faces[1:]] * normals[faces[:-1]]).sum(axis=1) < _FOLD
    return np.isin(quads.reshape(-1), edges[1:][folds])


def _as_kept(mesh, normals):
    """Corner normals (c, 3) as Blender keeps them on this mesh: as angles to its own, of which it
    drops the second below acos(1 - 1e-4) = 0.8 degrees; what they are taken from depends on the
    order of the mesh's edges, so that a mesh made anew would drop others."""
    own = mesh.copy()
    try:
        part("features.surface.surface_mesh").write_normals(own, normals)
        return _corner_normals(own)
    finally:
        bpy.data.meshes.remove(own)


def _corner_normals(mesh):
    if hasattr(mesh, "calc_normals_split"):
        mesh.calc_normals_split()
    normals = np.empty((len(mesh.loops), 3), dtype=np.float32)
    mesh.loops.foreach_get("normal", normals.reshape(-1))
    return normals


def _of_hydrostatics(state, wanted):
    if isinstance(wanted, str) or state.hydrostatics.values is None:
        if state.hydrostatics.values is None and state.hydrostatics.status == wanted:
            return []
        return [f"hydrostatics {state.hydrostatics.status!r}, afresh {wanted!r}"[:300]]
    found, size = [], max(wanted.displaced_volume, 1.0)
    for name in ("displaced_volume", "wetted_surface", "kb", "lcb", "waterplane_area"):
        ours, theirs = getattr(state.hydrostatics.values, name), getattr(wanted, name)
        if abs(ours - theirs) > _INTEGRAL_TOLERANCE * max(abs(theirs), size):
            found.append(f"{name} {ours}, afresh {theirs}")
    return found


def _of_lines(state, wanted):
    if isinstance(wanted, str) or state.lines.status:
        same = state.lines.status == wanted
        return [] if same else [f"lines {state.lines.status!r}, afresh {wanted!r}"[:300]]
    if state.lines.groups.keys() != wanted.keys():
        return [f"lines of {sorted(state.lines.groups)}, afresh of {sorted(wanted)}"]
    for kind, group in wanted.items():
        if not _are_same(state.lines.groups[kind].polylines, group.polylines):
            return [f"lines of kind {kind} are not those of the surface"]
    return []


def _are_same(lines, others):
    """Whether polylines (k, 3) are the same, point by point."""
    if list(map(len, lines)) != list(map(len, others)):
        return False
    return not len(lines) or np.array_equal(np.concatenate(lines), np.concatenate(others))
