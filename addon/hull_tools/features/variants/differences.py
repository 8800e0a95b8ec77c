# SPDX-License-Identifier: GPL-3.0-or-later
"""The differences of all particulars between a hull and the other hull: each at its own draft, trim
and heel, and both at those of the hull. A difference is the hull's value less the other's."""

from dataclasses import dataclass, replace

import numpy as np

from ...bridge import native
from ..flotation import afloat, hydrostatics
from ..flotation.ship import Ship
from ..lines import line_places
from . import other_hull

IS_LIVE = False

_COLUMNS = tuple(
    f"{what}, {how} draft [{unit}]"
    for how in ("own", "same")
    for what, unit in (("other hull", "see unit"), ("difference", "see unit"), ("part", "%"))
)


@dataclass(frozen=True)
class Inputs:
    """where, other_where: afloat.Afloat of both; places: line_places.LinePlaces of the hull."""

    where: afloat.Afloat
    other: other_hull.Other
    other_where: afloat.Afloat
    places: line_places.LinePlaces


@dataclass(frozen=True, eq=False)
class Compared:
    """rows: hull_native.Difference by name of the hydrostatics.QUANTITIES, of which values and what
    follows from them are None where they are undefined; areas: hull_native.AreaDifference. Both
    are empty where the other hull does not float there; message says so."""

    rows: dict
    areas: object = None
    message: str = ""


@dataclass(frozen=True, eq=False)
class Result:
    """by: Compared by Object.hull.variants.afloat: "OWN" draft, trim and heel, "SAME"."""

    name: str
    by: dict


def inputs(settings, metres_per_unit):
    obj = settings.id_data
    other = other_hull.of(obj, metres_per_unit)
    return Inputs(
        afloat.afloat(settings, metres_per_unit),
        other,
        afloat.afloat(other_hull.settings_of(obj), metres_per_unit),
        line_places.line_places(settings, metres_per_unit),
    )


def compute(ship, wanted):
    """Result; ValueError where the hull itself has nothing under water."""
    other = wanted.other.source.new_ship()
    found = ship.hydrostatics(wanted.where)
    by = {}
    for name, where in (("OWN", wanted.other_where), ("SAME", wanted.where)):
        ship.tell(len(by), 2)
        try:
            by[name] = _compared(ship, found, wanted, other, where)
        except ValueError as error:
            by[name] = Compared({}, message=f"{wanted.other.name}: {error}")
    return Result(wanted.other.name, by)


def _compared(ship, found, wanted, other, where):
    others = other.hydrostatics(where)
    values = hydrostatics.described(found, wanted.where)
    other_values = hydrostatics.described(others, where)
    rows = {}
    for quantity in hydrostatics.QUANTITIES:
        value, beside = getattr(values, quantity.name), getattr(other_values, quantity.name)
        row = native.require().difference(quantity.path, found, others, where.length_pp)
        is_defined = None not in (value, beside)
        rows[quantity.name] = replace(
            row, value=value, other=beside, percent=row.percent if is_defined else None
        )
    areas = native.require().compare_areas(
        _as_compared(ship, wanted.where),
        _as_compared(other, where),
        stations=_stations(wanted.places, ship, other),
    )
    return Compared(rows, areas)


def _as_compared(ship: Ship, where):
    return native.require().ComparedHull(ship.body, **where.position())


def _stations(places, *ships):
    """Those of the lines plan, as far as either hull reaches; None without any."""
    points = np.concatenate([ship.body.surface.mesh.points for ship in ships])
    return places.positions(points)[0] or None


def header(result):
    return ["quantity", "unit", "this hull [see unit]", *_COLUMNS, "compared with"]


def rows(result):
    own, same = result.by["OWN"], result.by["SAME"]
    for quantity in hydrostatics.QUANTITIES:
        found = [one.rows.get(quantity.name) for one in (own, same)]
        value = next((row.value for row in found if row is not None), None)
        cells = _shown(quantity, value), *_cells(quantity, found)
        yield [quantity.title, quantity.unit, *cells, result.name]
    for title, unit, name in (
        ("largest difference of sectional areas", "m2", "largest"),
        ("its station from AP", "m", "largest_at"),
    ):
        yield [title, unit, None, *_of_areas(own, same, name), result.name]


def _cells(quantity, found):
    for row in found:
        if row is None:
            yield from (None, None, None)
        else:
            yield from (_shown(quantity, row.other), _shown(quantity, row.difference), row.percent)


def _shown(quantity, value):
    """In the unit of the table: angles are in degrees there."""
    return np.degrees(value) if quantity.unit == "deg" and value is not None else value


def _of_areas(own, same, name):
    for one in (own, same):
        yield from (None, None if one.areas is None else getattr(one.areas, name), None)
