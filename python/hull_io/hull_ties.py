# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of a hull file that tells which control points follow others, and groups of points.

    "ties": [{"kind": "line", "point": point, "to": [point, point], "share": part of the way},
             {"kind": "anchor", "point": point, "to": [point], "distance": [x, y, z]},
             {"kind": "level" or "mirror", "point": point, "to": [point]},
             {"kind": "camber", "point": point, "to": [point], "share": part of the breadth}, ...],
    "groups": [{"name": "...", "points": [point, ...]}, ...]

line: the point is on the straight line between two others; anchor: at a distance from another;
level: as high; mirror: its image on the centre plane, both but for a distance where one is given;
camber: deck at side, lower than another by a share of the breadth at the point. A point follows
once, and none by others itself.
"""

from .hull_data import PointGroup, Tie
from .limits import FURTHEST_POINT

KEYS = ("ties", "groups")
KINDS = ("line", "anchor", "level", "mirror", "camber")
_TIE_KEYS = ("kind", "point", "to", "share", "distance")


def parsed(check, content, point_count):
    """Values for a HullData by name, of the content of a hull file; raises HullFileError."""
    return {
        "ties": _ties(check, content.get("ties", []), point_count),
        "groups": [
            _group(check, entry, f"groups[{place}]", point_count)
            for place, entry in enumerate(check.list(content.get("groups", []), "groups"))
        ],
    }


def _ties(check, value, point_count):
    found = {}
    for place, entry in enumerate(check.list(value, "ties")):
        tie = _tie(check, entry, f"ties[{place}]", point_count)
        if tie.point in found:
            raise check.error(f"ties[{place}].point", "it follows others already", "tie it once")
        found[tie.point] = tie
    round_in = circle(found)
    if round_in:
        place = next(place for place, point in enumerate(found) if point in round_in)
        raise check.error(f"ties[{place}]", "its point would follow itself", "take it out")
    return list(found.values())


def circle(ties):
    """Points that follow one another in a circle, of {point: its Tie}; none where there is none."""
    clear = set()
    for start in ties:
        if start in clear:
            continue
        path, ways = {start}, [(start, iter(ties[start].to))]
        while ways:
            point, leaders = ways[-1]
            leader = next((one for one in leaders if one in ties and one not in clear), None)
            if leader is None:
                ways.pop()
                path.remove(point)
                clear.add(point)
            elif leader in path:
                way = [each for each, _ in ways]
                return set(way[way.index(leader) :])
            else:
                path.add(leader)
                ways.append((leader, iter(ties[leader].to)))
    return set()


def _tie(check, value, where, point_count):
    entry = check.object(value, where, _TIE_KEYS)
    for key in ("kind", "point", "to"):
        if key not in entry:
            raise check.error(f"{where}.{key}", "it is missing", "add it")
    kind = check.choice(entry["kind"], f"{where}.kind", KINDS)
    count = 2 if kind == "line" else 1
    to = check.list(entry["to"], f"{where}.to", count)
    distance = check.list(entry.get("distance", [0, 0, 0]), f"{where}.distance", 3)
    far = 2.0 * FURTHEST_POINT
    return Tie(
        kind,
        check.index(entry["point"], f"{where}.point", point_count, "point"),
        tuple(
            check.index(point, f"{where}.to[{i}]", point_count, "point")
            for i, point in enumerate(to)
        ),
        check.number(entry.get("share", 0.0), f"{where}.share", 0.0, 1.0),
        tuple(
            check.number(part, f"{where}.distance[{i}]", -far, far)
            for i, part in enumerate(distance)
        ),
    )


def _group(check, value, where, point_count):
    entry = check.object(value, where, ("name", "points"))
    points = check.list(entry.get("points", []), f"{where}.points")
    for place, point in enumerate(points):
        check.index(point, f"{where}.points[{place}]", point_count, "point")
    return PointGroup(check.text(entry.get("name", ""), f"{where}.name"), sorted(set(points)))


def entries(data):
    """What a hull file says of a HullData, by its keys; nothing of what there is none of."""
    found = {
        "ties": [_tie_entry(tie) for tie in data.ties],
        "groups": [
            {"name": group.name, "points": [int(point) for point in group.points]}
            for group in data.groups
        ],
    }
    return {key: value for key, value in found.items() if value}


def _tie_entry(tie):
    entry = {"kind": tie.kind, "point": int(tie.point), "to": [int(point) for point in tie.to]}
    if tie.kind in ("line", "camber"):
        entry["share"] = float(tie.share)
    if any(tie.distance):
        entry["distance"] = [float(part) for part in tie.distance]
    return entry


def renumbered(ties, number, reflect=False):
    """Ties of points by their new numbers, {old: new}, those left out of which a point is not among
    them; reflect: as of the other side."""
    found = []
    for tie in ties:
        if tie.point in number and all(point in number for point in tie.to):
            x, y, z = tie.distance
            distance = (x, -y if reflect else y, z)
            to = tuple(number[point] for point in tie.to)
            found.append(Tie(tie.kind, number[tie.point], to, tie.share, distance))
    return found
