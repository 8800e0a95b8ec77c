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

from ...bridge import native
from ...bridge.blender import units
from ...bridge.mesh import mesh_arrays, mesh_check, moves, valid_part
from ...bridge.objects import hull_objects
from ..constraints import centre_keeping, flat_keeping
from ..fairness import combs, level_lines
from ..flotation import afloat, hydrostatics, ship
from ..lines import lines
from ..surface import shown_surface
from . import plausible

_states = {}

_HELD_IN_FLATS = "Points stay in their flats: Release under Shape frees them."
_HELD_ON_CENTRE = "Points stay on the centre plane: Keep on centre, switched off, frees them."


@dataclass
class HullState:
    """Results of one hull, for panels to show.

    status: why the surface is not up to date, or "". hydrostatics: Hydrostatics or None, and then
    hydrostatics_status says why. lines: lines.Group by kind of those that are shown; lines_status:
    why they are not up to date, or "". combs, level_lines and fairness_status: the same of what
    fairness is judged by. colour_scale: the hull_native.ColourScale of the surface object's
    colours, None when it has none. body: the hull_native.HullBody of `surface`; both change with
    the next edit, so that only `source`, the ship.ShipSource of both, is for threads. moved: the
    moves.Moves of the surface. memory: see ship.Ship. shown_points: the hull_native.ShownPoints of
    the surface, None before they are shown.
    analyses: see features.analyses. task, conversion: what is converted or written, and what came
    of the last conversion: see features.conversion.conversions. cad_problem: see
    features.exchange.cad_files. fit: the fitting.Report of the last
    fit, or None. worst_spot: the one of patches.SPOTS that is marked in the 3D view, or "".
    keys: what each result was computed from. flat_memory: see features.constraints.flat_keeping.
    held: what points were kept from in the last edit that moved any, for the user, or "".
    is_part: the mesh has errors, and the surface is of what makes one. extents, doubts: see
    features.hull.plausible. is_placed: undo or numbers have put the points where they are. name:
    the object's.
    """

    name: str
    status: str = ""
    is_part: bool = False
    remarks: list = field(default_factory=list)
    check: mesh_check.MeshCheck = mesh_check.MeshCheck()
    surface: object = None
    moved: object = None
    memory: dict = field(default_factory=dict)
    shown_points: object = None
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
    cad_problem: object = None
    fit: object = None
    worst_spot: str = ""
    keys: dict = field(default_factory=dict)
    flat_memory: flat_keeping.Memory = field(default_factory=flat_keeping.Memory)
    held: str = ""
    extents: object = None
    doubts: list = field(default_factory=list)
    is_placed: bool = False

    @property
    def ship(self):
        """The ship.Ship that follows the edits."""
        return ship.Ship(self.body, self.source.deck_edge, self.moved, self.memory)


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
    """Forgets what surface objects show, after undo has changed them and the hulls."""
    for state in _states.values():
        shown_surface.forget(state)
        state.is_placed = True


def with_foreign_surface(objects):
    """The hulls whose surface objects are among these, and are not as they were left: nothing is
    known of what they show any longer."""
    found = []
    for shown in objects:
        hull = hull_objects.hull_of(shown)
        if hull in (None, shown) or shown != hull.hull.surface_object:
            continue
        state = state_of(hull)
        if state is not None and not shown_surface.is_as_left(hull, state):
            shown_surface.forget(state)
            found.append(hull)
    return found


def let_be_placed(obj):
    """What is about to move a hull's points places them on purpose, the centre plane or not."""
    if state_of(obj) is not None:
        state_of(obj).is_placed = True


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


def up_to_date(obj, scene):
    """The HullState of a hull as it is now; ValueError with the reason when that has no surface."""
    state = refresh(obj, scene)
    if state.status:
        raise ValueError(state.status)
    return state


def _refresh(obj, scene, state):
    reason = hull_objects.refusal(obj)
    if reason:
        raise ValueError(reason)
    state.remarks = hull_objects.remarks(obj)
    held = [_HELD_IN_FLATS] if flat_keeping.keep(obj, state.flat_memory) else []
    scale = units.metres_per_unit(scene)
    geometry_before = state.keys.get("geometry")
    geometry_key = _update_ship(obj, state, scale, held)
    if held or geometry_key != geometry_before:
        state.held = " ".join(held)
    if state.surface is not None and state.keys.get("geometry") == geometry_key:
        shown_surface.follow(obj, state, scale, geometry_key)
    if state.check.errors:
        raise ValueError(state.check.errors[0].message)
    _tell_samples(obj, state)
    _update_hydrostatics(obj, state, scale)
    plausible.update(obj, state, scale)
    _update_lines(obj, state, scale)
    _update_fairness(obj, state, scale)


