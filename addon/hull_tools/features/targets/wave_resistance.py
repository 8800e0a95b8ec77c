# SPDX-License-Identifier: GPL-3.0-or-later
"""Wave resistance as a number that is wanted: at the speed of a row, by Michell's integral."""

from dataclasses import dataclass, field

from ...bridge import limits, native
from ...bridge.blender import units
from ..flotation import afloat
from ..hull import hull_state
from ..resistance.asked import KNOT


@dataclass
class KnownWaves:
    """kN by speed in m/s of the hull and the water of a key."""

    key: object = None
    values: dict = field(default_factory=dict)


def speed_of(row):
    """m/s."""
    return (
        limits.within(units.as_typed(row.speed_kn), "The speed in kn", 0.0, limits.FASTEST) * KNOT
    )


def known(row, obj, state, scene):
    """The wave resistance at a row's speed, kN, of a hull with its HullState, if it was computed of
    the hull as it is and lies; else None."""
    of_hull = state.of(KnownWaves)
    try:
        is_current = of_hull.key == _key(state, _where(obj, scene))
        return of_hull.values.get(speed_of(row)) if is_current else None
    except ValueError:  # it lies as no ship can
        return None


def compute(row, obj, scene):
    """Computes it; does nothing where a hull has none: it heels, is dry or the speed is none."""
    state = hull_state.state_of(obj)
    if state is None or state.status or state.ship.surface is None:
        return
    try:
        where = _where(obj, scene)
        position = where.position()
        key = _key(state, where)
        of_hull = state.of(KnownWaves)
        if of_hull.key != key:
            of_hull.key, of_hull.values = key, {}
        if position.pop("heel") == 0.0:
            source = state.ship.source
            found = source.own_ship() if source.is_joined else source.ship
            integral = native.require().MichellIntegral(
                found.body, water_density=where.water_density, **position
            )
            speed = speed_of(row)
            of_hull.values[speed] = integral.resistance([speed])[0].resistance
    except ValueError:
        return  # solving says why


def _where(obj, scene):
    return afloat.afloat(obj.hull, units.metres_per_unit(scene))


def _key(state, where):
    return state.ship.geometry_key, where
