# SPDX-License-Identifier: GPL-3.0-or-later
"""New marks of a hull that was transformed taken out again; displacement and LCB stay."""

from dataclasses import dataclass, replace

import numpy as np

from ....hull_fairness import fair_changes, kept_numbers
from ...bridge import limits, native
from ...bridge.blender import units
from ...bridge.counts import counted
from ..fairing import seen_marks
from ..hull import form_before
from . import form_parameters
from .parent_task import ParentTask

# Of the work: the form before is judged itself, and six images of it; then some dozen counts.
_BEFORE = 0.35


@dataclass(frozen=True)
class Asked:
    """most: of the beam, the root mean square shift that is not exceeded. parallel: the parallel
    middle body stays."""

    most: float
    parallel: bool = True


class NewMarks:
    """Fairs new marks out of a parents.Parent, or of what it is when its points have moved; all of
    Blender's is read here."""

    def __init__(self, parent, asked):
        limits.within(asked.most, "Deviation over B", 0.0, 1.0)
        self.beam = seen_marks.beam_of(parent.obj, parent.control.points, parent.scale)
        if not self.beam > 0.0:
            raise ValueError("Give the beam first: what is seen is measured by it")
        self.wanted = seen_marks.wanted_of(parent.obj, parent.scale, self.beam)
        self._parent, self._asked = parent, asked
        self._position = parent.position()
        self._limits = parent.reach_arguments(False, False, False)

    def faired(self, known, surface, progress):
        """The hull_fairness.fair_changes.FairChange of a LimitSurface with the parent's mesh, but
        for its points; known: hull_fairness.changes.Known of the form before."""
        return fair_changes.fair_new_marks(
            known,
            surface,
            self._asked.most * self.beam,
            self._kept(surface),
            self.wanted,
            progress=progress,
            **self._held(surface),
        )

    def _held(self, surface):
        hull_native = native.require()
        parallel = ()
        if self._asked.parallel:
            body = self._body(surface.mesh.points)
            parallel = form_parameters.parallel_of(body, self._position, self._parent.where)
        held, normals = fair_changes.held_form(surface, parallel)
        tied, directions = hull_native.square_ties(surface)
        return {
            "locked": self._limits["locked"],
            "held_points": np.concatenate([self._limits["held_points"], held]),
            "held_normals": np.concatenate([self._limits["held_normals"], normals]),
            "tied": tied,
            "tied_directions": directions,
            "kept": hull_native.square_sums(surface),
        }

    def _kept(self, surface):
        where = self._parent.where
        return kept_numbers.kept_numbers(
            self._body,
            surface.mesh.points,
            (kept_numbers.VOLUME, kept_numbers.LCB),
            length_pp=where.length_pp or None,
            water_density=where.water_density,
            **self._position,
        )

    def _body(self, points):
        return self._parent.moved_body(points - self._parent.control.points)


class FairingChange(ParentTask):
    """The task of taking out the marks that a hull has and the form before had not; see
    conversion.conversions."""

    text = "Fairing new marks"

    def __init__(self, obj, scene, asked):
        super().__init__(obj, scene)
        self._fairing = NewMarks(self.parent, asked)
        self._marks_before = form_before.MarksBefore(obj, self._fairing.beam)
        self.begin(self._run)

    def _run(self, progress):
        known = self._marks_before.known(lambda share: progress(_BEFORE * share))
        return self._fairing.faired(
            known,
            self.parent.surface,
            lambda share: progress(_BEFORE + (1.0 - _BEFORE) * share),
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
    along = float(np.abs(found.moves[:, 0]).max())
    if along:
        shift = f"{shift}, points along the ship by {units.format_mm(along)} at most"
    return f"{text}; the surface shifts by {shift}; ∇ and LCB stay", bool(found.new)
