# SPDX-License-Identifier: GPL-3.0-or-later
"""What was computed of each hull, and the functions that bring it up to date.

Each subject keeps its results with what they were computed from, and follows by itself; here they
are put together, in the order of the data. A mesh under construction that has errors leaves the
last good surface and says so in `status`.

States are found by the object's address, which stays when the object is renamed; they hold nothing
of Blender's and know what they were computed from, so that undo cannot harm them.
"""

from dataclasses import dataclass, field

import bpy

from ...bridge.blender import units
from ...bridge.objects import appendages, hull_mesh, hull_objects
from ..constraints.keeping import Keeping
from ..fairness.live_fairness import LiveFairness
from ..flotation.live_hydrostatics import LiveHydrostatics
from ..flotation.live_ship import LiveShip
from ..lines.live_lines import LiveLines
from ..surface.shown_surface import ShownSurface
from . import curve_entries
from .noticed_scale import NoticedScale
from .plausible import Plausible

_states = {}


@dataclass(eq=False)
class HullState:
    """Results of one hull, for panels to show.

    name: the object's. status: why the surface is not up to date, or ""; refusal: why the object
    cannot be a hull, which is the status then. remarks: what a user may expect and is not so, as
    sentences.
    """

    name: str
    status: str = ""
    refusal: str = ""
    remarks: list = field(default_factory=list)
    keeping: Keeping = field(default_factory=Keeping)
    ship: LiveShip = field(default_factory=LiveShip)
    shown: ShownSurface = field(default_factory=ShownSurface)
    hydrostatics: LiveHydrostatics = field(default_factory=LiveHydrostatics)
    plausible: Plausible = field(default_factory=Plausible)
    scaling: NoticedScale = field(default_factory=NoticedScale)
    lines: LiveLines = field(default_factory=LiveLines)
    fairness: LiveFairness = field(default_factory=LiveFairness)
    _of_subjects: dict = field(default_factory=dict)

    def of(self, kind):
        """What a later subject knows of this hull: the instance of its dataclass `kind`, empty at
        first."""
        if kind not in self._of_subjects:
            self._of_subjects[kind] = kind()
        return self._of_subjects[kind]

    def checked(self):
        """This; ValueError with the reason when there is no surface of the hull as it is."""
        if self.status:
            raise ValueError(self.status)
        return self


def state_of(obj):
    """The HullState of a hull, None when nothing was computed yet."""
    return _states.get(obj.as_pointer())


def hull_with(state, scene):
    """The hull of a scene with a HullState, whatever its name is by now, or None."""
    return next((obj for obj in scene.objects if state_of(obj) is state), None)


def is_outdated(obj):
    """Whether what is known of a hull is of its mesh as it was, which has errors by now."""
    state = state_of(obj)
    return state is not None and bool(state.status)


def known_hulls(view_layer):
    """Pairs (hull, HullState) of the hulls in a view layer of which something was computed."""
    for address, state in _states.items():
        obj = _at(address, state.name, view_layer.objects)
        if obj is not None:
            yield obj, state


def _at(address, name, objects):
    """The object at an address among objects, or None; found quickly by its name, which a linked
    one may have in common with one of the file's own."""
    obj = objects.get(name)
    if obj is None or obj.as_pointer() == address:
        return obj
    return next((other for other in objects if other.as_pointer() == address), None)


def follow_edit(obj, scene, is_by_hand=True, may_wait=False, placed=None):
    """After points of a hull were moved: what holds them is put into effect in its mesh, then all
    is brought up to date; returns the HullState. is_by_hand: see constraints.keeping; may_wait: see
    LiveShip.follow.

    placed(obj, scene, found, keep) has points go elsewhere once they are where they may be, and
    returns the hull_mesh.HullMesh then: `found` is that of now, keep() that after others have moved
    points. So all that follows is computed once, of points that stay.
    """

    def read(state):
        curve_entries.follow(obj)
        found = state.keeping.keep(obj, state.ship, is_by_hand)
        if placed is None:
            return found
        return placed(obj, scene, found, lambda: state.keeping.keep(obj, state.ship, False))

    state = _brought_up_to_date(obj, scene, read, may_wait)
    if state.refusal and placed is not None:
        # Nothing was read of it; its points go all the same.
        placed(obj, scene, hull_mesh.read(obj), lambda: hull_mesh.read(obj))
    return state


def refresh(obj, scene):
    """Brings all that is computed of a hull up to date with its mesh, which is only read; returns
    the HullState."""
    return _brought_up_to_date(obj, scene, lambda state: hull_mesh.read(obj))


