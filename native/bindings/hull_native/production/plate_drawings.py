# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings of flat plates with marks, of what lies on stock plates, and of templates."""

from math import atan2, cos, degrees, isfinite, pi, sin

import numpy as np

from .._core import plane_across
from .._drawing import ShopDrawing
from ..polylines import length_of
from .plate_lists import all_sides, form_of
from .plate_room import reach_within, roomy_place
from .shop_files import shop_ending, write_shop_drawings

_STRETCH_LINES = 6
# Of DXF files: breadths by which words grow, m, and how far.
_WORDS_OF_BREADTH, _LARGEST_WORDS = 0.25, 10.0
# mm on paper, by the breadth in m: names on plates of the mill.
_NAME = 10.0


def upright(angle):
    """The angle of words along a line, so that they are not upside down."""
    return angle - pi * round(angle / pi)


def _middle(line, part=0.5):
    """(point, direction angle) in the middle of a polyline, or at another part of its length."""
    steps = np.linalg.norm(np.diff(line, axis=0), axis=1)
    along = np.concatenate([[0.0], np.cumsum(steps)])
    k = min(int(np.searchsorted(along, part * along[-1])), len(line) - 1)
    k = max(k, 1)
    share = (part * along[-1] - along[k - 1]) / max(steps[k - 1], 1e-300)
    way = line[k] - line[k - 1]
    return line[k - 1] + share * way, atan2(way[1], way[0])


def _percent(stretch):
    """Of a ratio, without a sign where nothing is left of it."""
    text = f"{100.0 * (stretch - 1.0):+.3f} %"
    return text[1:] if text[1:] == "0.000 %" else text


def plate_drawing(one, *, marks=(), words=1.0):
    """The ShopDrawing of a ListedPlate: outline with the names of the curves there and the lengths
    of sides, marks, rolling line, seen from the water.

    marks: (layer, curve) pairs, a SurfaceCurve drawn on a layer such as "FRAMES" with its name.
    words: how much larger words are than is usual on paper at true size. ValueError unless it is
    above 0.
    """
    if not (isfinite(words) and words > 0.0):
        raise ValueError(f"The size of a drawing's words must be above 0, not {words:g}.")
    flat = one.flat
    length, breadth = one.extents
    least, largest = flat.stretch
    radius = flat.rolling_radius
    rows = [
        ("Thickness", f"{1000.0 * one.thickness:g} mm"),
        ("Area on the hull", f"{one.plate.area:.3f} m²"),
        ("Area flat", f"{flat.area:.3f} m²"),
        ("Mass", f"{1000.0 * one.mass_t:.0f} kg"),
        ("Rectangle", f"{1000.0 * length:.0f} × {1000.0 * breadth:.0f} mm"),
        ("Form", form_of(flat)),
        ("Least stretch", _percent(least)),
        ("Largest stretch", _percent(largest)),
        ("Rolling radius", f"{radius:.2f} m" if isfinite(radius) else "plane"),
        ("Roll from length", f"{degrees(flat.rolling_angle):.1f}°" if isfinite(radius) else "–"),
        ("Seen from", "outside"),
        ("From x", f"{one.plate.box[0][0]:.2f} to {one.plate.box[1][0]:.2f} m"),
    ]
    drawing = ShopDrawing(f"Plate {one.name}", rows)
    borders = [line for _, line in all_sides(flat)]
    inner, _ = roomy_place(flat, borders)
    for name, line in flat.sides:
        drawing.add_line("OUTLINE", 1000.0 * line)
        _put_side_words(drawing, name, line, inner, words)
    for name, line in (side for hole in flat.holes for side in hole):
        drawing.add_line("OUTLINE", 1000.0 * line)
        _put_side_words(drawing, name, line, line.mean(axis=0), words)
    for layer, curve in marks:
        for line, _ in flat.marks(curve):
            drawing.add_line(layer, 1000.0 * line)
            # Long ones run through the plate's middle, where its own name is.
            part = 0.25 if length_of(line) > 0.5 * length else 0.5
            _put_mark_words(drawing, curve.name, line, part, words)
    if isfinite(radius):
        _put_rolling_line(drawing, flat, borders, inner, words)
    drawing.add_text(one.name, 1000.0 * inner, size=16.0 * words, lift=-20.0 * words)
    return drawing


def _put_side_words(drawing, name, line, inner, words):
    length = length_of(line)
    if length < 0.15:
        return
    at, angle = _middle(line)
    angle = upright(angle)
    inward = np.array([-sin(angle), cos(angle)]) @ (inner - at)
    text = f"{name}  {1000.0 * length:.0f}" if name else f"{1000.0 * length:.0f}"
    # Outside, so that marks inside stay whole.
    lift = -7.0 * words if inward > 0.0 else 7.0 * words
    drawing.add_text(text, 1000.0 * at, size=8.0 * words, angle=angle, lift=lift)


def _put_mark_words(drawing, name, line, part, words):
    if not name or length_of(line) < 0.2:
        return
    at, angle = _middle(line, part)
    drawing.add_text(name, 1000.0 * at, size=7.0 * words, angle=upright(angle))


def _put_rolling_line(drawing, flat, borders, middle, words):
    """Through the middle, as long as half the plate where that is within it, with its words."""
    way = np.array([cos(flat.rolling_angle), sin(flat.rolling_angle)])
    sizes = flat.points.max(axis=0)
    half = 0.25 * min(sizes[0] / max(abs(way[0]), 1e-9), sizes[1] / max(abs(way[1]), 1e-9))
    half = min(half, 0.9 * reach_within(borders, middle, way))
    ends = middle + np.array([[-half], [half]]) * way
    drawing.add_line("ROLLING", 1000.0 * ends)
    at = middle + 0.6 * half * way
    angle = upright(flat.rolling_angle)
    drawing.add_text("roll", 1000.0 * at, size=7.0 * words, angle=angle, lift=6.0 * words)


