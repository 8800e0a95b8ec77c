# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of a hull file that tells how the shell is divided into plates, and of its frames.

    "plating": {"rules": [{"kind": "strakes", "value": m, "on": true}, ...,
                          {"kind": "projected", "line": [[x, y, z], ...]}],
                "along_knuckles": true, "across_centre": true, "thickness": m,
                "first_frame": n, "ranges": [{"last": n, "spacing": m}, ...],
                "numbered_from": "AP" or "FP", "in_roman": false,
                "mark_waterlines": false, "mark_buttocks": false}

kind: of plating_data.SEAM_KINDS; value: its girth, height, breadth, place along the ship or
distance. What is left out is as Plating has it.
"""

from .limits import FURTHEST_POINT, MAX_LINE_POINTS, THICKEST
from .plating_data import SEAM_KINDS, FrameRange, Plating, SeamRule

KEY = "plating"
MOST_RULES, MOST_RANGES = 200, 200
# Of rules, m, either way; of frames.
LARGEST_VALUE, LARGEST_FRAME = 1000.0, 100_000
LEAST_SPACING, LARGEST_SPACING, THINNEST = 0.01, 100.0, 1e-5
_PLANES = ("waterline", "buttock", "station")
_DEFAULTS = vars(Plating())
_RULE_KEYS = tuple(vars(SeamRule("strakes")))


def parsed(check, content):
    """The Plating of a hull file's content, None where it says nothing; raises HullFileError."""
    if KEY not in content:
        return None
    given = check.object(content[KEY], KEY, tuple(_DEFAULTS))
    value = {**_DEFAULTS, **given}
    rules = check.list(value["rules"], f"{KEY}.rules", most=MOST_RULES)
    ranges = check.list(value["ranges"], f"{KEY}.ranges", most=MOST_RANGES)
    plating = Plating(
        [_rule(check, one, f"{KEY}.rules[{place}]") for place, one in enumerate(rules)],
        check.flag(value["along_knuckles"], f"{KEY}.along_knuckles"),
        check.flag(value["across_centre"], f"{KEY}.across_centre"),
        check.number(value["thickness"], f"{KEY}.thickness", THINNEST, THICKEST),
        _frame(check, value["first_frame"], f"{KEY}.first_frame"),
        [_range(check, one, f"{KEY}.ranges[{place}]") for place, one in enumerate(ranges)],
        check.choice(value["numbered_from"], f"{KEY}.numbered_from", ("AP", "FP")),
        check.flag(value["in_roman"], f"{KEY}.in_roman"),
        check.flag(value["mark_waterlines"], f"{KEY}.mark_waterlines"),
        check.flag(value["mark_buttocks"], f"{KEY}.mark_buttocks"),
    )
    if fault := plating.fault_of_frames():
        where, *told = fault
        raise check.error(f"{KEY}.{where}", *told)
    return plating


def _rule(check, value, where):
    entry = check.object(value, where, _RULE_KEYS)
    kind = check.choice(entry.get("kind"), f"{where}.kind", SEAM_KINDS)
    needed = "line" if kind == "projected" else "value"
    if needed not in entry:
        raise check.error(f"{where}.{needed}", "it is missing", "add it")
    lowest = 0.0 if kind == "openings" else 1e-6
    if kind in (*_PLANES, "projected"):
        lowest = -LARGEST_VALUE
    number = entry.get("value", 0.0)
    return SeamRule(
        kind,
        check.number(number, f"{where}.value", lowest, LARGEST_VALUE),
        _line(check, entry.get("line", []), f"{where}.line", kind == "projected"),
        check.flag(entry.get("on", True), f"{where}.on"),
    )


def _line(check, value, where, is_needed):
    points = check.list(value, where, most=MAX_LINE_POINTS)
    if is_needed and len(points) < 2:
        raise check.error(where, f"it has {len(points)} points", "a line has two or more")
    return [
        tuple(
            check.number(part, f"{where}[{place}].{axis}", -FURTHEST_POINT, FURTHEST_POINT)
            for axis, part in zip("xyz", check.list(point, f"{where}[{place}]", 3))
        )
        for place, point in enumerate(points)
    ]


def _range(check, value, where):
    entry = check.object(value, where, ("last", "spacing"))
    for key in ("last", "spacing"):
        if key not in entry:
            raise check.error(f"{where}.{key}", "it is missing", "add it")
    return FrameRange(
        _frame(check, entry["last"], f"{where}.last"),
        check.number(entry["spacing"], f"{where}.spacing", LEAST_SPACING, LARGEST_SPACING),
    )


def _frame(check, value, where):
    number = check.number(value, where, -LARGEST_FRAME, LARGEST_FRAME)
    if number != int(number):
        raise check.error(where, f"{number:g} is no number of a frame", "write a whole number")
    return int(number)


def entries(data):
    """What a hull file says of a HullData's plating; nothing of what there is none of."""
    own = data.plating
    if own is None:
        return {}
    rules = [
        {
            "kind": rule.kind,
            "value": float(rule.value),
            **({"line": [[float(part) for part in p] for p in rule.line]} if rule.line else {}),
            "on": bool(rule.on),
        }
        for rule in own.rules
    ]
    ranges = [{"last": int(one.last), "spacing": float(one.spacing)} for one in own.ranges]
    return {
        KEY: {
            "rules": rules,
            "along_knuckles": bool(own.along_knuckles),
            "across_centre": bool(own.across_centre),
            "thickness": float(own.thickness),
            "first_frame": int(own.first_frame),
            "ranges": ranges,
            "numbered_from": own.numbered_from,
            "in_roman": bool(own.in_roman),
            "mark_waterlines": bool(own.mark_waterlines),
            "mark_buttocks": bool(own.mark_buttocks),
        }
    }