def up_to_date(obj, scene):
    """The HullState of a hull as it is now; ValueError with the reason when that has no surface."""
    return refresh(obj, scene).checked()


def known(obj, subject):
    """What is kept for a subject's class of a hull of which something is known, else None."""
    state = state_of(obj)
    return None if state is None else state.of(subject)


def last_report(obj, subject):
    """(the report that a subject of a hull's state keeps or None, whether it is of the hull as it
    is)."""
    state = state_of(obj)
    report = None if state is None else state.of(subject).report
    return report, report is not None and state.ship.geometry_key == report.key


def _brought_up_to_date(obj, scene, read, may_wait=False):
    """read: HullState → the hull_mesh.HullMesh of the hull."""
    address = obj.as_pointer()
    if address not in _states:
        _states[address] = HullState(obj.name)
    state = _states[address]
    state.name = obj.name
    try:
        state.refusal = hull_objects.refusal(obj)
        if state.refusal:
            raise ValueError(state.refusal)
        _follow(obj, scene, state, read(state), may_wait)
        state.status = ""
    except ValueError as error:
        state.status = str(error)
    return state


def _follow(obj, scene, state, found, may_wait):
    """Each subject follows those before it."""
    scale = units.metres_per_unit(scene)
    state.remarks = hull_objects.remarks(obj)
    state.scaling.follow(obj.hull, found.data.points)
    if state.ship.follow(found, scale, may_wait):
        state.shown.follow(obj, state.ship, scale)
    if state.ship.check.errors:
        raise ValueError(state.ship.check.errors[0].message)
    state.remarks += state.shown.remarks(obj) + state.ship.remarks()
    state.hydrostatics.follow(obj.hull, state.ship, scale)
    state.plausible.follow(obj, state.ship, state.hydrostatics.values, scale)
    state.lines.follow(obj.hull, state.ship, scale)
    state.fairness.follow(obj, state.ship, state.lines.groups, scale)


def with_foreign_surface(objects):
    """The hulls whose surface objects are among these, and are not as they were left: nothing is
    known of what they show any longer."""
    found = []
    for hull, state in _shown_by(objects):
        if not state.shown.is_as_left(hull):
            state.shown.forget()
            found.append(hull)
    return found


def with_unknown_surface(objects):
    """The hulls whose surface objects are among these, and of which nothing is known since they
    were worked on, without looking at their meshes."""
    return [hull for hull, state in _shown_by(objects) if not state.shown.is_known]


def _shown_by(objects):
    """Pairs (hull, HullState) of those whose surface objects are among these."""
    for shown in objects:
        hull = hull_objects.hull_of(shown)
        if hull in (None, shown) or shown != hull.hull.surface_object:
            continue
        state = state_of(hull)
        if state is not None:
            yield hull, state


def with_other_refusal(view_layer):
    """The hulls in a view layer that are refused, or are not, other than when they were last
    brought up to date."""
    return [
        hull
        for hull, state in known_hulls(view_layer)
        if hull_objects.refusal(hull) != state.refusal
    ]


def with_other_appendages(view_layer):
    """Hulls of which appendages came or went since they were brought up to date."""
    return [
        hull
        for hull in hull_objects.hulls(view_layer.objects)
        if hull.as_pointer() in _states
        and _states[hull.as_pointer()].ship.appendages_key != appendages.read(hull)
    ]


def with_shared_mesh(hulls, view_layer):
    """The hulls in a view layer that have a mesh of these, where several objects have it."""
    shared = {hull.data for hull in hulls if hull.data.users > 1}
    if not shared:
        return []
    return [hull for hull, _ in known_hulls(view_layer) if hull.data in shared]


def forget(obj):
    _states.pop(obj.as_pointer(), None)


def forget_all():
    _states.clear()
    curve_entries.forget_all()


def forget_shown():
    """Forgets what surface objects show, after undo has changed them and the hulls."""
    for state in _states.values():
        state.shown.forget()


def forget_deleted():
    """Forgets what is no hull any longer; those that were renamed are known by their new name."""
    if all(_is_there(address, state.name) for address, state in _states.items()):
        return
    names = {obj.as_pointer(): obj.name for obj in hull_objects.hulls(bpy.data.objects)}
    for address in list(_states):
        if address in names:
            _states[address].name = names[address]
        else:
            del _states[address]


def _is_there(address, name):
    """Whether a hull is at this address still; found quickly by the name it had."""
    obj = _at(address, name, bpy.data.objects)
    return obj is not None and obj.name == name and hull_objects.is_hull(obj)
