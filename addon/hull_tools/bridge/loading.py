# SPDX-License-Identifier: GPL-3.0-or-later
"""The lists of Object.hull.loading: load cases, and openings that flood the ship."""

from . import hull_state, units


def add_load_case(obj, scene):
    """A load case of the displacement and LCB at hand, on which one goes on; returns it."""
    loading = obj.hull.loading
    found = hull_state.refresh(obj, scene).hydrostatics
    case = loading.load_cases.add()
    case.name = f"Load case {len(loading.load_cases)}"
    case.vcg = loading.kg
    if found is not None:
        case.mass_t = found.displacement_t
        case.lcg = found.lcb / units.metres_per_unit(scene)
    loading.active_load_case = len(loading.load_cases) - 1
    return case


def add_flooding_point(obj):
    """An opening at the side of the deck amidships; returns it."""
    settings, loading = obj.hull, obj.hull.loading
    point = loading.flooding_points.add()
    point.name = f"Opening {len(loading.flooding_points)}"
    point.position = (0.5 * settings.length_pp, 0.5 * settings.beam, settings.depth)
    loading.active_flooding_point = len(loading.flooding_points) - 1
    return point


def remove_load_case(obj):
    loading = obj.hull.loading
    loading.active_load_case = _removed(obj, loading.load_cases, loading.active_load_case)


def remove_flooding_point(obj):
    loading = obj.hull.loading
    loading.active_flooding_point = _removed(
        obj, loading.flooding_points, loading.active_flooding_point
    )


def _removed(obj, entries, index):
    """Removes the entry at an index; returns the index of the one to be chosen then."""
    entries.remove(min(max(index, 0), len(entries) - 1))
    obj.update_tag(refresh={"DATA"})
    return max(min(index, len(entries) - 1), 0)