def stretch_drawing(one):
    """The ShopDrawing of the map of stretch of a ListedPlate: lines of equal stretch of area, in
    parts per thousand, from that of the flat plate. ValueError for a developed one, which has
    none."""
    flat = one.flat
    if flat.developed:
        raise ValueError(f"Plate {one.name} was developed: it has no stretch to be drawn.")
    drawing = ShopDrawing(f"Plate {one.name}: stretch of area, ‰", [("Seen from", "outside")])
    for _, line in all_sides(flat):
        drawing.add_line("OUTLINE", 1000.0 * line)
    at_nodes = _at_nodes(flat)
    low, high = np.nanmin(at_nodes), np.nanmax(at_nodes)
    for value in np.linspace(low, high, _STRETCH_LINES + 2)[1:-1]:
        for k, line in enumerate(_level_lines(flat, at_nodes, value)):
            drawing.add_line("STRETCH", 1000.0 * line)
            if length_of(line) > 0.2:
                at, angle = _middle(line)
                drawing.add_text(
                    f"{1000.0 * value:+.2f}", 1000.0 * at, size=7.0, angle=upright(angle)
                )
    return drawing


def _at_nodes(flat):
    """Stretch of area less one, at corners of triangles: the mean of those around."""
    area = flat.stretches[:, 0] * flat.stretches[:, 1] - 1.0
    sums, counts = np.zeros(len(flat.points)), np.zeros(len(flat.points))
    for k in range(3):
        np.add.at(sums, flat.triangles[:, k], area)
        np.add.at(counts, flat.triangles[:, k], 1.0)
    with np.errstate(invalid="ignore"):
        return sums / counts


def _level_lines(flat, values, level):
    """Polylines where a function that is linear in triangles has a value."""
    pieces = {}
    for triangle in flat.triangles:
        ends = []
        for a, b in ((0, 1), (1, 2), (2, 0)):
            i, j = sorted((int(triangle[a]), int(triangle[b])))
            if (values[i] < level) != (values[j] < level):
                ends.append((i, j))
        if len(ends) == 2:
            pieces.setdefault(ends[0], []).append(ends[1])
            pieces.setdefault(ends[1], []).append(ends[0])

    def point(side):
        i, j = side
        t = (level - values[i]) / (values[j] - values[i])
        return flat.points[i] + t * (flat.points[j] - flat.points[i])

    lines = []
    while pieces:
        start = next((s for s, beyond in pieces.items() if len(beyond) == 1), next(iter(pieces)))
        line, at = [start], start
        while pieces.get(at):
            following = pieces[at].pop()
            if not pieces[at]:
                del pieces[at]
            pieces[following].remove(at)
            if not pieces[following]:
                del pieces[following]
            line.append(following)
            at = following
        lines.append(np.array([point(side) for side in line]))
    return lines


def nesting_drawing(stock, name):
    """The ShopDrawing of a StockPlate with the plates on it."""
    rows = [
        ("Thickness", f"{1000.0 * stock.thickness:g} mm"),
        ("Used", f"{100 * stock.used:.1f} %"),
    ]
    drawing = ShopDrawing(f"Stock plate {name}", rows)
    a, b = 1000.0 * stock.length, 1000.0 * stock.breadth
    drawing.add_line("BASE", [(0, 0), (a, 0), (a, b), (0, b), (0, 0)])
    for one, x, y in stock.laid:
        shift = np.array([x, y])
        for line in one.outline:
            drawing.add_line("OUTLINE", 1000.0 * (line + shift))
        place, room = roomy_place(one.flat, [line for _, line in all_sides(one.flat)])
        # Small pieces lie close together.
        size = min(max(_NAME * 2.0 * room, 3.0), 20.0)
        drawing.add_text(one.name, 1000.0 * (one.as_laid(place) + shift), size=size)
    return drawing


def plane_marks(curves, axis, places, names):
    """SurfaceCurves in the planes across an axis "x", "y" or "z" at places (m), each by its name,
    made by HullCurves; planes that do not meet the hull are left out."""
    marks = []
    for place, name in zip(places, names):
        try:
            marks += curves.in_plane(plane_across(axis, float(place)), name)
        except ValueError:
            continue
    return marks


def frame_marks(curves, table, low, high):
    """SurfaceCurves of the frames of a FrameTable from x = low to high, named "Fr …", as
    plane_marks()."""
    at = np.flatnonzero(np.isin(table.numbers, table.within(low, high)))
    return plane_marks(curves, "x", table.positions[at], [f"Fr {table.names[k]}" for k in at])


def write_plates(listed, path, *, marks=(), paper="A3", progress=None):
    """Writes ListedPlates as write_shop_drawings() does, in one file; in .dxf with words that grow
    with the plate. marks: as of plate_drawing(). progress: called with the share done."""
    is_dxf, drawings = shop_ending(path) == ".dxf", []
    for k, one in enumerate(listed):
        if progress:
            progress(k / len(listed))
        words = _words_on_screen(one) if is_dxf else 1.0
        drawings.append(plate_drawing(one, marks=marks, words=words))
    write_shop_drawings(drawings, path, paper=paper)


def _words_on_screen(one):
    """So that words can be read with the whole plate on the screen, and fit between its frames."""
    return min(max(one.extents[1] / _WORDS_OF_BREADTH, 1.0), _LARGEST_WORDS)
