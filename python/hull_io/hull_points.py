# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of a hull file that tells which control points tools may not move, or only in a plane.

    "locked": [point, ...],
    "kept": {"stations": [point, ...], "buttocks": [point, ...], "waterlines": [point, ...]}

A point that is kept in its station keeps its x, in its buttock its y, in its waterline its z: the
plane is where the point is. All may be left out.
"""

from .hull_data import KEPT_IN, Kept

KEYS = ("locked", "kept")


def parsed(check, content, point_count):
    """Values for a HullData by name, of the content of a hull file; raises HullFileError."""
    entries = check.object(content.get("kept", {}), "kept", KEPT_IN)
    return {
        "locked": _points(check, content.get("locked", []), "locked", point_count),
        "kept": Kept(
            **{
                name: _points(check, value, f"kept.{name}", point_count)
                for name, value in entries.items()
            }
        ),
    }


def _points(check, value, where, point_count):
    points = check.list(value, where)
    for place, point in enumerate(points):
        check.index(point, f"{where}[{place}]", point_count, "point")
    return sorted(set(points))


def entries(data):
    """What a hull file says of a HullData, by its keys; nothing of what there is none of."""
    kept = {name: getattr(data.kept, name) for name in KEPT_IN}
    kept = {name: [int(point) for point in points] for name, points in kept.items() if points}
    found = {"locked": [int(point) for point in data.locked], "kept": kept}
    return {key: value for key, value in found.items() if value}
