# SPDX-License-Identifier: GPL-3.0-or-later
"""What a hull file tells of how the hull lies and is loaded: m, t and degrees.

    "afloat": {"trim": m by the stern, "heel_deg": degrees to starboard, "deck_closed": true},
    "load": {"mass_t": t, "kg": m, "kg_is_guess": false, "lcg": m, "free_trim": true,
             "loaded": "typed", "case": "..."},
    "load_cases": [{"name": "...", "mass_t": t, "lcg": m, "tcg": m, "vcg": m,
                    "with_weights": false, "vcg_is_guess": false}, ...],
    "openings": [{"name": "...", "position": [x, y, z]}, ...],
    "wind": {"hull_profile": true, "areas": [{"name": "...", "area": m2, "z": m}, ...], "lever": m,
             "pressure": Pa, "keel_area": m2, "sharp_bilges": false, "roll_period": s}

All may be left out; without "wind" the wind areas are not known. A load without mass_t is the
displacement afloat, one without lcg has it above the centre of buoyancy; "loaded" is "typed",
"weights" or, for the load case that is named, "case". Centres that are left out are 0.
"""

from .limits import (
    FURTHEST_POINT,
    HEAVIEST_LOAD,
    LARGEST_WIND_AREA,
    LONGEST_DIMENSION,
    LONGEST_ROLL_PERIOD,
    MAX_LOADING_ENTRIES,
    STRONGEST_WIND,
)
from .ship_data import LOADED, Afloat, DownfloodingPoint, Load, LoadCase, Wind, WindArea

KEYS = ("afloat", "load", "load_cases", "openings", "wind")


def parsed(check, content):
    """Values for a HullData by name, of the content of a hull file; raises HullFileError."""
    return {
        "afloat": _afloat(check, content.get("afloat", {})),
        "load": _load(check, content.get("load", {})),
        "load_cases": _listed(check, content, "load_cases", _load_case),
        "downflooding_points": _listed(check, content, "openings", _downflooding_point),
        "wind": _wind(check, content["wind"]) if "wind" in content else None,
    }


def _length(check, value, where):
    return check.number(value, where, -LONGEST_DIMENSION, LONGEST_DIMENSION)


def _afloat(check, value):
    entries = check.object(value, "afloat", ("trim", "heel_deg", "deck_closed"))
    return Afloat(
        trim_m=_length(check, entries.get("trim", 0), "afloat.trim"),
        heel_deg=check.number(entries.get("heel_deg", 0), "afloat.heel_deg", -180.0, 180.0),
        deck_closed=check.flag(entries.get("deck_closed", True), "afloat.deck_closed"),
    )


def _load(check, value):
    known = ("mass_t", "kg", "kg_is_guess", "lcg", "free_trim", "loaded", "case")
    entries = check.object(value, "load", known)
    load = Load(
        kg=check.number(entries.get("kg", 0), "load.kg", 0.0, LONGEST_DIMENSION),
        kg_is_guess=check.flag(entries.get("kg_is_guess", False), "load.kg_is_guess"),
        free_trim=check.flag(entries.get("free_trim", True), "load.free_trim"),
        loaded=check.choice(entries.get("loaded", "typed"), "load.loaded", LOADED),
        case=check.text(entries.get("case", ""), "load.case"),
    )
    if "mass_t" in entries:
        load.mass_t = check.number(entries["mass_t"], "load.mass_t", 0.0, HEAVIEST_LOAD)
    if "lcg" in entries:
        load.lcg = _length(check, entries["lcg"], "load.lcg")
    return load


def _listed(check, content, key, parse, parent=""):
    where = f"{parent}{key}"
    entries = check.list(content.get(key, []), where)
    if len(entries) > MAX_LOADING_ENTRIES:
        raise check.error(
            where, f"it has {len(entries)} entries", f"write at most {MAX_LOADING_ENTRIES}"
        )
    return [parse(check, entry, f"{where}[{index}]") for index, entry in enumerate(entries)]


