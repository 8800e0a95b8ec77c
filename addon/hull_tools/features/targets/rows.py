# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of Object.hull.targets: what they ask for, what is at present, how they come and go."""

from contextlib import contextmanager
from dataclasses import dataclass

from ...bridge import limits, native
from ...bridge.blender import units
from ..flotation import afloat, hydrostatics
from ..hull import hull_state
from . import quantities, wave_resistance


@dataclass
class OwnNumbers:
    """hydrostatics.HydrostaticValues of a hull without its appendages, of which targets are, or
    None; by what they are of."""

    values: object = None
    key: tuple = None


def follow(obj, scene):
    """Brings them up to date, where rows ask for them and they are others than the hull's."""
    state = hull_state.state_of(obj)
    if state is None or state.status or not (obj.hull.targets.rows and _is_joined(state)):
        return
    own = state.of(OwnNumbers)
    try:
        where = afloat.afloat(obj.hull, units.metres_per_unit(scene))
        key = state.ship.key, where
        if own.key != key:
            own.key, own.values = key, None
            found = state.ship.source.own_ship().hydrostatics(where)
            own.values = hydrostatics.described(found, where)
    except ValueError:
        return  # the panel Hydrostatics says why


def _is_joined(state):
    return state.ship.source is not None and state.ship.source.is_joined


def _values(state):
    """The hydrostatics.HydrostaticValues that targets begin with, as last computed, or None."""
    return state.of(OwnNumbers).values if _is_joined(state) else state.hydrostatics.values


def in_use(obj):
    rows = [row for row in obj.hull.targets.rows if row.use]
    if not rows:
        raise ValueError("Add a target first, and switch it on")
    limits.at_most(len(rows), "targets", limits.MOST_TARGETS)
    return rows


def wanted(row):
    """What a row asks for, in short."""
    sign = {"equal": "=", "at least": "≥", "at most": "≤"}[row.sense]
    return f"{sign} {units.as_typed(row.value):g}"


def kg_of(obj, scale):
    return units.as_typed(obj.hull.loading.kg) * scale


@contextmanager
def kg_stays(obj, told):
    """A hull may be scaled here: where a GM is wanted, told as pairs (Quantity, …), its KG does not
    go along, for that is what KMt was found by."""
    loading = obj.hull.loading
    before = loading.kg, loading.kg_is_guess
    yield
    if any(quantity.identifier == quantities.GM for quantity, _ in told):
        loading.kg, loading.kg_is_guess = before


def present(row, obj, scene):
    """What a row's number is of the hull as it was last computed, in its unit; None: not known."""
    state = hull_state.state_of(obj)
    values = None if state is None else _values(state)
    if values is None:
        return None
    quantity = quantities.quantity_of(row)
    if quantity.identifier == quantities.WAVES:
        return wave_resistance.known(row, obj, state, scene)
    if quantity.identifier == quantities.GM:
        return values.kmt - kg_of(obj, units.metres_per_unit(scene))
    return getattr(values, _NAMES.get(quantity.number, quantity.number.replace(".", "_")), None)


# Names in flotation.hydrostatics that are not hull_native's.
_NAMES = {
    "midship_section.area": "midship_area",
    "km_transverse": "kmt",
    "km_longitudinal": "kml",
    "bm_transverse": "bmt",
}


def add_row(obj, quantity=None):
    """A row of a hull's targets with the present value as the wanted one; returns it."""
    settings = obj.hull.targets
    limits.at_most(len(settings.rows) + 1, "targets", limits.MOST_TARGETS)
    row = settings.rows.add()
    if quantity is not None:
        row.quantity = quantity
    settings.active_row = len(settings.rows) - 1
    return row


def take_present(row, obj, scene):
    """Makes the present value of a row's number the wanted one, where it is known."""
    follow(obj, scene)
    if row.quantity == quantities.WAVES:
        wave_resistance.compute(row, obj, scene)
    is_section = row.quantity == quantities.SECTION
    value = _section_area(row, obj, scene) if is_section else present(row, obj, scene)
    if value is not None:
        row.value = value


def _section_area(row, obj, scene):
    """At a row's station of the hull as it is, m²; None where it has none, or heels."""
    state = hull_state.state_of(obj)
    if state is None or state.status:
        return None
    scale = units.metres_per_unit(scene)
    station = units.as_typed(row.station) * scale
    try:
        position = afloat.afloat(obj.hull, scale).position()
        if position.pop("heel") != 0.0:
            return None
        body = state.ship.source.own_ship().body
        return float(native.require().section_areas(body, [station], **position).areas[0])
    except ValueError:
        return None  # solving says why


def chosen_row(obj):
    """The row that is chosen; ValueError without one."""
    settings = obj.hull.targets
    if not 0 <= settings.active_row < len(settings.rows):
        raise ValueError("Choose a target first")
    return settings.rows[settings.active_row]


def remove_row(obj):
    """Removes the row that is chosen."""
    settings = obj.hull.targets
    if not settings.rows:
        raise ValueError("There is no target")
    index = min(max(settings.active_row, 0), len(settings.rows) - 1)
    settings.rows.remove(index)
    settings.active_row = max(min(index, len(settings.rows) - 1), 0)
