# SPDX-License-Identifier: GPL-3.0-or-later
"""What an eye sees that is not fair on a hull's lines and reflection lines: the task that counts,
its report, and the marks that were accepted as what the design calls for.

It is what hull_fairness.lines finds: inflections and dips of stations, waterlines, buttocks,
creases and borders, kinks and waves of reflection lines.
"""

from collections import Counter
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from mathutils import Vector

from ....hull_fairness import lines as judging
from ...bridge import native
from ...bridge.background import jobs
from ...bridge.blender import units, view_target
from ...bridge.mesh import selection
from ..conversion import conversions
from ..hull import form_before, hull_state

# By hull_fairness's marks: what several are called.
NAMES = {"inflection": "Inflections", "dip": "Flat spots", "kink": "Kinks", "wave": "Waves"}
CHANGE = "Since the form before"
# Of the beam: an accepted mark may wander by as much to each side.
_WANDERS = 0.1
_VIEW_DISTANCE = 0.15  # of the length
_ACCEPTED = "accepted"
# Of the work of comparing: the form before is judged itself, and six images of it.
_BEFORE = 7.0 / 8.0


@dataclass(frozen=True)
class Report:
    """key: the geometry of the hull that was judged. judged: its hull_fairness.lines.Lines; places:
    (Line, Found) of what is not accepted; before: how many there were of each mark when it was
    counted before, or None; least: m, what is less deep is not seen; change: the
    hull_fairness.changes.MarkChange from the form before, or None."""

    key: object
    judged: tuple
    places: tuple
    least: float
    before: object = None
    change: object = None

    @property
    def counts(self):
        """How many are not accepted, by mark."""
        return Counter(found.mark for _, found in self.places)

    @cached_property
    def new_count(self):
        """How many of the places the form before had not."""
        return sum(map(self.is_new, self.places))

    def is_new(self, place):
        return _key_of(*place) in self._new_keys

    @cached_property
    def _new_keys(self):
        new = () if self.change is None else self.change.new
        return {_key_of(one.line, one.found) for one in new}

    @property
    def accepted(self):
        return sum(len(line.found) for line in self.judged) - len(self.places)


def _key_of(line, found):
    return line.name, found.mark, found.point


@dataclass
class Known:
    """The last Report of a hull, or None, and which of its places is shown."""

    report: object = None
    shown: int = -1


class Judging(jobs.JobTask):
    """The task of judging a hull as it is now; see features.conversion.conversions. is_compared:
    with what the form before has; ValueError where that is not known. result():
    ([hull_fairness.lines.Line], the MarkChange or None)."""

    text = "Counting marks"

    def __init__(self, obj, scene, is_compared=False):
        self.state = hull_state.up_to_date(obj, scene)
        conversions.clear_way(obj)
        source, self._key = self.state.ship.source, self.state.ship.geometry_key
        scale = units.metres_per_unit(scene)
        beam = beam_of(obj, source.control.points, scale)
        if not beam > 0.0:
            raise ValueError("Give the beam first: what is seen is measured by it")
        self._least = judging.LEAST_DEPTH * beam
        form = form_before.MarksBefore(obj, beam) if is_compared else None
        wanted, surface = wanted_of(obj, scale, beam), source.new_surface()
        self._job = jobs.Job(lambda progress: _judged(surface, beam, wanted, form, progress))
        conversions.watch(self)

    def note(self, obj, scene):
        """Notes what came of it for panels to show; returns the Report."""
        known = self.state.of(Known)
        before = None if known.report is None else known.report.counts
        lines, change = self.result()
        report = Report(self._key, tuple(lines), (), self._least, before, change)
        known.report, known.shown = _sifted(report, obj, scene), -1
        return known.report


def _judged(surface, beam, wanted, form, progress):
    """What Judging gives; form: the form_before.MarksBefore or None."""
    if form is None:
        return judging.judged(surface, beam, progress=progress), None
    known = form.known(lambda share: progress(_BEFORE * share))
    lines = judging.judged(
        surface, beam, progress=lambda share: progress(_BEFORE + (1.0 - _BEFORE) * share)
    )
    return lines, known.compared(lines, surface, wanted)


def beam_of(obj, points, scale):
    """m: the beam that was given, or that of control points (n, 3) in m."""
    return scale * obj.hull.beam or 2.0 * float(np.abs(points[:, 1]).max())


def wanted_of(obj, scale, beam):
    """What is accepted, as hull_fairness.lines has what a design calls for; beam in m."""
    found = []
    for entry in obj.hull.fairness.accepted:
        point = scale * np.array(entry.point)
        box = {axis: (x - _WANDERS * beam, x + _WANDERS * beam) for axis, x in zip("xyz", point)}
        found.append((entry.line, entry.mark, 1, box, _ACCEPTED))
    return tuple(found)