def _load_case(check, value, where):
    known = ("name", "mass_t", "lcg", "tcg", "vcg", "with_weights", "vcg_is_guess")
    entries = check.object(value, where, known)
    if "mass_t" not in entries:
        raise check.error(f"{where}.mass_t", "it is missing", "add the mass in t")
    centre = {
        key: _length(check, entries.get(key, 0), f"{where}.{key}") for key in ("lcg", "tcg", "vcg")
    }
    return LoadCase(
        name=check.text(entries.get("name", "Load case"), f"{where}.name"),
        mass_t=check.number(entries["mass_t"], f"{where}.mass_t", 0.0, HEAVIEST_LOAD),
        with_weights=check.flag(entries.get("with_weights", False), f"{where}.with_weights"),
        vcg_is_guess=check.flag(entries.get("vcg_is_guess", False), f"{where}.vcg_is_guess"),
        **centre,
    )


def _downflooding_point(check, value, where):
    entries = check.object(value, where, ("name", "position"))
    if "position" not in entries:
        raise check.error(f"{where}.position", "it is missing", "add [x, y, z] in m")
    position = check.list(entries["position"], f"{where}.position", 3)
    return DownfloodingPoint(
        name=check.text(entries.get("name", "Opening"), f"{where}.name"),
        position=tuple(
            check.number(number, f"{where}.position.{axis}", -FURTHEST_POINT, FURTHEST_POINT)
            for axis, number in zip("xyz", position)
        ),
    )


def _wind(check, value):
    known = ("hull_profile", "areas", "lever", "pressure", "keel_area", "sharp_bilges",
             "roll_period")  # fmt: skip
    entries = check.object(value, "wind", known)

    def number(key, default, greatest):
        return check.number(entries.get(key, default), f"wind.{key}", 0.0, greatest)

    wind = Wind(
        hull_profile=check.flag(entries.get("hull_profile", True), "wind.hull_profile"),
        areas=_listed(check, entries, "areas", _wind_area, "wind."),
        pressure=number("pressure", Wind.pressure, STRONGEST_WIND),
        keel_area=number("keel_area", 0, LARGEST_WIND_AREA),
        sharp_bilges=check.flag(entries.get("sharp_bilges", False), "wind.sharp_bilges"),
    )
    if "lever" in entries:
        wind.lever = number("lever", 0, LONGEST_DIMENSION)
    if "roll_period" in entries:
        wind.roll_period = number("roll_period", 0, LONGEST_ROLL_PERIOD)
    return wind


def _wind_area(check, value, where):
    entries = check.object(value, where, ("name", "area", "z"))
    if "area" not in entries:
        raise check.error(f"{where}.area", "it is missing", "add the area in m²")
    return WindArea(
        name=check.text(entries.get("name", "Wind area"), f"{where}.name"),
        area=check.number(entries["area"], f"{where}.area", 0.0, LARGEST_WIND_AREA),
        z=_length(check, entries.get("z", 0), f"{where}.z"),
    )


def entries(data):
    """What a hull file says of a HullData, by its keys."""
    load = {"kg": float(data.load.kg), "free_trim": bool(data.load.free_trim)}
    if data.load.kg_is_guess:
        load["kg_is_guess"] = True
    if data.load.loaded != "typed":
        load["loaded"] = data.load.loaded
    if data.load.case:
        load["case"] = data.load.case
    for key in ("mass_t", "lcg"):
        if getattr(data.load, key) is not None:
            load[key] = float(getattr(data.load, key))
    found = {
        "afloat": {
            "trim": float(data.afloat.trim_m),
            "heel_deg": float(data.afloat.heel_deg),
            "deck_closed": bool(data.afloat.deck_closed),
        },
        "load": load,
        "load_cases": [
            {
                "name": case.name,
                "mass_t": float(case.mass_t),
                "lcg": float(case.lcg),
                "tcg": float(case.tcg),
                "vcg": float(case.vcg),
                **({"with_weights": True} if case.with_weights else {}),
                **({"vcg_is_guess": True} if case.vcg_is_guess else {}),
            }
            for case in data.load_cases
        ],
        "openings": [
            {"name": point.name, "position": [float(part) for part in point.position]}
            for point in data.downflooding_points
        ],
    }
    if data.wind is not None:
        found["wind"] = _wind_entries(data.wind)
    return found


def _wind_entries(wind):
    found = {
        "hull_profile": bool(wind.hull_profile),
        "areas": [
            {"name": part.name, "area": float(part.area), "z": float(part.z)} for part in wind.areas
        ],
        "pressure": float(wind.pressure),
        "keel_area": float(wind.keel_area),
        "sharp_bilges": bool(wind.sharp_bilges),
    }
    for key in ("lever", "roll_period"):
        if getattr(wind, key) is not None:
            found[key] = float(getattr(wind, key))
    return found
