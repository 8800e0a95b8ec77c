# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of control points smoothed that are selected in edit mode, within a mean deviation."""

from dataclasses import dataclass

import numpy as np

from ...bridge import limits, native
from ...bridge.blender import units
from ...bridge.counts import counted
from ...bridge.mesh import mesh_points
from ...bridge.objects import hull_mesh
from ..constraints import move_limits
from ..fairness import row_combs
from ..hull import hull_state
from ..lines import lines
from . import folds, local_marks, row_choice, row_smoothing


@dataclass(frozen=True)
class Asked:
    """deviation: m, root mean square of the moves of the points that may move."""

    deviation: float
    keep_ends: bool = True
    keep_stations: bool = True

    def checked(self):
        limits.within(self.deviation, "Deviation in m", 0.0, limits.LONGEST)
        return self


@dataclass(frozen=True, eq=False)
class Report:
    """What came of it. key: the geometry of the hull it gave; count: of the points that moved; rms,
    largest: m, of their moves; is_bound: the deviation bounds them; before, after: inflections of
    the rows; marks_before, marks_after: local_marks.Marks of the surface around them."""

    key: object
    count: int
    rms: float
    largest: float
    is_bound: bool
    before: int
    after: int
    marks_before: local_marks.Marks
    marks_after: local_marks.Marks

    @property
    def has_more_marks(self):
        return self.after > self.before or self.marks_after.is_more_than(self.marks_before)


@dataclass
class LastRow:
    """The Report of the last rows of a hull that were smoothed, or None."""

    report: object = None


def fair_rows(obj, scene, asked):
    """Smooths the selected rows of a hull in edit mode, as Asked; returns the Report. Selected
    points move so that the whole rows that they are of are smooth. Locked points stay, flats stay
    flat, and points where a row crosses a knuckle, or passes a corner, stay.

    ValueError where that cannot be: nothing moves then.
    """
    asked.checked()
    state = hull_state.up_to_date(obj, scene)
    scale, found = units.metres_per_unit(scene), hull_mesh.read(obj)
    control = found.control(scale)
    choices = row_choice.chosen(obj, control)
    rows = list({choice.row.points.tobytes(): choice.row for choice in choices}.values())
    hull_native = native.require()
    mesh = hull_native.ControlMesh(*control.arguments())
    surface = hull_native.LimitSurface(mesh, found.scheme)
    size = lines.size_of(surface)
    allowed = move_limits.of_hull(obj, control.vertex_ids, control.points)
    points = np.unique(np.concatenate([row.points for row in rows]))
    parts = [(row.points[part], closed) for row in rows for part, closed in row.parts()]
    smoothed = row_smoothing.smooth(
        control.points[points],
        [(np.searchsorted(points, part), closed) for part, closed in parts],
        _conditions(points, _held(rows, choices, asked), asked, allowed.reshape_arguments(surface)),
        asked.deviation,
    )
    moves = np.zeros_like(control.points)
    moves[points] = smoothed.moves
    is_moved = moves.any(axis=1)
    moved = hull_native.LimitSurface(mesh.with_points(control.points + moves), found.scheme)
    folds.refuse(surface, moved)
    around = local_marks.Around(surface, control.points[points], size)
    inflections = [
        sum(len(row_combs.inflections(each, row)) for row in rows)
        for each in (control.points, control.points + moves)
    ]
    indices = control.vertex_ids[is_moved]
    before = found.data.points[indices].astype(np.float64)
    mesh_points.write(obj.data, indices, before + moves[is_moved] / scale)
    state = hull_state.follow_edit(obj, scene, is_by_hand=False)
    report = state.of(LastRow).report = Report(
        state.ship.geometry_key,
        int(np.count_nonzero(is_moved)),
        smoothed.rms,
        float(np.linalg.norm(moves, axis=1).max()),
        smoothed.is_bound,
        *inflections,
        around.now,
        around.of(moved) if is_moved.any() else around.now,
    )
    return report


def _held(rows, choices, asked):
    """The control points that stay altogether: those that are not chosen, those at knuckles, and
    at ends if these are kept."""
    everything = np.concatenate([row.points for row in rows])
    held = [np.setdiff1d(everything, np.concatenate([choice.moving for choice in choices]))]
    held += [row.points[list(row.knuckles)] for row in rows]
    if asked.keep_ends:
        held += [choice.ends for choice in choices]
    return np.concatenate(held).astype(np.int64)


def _conditions(points, held, asked, allowed):
    """As row_smoothing.smooth takes them, of control points (n,), rising, of which `held` stay;
    allowed: constraints.move_limits.MoveLimits.reshape_arguments()."""
    count = len(points)
    place = {int(point): i for i, point in enumerate(points)}
    rows = []

    def hold(terms):
        """The sum over (control point, direction) is kept; points of no row do not move."""
        row = np.zeros((count, 3))
        for point, direction in terms:
            if int(point) in place:
                row[place[int(point)]] += direction
        if row.any():
            rows.append(row.ravel())

    for point in {*held.tolist(), *allowed["locked"].tolist()}:
        for axis in np.eye(3):
            hold([(point, axis)])
    for point in points if asked.keep_stations else ():
        hold([(point, (1.0, 0.0, 0.0))])
    for point, normal in zip(allowed["held_points"], allowed["held_normals"]):
        hold([(point, normal)])
    for pair, direction in zip(allowed["tied"], allowed["tied_directions"]):
        hold([(pair[0], direction), (pair[1], -np.asarray(direction))])
    for of_points, directions in allowed["kept"]:
        hold(zip(of_points, directions))
    return np.array(rows).reshape(-1, 3 * count)


def last_report(obj):
    """(the Report of the last smoothing of rows of a hull or None, whether the hull is as that made
    it)."""
    return hull_state.last_report(obj, LastRow)


def rows(report):
    """Pairs (name, value) of what a panel shows of a Report."""
    before, after = report.marks_before, report.marks_after
    return [
        ("Points moved", str(report.count)),
        ("RMS move", units.format_mm(report.rms)),
        ("Largest move", units.format_mm(report.largest)),
        ("Inflections of rows", f"{report.before} → {report.after}"),
        ("of the surface", f"{before.inflections} → {after.inflections}"),
        ("Extrema", f"{before.extrema} → {after.extrema}"),
    ]


def summary(report):
    """A Report as a sentence."""
    bound = "" if report.is_bound else ": as smooth as they can be"
    text = (
        f"{counted(report.count, 'point')} moved by {units.format_mm(report.rms)} RMS, "
        f"{units.format_mm(report.largest)} at most{bound}; inflections of the rows "
        f"{report.before} → {report.after}, of the surface around "
        f"{report.marks_before.inflections} → {report.marks_after.inflections}"
    )
    return f"More marks than before. {text}" if report.has_more_marks else text
