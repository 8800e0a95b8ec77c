# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows and columns of control points over a HullOutline, as Greshake (2021, 6.1) lays them: rows
across the ship, mostly of one x, columns from the contour to the deck edge; knuckles are columns,
or rows where they run across.

Abaft the arch of a stern post rows begin at the contour there, in the column that ends in the arch;
the columns below begin at the post. At stem, post and arch the first column ends in the row before.
"""

from dataclasses import dataclass, field
from functools import cmp_to_key

import numpy as np

from ..polylines import bend_shares, foot_on, lengths_along, points_at, where_x_is
from .best_rows import best_rows
from .girth_lines import GirthLines

# How much of the rows' places are by the turning of lines along the ship; trial rows, and parts of
# them from line to line.
_BY_TURNING, _TRIALS, _ALONG = 0.6, 80, 12
# Of an even spacing: from where whole sections begin to the first row before a post.
_FIRST = 0.35
# A knuckle line is across where less of it is along the ship.
_ACROSS = 0.3
# Of the length: a knuckle's end is on the line of an end; sections are all alike.
_AT_END, _ALIKE = 1e-6, 1e-4
# Rows after the post over which columns come to where they are amidships.
_AFTER_POST = 4
_LEAST_GAP = 0.2


@dataclass
class GridRow:
    """A row of control points (columns + 1, 3), m, from the column `low` on. Kinds "station" and
    "arch" are of one x; "free" rows are not; "transom" and "bow" lie along the border at an end,
    "stem" and "post" along the contour. line, shares: what it was laid along. knuckles: of those
    along the ship that it has a point of, the share of the line there."""

    kind: str
    line: object
    low: int = 0
    x: object = None
    points: object = None
    post: object = None  # of an arch: the contour below, upwards
    knuckles: dict = field(default_factory=dict)
    is_knuckle: bool = False

    def __post_init__(self):
        self.shares = None if self.line is None else bend_shares(self.line)

    def on_line(self, shares):
        return points_at(self.line, self.shares, shares)


@dataclass
class HullGrid:
    outline: object
    rows: list
    columns: int
    knuckle_columns: list  # of the knuckles along the ship
    knuckles: list

    @property
    def arch_row(self):
        return next((i for i, row in enumerate(self.rows) if row.kind == "arch"), None)


def best_places(outline, girths, count):
    """(count,) x of rows, m, with which columns meet the sections best; the first and the last one
    are where the ends want them."""
    before, _ = keel_range(outline)
    if outline.arch is not None:
        before = float(outline.on_contour(outline.arch)[0])
    after = float(outline.contour[-1, 0])
    return best_rows(girths, _row_places(outline, girths, count), before, after)


def laid_grid(outline, columns, rows, counter_rows=2, post_columns=4, girths=None, at=None):
    """The HullGrid of so many columns between contour and deck edge and rows of one x; with an arch
    so many of them abaft it, and so many columns that begin below it. girths: the outline's
    GirthLines where they are not of its network. at: x of the rows, instead of their number."""
    girths = girths or GirthLines(outline)
    across, along = _sorted_knuckles(outline.knuckles)
    low = post_columns if outline.arch is not None else 0
    laid = _rows(outline, girths, rows, counter_rows, low, at)
    for line in across:
        _put_row(laid, line)
    along = _crossed_knuckles(laid, along, outline.length)
    if len(along) > columns - 1:
        raise ValueError(
            f"{len(along)} knuckles along the ship need {len(along) + 1} columns at least, not "
            f"{columns}: give a larger budget."
        )
    grid = HullGrid(outline, laid, columns, _columns_of(laid, len(along), columns), along)
    _place(grid, low)
    return grid


def _sorted_knuckles(knuckles):
    across, along = [], []
    for line in knuckles:
        way = line[-1] - line[0]
        if abs(way[0]) < _ACROSS * lengths_along(line)[-1]:
            across.append(line if line[0, 2] < line[-1, 2] else line[::-1])
        else:
            along.append(line if way[0] > 0.0 else line[::-1])
    return across, along


def _rows(outline, girths, count, counter_rows, low, at):
    rows, lengths = [], outline.lengths
    if outline.aft is not None:
        rows.append(GridRow("transom", outline.aft, low))
    else:
        stern = outline.contour[lengths < outline.post][::-1]
        rows.append(GridRow("post", np.vstack([outline.on_contour(outline.post), stern])))
    if outline.arch is not None:
        aft, arch = float(outline.aft[:, 0].max()), float(outline.on_contour(outline.arch)[0])
        for x in aft + (arch - aft) * np.linspace(0.0, 1.0, counter_rows + 2)[1:-1]:
            rows.append(GridRow("station", girths.at(x, on_counter=True), low, x))
        below = (lengths > outline.arch) & (lengths < outline.post)
        ends = outline.on_contour([outline.post, outline.arch])
        post = np.vstack([ends[:1], outline.contour[below][::-1], ends[1:]])
        rows.append(GridRow("arch", girths.at(arch, on_counter=True), 0, arch, post=post))
    for x in _row_places(outline, girths, count) if at is None else at:
        rows.append(GridRow("station", girths.at(x), 0, float(x)))
    if outline.stem is None:
        rows.append(GridRow("bow", outline.forward))
    else:
        stem = outline.contour[lengths > outline.stem]
        rows.append(GridRow("stem", np.vstack([outline.on_contour(outline.stem), stem])))
    return rows


def keel_range(outline):
    """The least and the largest x of whole sections from the keel to the deck edge."""
    contour, lengths = outline.contour, outline.lengths
    high = float(outline.deck[-1, 0])
    if outline.stem is None:
        high = float(outline.forward[:, 0].min())
    else:
        high = min(high, float(contour[lengths >= outline.stem, 0].min()))
        # Where points of the contour are far apart, it begins well before the next one; less than
        # this, rows keep from it anyway.
        high = min(high, float(outline.on_contour(outline.stem)[0]) + 5e-3 * outline.length)
    if outline.arch is not None:
        low = float(contour[(lengths >= outline.arch) & (lengths <= outline.post), 0].max())
    elif outline.aft is not None:
        low = float(outline.aft[:, 0].max())
    else:
        low = float(contour[lengths <= outline.post, 0].max())
    return low, high


def _row_places(outline, girths, count):
    """x of rows: closer where lines along the ship turn."""
    low, high = keel_range(outline)
    margin = 0.01 * (high - low)
    at = np.linspace(low + margin, high - margin, _TRIALS)
    shares = np.linspace(0.0, 1.0, _ALONG + 1)
    trial, even = [], []
    for x in at:
        line = girths.at(x)
        trial.append(points_at(line, bend_shares(line), shares))
        lengths = lengths_along(line)
        even.append(points_at(line, lengths, shares * lengths[-1])[:, 1:])
    ways = np.diff(np.array(trial), axis=0)
    ways /= np.linalg.norm(ways, axis=2)[:, :, None]
    turns = np.arccos(np.clip((ways[1:] * ways[:-1]).sum(axis=2), -1.0, 1.0)).sum(axis=1)
    turns = np.convolve(np.pad(turns, 4, "edge"), np.full(7, 1.0 / 7.0), "valid")
    if np.ptp(even, axis=0).max() < _ALIKE * outline.length or not turns.sum() > 0.0:
        # Where bends are on sections that are all alike is told by how these were drawn alone.
        turns = np.ones_like(turns)
    density = (1.0 - _BY_TURNING) / _TRIALS + _BY_TURNING * turns / turns.sum()
    reached = np.concatenate([[0.0], np.cumsum(0.5 * (density[1:] + density[:-1]))])
    # A transom is a row itself; before a post the first row is closer.
    first = 1.0 if outline.aft is not None and outline.arch is None else _FIRST
    inner = np.linspace(first / count, 1.0, count)
    return np.interp(inner, reached / reached[-1], at)


def _put_row(rows, line):
    """The nearest row of one x is put to where a knuckle, upwards, runs across."""
    x = float(np.median(line[:, 0]))
    stations = [i for i, row in enumerate(rows) if row.kind == "station" and row.low == 0]
    nearest = min(stations, key=lambda i: abs(rows[i].x - x))
    rows[nearest] = GridRow("station", line, 0, x, is_knuckle=True)


def _crossed_knuckles(rows, lines, length):
    """The knuckles along the ship that two rows or more cross, from below, told to the rows."""
    shares = []
    for line in lines:
        of_rows = {}
        for i, row in enumerate(rows):
            if row.x is not None:
                places = where_x_is(line, row.x)
                places = [points_at(line, lengths_along(line), places[0])] if places else []
            else:
                places = [
                    end
                    for end in line[[0, -1]]
                    if foot_on(row.line, row.shares, end)[1] < _AT_END * length
                ]
            if places:
                of_rows[i] = foot_on(row.line, row.shares, places[0])[0]
        shares.append(of_rows)
    kept = [i for i, of_rows in enumerate(shares) if len(of_rows) > 1]
    kept.sort(key=cmp_to_key(lambda a, b: _above(shares[a], shares[b])))
    for number, i in enumerate(kept):
        for row, share in shares[i].items():
            rows[row].knuckles[number] = share
    return [lines[i] for i in kept]


def _above(first, second):
    """How much one knuckle is above another: in the rows that have both, or else in the mean."""
    both = [first[row] - second[row] for row in first if row in second]
    return np.mean(both) if both else np.mean([*first.values()]) - np.mean([*second.values()])


def _columns_of(rows, count, columns):
    """The column of each knuckle along the ship: rising, as near to its share as can be."""
    found = []
    for number in range(count):
        share = np.median([row.knuckles[number] for row in rows if number in row.knuckles])
        least = found[-1] + 1 if found else 1
        found.append(int(np.clip(round(share * columns), least, columns - count + number)))
    return found


def _place(grid, post_columns):
    shares = [_column_shares(grid, i, post_columns) for i in range(len(grid.rows))]
    if post_columns:
        _run_on(grid, shares, post_columns)
    for row, of_row in zip(grid.rows, shares):
        row.points = row.on_line(of_row)
        if row.kind == "arch":
            even = np.linspace(0.0, 1.0, post_columns + 1)
            row.points[: post_columns + 1] = points_at(row.post, bend_shares(row.post), even)


def _column_shares(grid, number, post_columns):
    """(columns + 1,) of a row's line. A knuckle's column goes on beyond its ends, by and by to
    where an even spacing has it."""
    row = grid.rows[number]
    # The line of an arch is that above it.
    first = post_columns if row.kind == "arch" else row.low
    known = {first: 0.0, grid.columns: 1.0}
    for knuckle, column in enumerate(grid.knuckle_columns):
        if column <= first:
            continue
        if knuckle in row.knuckles:
            known[column] = row.knuckles[knuckle]
            continue
        having = [i for i, other in enumerate(grid.rows) if knuckle in other.knuckles]
        there = [grid.rows[i].knuckles[knuckle] for i in having]
        if having[0] < number < having[-1]:
            known[column] = np.interp(number, having, there)
            continue
        end = 0 if number < having[0] else len(grid.rows) - 1
        near = having[0] if number < having[0] else having[-1]
        share = abs(number - near) / abs(end - near)
        even = (column - first) / (grid.columns - first)
        known[column] = (1.0 - share) * np.interp(near, having, there) + share * even
    columns = sorted(known)
    values = np.interp(np.arange(grid.columns + 1), columns, [known[column] for column in columns])
    return _apart(values)


def _apart(shares):
    """Rising shares with the same ends, columns being no closer than _LEAST_GAP of an even one."""
    gaps = np.maximum(np.diff(shares), 0.0)
    gaps = np.where(np.arange(len(gaps)) < np.argmax(gaps > 0.0), 0.0, gaps)
    inner = np.flatnonzero(np.cumsum(gaps) > 0.0)
    gaps[inner] = np.maximum(gaps[inner], _LEAST_GAP / len(gaps))
    return np.concatenate([shares[:1], shares[0] + np.cumsum(gaps) / gaps.sum() * np.ptp(shares)])


def _run_on(grid, shares, post_columns):
    """Columns that begin at the post go on there, and come by and by to their places amidships."""
    arch = grid.rows[grid.arch_row]
    below, above = lengths_along(arch.post)[-1], lengths_along(arch.line)[-1]
    even = np.linspace(0.0, below, post_columns + 1)
    upper = below + above * shares[grid.arch_row][post_columns + 1 :]
    begin = np.concatenate([even, upper]) / (below + above)
    after = range(grid.arch_row + 1, min(grid.arch_row + 1 + _AFTER_POST, len(grid.rows) - 1))
    for step, i in enumerate(after, 1):
        share = step / (len(after) + 1)
        mixed = (1.0 - share) * begin + share * shares[i]
        fixed = [0, grid.columns]
        fixed += [grid.knuckle_columns[k] for k in grid.rows[i].knuckles]
        fixed.sort()
        off = [shares[i][column] - mixed[column] for column in fixed]
        mixed += np.interp(np.arange(grid.columns + 1), fixed, off)
        shares[i] = _apart(mixed)
