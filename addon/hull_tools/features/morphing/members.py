# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull as the member of its family that its weights say, as they are moved."""

import hashlib
from dataclasses import dataclass

import bpy
import numpy as np

from ...bridge.blender import units
from ...bridge.mesh import mesh_points
from ...bridge.mesh.mesh_editing import check_single_user
from ...bridge.objects import hull_mesh, hull_objects
from ..hull import hull_state
from ..variants import kept_hulls
from . import family_flats, local_parents, parents, weights

NOT_OF_FAMILY = (
    "The mesh is no longer the family's: points, faces or creases were changed. Make it a hull of "
    "its own, or go back to the family"
)
_FOLDED = "Beyond that the surface folds, at {}: the weights stay"


@dataclass
class Member:
    """What is told of a hull of a family. problem: why the last weights were not taken, or "".
    is_of_family: the mesh is that of the member that was shown last."""

    problem: str = ""
    is_of_family: bool = True


def told(obj):
    """The Member of a hull, as it was last brought up to date."""
    state = hull_state.state_of(obj)
    return Member() if state is None else state.of(Member)


def weight_changed(obj, entry, scene):
    """After the weight of one of a hull's parents was moved: the others follow, and the hull is
    the member of these weights, unless that cannot be: then all weights are as they were."""
    if weights.is_writing():
        return
    morph = obj.hull.morph
    weights.follow_one(morph, list(morph.parents).index(entry))
    _show_or_stay(obj, scene)


def settings_changed(obj, scene):
    """After another setting of the family was changed that the member goes by."""
    if parents.is_member(obj) and not weights.is_writing():
        _show_or_stay(obj, scene)


def set_weights(obj, scene, wanted):
    """Makes a hull the member of weights, one a parent, that sum to 1. ValueError where it cannot
    be that: all stays as it is then."""
    _check_member(obj)
    morph = obj.hull.morph
    before = [entry.weight for entry in morph.parents]
    weights.write(morph, weights.checked(wanted, len(morph.parents)))
    try:
        show(obj, scene)
    except ValueError:
        weights.write(morph, before)
        raise
    weights.remember_shares(morph)
    obj.update_tag(refresh={"DATA"})


def _show_or_stay(obj, scene):
    morph, member, state = obj.hull.morph, told(obj), hull_state.state_of(obj)
    if state is not None:
        state.shown.is_sliding = not bpy.app.background  # where nobody pauses, nothing waits for it
    try:
        show(obj, scene)
        member.problem = ""
    except ValueError as error:
        member.problem = str(error)
        weights.write(morph, [entry.shown_weight for entry in morph.parents])


def follow(obj, scene):
    """Brings a hull up to date with its weights where something else than a slider has set them,
    as animation does, and sees whether its mesh is the family's still. What cannot be is told."""
    if not parents.is_member(obj):
        return
    state = hull_state.state_of(obj) or hull_state.refresh(obj, scene)
    member = state.of(Member)
    member.is_of_family = is_of_family(obj)
    morph = obj.hull.morph
    is_shown = all(entry.weight == entry.shown_weight for entry in morph.parents)
    is_shown &= morph.shown_local == local_parents.key(obj)
    if is_shown or not member.is_of_family or hull_objects.locked(obj):
        return
    try:
        show(obj, scene)
        member.problem = ""
    except ValueError as error:
        member.problem = str(error)


def is_of_family(obj):
    """Whether the mesh of a hull is that of the member that was shown last, bit by bit."""
    return _mesh_key(hull_mesh.read(obj)) == obj.hull.morph.shown_mesh


def _mesh_key(found):
    digest = hashlib.blake2b(found.topology + found.points_digest, digest_size=16)
    return digest.hexdigest()


def show(obj, scene):
    """Moves the control points of a hull to the member of its weights, and gives it its drafts.
    ValueError, all being as it was, where that is folded, or the mesh is not the family's."""
    reason = hull_objects.locked(obj)
    if reason:
        raise ValueError(reason)
    check_single_user(obj.data)
    if not is_of_family(obj):
        raise ValueError(NOT_OF_FAMILY)
    scale = units.metres_per_unit(scene)
    write(obj, member_points(obj, scene, weights.read(obj.hull.morph)) / scale)


def member_points(obj, scene, wanted):
    """(n, 3), m: the member of a hull's family with these weights and the hull's factors.
    ValueError, with a place, where its surface is folded."""
    scale = units.metres_per_unit(scene)
    family = parents.family_of(obj, scale)
    local = local_parents.of_hull(obj, family, scale)
    points = family.native.points(wanted, local=local, mirrored=obj.hull.half)
    place = family.native.first_fold(points)
    if place is not None:
        at = ", ".join(f"{name} {units.format_value(scene, value, 'm')}"
                       for name, value in zip("xyz", place))  # fmt: skip
        raise ValueError(_FOLDED.format(at))
    return points * factors_of(obj.hull.morph)


def factors_of(morph):
    """(3,) of length, beam and draft."""
    return np.array([units.as_typed(factor) for factor in morph.factors])


def write(obj, points):
    """Puts the points (n, 3), in Blender's units, into the mesh of a hull, which has the family's
    faces, and keeps what is shown then."""
    mesh_points.write(obj.data, np.arange(len(points)), points)
    morph = obj.hull.morph
    morph.shown_mesh, morph.shown_local = _mesh_key(hull_mesh.read(obj)), local_parents.key(obj)
    for entry in morph.parents:
        entry.shown_weight = entry.weight
    if morph.follows_particulars:
        _write_particulars(obj.hull)


def _write_particulars(settings):
    morph = settings.morph
    found = parents.blended(morph, weights.read(morph), factors_of(morph))
    for name, value in found.items():
        group = settings.loading if name == "kg" else settings
        value = np.float32(value)
        if np.float32(getattr(group, name)) != value:
            setattr(group, name, value)


def back_to_family(obj, scene):
    """Gives a hull whose mesh was changed the family's mesh again, as the member of its weights."""
    _check_member(obj)
    reason = hull_objects.locked(obj)
    if reason:
        raise ValueError(reason)
    check_single_user(obj.data)
    if obj.data.is_editmode:
        raise ValueError("Leave edit mode first (Tab)")
    points = member_points(obj, scene, weights.read(obj.hull.morph))
    give_mesh(obj)
    write(obj, points / units.metres_per_unit(scene))
    told(obj).problem = ""
    return hull_state.follow_edit(obj, scene, is_by_hand=False)


def give_mesh(obj):
    """Gives a hull the faces, tags and layers of its family, with the first parent's points."""
    if obj.data.shape_keys is not None:
        obj.shape_key_clear()
    kept_hulls.write_mesh(obj.hull.morph.parents[0].mesh, obj.data)
    obj.hull.flats.clear()


def make_own(obj):
    """Takes a hull out of its family: its mesh stays bit by bit. What was flat in the layout and is
    so in it is kept flat again, unless the mesh was changed by hand."""
    _check_member(obj)
    reason = hull_objects.locked(obj)
    if reason:
        raise ValueError(reason)
    if is_of_family(obj):
        family_flats.keep_again(obj)
    obj.hull.property_unset("morph")
    state = hull_state.state_of(obj)
    if state is not None:
        state.of(parents.Known).family = None
    obj.update_tag(refresh={"DATA"})


def _check_member(obj):
    if not parents.is_member(obj):
        raise ValueError("The hull is of no family: make a morph of two hulls first")
