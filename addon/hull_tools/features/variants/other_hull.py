# SPDX-License-Identifier: GPL-3.0-or-later
"""The hull that a hull is compared with: one of its variants, or another hull object. Both lie on
one another by their own origins, as if they were one object."""

from dataclasses import dataclass, field, replace

from ...bridge.mesh import mesh_check
from ...bridge.objects import hull_mesh, hull_objects
from ..flotation import ship
from ..flotation.appendages import native_bodies
from ..hull import hull_state
from . import kept_hulls


@dataclass(frozen=True)
class Other:
    """key: equal where surface and body are. source: flotation.ship.ShipSource, for any thread."""

    name: str
    key: tuple
    source: ship.ShipSource = field(compare=False)


@dataclass
class _Known:
    """The source that was made last, so that what was made of it is found again."""

    key: tuple = None
    source: object = None


def is_chosen(obj):
    """Whether a hull is compared with something, be that as it may: `of` says what is wrong."""
    variants = obj.hull.variants
    if variants.compared_with == "HULL":
        return variants.other_hull is not None
    return kept_hulls.chosen(obj) is not None


def of(obj, scale):
    """The Other of a hull; scale: metres of Blender's unit. ValueError with the remedy where there
    is none, or it has no surface."""
    variants = obj.hull.variants
    if variants.compared_with == "HULL":
        return _object(obj, variants.other_hull)
    entry = kept_hulls.chosen(obj)
    if entry is None:
        raise ValueError("Keep the hull as a variant first, or compare it with another hull")
    return _variant(obj, entry, scale)


def settings_of(obj):
    """The Object.hull of another hull, or the variant, which is of the same form: of a hull that
    has an Other. Not to be kept: Blender may move it in memory."""
    variants = obj.hull.variants
    if variants.compared_with == "HULL":
        return variants.other_hull.hull
    return kept_hulls.chosen(obj)


def _object(obj, other):
    if other is None or not hull_objects.is_hull(other) or other == obj:
        raise ValueError("Choose the other hull first")
    if not other.users_scene:
        raise ValueError(f'"{other.name}" is in no scene any longer: choose another hull')
    state = hull_state.state_of(other)
    if state is None:
        raise ValueError(f'"{other.name}" was not looked at yet: Update Surface and Lines there')
    if state.refusal or state.ship.source is None:
        raise ValueError(state.refusal or f'"{other.name}" has no surface: {state.status}')
    return Other(other.name, state.ship.key, state.ship.source)


def _variant(obj, entry, scale):
    found, state = hull_mesh.read(kept_hulls.as_hull(obj, entry)), hull_state.state_of(obj)
    # Bodies of the mesh that overlap count as those of the hull do.
    once = state.ship.source is not None and state.ship.source.once
    key = (found.topology_key, found.points_digest, scale, found.openings,
           found.data.deck_edge().tobytes(), found.appendages, once)  # fmt: skip
    known = state.of(_Known)
    if known.key != key:
        control = found.control(scale)
        check, mesh = mesh_check.check_control_mesh(found.data, control, found.half)
        if mesh is None:
            raise ValueError(f'"{entry.name}" has no surface: {check.errors[0].message}')
        source = ship.source_of(found, control, _bodies(found, control, scale))
        known.key, known.source = key, replace(source, once=once)
    return Other(entry.name, key, known.source)


def _bodies(found, control, scale):
    """Appendages, none where one of them is no body, as for the hull itself, which says so."""
    try:
        return native_bodies(found.appendages, scale, control.points)
    except ValueError:
        return []
