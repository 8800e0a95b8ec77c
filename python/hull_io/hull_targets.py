# SPDX-License-Identifier: GPL-3.0-or-later
"""What a hull file tells of what is wanted of the hull: m, m², m³, t, kN and percent.

    "targets": {"rows": [{"quantity": "kmt", "sense": "at least", "value": 6.3, "tolerance": 0.0,
                          "station": m, "speed_kn": kn, "on": true}, ...],
                "moving": "all", "selected" or "none",
                "staying": ["profile", "deck_edge", "greatest_beam"],
                "length": {"free": false, "percent": 5.0}, "beam": ..., "draft": ...,
                "fairness": 0.05},
    "area_target": {"source": "...", "base": [[x, area], ...], "points": [[x, area], ...]}

All may be left out, but quantity and value of a row; wanted.QUANTITIES has the quantities. The
curve goes through its points; between them it is the base and what they have been moved from that.
"""

from .limits import (
    FASTEST_KN,
    FURTHEST_POINT,
    GREATEST_DIMENSION_CHANGE,
    GREATEST_TARGET,
    GREATEST_TARGET_STIFFNESS,
    LARGEST_SECTION,
    MAX_AREA_TABLE_ROWS,
    MAX_TARGETS,
)
from .wanted import (
    DIMENSIONS,
    MOVING,
    QUANTITIES,
    SENSES,
    STAYING,
    AreaPoint,
    AreaTarget,
    FreeDimension,
    Target,
    Targets,
)

KEYS = ("targets", "area_target")
_ROW = ("quantity", "sense", "value", "tolerance", "station", "speed_kn", "on")


def parsed(check, content):
    """Values for a HullData by name, of the content of a hull file; raises HullFileError."""
    found = {"targets": _targets(check, content.get("targets", {}))}
    if "area_target" in content:
        found["area_target"] = _area_target(check, content["area_target"])
    return found


def _targets(check, value):
    known = ("rows", "moving", "staying", *DIMENSIONS, "fairness")
    entries = check.object(value, "targets", known)
    rows = check.list(entries.get("rows", []), "targets.rows", most=MAX_TARGETS)
    staying = check.list(entries.get("staying", list(STAYING)), "targets.staying")
    for index, name in enumerate(staying):
        check.choice(name, f"targets.staying[{index}]", STAYING)
    return Targets(
        rows=[_row(check, row, f"targets.rows[{index}]") for index, row in enumerate(rows)],
        moving=check.choice(entries.get("moving", MOVING[0]), "targets.moving", MOVING),
        staying=tuple(name for name in STAYING if name in staying),
        fairness=check.number(
            entries.get("fairness", Targets.fairness), "targets.fairness",
            0.0, GREATEST_TARGET_STIFFNESS,
        ),
        **{name: _dimension(check, entries.get(name, {}), name) for name in DIMENSIONS},
    )  # fmt: skip


def _row(check, value, where):
    entries = check.object(value, where, _ROW)
    for key in ("quantity", "value"):
        if key not in entries:
            raise check.error(f"{where}.{key}", "it is missing", "add it")

    def number(key, least, most):
        return check.number(entries.get(key, 0.0), f"{where}.{key}", least, most)

    return Target(
        quantity=check.choice(entries["quantity"], f"{where}.quantity", QUANTITIES),
        value=number("value", -GREATEST_TARGET, GREATEST_TARGET),
        sense=check.choice(entries.get("sense", SENSES[0]), f"{where}.sense", SENSES),
        tolerance=number("tolerance", 0.0, GREATEST_TARGET),
        station=number("station", -FURTHEST_POINT, FURTHEST_POINT),
        on=check.flag(entries.get("on", True), f"{where}.on"),
        speed_kn=number("speed_kn", 0.0, FASTEST_KN),
    )


def _dimension(check, value, name):
    entries = check.object(value, f"targets.{name}", ("free", "percent"))
    percent = entries.get("percent", FreeDimension.percent)
    return FreeDimension(
        check.flag(entries.get("free", False), f"targets.{name}.free"),
        check.number(percent, f"targets.{name}.percent", 0.0, GREATEST_DIMENSION_CHANGE),
    )


def _area_target(check, value):
    entries = check.object(value, "area_target", ("source", "base", "points"))
    return AreaTarget(
        _area_points(check, entries.get("base", []), "area_target.base"),
        _area_points(check, entries.get("points", []), "area_target.points"),
        check.text(entries.get("source", ""), "area_target.source"),
    )


def _area_points(check, value, where):
    points = []
    for index, pair in enumerate(check.list(value, where, most=MAX_AREA_TABLE_ROWS)):
        x, area = check.list(pair, f"{where}[{index}]", 2)
        points.append(
            AreaPoint(
                check.number(x, f"{where}[{index}].x", -FURTHEST_POINT, FURTHEST_POINT),
                check.number(area, f"{where}[{index}].area", 0.0, LARGEST_SECTION),
            )
        )
    return points


def entries(data):
    """What a hull file says of what is wanted of a HullData, by its keys; nothing where nothing
    is."""
    found = {}
    if data.targets != Targets():
        found["targets"] = _targets_entry(data.targets)
    if data.area_target is not None:
        found["area_target"] = {
            "source": data.area_target.source,
            "base": _pairs(data.area_target.base),
            "points": _pairs(data.area_target.points),
        }
    return found


def _targets_entry(targets):
    return {
        "rows": [
            {
                "quantity": row.quantity,
                "sense": row.sense,
                "value": float(row.value),
                "tolerance": float(row.tolerance),
                "station": float(row.station),
                **({"speed_kn": float(row.speed_kn)} if row.speed_kn else {}),
                "on": bool(row.on),
            }
            for row in targets.rows
        ],
        "moving": targets.moving,
        "staying": list(targets.staying),
        **{name: _dimension_entry(getattr(targets, name)) for name in DIMENSIONS},
        "fairness": float(targets.fairness),
    }


def _dimension_entry(dimension):
    return {"free": bool(dimension.free), "percent": float(dimension.percent)}


def _pairs(points):
    return [[float(point.x), float(point.area)] for point in points]