def _tell_samples(obj, state):
    shown, wanted = shown_surface.samples_of(obj, state), obj.hull.samples
    if shown < wanted:
        state.remarks.append(
            f"Samples: {shown} are shown for {wanted}: Blender would take long for more faces"
        )


def _update_ship(obj, state, scale, held):
    """Brings surface, body and source up to date; returns the key of the mesh. What points are kept
    from is added to the texts `held`.

    Of a mesh with errors the last good surface stays; where there is none, it is that of its part
    that makes one.
    """
    settings = obj.hull
    data = mesh_arrays.read_mesh(obj.data)
    excluded = hull_objects.excluded_slots(obj)
    topology_key = (data.topology_digest(), excluded, settings.half, settings.scheme)
    if _keeps_centre(obj, state, topology_key):
        border = state.surface.mesh.border_edges
        kept = centre_keeping.kept(obj, data, state.source.control, border)
        if kept is not data:
            data = kept
            held.append(_HELD_ON_CENTRE)
    state.is_placed = False
    geometry_key = (topology_key, data.points_digest(), scale)
    marks = np.packbits(data.deck_edges).tobytes()
    openings = "closed" if settings.deck_closed else "open"
    key = (geometry_key, openings, marks)
    if state.keys.get("ship") != key:
        if state.keys.get("control") == (topology_key, marks):
            control = mesh_arrays.moved_arrays(state.source.control, data, scale)
        else:
            control = mesh_arrays.control_arrays(data, scale, excluded)
        state.check, mesh = mesh_check.check_control_mesh(data, control, settings.half)
        is_whole = mesh is not None
        if not is_whole and (state.surface is None or state.is_part):
            control, mesh = valid_part.valid_part(control)
        if mesh is not None:
            state.is_part = not is_whole
            deck_edge = tuple(map(tuple, control.deck_edge.tolist()))
            source = ship.ShipSource(control, settings.scheme, settings.half, openings, deck_edge)
            _make_body(state, mesh, source, topology_key, geometry_key)
            state.keys["control"] = (topology_key, marks) if is_whole else None
        state.keys["ship"] = key
    return geometry_key


def _keeps_centre(obj, state, topology_key):
    """Whether points were moved by hand, so that those on the centre plane are to stay there."""
    settings = obj.hull
    return (
        settings.half
        and settings.keep_centre
        and obj.data.is_editmode
        and not state.is_placed
        and state.surface is not None
        and state.keys.get("topology") == topology_key
    )


def _make_body(state, mesh, source, topology_key, geometry_key):
    """Surface and body of a source: those that are there where only points have moved."""
    surface, body = state.surface, state.body
    has_moved = state.keys.get("geometry") != geometry_key
    if surface is None or state.keys.get("topology") != topology_key:
        surface, body = native.require().LimitSurface(mesh, source.scheme), None
        state.moved = moves.Moves(None, geometry_key, native.require().MoveWatch(surface))
        state.shown_points = None
    elif has_moved:
        # Until all of them have the points that the surface has, there is no body.
        before, state.body = state.keys.pop("geometry", None), None
        surface.set_points(source.control.points)
        state.moved = state.moved.further(before, geometry_key)
    if body is None or body.openings != source.openings:
        body = source.live_body(surface)
        state.memory.clear()
    elif has_moved:
        body.update()
    state.surface, state.body, state.source = surface, body, source
    state.keys.update(topology=topology_key, geometry=geometry_key)


def _update_lines(obj, state, scale):
    settings, surface = obj.hull, state.surface
    try:
        wanted = lines.wanted_cuts(settings, surface.mesh.points, scale)
        state.lines = lines.groups(state.lines, surface, wanted, settings.half, state.moved)
        state.lines_status = ""
    except ValueError as error:
        state.lines_status = str(error)


def _update_fairness(obj, state, scale):
    settings, surface = obj.hull, state.surface
    try:
        shown = [group for group in state.lines.values() if group.key[0] == state.moved.after]
        state.combs = combs.combs(state.combs, surface, settings, state.moved, scale, shown)
        state.level_lines = level_lines.level_lines(
            state.level_lines, surface, settings, state.moved.after
        )
        state.fairness_status = ""
    except ValueError as error:
        state.fairness_status = str(error)


def _update_hydrostatics(obj, state, scale):
    key = None
    try:
        where = afloat.afloat(obj.hull, scale)
        key = (state.keys["ship"], where)
        if state.keys.get("hydrostatics") == key:
            return
        state.hydrostatics = hydrostatics.at(state.ship, where)
        state.hydrostatics_status = ""
    except ValueError as error:
        state.hydrostatics = None
        state.hydrostatics_status = str(error)
    state.keys["hydrostatics"] = key
