# SPDX-License-Identifier: GPL-3.0-or-later
"""The lists of Object.hull.loading: load cases, and openings that flood the ship."""

from ...bridge.blender import units
from . import hull_state

_ACTIVE = {"load_cases": "active_load_case", "flooding_points": "active_flooding_point"}


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


def remove(obj, entries):
    """Removes the chosen entry of "load_cases" or "flooding_points"."""
    loading, active = obj.hull.loading, _ACTIVE[entries]
    index, listed = getattr(loading, active), getattr(loading, entries)
    listed.remove(min(max(index, 0), len(listed) - 1))
    setattr(loading, active, max(min(index, len(listed) - 1), 0))
    obj.update_tag(refresh={"DATA"})
