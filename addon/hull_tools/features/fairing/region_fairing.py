# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface faired around the control points that are selected in edit mode.

How far it may shift is asked for, and met: hull_native.FairRegion. What is prepared for it is
remembered, so that another deviation in the redo panel costs next to nothing.
"""

from dataclasses import dataclass, field

import numpy as np

from ...bridge import limits, native
from ...bridge.background import jobs
from ...bridge.blender import units
from ...bridge.counts import counted
from ...bridge.mesh import mesh_points
from ...bridge.objects import hull_mesh
from ..constraints import move_limits
from ..conversion import conversions
from ..hull import hull_state
from ..hull.as_it_was import AsItWas
from ..lines import lines
from . import form_keeping, local_marks, marks_out, seen_marks

# As hull_native.FairRegion names them, in capitals.
ENERGIES = ("LENGTHWISE", "BLEND", "THIN_PLATE", "CURVATURE", "VARIATION")


@dataclass(frozen=True)
class Asked:
    """deviation, largest: m; largest 0: any. energy: of ENERGIES. by_marks: the deviation is found
    by marks_out, not above the one given."""

    deviation: float
    largest: float = 0.0
    energy: str = ENERGIES[0]
    keep_stations: bool = True
    keep_creases: bool = True
    along_normals: bool = True
    refuse_more: bool = False
    keep_volume: bool = False
    keep_lcb: bool = False
    by_marks: bool = False

    @property
    def kept(self):
        """Names of numbers as form_keeping has them."""
        wanted = ((form_keeping.VOLUME, self.keep_volume), (form_keeping.LCB, self.keep_lcb))
        return tuple(name for name, is_kept in wanted if is_kept)

    def checked(self):
        limits.within(self.deviation, "Deviation in m", 0.0, limits.LONGEST)
        limits.within(self.largest, "Largest in m", 0.0, limits.LONGEST)
        return self


@dataclass(frozen=True, eq=False)
class Report:
    """What came of it. key: the geometry of the hull it gave; rms, largest: m, of the surface's
    shift; bound: see hull_native.Faired; before, after: Marks around the points; missed: by how
    much kept numbers changed, by their names in form_keeping, in m³ and m."""

    key: object
    count: int
    rms: float
    largest: float
    bound: str
    gain: float
    settled: bool
    before: local_marks.Marks
    after: local_marks.Marks
    missed: dict = field(default_factory=dict)

    @property
    def has_more_marks(self):
        return self.after.is_more_than(self.before)


@dataclass
class LastFairing:
    """The Report of the last fairing of a hull, or None."""

    report: object = None


@dataclass
class Prepared:
    """What the last fairing of a hull was prepared with: (its key, hull_native.FairRegion,
    local_marks.Around), or None."""

    last: tuple = None


class _Start:
    """A hull as it is before it is faired, and what is prepared for that."""

    def __init__(self, obj, scene, asked):
        self.asked, self.state = asked.checked(), hull_state.up_to_date(obj, scene)
        self._kept = self.state.of(Prepared)  # here: `solve` may be in a thread
        self.scale = units.metres_per_unit(scene)
        self.found = hull_mesh.read(obj)
        self.control = self.found.control(self.scale)
        self.chosen = np.flatnonzero(
            np.isin(self.control.vertex_ids, mesh_points.selected(obj.data))
        )
        if not len(self.chosen):
            raise ValueError("Select the control points that are to move first")
        hull_native = native.require()
        mesh = hull_native.ControlMesh(*self.control.arguments())
        self.surface = hull_native.LimitSurface(mesh, self.found.scheme)
        self.size = lines.size_of(self.surface)
        self.limits = move_limits.of_hull(obj, self.control.vertex_ids, self.control.points)
        self.seen = self._seen(obj) if asked.by_marks else None
        self.keeping = form_keeping.keeping(obj, self.scale, self.state.ship.source, asked.kept)

    def _seen(self, obj):
        beam = seen_marks.beam_of(obj, self.control.points, self.scale)
        box = marks_out.around(self.control, self.chosen, beam)
        wanted = seen_marks.wanted_of(obj, self.scale, beam)
        return marks_out.Seen(self.surface, beam, wanted, box)

    def prepared(self):
        """(hull_native.FairRegion, local_marks.Around), those of the last time where nothing but
        the deviation differs."""
        asked, held = self.asked, self.limits
        key = (
            self.found.topology_key,
            self.found.points_digest,
            self.scale,
            self.chosen.tobytes(),
            held.key(),
            (asked.energy, asked.keep_stations, asked.keep_creases, asked.along_normals),
            self.keeping and self.keeping.key,
        )
        if self._kept.last is None or self._kept.last[0] != key:
            region = native.require().FairRegion(
                self.surface,
                self.chosen,
                energy=asked.energy.lower(),
                keep_stations=asked.keep_stations,
                keep_creases=asked.keep_creases,
                along_normals=asked.along_normals,
                conditions=self.keeping.conditions() if self.keeping else (),
                **held.reshape_arguments(self.surface),
            )
            around = local_marks.Around(self.surface, self.control.points[self.chosen], self.size)
            self._kept.last = key, region, around
        return self._kept.last[1:]

    def solve(self, progress=None):
        """(hull_native.Faired, Marks before, Marks after, what kept numbers miss)."""
        asked, (region, around) = self.asked, self.prepared()
        # While deviations are tried it is these that are told of.
        told = None if asked.by_marks else progress

        def solution(deviation, values=()):
            largest = asked.largest or np.inf
            return region.solve(deviation, largest=largest, values=values, progress=told)

        missed = {}  # by the last solution, which is the one that is taken

        def faired_for(deviation):
            if self.keeping is None:
                return solution(deviation)
            faired, shares = self.keeping.solve(lambda values: solution(deviation, values))
            missed.update(zip(self.keeping.names, shares * self.keeping.sizes))
            return faired

        if asked.by_marks:
            tell = progress or (lambda share: None)
            faired = marks_out.best(faired_for, self.seen.count, asked.deviation, tell)
        else:
            faired = faired_for(asked.deviation)
        if faired.folded_place is not None:
            place = ", ".join(f"{x:.2f}" for x in faired.folded_place)
            raise ValueError(
                f"The surface would be turned over at ({place}) m: give a smaller deviation"
            )
        before, after = around.now, around.moved(faired.moves)
        if self.asked.refuse_more and after.is_more_than(before):
            raise ValueError(f"Refused, since there would be more marks: {_marks(before, after)}")
        return faired, before, after, missed

    def write(self, obj, scene, faired, before, after, missed):
        """Moves the points; returns the Report. Coordinates that do not move stay bit by bit."""
        is_moved = faired.moves.any(axis=1)
        indices = self.control.vertex_ids[is_moved]
        points = self.found.data.points[indices].astype(np.float64)
        mesh_points.write(obj.data, indices, points + faired.moves[is_moved] / self.scale)
        state = hull_state.follow_edit(obj, scene, is_by_hand=False)
        report = state.of(LastFairing).report = Report(
            state.ship.geometry_key,
            int(np.count_nonzero(is_moved)),
            faired.rms,
            faired.largest,
            faired.bound,
            1.0 - faired.energy_after / faired.energy_before if faired.energy_before else 0.0,
            faired.settled,
            before,
            after,
            missed,
        )
        return report


def fair_selected(obj, scene, asked):
    """Fairs a hull in edit mode around its selected points, as Asked; returns the Report.

    ValueError where that cannot be: nothing moves then.
    """
    start = _Start(obj, scene, asked)
    return start.write(obj, scene, *start.solve())


class Fairing(jobs.JobTask):
    """The same as a task; see features.conversion.conversions. result(): what write() takes."""

    text = "Fairing"

    def __init__(self, obj, scene, asked):
        self._start = _Start(obj, scene, asked)
        self.state = self._start.state
        self._before = AsItWas(obj, scene, "fair it again")
        conversions.clear_way(obj)
        self._job = jobs.Job(self._start.solve)
        conversions.watch(self)

    def write(self, scene):
        """Moves the hull's control points; returns the Report. ValueError when the hull is no
        longer what was faired."""
        solved = self.result()
        return self._start.write(self._before.checked(scene), scene, *solved)


def last_report(obj):
    """(the Report of a hull's last fairing or None, whether the hull is as that made it)."""
    return hull_state.last_report(obj, LastFairing)


def rows(report):
    """Pairs (name, value) of what a panel shows of a Report."""
    before, after = report.before, report.after
    return [
        ("Points moved", str(report.count)),
        ("RMS shift", units.format_mm(report.rms)),
        ("Largest shift", units.format_mm(report.largest)),
        ("Inflections", f"{before.inflections} → {after.inflections}"),
        ("Extrema", f"{before.extrema} → {after.extrema}"),
        *((_MISSED[name], f"{miss:.1e} {_UNITS[name]}") for name, miss in report.missed.items()),
    ]


def _marks(before, after):
    return (
        f"inflections {before.inflections} → {after.inflections}, "
        f"extrema of curvature {before.extrema} → {after.extrema}"
    )


_MISSED = {form_keeping.VOLUME: "∇ changed by", form_keeping.LCB: "LCB changed by"}
_UNITS = {form_keeping.VOLUME: "m³", form_keeping.LCB: "m"}
_BOUNDS = {
    "deviation": "",
    "largest": ", as far as the largest shift lets",
    "nothing": ": as fair as these points can make it",
}


def summary(report):
    """A Report as a sentence."""
    text = (
        f"{counted(report.count, 'point')} moved, surface shifted by "
        f"{units.format_mm(report.rms)} RMS, {units.format_mm(report.largest)} at most"
        f"{_BOUNDS[report.bound]}; {_marks(report.before, report.after)}"
    )
    for name, miss in report.missed.items():
        text += f"; {_MISSED[name]} {miss:.1e} {_UNITS[name]}"
    if report.has_more_marks:
        text = f"More marks than before. {text}"
    return text if report.settled else f"{text}. It may get fairer still: fair again"
