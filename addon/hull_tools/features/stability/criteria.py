# SPDX-License-Identifier: GPL-3.0-or-later
"""The criteria of the 2008 IS Code, Part A, for the load of the stability panel: 2.2, and 2.3 where
the wind areas are known."""

from dataclasses import dataclass
from math import degrees

from ...bridge import native
from ..hull import deck_edge
from . import loads, wind

IS_LIVE = False

GENERAL, WEATHER = "2.2", "2.3"
NAMES = {GENERAL: "GZ and GM", WEATHER: "Severe wind and rolling"}
_NO_WIND = "The wind areas are not known: give them under Wind and Rolling."


@dataclass(frozen=True)
class Inputs:
    load: loads.LoadInputs
    wind: object  # wind.WindInputs, None while the areas are not known


@dataclass(frozen=True)
class Result:
    """report: hull_native.StabilityReport. weather: hull_native.WeatherCriterion, or None and the
    reason in no_weather. remarks: sentences about what all of it rests on."""

    report: object
    weather: object
    no_weather: str
    remarks: tuple

    @property
    def criteria(self):
        found = list(self.report.criteria)
        return found + list(self.weather.criteria) if self.weather else found

    def outcomes(self):
        """(paragraph of Part A, outcome, the paragraphs that are not met) of 2.2 and of 2.3."""
        yield (GENERAL, *_outcome(self.report.criteria))
        if self.weather:
            yield (WEATHER, *_outcome(self.weather.criteria))
        else:
            yield (WEATHER, "not computed", [])

    def notes(self):
        """All that is to be said, each sentence once."""
        notes = [one.note for one in self.criteria]
        return list(dict.fromkeys(note for note in (*self.remarks, *notes) if note))


def is_within_limit(one):
    """Whether the value of a hull_native.Criterion is: it fails all the same where the curve of
    levers ends too early, which its note tells."""
    if one.value is None:
        return False
    return one.value >= one.limit if one.bound == "at least" else one.value <= one.limit


def _outcome(criteria):
    failed = list(dict.fromkeys(one.paragraph for one in criteria if one.outcome == "fail"))
    if failed:
        return "fail", failed
    passes = all(one.outcome == "pass" for one in criteria)
    return "pass" if passes else "not computed", []


def inputs(settings, metres_per_unit):
    return of_inputs(settings, metres_per_unit, loads.load_inputs(settings, metres_per_unit))


def of_inputs(settings, metres_per_unit, load):
    """The Inputs of an Object.hull with loads.LoadInputs."""
    return Inputs(load, wind.wind_inputs(settings, metres_per_unit))


def compute(ship, given):
    return of_load(ship, loads.load(ship, given.load), given)


def of_load(ship, load, given):
    """The Result of a loads.Load."""
    arguments = {
        **load.arguments(given.load),
        "downflooding_points": given.load.downflooding_points or None,
        "deck_edge": deck_edge.points_of(ship.body.surface, ship.deck_edge),
    }
    report = native.require().stability_criteria(ship.body, **arguments)
    weather, no_weather = _weather(ship.body, given, arguments)
    return Result(report, weather, no_weather, tuple(_remarks(report, load)))


def _weather(body, given, arguments):
    if given.wind is None:
        return None, _NO_WIND
    where = given.load.where
    try:
        found = native.require().weather_criterion(
            body,
            **arguments,
            **given.wind.arguments(),
            midship=where.draft_at,
            beam=where.beam or None,
        )
    except ValueError as error:
        return None, str(error)
    return found, ""


def _remarks(report, load):
    yield from loads.remarks(load)
    if report.deck_edge_heel == 0.0:
        yield loads.DECK_EDGE_UNDER_WATER


def shown(value, unit):
    """(value, unit) as people read them: degrees instead of radians."""
    if unit == "rad":
        return (None if value is None else degrees(value)), "deg"
    return value, unit.replace("·", " ")


def header(result):
    # Paragraphs by themselves would pass for dates.
    return ["paragraph of the 2008 IS Code", "criterion", "value [see unit]", "bound",
            "limit [see unit]", "unit", "outcome", "note"]  # fmt: skip


def rows(result):
    for one in result.criteria:
        value, unit = shown(one.value, one.unit)
        limit, _ = shown(one.limit, one.unit)
        yield [f"Part A {one.paragraph}", one.name, value, one.bound, limit, unit, one.outcome,
               one.note]  # fmt: skip
    if result.weather is None:
        yield [f"Part A {WEATHER}", NAMES[WEATHER], None, None, None, None, "not computed",
               result.no_weather]  # fmt: skip
    else:
        for paragraph, name, value, unit in weather_numbers(result.weather):
            value, unit = shown(value, unit)
            yield [f"Part A {paragraph}", name, value, None, None, unit, None, None]
    for remark in result.remarks:
        yield [None, "remark", None, None, None, None, None, remark]


def weather_numbers(found):
    """(paragraph, name, value, unit) of what the criterion follows from; None: not to be had."""
    roll = found.roll
    yield "2.3.2", "Wind area A", found.wind_area, "m2"
    yield "2.3.2", "Lever Z", found.wind_lever, "m"
    yield "2.3.2", "Steady wind lw1", found.steady_lever, "m"
    yield "2.3.2", "Gust lw2", found.gust_lever, "m"
    yield "2.3.1", "Heel under steady wind φ0", found.steady_heel, "rad"
    yield "2.3.4", "Angle of roll φ1", roll and roll.angle, "rad"
    yield "2.3.1", "End of area b φ2", found.last_heel, "rad"
    yield "2.3.1", "Area a", found.area_a, "m·rad"
    yield "2.3.1", "Area b", found.area_b, "m·rad"
    yield "2.3.4", "Period T", roll and roll.period, "s"
    for name in ("k", "X1", "X2", "r", "s"):
        yield "2.3.4", f"Factor {name}", roll and getattr(roll, name.lower()), ""
