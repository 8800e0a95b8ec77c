# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape fields of a study: their description, and the hull_native.ShapeFields it stands for."""

import hull_native as hn
import numpy as np
from hull_io.checked_json import shown

from .values import number, numbers

BASES = ("point", "plane", "line", "crease", "cells")
BLENDS = ("exact", "sum")
MOST_FIELDS = 32
_MOST_POINTS, _MOST_CELLS = 10_000, 1_000_000

_OF_BASE = {
    "point": ("point",),
    "plane": ("point", "normal"),
    "line": ("points", "knuckles", "closed"),
    "crease": ("crease",),
    "cells": ("cells",),
}
_OF_ALL = ("base", "shift", "extent", "falloff", "axes", "protects")


def checked_fields(check, value, where, variables):
    """Descriptions of shape fields with all of their keys."""
    value = check.list(value, where, most=MOST_FIELDS)
    if not value:
        raise check.error(where, "it has no field", "describe one")
    return [_checked(check, one, f"{where}[{k}]", variables) for k, one in enumerate(value)]


def _checked(check, value, where, variables):
    value = check.object(value, where)
    base = check.choice(value.get("base"), f"{where}.base", BASES)
    check.object(value, where, {*_OF_ALL, *_OF_BASE[base]})
    protects = check.flag(value.get("protects", False), f"{where}.protects")
    found = {
        "base": base,
        "protects": protects,
        "shift": numbers(check, value.get("shift", [0, 0, 0]), f"{where}.shift", variables, 3),
        "extent": number(check, value.get("extent"), f"{where}.extent", variables),
        "falloff": number(check, value.get("falloff", 0.5), f"{where}.falloff", variables),
        "axes": _axes(check, value.get("axes", "xyz"), f"{where}.axes"),
    }
    return {**found, **_CHECKED_BASES[base](check, value, where, variables)}


def _axes(check, value, where):
    if set(check.text(value, where)) - set("xyz"):
        raise check.error(where, f"{shown(value)} names no axes", "write letters of x, y and z")
    return value


def _point(check, value, where, variables):
    return {"point": numbers(check, value.get("point"), f"{where}.point", variables, 3)}


def _plane(check, value, where, variables):
    normal = numbers(check, value.get("normal"), f"{where}.normal", variables, 3)
    return {**_point(check, value, where, variables), "normal": normal}


def _line(check, value, where, variables):
    points = check.list(value.get("points"), f"{where}.points", most=_MOST_POINTS)
    knuckles = check.list(value.get("knuckles", []), f"{where}.knuckles", most=len(points))
    return {
        "points": [
            numbers(check, one, f"{where}.points[{k}]", variables, 3)
            for k, one in enumerate(points)
        ],
        "knuckles": [
            check.index(one, f"{where}.knuckles", len(points), "point") for one in knuckles
        ],
        "closed": check.flag(value.get("closed", False), f"{where}.closed"),
    }


def _crease(check, value, where, variables):
    crease = check.index(value.get("crease"), f"{where}.crease", _MOST_CELLS, "crease")
    return {"crease": crease}


def _cells(check, value, where, variables):
    cells = check.list(value.get("cells"), f"{where}.cells", most=_MOST_CELLS)
    return {"cells": [check.index(one, f"{where}.cells", _MOST_CELLS, "cell") for one in cells]}


_CHECKED_BASES = {
    "point": _point,
    "plane": _plane,
    "line": _line,
    "crease": _crease,
    "cells": _cells,
}


def shape_fields(surface, described, blend, mirrored):
    """The hull_native.ShapeFields of descriptions without variables. surface: the LimitSurface that
    creases and cells are of. ValueError where one is none."""
    fields = [_field(surface, one) for one in described]
    return hn.ShapeFields(fields, mirrored=mirrored, blend=blend)


def _field(surface, one):
    settings = {key: one[key] for key in ("shift", "extent", "falloff", "protects", "axes")}
    settings["shift"] = tuple(settings["shift"])
    base = one["base"]
    if base == "point":
        return hn.ShapeField.at_point(one["point"], **settings)
    if base == "plane":
        return hn.ShapeField.at_plane(one["point"], one["normal"], **settings)
    if base == "cells":
        return hn.ShapeField.of_region(surface, np.array(one["cells"]), **settings)
    return hn.ShapeField.along(_curve(surface, one), **settings)


def _curve(surface, one):
    if one["base"] == "line":
        return hn.FieldCurve(one["points"], knuckles=one["knuckles"], closed=one["closed"])
    creases = hn.crease_curves(surface)
    if one["crease"] >= len(creases):
        raise ValueError(
            f"The hull has no crease {one['crease']}: it has {len(creases)}, from 0 on."
        )
    return hn.FieldCurve.of_crease(creases[one["crease"]])
