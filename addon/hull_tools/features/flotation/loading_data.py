# SPDX-License-Identifier: GPL-3.0-or-later
"""How a hull lies and is loaded: from hull_io's HullData to Object.hull, and back."""

from math import degrees, radians

from ....hull_io.ship_data import (
    Afloat,
    DownfloodingPoint,
    Load,
    LoadCase,
    Weight,
    Weights,
    Wind,
    WindArea,
)
from ...bridge.blender.units import as_stored, as_typed
from . import resistance_data

_CENTRE = ("lcg", "tcg", "vcg")


def give_loading(settings, hull, scale):
    """To an Object.hull without load cases and openings; scale: metres of Blender's unit."""
    settings.trim_m = hull.afloat.trim_m / scale
    settings.heel = radians(hull.afloat.heel_deg)
    settings.deck_closed = hull.afloat.deck_closed
    loading, load = settings.loading, hull.load
    loading.use_displacement = load.mass_t is None
    loading.mass_t = load.mass_t or 0.0
    loading.kg = load.kg / scale
    loading.kg_is_guess = load.kg_is_guess
    loading.use_lcb = load.lcg is None
    loading.lcg = (load.lcg or 0.0) / scale
    loading.free_trim = load.free_trim
    loading.loaded, loading.loaded_case = load.loaded.upper(), load.case
    for case in hull.load_cases:
        entry = loading.load_cases.add()
        entry.name, entry.mass_t = case.name, case.mass_t
        for key in _CENTRE:
            setattr(entry, key, getattr(case, key) / scale)
        entry.with_weights, entry.vcg_is_guess = case.with_weights, case.vcg_is_guess
    _give_weights(settings.weights, hull.weights, scale)
    for point in hull.downflooding_points:
        entry = loading.downflooding_points.add()
        entry.name = point.name
        entry.position = [value / scale for value in point.position]
    resistance_data.give(settings.resistance, hull.resistance, scale)
    if hull.wind is not None:
        _give_wind(settings.wind, hull.wind, scale)


def _give_weights(settings, weights, scale):
    settings.thickness, settings.density = weights.thickness / scale, weights.density
    for item in weights.items:
        entry = settings.items.add()
        entry.name, entry.mass_t = item.name, item.mass_t
        for key in _CENTRE:
            setattr(entry, key, getattr(item, key) / scale)


def _give_wind(settings, wind, scale):
    settings.source = "HULL" if wind.hull_profile else "GIVEN"
    for area in wind.areas:
        entry = settings.areas.add()
        entry.name, entry.area, entry.z = area.name, area.area, area.z / scale
    settings.lever = (wind.lever or 0.0) / scale
    settings.pressure = wind.pressure
    settings.keel_area = wind.keel_area
    settings.sharp_bilges = wind.sharp_bilges
    settings.roll_period = wind.roll_period or 0.0


def take_loading(settings, scale):
    """The values for a HullData, by name, of an Object.hull."""
    loading = settings.loading

    def metres(value):
        return as_stored(value) * scale

    return {
        "afloat": Afloat(
            metres(settings.trim_m), as_typed(degrees(settings.heel)), settings.deck_closed
        ),
        "load": Load(
            None if loading.use_displacement else as_stored(loading.mass_t),
            metres(loading.kg),
            None if loading.use_lcb else metres(loading.lcg),
            loading.free_trim,
            loading.kg_is_guess,
            loading.loaded.lower(),
            loading.loaded_case,
        ),
        "load_cases": [
            LoadCase(*_named_mass(case, metres), case.with_weights, case.vcg_is_guess)
            for case in loading.load_cases
        ],
        "weights": Weights(
            metres(settings.weights.thickness),
            as_stored(settings.weights.density),
            [Weight(*_named_mass(item, metres)) for item in settings.weights.items],
        ),
        "downflooding_points": [
            DownfloodingPoint(point.name, tuple(metres(value) for value in point.position))
            for point in loading.downflooding_points
        ],
        "wind": _taken_wind(settings.wind, metres),
        "resistance": resistance_data.taken(settings.resistance, metres),
    }


def _named_mass(entry, metres):
    """Name, mass in t and centre in m of an entry of a list."""
    return entry.name, as_stored(entry.mass_t), *(metres(getattr(entry, key)) for key in _CENTRE)


def _taken_wind(settings, metres):
    """The Wind of an Object.hull.wind; None while its areas are not known."""
    if settings.source == "NONE":
        return None
    return Wind(
        hull_profile=settings.source == "HULL",
        areas=[
            WindArea(entry.name, as_stored(entry.area), metres(entry.z)) for entry in settings.areas
        ],
        lever=metres(settings.lever) or None,
        pressure=as_stored(settings.pressure),
        keel_area=as_stored(settings.keel_area),
        sharp_bilges=settings.sharp_bilges,
        roll_period=as_stored(settings.roll_period) or None,
    )
