# SPDX-License-Identifier: GPL-3.0-or-later
"""What Object.hull.targets asks for, as hull_native takes it."""

from ...bridge import limits, native
from ...bridge.blender import units
from ..flotation import afloat
from . import quantities, rows, wave_resistance

DIMENSIONS = ("length", "beam", "draft")


def told(obj):
    """Pairs (Quantity, what is asked for in short) of the rows in use."""
    return [(quantities.quantity_of(row), rows.wanted(row)) for row in rows.in_use(obj)]


def form_target(row, obj, scale):
    """The hull_native.FormTarget of a row."""
    quantity = quantities.quantity_of(row)
    afloat.afloat(obj.hull, scale).check_given(quantity.number, quantity.label)
    value, tolerance = units.as_typed(row.value), units.as_typed(row.tolerance)
    limits.within(
        value, f"The wanted {quantity.label}", -limits.GREATEST_TARGET, limits.GREATEST_TARGET
    )
    limits.within(tolerance, f"The tolerance of {quantity.label}", 0.0, limits.GREATEST_TARGET)
    if quantity.identifier == quantities.GM:
        value += rows.kg_of(obj, scale)
    station = {}
    if quantity.identifier == quantities.SECTION:
        station["station"] = units.as_typed(row.station) * scale
    if quantity.identifier == quantities.WAVES:
        station["speed"] = wave_resistance.speed_of(row)
    return native.require().FormTarget(
        quantity.number, value, tolerance=tolerance, sense=row.sense, **station
    )


def options(obj, source, scale):
    """How the ship of a flotation.ship.ShipSource lies in the water, her dimensions and what may
    become of them, as keyword arguments. ValueError for a ship that heels."""
    settings = obj.hull.targets
    where = afloat.afloat(obj.hull, scale)
    if where.heel != 0.0:
        raise ValueError("Targets are of the ship upright: set Heel to 0 first")
    limits.within(settings.stiffness, "Fairness", 0.0, limits.GREATEST_TARGET_STIFFNESS)
    position = where.position()
    del position["heel"]
    return {
        "mirrored": source.half,
        "openings": source.openings,
        "stiffness": settings.stiffness,
        **position,
        **where.project(),
        **_scales(settings),
    }


def _scales(settings):
    scales = {}
    for name in DIMENSIONS:
        change = 0.01 * getattr(settings, f"{name}_change")
        limits.within(change, f"The change of {name}", 0.0, 0.01 * limits.GREATEST_DIMENSION_CHANGE)
        if getattr(settings, f"free_{name}"):
            scales[f"{name}_scale"] = (1.0 - change, 1.0 + change)
    return scales
