# SPDX-License-Identifier: GPL-3.0-or-later
"""What the 3D view shows of a hull's shape fields: their bases, and lines of equal intensity of the
one that is chosen. It follows the hull and the fields; drawing computes nothing."""

from dataclasses import dataclass, field

from ...bridge.blender import units
from ...bridge.objects import curve_lines
from ..hull import hull_state
from . import prepared, preview, seen_bases, seen_lines


@dataclass
class Seen:
    """Of one hull. bases: seen_bases.Base of the fields that are on; chosen: that of the chosen
    one, on or not, or None; lines: its seen_lines.Lines, or None."""

    bases: list = field(default_factory=list)
    chosen: object = None
    lines: object = None
    known: object = field(default_factory=seen_lines.Known)
    key: tuple = None  # what all of it was computed for


def of_hull(obj):
    """The Seen of a hull of which something is known, else None."""
    return hull_state.known(obj, Seen)


def follow(obj, scene):
    """Brings what is seen of a hull's fields up to date with the hull, after its preview."""
    state = hull_state.state_of(obj)
    if state is None:
        return
    seen, settings = state.of(Seen), obj.hull.fields
    if not (settings.show_fields and settings.fields) or state.ship.surface is None:
        vars(seen).update(vars(Seen()))
        return
    if state.status:  # the last good surface is shown still, with what belongs to it
        return
    scale = units.metres_per_unit(scene)
    ground, surface_key = _at_start(obj, state, scale)
    fields = tuple(
        (each.use, each.falloff, seen_lines.values_of(each), preview.base_of(each, obj))
        for each in settings.fields
    )
    samples = seen_lines.samples_of(obj, ground.surface)
    key = (state.ship.geometry_key, surface_key, scale, samples, settings.active_field, fields)
    if seen.key == key:
        return
    found = seen_bases.found(obj, ground)
    seen.bases = [base for number, base in found.items() if settings.fields[number].use]
    seen.chosen, seen.lines, seen.key = found.get(settings.active_field), None, key
    if seen.chosen is not None:
        shown = state.ship.surface
        seen.lines = seen_lines.found(obj, seen.chosen, seen.known, shown, ground)


def follow_curves(changed, scene, view_layer):
    """The same of the hulls in a view layer with fields whose curves are among changed objects or
    were deleted: of these nothing else is told."""
    with curve_lines.read_once():
        for obj, _ in hull_state.known_hulls(view_layer):
            if preview.has_other_curves(obj, changed):
                follow(obj, scene)


def _at_start(obj, state, scale):
    """(prepared.Ground, the key of its surface) of the hull as it is without a preview."""
    previewed = preview.of_hull(obj)
    if previewed is not None and previewed.own is not None:
        return previewed.own, previewed.own.key
    source = state.ship.source
    ground = prepared.Ground(scale, source.control, state.ship.surface, source.half)
    return ground, state.ship.geometry_key
