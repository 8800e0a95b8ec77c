# SPDX-License-Identifier: GPL-3.0-or-later
"""New marks of a hull that was transformed taken out again; displacement and LCB stay."""

from dataclasses import dataclass, replace

import numpy as np

from ....hull_fairness import fair_changes, kept_numbers
from ...bridge import limits
from ...bridge.blender import units
from ...bridge.counts import counted
from ..fairing import seen_marks
from ..hull import form_before
from . import particulars
from .parent_task import ParentTask

# Of the work: the form before is judged itself, and six images of it; then some dozen counts.
_BEFORE = 0.35


@dataclass(frozen=True)
class Asked:
    """most: of the beam, the root mean square shift that is not exceeded. parallel: the parallel
    middle body stays."""

    most: float
    parallel: bool = True


class FairingChange(ParentTask):
    """The task of taking out the marks that a hull has and the form before had not; see
    conversion.conversions."""

    text = "Fairing new marks"

    def __init__(self, obj, scene, asked):
        limits.within(asked.most, "Deviation over B", 0.0, 1.0)
        super().__init__(obj, scene)
        parent = self.parent
        self._beam = seen_marks.beam_of(obj, parent.control.points, parent.scale)
        if not self._beam > 0.0:
            raise ValueError("Give the beam first: what is seen is measured by it")
        self._marks_before = form_before.MarksBefore(obj, self._beam)
        self._most = asked.most * self._beam
        self._wanted = seen_marks.wanted_of(obj, parent.scale, self._beam)
        self._limits = self._held(asked.parallel)
        self._keeping = self._kept()
        self.begin(self._run)

    def _held(self, keeps_parallel):
        parent = self.parent
        found = parent.reach_arguments(False, False, False)
        parallel = particulars.parallel_body(parent) if keeps_parallel else ()
        held, normals = fair_changes.held_form(parent.surface, parallel)
        found["held_points"] = np.concatenate([found["held_points"], held])
        found["held_normals"] = np.concatenate([found["held_normals"], normals])
        return found

    def _kept(self):
        parent, where = self.parent, self.parent.where
        return kept_numbers.kept_numbers(
            lambda points: parent.moved_body(points - parent.control.points),
            parent.control.points,
            (kept_numbers.VOLUME, kept_numbers.LCB),
            length_pp=where.length_pp or None,
            water_density=where.water_density,
            **parent.position(),
        )

    def _run(self, progress):
        known = self._marks_before.known(lambda share: progress(_BEFORE * share))
        return fair_changes.fair_new_marks(
            known,
            self.parent.surface,
            self._most,
            self._keeping,
            self._wanted,
            progress=lambda share: progress(_BEFORE + (1.0 - _BEFORE) * share),
            **self._limits,
        )

    def write(self, scene):
        """Moves the hull's control points; returns the hull_fairness.fair_changes.FairChange. The
        form before stays what it was. ValueError when the hull is no longer what it was."""
        found = self.result()
        replace(self.parent, obj=self.unchanged(scene)).moved(scene, found.moves)
        return found


def _first(found):
    """The first of the marks that are left, in words."""
    one = found.new[0]
    return f"the first: {seen_marks.text_of(one.line, one.found)}"


def summary(found):
    """A FairChange as (a sentence, whether new marks are left)."""
    if not found.start:
        return "No mark is new: nothing moves", False
    left = counted(len(found.new), "new mark")
    if not found.rms:
        where = _first(found)
        return f"{left}, of which none goes within that deviation: nothing moves; {where}", True
    shift = f"{units.format_mm(found.rms)} RMS, {units.format_mm(found.largest)} at most"
    text = f"{counted(found.start, 'new mark')} before, {len(found.new)} left"
    if found.new:
        text = f"{text}, {_first(found)}"
    return f"{text}; the surface shifts by {shift}; ∇ and LCB stay", bool(found.new)
