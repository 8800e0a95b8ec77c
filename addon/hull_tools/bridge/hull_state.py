# SPDX-License-Identifier: GPL-3.0-or-later
"""What was computed of each hull, and the one function that brings it up to date.

`refresh` reads the control mesh and does only what the changes since the last time ask for. A mesh
under construction that has errors leaves the last good surface and says so in `status`.
Results are kept by the object's name; they hold nothing of Blender's, so undo cannot harm them.
"""

from dataclasses import dataclass, field

import numpy as np

from . import (
    afloat,
    hull_objects,
    hydrostatics,
    lines,
    lines_object,
    mesh_arrays,
    mesh_check,
    native,
    shown_objects,
    surface_object,
    units,
)

_states = {}


@dataclass
class HullState:
    """Results of one hull, for panels to show.

    status: why the surface is not up to date, or "". hydrostatics: Hydrostatics or None, and then
    hydrostatics_status says why. body: the hull_native.HullBody of `surface`. analyses: see
    bridge.analyses. keys: what each result was computed from.
    """

    status: str = ""
    remarks: list = field(default_factory=list)
    check: mesh_check.MeshCheck = mesh_check.MeshCheck()
    surface: object = None
    body: object = None
    hydrostatics: object = None
    hydrostatics_status: str = ""
    analyses: dict = field(default_factory=dict)
    keys: dict = field(default_factory=dict)


def state_of(obj):
    """The HullState of a hull, None when nothing was computed yet."""
    return _states.get(obj.name_full)


def forget(obj):
    _states.pop(obj.name_full, None)


def forget_all():
    _states.clear()


def refresh(obj, scene):
    """Brings surface, lines, check and hydrostatics of a hull up to date; returns its HullState."""
    state = _states.setdefault(obj.name_full, HullState())
    try:
        _refresh(obj, scene, state)
        state.status = ""
    except ValueError as error:
        state.status = str(error)
    return state


def _refresh(obj, scene, state):
    reason = hull_objects.refusal(obj)
    if reason:
        raise ValueError(reason)
    state.remarks = hull_objects.remarks(obj)
    scale = units.metres_per_unit(scene)
    geometry_key = _update_surface(obj, state, scale)
    _show_surface(obj, state, scale, geometry_key)
    _update_body(obj, state, geometry_key)
    _update_hydrostatics(obj, state, scale)
    _show_lines(obj, state, scale, geometry_key)


def _update_surface(obj, state, scale):
    """The key of the state's surface; ValueError with the first error of a mesh that has any."""
    settings = obj.hull
    data = mesh_arrays.read_mesh(obj.data)
    excluded = hull_objects.excluded_slots(obj)
    key = (data.digest(), scale, excluded, settings.half, settings.scheme)
    if state.keys.get("surface") != key:
        control = mesh_arrays.control_arrays(data, scale, excluded)
        state.check, mesh = mesh_check.check_control_mesh(data, control, settings.half)
        if mesh is not None:
            state.surface = native.require().LimitSurface(mesh, settings.scheme)
        state.keys["surface"] = key
    if state.check.errors:
        raise ValueError(state.check.errors[0].message)
    return key


def _show_surface(obj, state, scale, geometry_key):
    shown = shown_objects.surface_of(obj)
    if shown is None:
        return
    settings = obj.hull
    mesh = shown.data
    place_key = (geometry_key, settings.samples, shown.name_full)
    # Normals take Blender most of the time: while the mesh is edited those of before turn along.
    is_due = state.keys.get("normals") != place_key and obj.mode != "EDIT"
    if state.keys.get("shown surface") == place_key and not is_due:
        return
    points, quads, normals = surface_object.surface_arrays(
        state.surface.tessellate(settings.samples), settings.half
    )
    topology_key = (surface_object.topology_of(quads), shown.name_full)
    if state.keys.get("shown topology") == topology_key and len(mesh.vertices) == len(points):
        surface_object.move_surface(mesh, points, scale)
    else:
        surface_object.write_surface(mesh, points, quads, scale)
        is_due = True
    if is_due:
        surface_object.write_normals(mesh, normals)
        state.keys["normals"] = place_key
    state.keys["shown topology"] = topology_key
    state.keys["shown surface"] = place_key


def _show_lines(obj, state, scale, geometry_key):
    shown = shown_objects.lines_of(obj)
    if shown is None:
        return
    settings = obj.hull
    points = state.surface.mesh.points
    where = lines.planes(settings, points, scale)
    draft = units.as_typed(settings.draft) * scale
    key = (geometry_key, where, draft, shown.name_full)
    if state.keys.get("shown lines") != key:
        found = lines.hull_lines(state.surface, where, draft, settings.half)
        length = float(np.ptp(points, axis=0).max())
        lines_object.write_lines(shown.data, found, length, scale)
        state.keys["shown lines"] = key


def _update_body(obj, state, geometry_key):
    settings = obj.hull
    key = (geometry_key, settings.deck_closed)
    if state.keys.get("body") != key:
        openings = "closed" if settings.deck_closed else "open"
        state.body = native.require().HullBody(
            state.surface, mirrored=settings.half, openings=openings
        )
        state.keys["body"] = key


def _update_hydrostatics(obj, state, scale):
    where = afloat.afloat(obj.hull, scale)
    key = (state.keys["body"], where)
    if state.keys.get("hydrostatics") == key:
        return
    try:
        state.hydrostatics = hydrostatics.at(state.body, where)
        state.hydrostatics_status = ""
    except ValueError as error:
        state.hydrostatics = None
        state.hydrostatics_status = str(error)
    state.keys["hydrostatics"] = key
