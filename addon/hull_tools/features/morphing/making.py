# SPDX-License-Identifier: GPL-3.0-or-later
"""Families made of hulls: the task that lays one control mesh onto all of them, and the hull that
is made a member of them."""

import re
from dataclasses import dataclass, field

import bpy

from ...bridge import limits, native
from ...bridge.background import jobs
from ...bridge.blender import units
from ...bridge.objects import hull_mesh, hull_objects
from ..conversion import conversions
from ..hull import hull_creation, hull_state
from ..variants import ship_settings
from . import layout_mesh, members, parents, stored_parents, weights

_GONE = '"{}" was deleted meanwhile: no family is made'
_PER_MILLE = 1e-3


@dataclass(frozen=True, eq=False)
class Taken:
    """A hull as it was taken for a family: its name, HullState, flotation.ship.ShipSource, and what
    is told of it then, in Blender's units."""

    name: str
    state: object
    source: object
    key: str
    particulars: tuple


@dataclass(frozen=True)
class Choice:
    """How hulls are made alike. layout: the number of the hull whose control mesh all get, or None
    for one that is no parent. pairs, apart: as hull_native.common_layout takes them."""

    layout: object
    tolerance: float
    most_subdivisions: int
    pairs: dict = field(default_factory=dict)
    apart: dict = field(default_factory=dict)


class Morphing(jobs.JobTask):
    """The task of making hulls alike; see conversion.conversions. hulls: the parents, two or more;
    layout: the hull whose control mesh they get, one of them or another one. result(): the
    stored_parents.Alike."""

    text = "Fitting the layout"

    def __init__(self, obj, hulls, layout, scene, pairs=None, apart=None):
        check_parents(hulls, layout)
        self.scale = units.metres_per_unit(scene)
        self._taken = [_taken(one, scene) for one in hulls]
        own = next((k for k, one in enumerate(hulls) if one == layout), None)
        self._shape = self._taken[own] if own is not None else _taken(layout, scene)
        found = hull_mesh.read(layout)
        self._layout = layout_mesh.layout_of(layout, found, found.control(self.scale))
        # By address: undo makes materials anew, and they may be deleted.
        slots = layout.material_slots
        self._materials = [slot.material and slot.material.as_pointer() for slot in slots]
        self.state = hull_state.state_of(obj)
        conversions.clear_way(obj)
        choice = self._choice = _choice(obj.hull.morph, own, pairs, apart)
        shape, taken = self._shape, self._taken
        self._job = jobs.Job(lambda progress: _made_alike(taken, shape, choice, progress))
        conversions.watch(self)

    def write(self, scene):
        """A new hull that is the member of equal weights; returns it. ValueError where a parent was
        deleted meanwhile."""
        hulls, layout = self._objects(scene)
        made = bpy.data.objects.new(_free_name(self._taken), bpy.data.meshes.new("Morph"))
        self._store(made, hulls, layout)
        for collection in hulls[0].users_collection:
            collection.objects.link(made)
        made.location = _beside(hulls)
        _give_settings(made, hulls[0], layout)
        members.give_mesh(made)
        _begin(made, scene)
        hull_creation.make_hull(made, scene, hulls[0].hull.half)
        return made

    def rewrite(self, obj, scene):
        """Gives a hull of a family this one in its place, with its weights."""
        hulls, layout = self._objects(scene)
        before = [entry.weight for entry in obj.hull.morph.parents]
        self._store(obj, hulls, layout)
        members.give_mesh(obj)
        weights.write(obj.hull.morph, before)
        _begin(obj, scene, before)
        return hull_state.follow_edit(obj, scene, is_by_hand=False)

    def _objects(self, scene):
        found = []
        for taken in (*self._taken, self._shape):
            obj = hull_state.hull_with(taken.state, scene)
            if not hull_objects.is_hull(obj):
                raise ValueError(_GONE.format(taken.name))
            found.append(obj)
        return found[:-1], found[-1]

    def _store(self, obj, hulls, layout):
        there = {material.as_pointer(): material for material in bpy.data.materials}
        materials = [there.get(address) for address in self._materials]
        stored_parents.store(
            obj, self.result(), self._taken, hulls, (self._shape, layout),
            (self._layout, materials), self.scale,
        )  # fmt: skip

    @property
    def told(self):
        """(what came of the fits in a sentence, whether it warns)."""
        return stored_parents.told(self.result(), [taken.name for taken in self._taken],
                                   self._shape.name)  # fmt: skip