def _sifted(report, obj, scene):
    """The Report with the places that are not accepted."""
    scale = units.metres_per_unit(scene)
    wanted = wanted_of(obj, scale, report.least / judging.LEAST_DEPTH)
    places = [
        (line, found)
        for line in report.judged
        for found in judging.with_reasons(line.kind, line.found, wanted)
        if found.reason is None
    ]
    new_first = sorted(places, key=lambda place: not report.is_new(place))
    return replace(report, places=tuple(new_first))


def last_report(obj):
    """(the last Report of a hull or None, whether it is of the hull as it is)."""
    return hull_state.last_report(obj, Known)


def shown_place(obj):
    """(number, (Line, Found)) of the place that is shown of a hull; (-1, None) where none is."""
    known = hull_state.known(obj, Known)
    if known is None or known.report is None or not 0 <= known.shown < len(known.report.places):
        return -1, None
    return known.shown, known.report.places[known.shown]


def accept(obj, scene, is_all):
    """Takes the place that is shown, or all, as what the design calls for; returns how many."""
    known = _known(obj)
    chosen = known.report.places
    if not is_all:
        number, place = shown_place(obj)
        if place is None:
            raise ValueError("Choose a mark first: press Select")
        chosen = (place,)
        known.shown = number - 1
    scale = units.metres_per_unit(scene)
    for line, found in chosen:
        entry = obj.hull.fairness.accepted.add()
        entry.line, entry.mark = line.kind, found.mark
        entry.point = np.array(found.point) / scale
    known.report = _sifted(known.report, obj, scene)
    return len(chosen)


def accept_none(obj, scene):
    """Forgets what was accepted; returns how many marks that were."""
    count = len(obj.hull.fairness.accepted)
    obj.hull.fairness.accepted.clear()
    known = hull_state.known(obj, Known)
    if known is not None and known.report is not None:
        known.report, known.shown = _sifted(known.report, obj, scene), -1
    return count


def show(context, obj, step):
    """Shows the next place, with step -1 the one before, with 0 the same again: the 3D cursor goes
    there, in edit mode the control points around are selected, and the 3D view looks there. Returns
    its text."""
    known, count = _known(obj), len(_known(obj).report.places)
    if not count:
        raise ValueError("There are no marks but accepted ones")
    known.shown = (max(known.shown, 0 if step <= 0 else -1) + step) % count
    line, found = known.report.places[known.shown]
    _look_at(context, obj, found.point)
    if obj.mode == "EDIT" and last_report(obj)[1]:
        selection.select(context, obj, "vertex", _points_around(obj, found.point))
    return f"{known.shown + 1} of {count}: {text_of(line, found)}"


def text_of(line, found):
    return f"{found.mark} on {line.name}, {found.size}"


def _known(obj):
    report, _ = last_report(obj)
    if report is None:
        raise ValueError("Nothing is known of the hull's marks: press Count Marks first")
    return hull_state.state_of(obj).of(Known)


def _look_at(context, obj, point):
    scale, view = units.metres_per_unit(context.scene), context.region_data
    context.scene.cursor.location = obj.matrix_world @ (Vector(point) / scale)
    view_target.look_at(view, context.scene.cursor.location)
    if view is not None:
        view.view_distance = _VIEW_DISTANCE * max(obj.dimensions)


def _points_around(obj, point):
    """Blender's points of the face that a place on the surface is of."""
    ship = hull_state.state_of(obj).ship
    control = ship.source.control
    tree = native.require().SurfaceTree(ship.surface)
    cell = int(tree.closest_points(np.array([point])).cells[0])
    face = int(np.searchsorted(np.cumsum(control.face_sizes), cell, side="right"))
    first = int(np.sum(control.face_sizes[:face]))
    corners = control.face_vertices[first : first + int(control.face_sizes[face])]
    return control.vertex_ids[corners].tolist()


def change_text(report):
    """What a change of the form did, such as "3 new, 1 gone"."""
    return f"{report.new_count} new, {len(report.change.gone)} gone"


def rows(report):
    """Pairs (name, value) of what a panel shows of a Report."""
    found = [] if report.change is None else [(CHANGE, change_text(report))]
    for mark, name in NAMES.items():
        before = "" if report.before is None else f"{report.before[mark]} → "
        found.append((name, f"{before}{report.counts[mark]}"))
    found.append(("Least depth", units.format_mm(report.least)))
    if report.accepted:
        found.append(("Accepted", str(report.accepted)))
    return found


def summary(report):
    """A Report as a sentence."""
    counts = report.counts
    text = ", ".join(f"{counts[mark]} {name.lower()}" for mark, name in NAMES.items())
    if report.change is not None:
        text = f"{CHANGE}: {change_text(report)}. {text}"
    return f"{text}, seen from {units.format_mm(report.least)} depth on"
