# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves of a hull from its table of offsets: stations, waterlines, buttocks, profile, deck
edge."""

import numpy as np

from ..errors import HullFileError
from ..table_text import table_rows
from .offset_lines import divided, lines_of
from .offset_tables import parse_offset_table
from .values import Geometry, polyline

# Station numbers up to this are no positions unless the table says so.
_MOST_STATION_NUMBER = 50


def read_offsets(text, name):
    """The Geometry of a table of offsets; x as the table has it, y of the half, z up."""
    rows, lines = divided(table_rows(text))
    table = parse_offset_table(rows, name)
    xs = _station_positions(table, name)
    stations = {}
    for offset in table.offsets:
        stations.setdefault(offset.station.text, _Station(xs[offset.station.text]))
        _take(table, stations[offset.station.text], offset)
    for text_of_station, said in table.knuckles:
        if text_of_station in stations:
            stations[text_of_station].mark(said)
    ordered = sorted(stations.items(), key=lambda item: item[1].x)
    curves = [station.curve(label) for label, station in ordered]
    in_space = lines_of(lines, table, name)
    told = {curve.kind for curve in in_space} - {"border", "profile"}
    # What is told in space is told better than by its places at stations.
    lengthwise = _lengthwise(table, [station for _, station in ordered], name)
    curves += [curve for curve in lengthwise if curve is None or curve.kind not in told]
    curves = tuple(curve for curve in (*curves, *in_space) if curve is not None)
    if not curves:
        raise HullFileError(
            f"{name}: no station has two points; give half-breadths at two waterlines or more."
        )
    return Geometry(
        name,
        "table of offsets",
        table.unit,
        curves,
        left_out=tuple(table.left_out),
        is_half=True,
        on_ship_axes=True,
    )


class _Station:
    """x; points by what they are measured at: half_breadths {z: y}, heights {y: z}, features {name:
    [y, z]}; knuckles: the (y, z) that are on one."""

    def __init__(self, x):
        self.x = x
        self.half_breadths, self.heights, self.features = {}, {}, {}
        self.names, self.knuckles = {}, set()

    def mark(self, said):
        """What a text such as "WL 1.5 m; buttock 2 m" names is on a knuckle."""
        for part in said.split(";"):
            if part.strip() in self.names:
                self.knuckles.add(self.names[part.strip()])

    def curve(self, label):
        """From the centre line outward and up: the shortest way that passes heights in the order
        of their buttocks and half-breadths in that of their waterlines, then the features where
        they lengthen it least."""
        lower = [(y, z) for y, z in sorted(self.heights.items())]
        outer = [(y, z) for z, y in sorted(self.half_breadths.items())]
        path = _merged(lower, outer)
        knuckles = set(self.knuckles)
        for _, (y, z), is_deck in self._whole_features():
            if (y, z) not in path:
                path.insert(len(path) if is_deck else _cheapest(path, (y, z)), (y, z))
            if not is_deck:
                knuckles.add((y, z))
        points = [(self.x, y, z) for y, z in path]
        at = [k for k, place in enumerate(path) if place in knuckles]
        return polyline(points, at, name=f"station {label}", kind="station")

    def _whole_features(self):
        for name, (y, z, is_deck) in self.features.items():
            if y is not None and z is not None:
                yield name, (y, z), is_deck


def _take(table, station, offset):
    line, value = offset.line, table.in_unit(offset.value)
    if line.kind in ("waterline", "buttock") and line.position is None:
        what = "height" if line.kind == "waterline" else "distance from the centre line"
        table.leave_out(f"'{line.text[:80]}' has no {what} in its heading")
        return
    if line.kind in ("stem", "stern"):
        # A point of it lies at its own x, and not at that of a station.
        table.leave_out(f"'{line.text[:80]}' has no x beside it, as in 'Stem: x'")
        return
    if line.kind == "waterline":
        z = _line_position(table, line, "waterline spacing")
        station.half_breadths[z] = value
        place = (value, z)
        station.names[f"WL {line.position.value:.10g} {line.position.unit or ''}".strip()] = place
    elif line.kind in ("buttock", "profile"):
        y = _line_position(table, line, "buttock spacing") if line.kind == "buttock" else 0.0
        station.heights[y] = value
        place = (y, value)
        if line.position is not None:
            unit = line.position.unit or ""
            station.names[f"buttock {line.position.value:.10g} {unit}".strip()] = place
    else:
        name = line.text.split(":")[0] if line.kind == "feature" else "deck edge"
        feature = station.features.setdefault(name, [None, None, line.kind == "deck"])
        feature[0 if line.what == "half_breadth" else 1] = value
        return
    if offset.value.on_knuckle:
        station.knuckles.add(place)


def _line_position(table, line, spacing):
    """Of a waterline or buttock: what its heading says, times the spacing where one is told."""
    if spacing in table.settings:
        return line.position.value * table.in_unit(table.settings[spacing])
    return table.in_unit(line.position)


def _station_positions(table, name):
    """x by the station's text. HullFileError where stations have numbers alone."""
    texts = list(dict.fromkeys(offset.station.text for offset in table.offsets))
    missing = [text for text in texts if text not in table.positions]
    if not missing:
        return {text: table.in_unit(table.positions[text]) for text in texts}
    if len(missing) < len(texts):
        raise HullFileError(
            f"{name}: station '{missing[0][:40]}' has no x and others have one; give the x of each "
            "station, or of none."
        )
    numbers = {text: table.station_headings[text].position for text in texts}
    for text, number in numbers.items():
        if number is None:
            raise HullFileError(
                f"{name}: it isn't told where station '{text[:40]}' is; name the stations by their "
                "x, or add a column 'x'."
            )
    values = np.array([number.value for number in numbers.values()])
    spacing = table.settings.get("station spacing") or table.settings.get("stations apart")
    if spacing is not None:
        return {text: n.value * table.in_unit(spacing) for text, n in numbers.items()}
    if "lpp" in table.settings and values.max() > 0.0:
        step = table.in_unit(table.settings["lpp"]) / values.max()
        return {text: number.value * step for text, number in numbers.items()}
    is_numbered = (values == np.round(values)).all() and np.abs(
        values
    ).max() <= _MOST_STATION_NUMBER
    if is_numbered and not any(n.unit for n in numbers.values()) and _steps_of_one(values):
        raise HullFileError(
            f"{name}: its stations have numbers from {values.min():g} to {values.max():g} and no "
            "places; add a line 'station spacing: 4.2', or a column 'x'."
        )
    return {text: table.in_unit(number) for text, number in numbers.items()}


