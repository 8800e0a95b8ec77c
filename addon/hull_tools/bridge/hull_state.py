# SPDX-License-Identifier: GPL-3.0-or-later
"""What was computed of each hull, and the one function that brings it up to date.

`refresh` reads the control mesh and does only what the changes since the last time ask for: points
that moved are handed to the surface and the body that are there. A mesh under construction that has
errors leaves the last good surface and says so in `status`.

Results are kept by the object's address, which stays when the object is renamed; they hold nothing
of Blender's and know what they were computed from, so that undo cannot harm them.
"""

from dataclasses import dataclass, field

import bpy
import numpy as np

from . import (
    afloat,
    colours,
    combs,
    flat_keeping,
    hull_objects,
    hydrostatics,
    level_lines,
    lines,
    mesh_arrays,
    mesh_check,
    native,
    ship,
    shown_objects,
    surface_object,
    units,
)

_states = {}

_SHOWN_KEYS = ("shown surface", "shown faces", "normals", "colours")


@dataclass
class HullState:
    """Results of one hull, for panels to show.

    status: why the surface is not up to date, or "". hydrostatics: Hydrostatics or None, and then
    hydrostatics_status says why. lines: lines.Group by kind of those that are shown; lines_status:
    why they are not up to date, or "". combs, level_lines and fairness_status: the same of what
    fairness is judged by. colour_scale: the hull_native.ColourScale of the surface object's
    colours, None when it has none. body: the hull_native.HullBody of `surface`; both change
    with the next edit, so that only `source`, the ship.ShipSource of both, is for threads.
    analyses: see bridge.analyses. task, conversion: what is converted or written, and what came of
    the last conversion: see bridge.conversions. worst_spot: the one of patches.SPOTS that is marked
    in the 3D view, or "". keys: what each result was computed from. flat_memory: see
    bridge.flat_keeping. name: the object's.
    """

    name: str
    status: str = ""
    remarks: list = field(default_factory=list)
    check: mesh_check.MeshCheck = mesh_check.MeshCheck()
    surface: object = None
    body: object = None
    source: object = None
    hydrostatics: object = None
    hydrostatics_status: str = ""
    lines: dict = field(default_factory=dict)
    lines_status: str = ""
    combs: dict = field(default_factory=dict)
    level_lines: dict = field(default_factory=dict)
    fairness_status: str = ""
    colour_scale: object = None
    analyses: dict = field(default_factory=dict)
    task: object = None
    conversion: object = None
    worst_spot: str = ""
    keys: dict = field(default_factory=dict)
    flat_memory: flat_keeping.Memory = field(default_factory=flat_keeping.Memory)

    @property
    def ship(self):
        """The ship.Ship that follows the edits."""
        return ship.Ship(self.body, self.source.deck_edge)


def state_of(obj):
    """The HullState of a hull, None when nothing was computed yet."""
    return _states.get(obj.as_pointer())


def known_hulls(view_layer):
    """Pairs (hull, HullState) of the hulls in a view layer of which something was computed."""
    for address, state in _states.items():
        obj = view_layer.objects.get(state.name)
        if obj is not None and obj.as_pointer() == address:
            yield obj, state


def forget(obj):
    _states.pop(obj.as_pointer(), None)


def forget_all():
    _states.clear()


def forget_shown():
    """Forgets what surface objects show, after they changed by themselves."""
    for state in _states.values():
        for key in _SHOWN_KEYS:
            state.keys.pop(key, None)


def forget_deleted():
    """Forgets what is no hull any longer."""
    if all(_is_there(address, state.name) for address, state in _states.items()):
        return
    hulls = {obj.as_pointer() for obj in hull_objects.hulls(bpy.data.objects)}
    for address in _states.keys() - hulls:
        del _states[address]


def _is_there(address, name):
    """Whether a hull is at this address still; found quickly by the name it had."""
    obj = bpy.data.objects.get(name)
    return obj is not None and obj.as_pointer() == address and hull_objects.is_hull(obj)


def refresh(obj, scene):
    """Brings surface, lines, check and hydrostatics of a hull up to date; returns its HullState."""
    state = _states.setdefault(obj.as_pointer(), HullState(obj.name))
    state.name = obj.name
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
    flat_keeping.keep(obj, state.flat_memory)
    scale = units.metres_per_unit(scene)
    geometry_key = _update_ship(obj, state, scale)
    _show_surface(obj, state, scale, geometry_key)
    _update_hydrostatics(obj, state, scale)
    _update_lines(obj, state, scale, geometry_key)
    _update_fairness(obj, state, scale, geometry_key)


