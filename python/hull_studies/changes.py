# SPDX-License-Identifier: GPL-3.0-or-later
"""The changes that make a variant of the study's hulls, described as plain data and checked.

  weights      the member of the family of all hulls with these weights of all but the first
  dimensions   scaled to length_pp, beam, draft and depth, m
  fields       shifted by shape fields
  sections     shifted to a block coefficient, volume …, and LCB
  targets      brought to any wanted numbers at the least change

They are taken in the order given. Numbers may be variables of the study: "$name".
"""

import hull_native as hn
from hull_io.wanted import SENSES

from .fields import BLENDS, checked_fields
from .values import number, numbers

PARTS = ("whole", "apart", "fore", "aft", "fair")
MOVES = ("points", "weights")
MOST_CHANGES, MOST_TARGETS = 20, 60

_DIMENSIONS = ("length_pp", "beam", "draft", "depth")
_SIZES = ("volume", "displacement_t", "block", "prismatic")
_PLACES = ("lcb", "lcb_percent")
SCALES = ("length_scale", "beam_scale", "draft_scale")


def checked_changes(check, value, variables, hulls):
    """Descriptions of changes with all of their keys; hulls: how many the study has."""
    value = check.list(value, "changes", most=MOST_CHANGES)
    found = []
    for k, one in enumerate(value):
        where = f"changes[{k}]"
        one = check.object(one, where)
        kind = check.choice(one.get("change"), f"{where}.change", tuple(_CHECKED))
        rest = {key: held for key, held in one.items() if key != "change"}
        found.append({"change": kind, **_CHECKED[kind](check, rest, where, variables, hulls)})
    _check_order(check, [one["change"] for one in found], found)
    return found


def _check_order(check, kinds, found):
    for k, kind in enumerate(kinds):
        if kind == "weights" and k > 0:
            raise check.error(
                f"changes[{k}]", "weights take a member of the family", "put them first, once"
            )
        by_weights = kind == "targets" and found[k]["moves"] == "weights"
        if by_weights and kinds[:k] != ["weights"]:
            raise check.error(
                f"changes[{k}].moves",
                "weights can be sought of a member of the family alone",
                'put the targets second, after weights, or write "points"',
            )


def _weights(check, value, where, variables, hulls):
    if hulls < 2:
        raise check.error(where, "the study has one hull", "give it another one, or no weights")
    check.object(value, where, {"weights"})
    weights = numbers(check, value.get("weights"), f"{where}.weights", variables, hulls - 1)
    return {"weights": weights}


def _dimensions(check, value, where, variables, hulls):
    check.object(value, where, _DIMENSIONS)
    if not value:
        raise check.error(where, "it has no dimension", f"give {', '.join(_DIMENSIONS)} or some")
    return {key: number(check, one, f"{where}.{key}", variables) for key, one in value.items()}


def _fields(check, value, where, variables, hulls):
    check.object(value, where, {"fields", "blend"})
    return {
        "fields": checked_fields(check, value.get("fields"), f"{where}.fields", variables),
        "blend": check.choice(value.get("blend", "exact"), f"{where}.blend", BLENDS),
    }


def _sections(check, value, where, variables, hulls):
    check.object(value, where, {"part", *_SIZES, *_PLACES})
    found = {"part": check.choice(value.get("part", "whole"), f"{where}.part", PARTS)}
    wanted = [key for key in (*_SIZES, *_PLACES) if key in value]
    for keys in (_SIZES, _PLACES):
        if len(set(keys) & set(wanted)) > 1:
            raise check.error(where, f"{' and '.join(keys)} say the same", "give one of them")
    if not wanted:
        raise check.error(where, "nothing is wanted", "give a block coefficient, an lcb or both")
    for key in wanted:
        found[key] = number(check, value[key], f"{where}.{key}", variables)
    return found


def _targets(check, value, where, variables, hulls):
    check.object(value, where, {"moves", "targets", "stiffness", *SCALES})
    rows = check.list(value.get("targets"), f"{where}.targets", most=MOST_TARGETS)
    if not rows:
        raise check.error(f"{where}.targets", "it has none", "describe one")
    found = {
        "moves": check.choice(value.get("moves", "points"), f"{where}.moves", MOVES),
        "stiffness": number(check, value.get("stiffness", 0.05), f"{where}.stiffness", variables),
        "targets": [
            _target(check, one, f"{where}.targets[{k}]", variables) for k, one in enumerate(rows)
        ],
    }
    for key in SCALES:
        found[key] = numbers(check, value.get(key, [1, 1]), f"{where}.{key}", variables, 2)
    return found


def _target(check, value, where, variables):
    keys = {"number", "value", "tolerance", "sense", "station", "weight"}
    value = check.object(value, where, keys)
    named = check.choice(value.get("number"), f"{where}.number", (*hn.FORM_NUMBERS, "section_area"))
    found = {
        "number": named,
        "value": number(check, value.get("value"), f"{where}.value", variables),
        "tolerance": number(check, value.get("tolerance", 0), f"{where}.tolerance", variables),
        "sense": check.choice(value.get("sense", "equal"), f"{where}.sense", SENSES),
        "weight": number(check, value.get("weight", 1), f"{where}.weight", variables),
    }
    if named == "section_area":
        found["station"] = number(check, value.get("station"), f"{where}.station", variables)
    elif "station" in value:
        raise check.error(f"{where}.station", f"{named} has no station", "take it out")
    return found


_CHECKED = {
    "weights": _weights,
    "dimensions": _dimensions,
    "fields": _fields,
    "sections": _sections,
    "targets": _targets,
}


def column_names(changes):
    """What the columns of each change begin with: its kind, from the second one of a kind on with
    its number."""
    seen, names = {}, []
    for one in changes:
        kind = one["change"]
        seen[kind] = seen.get(kind, 0) + 1
        names.append(kind if seen[kind] == 1 else f"{kind} {seen[kind]}")
    return names


def target_names(targets):
    """Of targets' columns: their numbers, from the second one of a kind on with its number."""
    seen, names = {}, []
    for one in targets:
        name = one["number"]
        seen[name] = seen.get(name, 0) + 1
        names.append(name if seen[name] == 1 else f"{name} {seen[name]}")
    return names


def told_numbers(changes, hulls):
    """Names of the numbers that making a variant tells besides its hydrostatics, in their order;
    hulls: how many the study has."""
    found = []
    for name, change in zip(column_names(changes), changes):
        if change["change"] in ("fields", "sections"):
            found += [f"{name}.residual_rms", f"{name}.residual_largest"]
        if change["change"] == "targets":
            found.append(f"{name}.shift_rms")
            found += [f"{name}.{key}" for key in SCALES]
            if change["moves"] == "weights":
                found += [f"{name}.weight {k + 1}" for k in range(hulls)]
            for one in target_names(change["targets"]):
                found += [f"{name}.{one}", f"{name}.{one}.miss"]
    return found