def _steps_of_one(values):
    return np.diff(np.sort(values)).max(initial=0.0) <= 1.0 + 1e-9


def _lengthwise(table, stations, name):
    """Waterlines, buttocks, the profile and the lines of features, through all stations that have
    them."""
    found = {}
    for station in stations:
        for z, y in station.half_breadths.items():
            found.setdefault(("waterline", z), []).append((station.x, y, z))
        for y, z in station.heights.items():
            kind = "buttock" if y != 0.0 else "profile"
            found.setdefault((kind, y), []).append((station.x, y, z))
        for feature, (y, z), is_deck in station._whole_features():
            kind = "deck_edge" if is_deck else "knuckle"
            found.setdefault((kind, feature), []).append((station.x, y, z))
    for (kind, at), points in found.items():
        kind = "border" if kind == "knuckle" and "edge" in at.lower() else kind
        label = f"{kind} {at:.10g}" if kind in ("waterline", "buttock") else kind.replace("_", " ")
        yield polyline(points, name=at if kind in ("knuckle", "border") else label, kind=kind)


def _merged(lower, outer):
    """Both lists of (y, z) in one, each in its own order, the shortest such way; points that both
    have are one."""
    outer = [place for place in outer if place not in set(lower)] if lower else outer
    if not lower or not outer:
        return list(lower or outer)
    a, b = np.array(lower), np.array(outer)
    # best[i, j, k]: the way through i of a and j of b that ends in a (k = 0) or b (1).
    best = np.full((len(a) + 1, len(b) + 1, 2), np.inf)
    came = np.zeros(best.shape, dtype=int)
    # It begins at the centre line, where that is told.
    best[1, 0, 0], best[0, 1, 1] = 0.0, np.inf if lower[0][0] == 0.0 else 0.0
    for i in range(len(a) + 1):
        for j in range(len(b) + 1):
            for k, (di, dj) in enumerate(((1, 0), (0, 1))):
                if i < di or j < dj or i + j < 2:
                    continue
                here = a[i - 1] if k == 0 else b[j - 1]
                ways = []
                for last in (0, 1):
                    p, q = i - di, j - dj
                    at = (a[p - 1] if p else None) if last == 0 else (b[q - 1] if q else None)
                    step = np.inf if at is None else np.hypot(*(here - at))
                    ways.append(best[p, q, last] + step)
                came[i, j, k] = int(ways[1] < ways[0])
                best[i, j, k] = min(ways)
    return _traced(lower, outer, best, came)


def _traced(lower, outer, best, came):
    i, j = len(lower), len(outer)
    k = int(best[i, j, 1] < best[i, j, 0])
    path = []
    while i + j > 0:
        path.append(lower[i - 1] if k == 0 else outer[j - 1])
        before = came[i, j, k]
        i, j = (i - 1, j) if k == 0 else (i, j - 1)
        k = before
    return path[::-1]


def _cheapest(path, place):
    """Where in a path of (y, z) another place lengthens it least; its ends count, too."""
    if len(path) < 2:
        return len(path)
    points, place = np.array(path), np.array(place)
    away = np.hypot(*(points - place).T)
    between = away[:-1] + away[1:] - np.hypot(*np.diff(points, axis=0).T)
    return int(np.argmin(np.concatenate([away[:1], between, away[-1:]])))
