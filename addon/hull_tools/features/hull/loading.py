# SPDX-License-Identifier: GPL-3.0-or-later
"""The lists of Object.hull about loads: load cases, openings that flood the ship, wind areas."""

from ...bridge.blender import units
from . import hull_state

# By list: the group of Object.hull that has it, and which of its entries is chosen there.
_LISTS = {
    "load_cases": ("loading", "active_load_case"),
    "downflooding_points": ("loading", "active_downflooding_point"),
    "areas": ("wind", "active_area"),
    "items": ("weights", "active_item"),
}


def _new_name(word, entries):
    """The word with a number, that none of the entries has: that of the last one, or higher."""
    taken = {entry.name for entry in entries}
    number = len(entries)
    while f"{word} {number}" in taken:
        number += 1
    return f"{word} {number}"


def add_load_case(obj, scene):
    """A load case of the displacement and LCB at hand, on which one goes on; returns it."""
    loading = obj.hull.loading
    found = hull_state.refresh(obj, scene).hydrostatics.values
    case = loading.load_cases.add()
    case.name = _new_name("Load case", loading.load_cases)
    case.vcg = loading.kg
    case.vcg_is_guess = loading.kg_is_guess
    if found is not None:
        case.mass_t = found.displacement_t
        case.lcg = found.lcb / units.metres_per_unit(scene)
    loading.active_load_case = len(loading.load_cases) - 1
    return case


def add_downflooding_point(obj):
    """An opening at the side of the deck amidships; returns it."""
    settings, loading = obj.hull, obj.hull.loading
    point = loading.downflooding_points.add()
    point.name = _new_name("Opening", loading.downflooding_points)
    point.position = (0.5 * settings.length_pp, 0.5 * settings.beam, settings.depth)
    loading.active_downflooding_point = len(loading.downflooding_points) - 1
    return point


def add_wind_area(obj):
    """An area above the deck, of no size as yet; returns it."""
    settings, wind = obj.hull, obj.hull.wind
    area = wind.areas.add()
    area.name = _new_name("Wind area", wind.areas)
    area.z = settings.depth
    wind.active_area = len(wind.areas) - 1
    return area


def add_weight(obj):
    """A weight amidships, of no mass as yet; returns it."""
    settings, weights = obj.hull, obj.hull.weights
    item = weights.items.add()
    item.name = _new_name("Weight", weights.items)
    item.lcg, item.vcg = 0.5 * settings.length_pp, settings.depth
    weights.active_item = len(weights.items) - 1
    return item


def entries_of(obj, name):
    """The list of that name: "load_cases", "downflooding_points", "areas" of the wind or "items"
    of the weights."""
    return getattr(getattr(obj.hull, _LISTS[name][0]), name)


def remove(obj, name):
    """Removes the chosen entry of the list of that name."""
    group, active = _LISTS[name]
    settings, listed = getattr(obj.hull, group), entries_of(obj, name)
    index = getattr(settings, active)
    listed.remove(min(max(index, 0), len(listed) - 1))
    setattr(settings, active, max(min(index, len(listed) - 1), 0))
    obj.update_tag(refresh={"DATA"})
