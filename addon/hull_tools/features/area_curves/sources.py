# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a target curve comes from: the hull as it is, another hull, a table."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from ....hull_io.area_tables import read_area_table
from ...bridge import limits
from ...bridge.blender import letters, units
from ...bridge.objects import hull_objects
from ..curves_of_form import sectional_areas
from ..flotation import afloat
from ..hull import hull_state
from . import stored, target_curve


def take_present(obj, scene, handles):
    """Makes the hull's curve as it is the target, with so many handles; returns the TargetCurve."""
    found, _ = present(obj, scene)
    return _take(obj, scene, (found.positions, found.areas), handles, "the hull as it was")


def take_from_hull(obj, scene, other, handles, to_length=True, areas_as="VOLUME"):
    """Makes another hull's curve the target, at that one's own draft and trim. to_length: x goes
    with Lpp. areas_as: "SAME", or times what gives it this hull's "VOLUME" or "LARGEST" section.
    Returns the TargetCurve; ValueError with the remedy."""
    if other is None or not hull_objects.is_hull(other) or other == obj:
        raise ValueError("Choose another hull of the scene, whose curve is taken")
    scale = units.metres_per_unit(scene)
    found, where = present(other, scene)
    x, areas = found.positions, found.areas
    if to_length:
        own = afloat.afloat(obj.hull, scale)
        if not (own.length_pp and where.length_pp):
            raise ValueError("Give Lpp of both hulls: the curve is scaled by it")
        x = x * (own.length_pp / where.length_pp)
    curve = target_curve.through(x, areas, _handles(handles))
    if areas_as != "SAME":
        own, _ = present(obj, scene)
        if areas_as == "LARGEST":
            curve = curve.scaled(own.areas.max() / areas.max())
        else:
            curve = curve.scaled(_volume(obj, scene) / curve.volume()[0])
    stored.write(obj, scene, curve, other.name)
    return curve


def take_from_table(obj, scene, path, handles):
    """Makes the curve of a CSV file the target; returns the TargetCurve. HullFileError, which is a
    ValueError, with line and remedy."""
    path = Path(path)
    return _take(obj, scene, read_area_table(path), handles, letters.taken(path.name))


def scale_to_volume(obj, scene, volume=None):
    """Multiplies the target's areas so that its volume is as wanted, m³, or that of the hull;
    returns the TargetCurve."""
    curve = stored.curve(obj, scene)
    wanted = _volume(obj, scene) if volume is None else volume
    limits.within(wanted, "The volume in m³", 1e-6, limits.LONGEST**3)
    curve = curve.scaled(wanted / curve.volume()[0])
    stored.write(obj, scene, curve)
    return curve


def present(obj, scene):
    """(sectional_areas.Areas of a hull as it is, upright; its Afloat), as close as can be."""
    state, where = _upright(obj, scene)
    found = sectional_areas.compute(state.ship.source.alone.new_ship(), where).areas
    wet = np.flatnonzero(found.areas > 0.0)
    if len(wet) < 3:
        raise ValueError("Nothing of the hull is immersed: raise the draft first")
    # One dry station at either end is the curve's foot.
    part = slice(max(wet[0] - 1, 0), wet[-1] + 2)
    return replace(found, positions=found.positions[part], areas=found.areas[part]), where


def _volume(obj, scene):
    state, where = _upright(obj, scene)
    return state.ship.source.alone.new_ship().hydrostatics(where).displaced_volume


def _upright(obj, scene):
    """(HullState, Afloat) of a hull as it is; ValueError where it heels."""
    state = hull_state.up_to_date(obj, scene)
    where = afloat.afloat(obj.hull, units.metres_per_unit(scene))
    if where.heel:
        raise ValueError("Area curves are of the ship upright: set the heel to zero first")
    return state, where


def _take(obj, scene, stations, handles, source):
    curve = target_curve.through(*stations, _handles(handles))
    stored.write(obj, scene, curve, source)
    return curve


def _handles(count):
    return int(limits.within(count, "The number of handles", 3, limits.MOST_AREA_HANDLES))