def _update_ship(obj, state, scale):
    """Brings surface, body and source up to date; returns the key of the surface.

    ValueError with the first error of a mesh that has any.
    """
    settings = obj.hull
    data = mesh_arrays.read_mesh(obj.data)
    excluded = hull_objects.excluded_slots(obj)
    topology_key = (data.topology_digest(), excluded, settings.half, settings.scheme)
    geometry_key = (topology_key, data.points_digest(), scale)
    marks = np.packbits(data.deck_edges).tobytes()
    openings = "closed" if settings.deck_closed else "open"
    key = (geometry_key, openings, marks)
    if state.keys.get("ship") != key:
        control = mesh_arrays.control_arrays(data, scale, excluded)
        state.check, mesh = mesh_check.check_control_mesh(data, control, settings.half)
        if mesh is not None:
            deck_edge = tuple(map(tuple, control.deck_edge.tolist()))
            source = ship.ShipSource(control, settings.scheme, settings.half, openings, deck_edge)
            _make_body(state, mesh, source, topology_key, geometry_key)
        state.keys["ship"] = key
    if state.check.errors:
        raise ValueError(state.check.errors[0].message)
    return geometry_key


def _make_body(state, mesh, source, topology_key, geometry_key):
    """Surface and body of a source: those that are there where only points have moved."""
    surface, body = state.surface, state.body
    has_moved = state.keys.get("geometry") != geometry_key
    if surface is None or state.keys.get("topology") != topology_key:
        surface, body = native.require().LimitSurface(mesh, source.scheme), None
    elif has_moved:
        state.keys.pop("geometry", None)
        state.body = None  # until it has the points that the surface has
        surface.set_points(source.control.points)
    if body is None or body.openings != source.openings:
        body = source.live_body(surface)
    elif has_moved:
        body.update()
    state.surface, state.body, state.source = surface, body, source
    state.keys.update(topology=topology_key, geometry=geometry_key)


def _show_surface(obj, state, scale, geometry_key):
    shown = shown_objects.surface_of(obj)
    if shown is None:
        state.colour_scale = None
        return
    settings = obj.hull
    mesh = shown.data
    place_key = (geometry_key, settings.samples, shown.name_full)
    # Normals take Blender most of the time: while the mesh is edited those of before turn along.
    is_due = state.keys.get("normals") != place_key and obj.mode != "EDIT"
    choice = colours.wanted(settings.fairness)
    are_colours_due = state.keys.get("colours") != (place_key, choice)
    if state.keys.get("shown surface") == place_key and not is_due and not are_colours_due:
        return
    tessellation = state.surface.tessellate(settings.samples)
    points, shared = surface_object.surface_points(tessellation, settings.half)
    faces_key = (geometry_key[0], settings.samples, shown.name_full, shared.tobytes())
    has_faces = state.keys.get("shown faces") == faces_key and len(mesh.vertices) == len(points)
    if has_faces:
        surface_object.move_surface(mesh, points, scale)
    if is_due or not has_faces:
        quads, normals = surface_object.surface_faces(tessellation, shared)
        if not has_faces:
            surface_object.write_surface(mesh, points, quads, scale)
        surface_object.write_normals(mesh, normals)
        state.keys["normals"] = place_key
    state.keys["shown faces"] = faces_key
    state.keys["shown surface"] = place_key
    if are_colours_due:
        state.colour_scale = _colour(shown, state.surface, tessellation, shared, choice)
        state.keys["colours"] = (place_key, choice)


def _colour(shown, surface, tessellation, shared, choice):
    """Gives the surface object its colours; returns their scale, or None."""
    if choice is None:
        colours.remove_colours(shown)
        return None
    scale, of_normals = colours.coloured(surface, tessellation, choice)
    corners = of_normals[tessellation.normal_indices]
    colours.write_colours(shown, surface_object.both_sides(tessellation, shared, corners))
    return scale


def _update_lines(obj, state, scale, geometry_key):
    settings, surface = obj.hull, state.surface
    try:
        wanted = lines.wanted_cuts(settings, surface.mesh.points, scale)
        state.lines = lines.groups(state.lines, surface, wanted, settings.half, geometry_key)
        state.lines_status = ""
    except ValueError as error:
        state.lines_status = str(error)


def _update_fairness(obj, state, scale, geometry_key):
    settings, surface = obj.hull, state.surface
    try:
        state.combs = combs.combs(state.combs, surface, settings, geometry_key, scale)
        state.level_lines = level_lines.level_lines(
            state.level_lines, surface, settings, geometry_key
        )
        state.fairness_status = ""
    except ValueError as error:
        state.fairness_status = str(error)


def _update_hydrostatics(obj, state, scale):
    where = afloat.afloat(obj.hull, scale)
    key = (state.keys["ship"], where)
    if state.keys.get("hydrostatics") == key:
        return
    try:
        state.hydrostatics = hydrostatics.at(state.body, where)
        state.hydrostatics_status = ""
    except ValueError as error:
        state.hydrostatics = None
        state.hydrostatics_status = str(error)
    state.keys["hydrostatics"] = key