def check_parents(hulls, layout):
    """ValueError, with the remedy, for hulls that are no parents of one family."""
    if len(hulls) < 2:
        raise ValueError("Select two hulls or more: they become the parents")
    limits.at_most(len(hulls), "parents", limits.MOST_PARENTS)
    first = hulls[0]
    for other in (*hulls[1:], layout):
        if other.hull.half != first.hull.half:
            whole, half = (first, other) if other.hull.half else (other, first)
            raise ValueError(
                f'"{half.name}" is a half hull, and "{whole.name}" one of both sides: Make Whole '
                "the one, or Make Half the other (panel Hull)"
            )
        if other.hull.scheme != first.hull.scheme:
            raise ValueError(
                f'"{first.name}" and "{other.name}" have different schemes: choose one (panel '
                "Surface)"
            )


def _taken(obj, scene):
    state = hull_state.up_to_date(obj, scene)
    if state.ship.source is None:
        raise ValueError(f'"{obj.name}" has no surface')
    key = parents.source_key(obj)
    return Taken(obj.name, state, state.ship.source, key, parents.particulars_of(obj))


def _choice(morph, own, pairs, apart):
    tolerance = units.as_typed(morph.tolerance)
    limits.within(tolerance, "Tolerance in ‰", *limits.MORPH_TOLERANCES)
    most = limits.within(morph.most_subdivisions, "Subdivisions", 0, limits.MOST_MORPH_SUBDIVISIONS)
    return Choice(own, _PER_MILLE * tolerance, most, pairs or {}, apart or {})


def _made_alike(taken, shape, choice, progress):
    """stored_parents.Alike of hulls; in the thread. Sentences of hull_native name hulls by numbers:
    here by their names."""
    hull_native = native.require()
    surfaces = [one.source.new_surface() for one in taken]
    layout = shape.source.new_surface()
    try:
        common = hull_native.common_layout(
            surfaces,
            layout=layout if choice.layout is None else choice.layout,
            pairs=choice.pairs,
            apart=choice.apart,
            tolerance=choice.tolerance,
            most_subdivisions=choice.most_subdivisions,
            progress=progress,
        )
    except ValueError as error:
        names = [one.name for one in taken]
        raise ValueError(_with_names(str(error), names, shape.name)) from None
    graphs = [hull_native.feature_graph(surface) for surface in (layout, *surfaces)]
    return stored_parents.Alike(common, layout, graphs[0], graphs[1:], choice.apart)


def _with_names(text, names, layout_name):
    found = re.match(r"Hull (\d+) has no part in the family\. ", text)
    if found is None:
        return text
    name = names[int(found[1]) - 1]
    reason = stored_parents.with_names(text[found.end() :], layout_name, name)
    return f'"{name}" has no part in the family. {reason}'


def _free_name(taken):
    return " × ".join(one.name for one in taken)[:60]


def _beside(hulls):
    """Where in the world a hull stands clear of all its parents, to port of them."""
    places = [one.matrix_world.translation for one in hulls]
    port = max(place.y + 0.5 * one.hull.beam for place, one in zip(places, hulls))
    widest = max(one.hull.beam for one in hulls)
    return places[0].x, port + widest, places[0].z


def _give_settings(made, first, layout):
    made.hull.samples = first.hull.samples
    ship_settings.copy_view(first.hull, made.hull)
    ship_settings.copy_ship(first.hull, made.hull)
    if layout != first:
        ship_settings.copy_named(layout.hull, made.hull, ("layers",))
    made.hull.source = ""


def _begin(obj, scene, wanted=None):
    """Shows the member of the wanted weights, or of equal ones; the first parent where that cannot
    be, as it is folded."""
    morph, scale = obj.hull.morph, units.metres_per_unit(scene)
    count = len(morph.parents)
    weights.write(morph, wanted or [1.0 / count] * count)
    try:
        points = members.member_points(obj, scene, weights.read(morph))
    except ValueError:
        first = [1.0] + [0.0] * (count - 1)
        weights.write(morph, first)
        points = parents.family_of(obj, scale).native.points(first) * members.factors_of(morph)
    members.write(obj, points / scale)
    weights.remember_shares(morph)


def selected_parents(active, objects):
    """The hulls among selected objects, or that these show, the active one first."""
    found = [hull_objects.hull_of(obj) for obj in (active, *objects)]
    return list(dict.fromkeys(hull for hull in found if hull is not None))


def layout_of(obj):
    """The hull whose layout a family of this and other hulls gets."""
    chosen = obj.hull.morph.layout_hull
    return chosen if parents.is_there(chosen) else obj
