# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls brought to a wanted displacement and centre of buoyancy in the way that leaves the fewest
new marks: by shifts of the sections, or by the least change, each with its marks faired out."""

from dataclasses import dataclass
from functools import partial

from ....hull_fairness import changes, fewest_marks
from ...bridge.counts import counted
from . import fair_changes, form_parameters, least_change, parents, reports, section_shifts
from .parent_task import ParentTask

# Of the work: the form before is judged itself, and six images of it.
_BEFORE = 0.25
SHIFTS, LEAST = "shifts of sections", "least change"


@dataclass(frozen=True)
class Asked:
    """volume, lcb, parallel: as least_change.Asked has them; most: as fair_changes.Asked does."""

    volume: dict
    lcb: object
    most: float
    parallel: bool = True


@dataclass(frozen=True)
class Changed:
    """tried: [hull_fairness.fewest_marks.Tried], of which the first was taken; after:
    form_parameters.FormParameters."""

    tried: list
    after: form_parameters.FormParameters


class FewestMarks(ParentTask):
    """The task of bringing a hull as it is now to what is Asked; see conversion.conversions."""

    text = "Looking for the fewest new marks"

    def __init__(self, obj, scene, asked):
        least = least_change.Asked(asked.volume, asked.lcb, parallel=asked.parallel)
        least.targets()  # what is wrong with them is told before all else
        super().__init__(obj, scene)
        parent = self.parent
        self._asked, self._known = asked, None
        self._fairing = fair_changes.NewMarks(
            parent, fair_changes.Asked(asked.most, asked.parallel)
        )
        wanted = section_shifts.Wanted(asked.volume, asked.lcb, "fair")
        self._shift = section_shifts.new_shift(parent, wanted)
        self._least = least_change.LeastMoves(parent, least)
        self.begin(self._run)

    def _run(self, progress):
        """[hull_fairness.fewest_marks.Tried]; ValueError where no way leads there."""
        found = self._found(lambda: progress(0.0))  # before marks are counted, which takes longer
        self._known = changes.Known(
            self.parent.surface, self._fairing.beam, lambda share: progress(_BEFORE * share)
        )

        def later(share):
            progress(_BEFORE + (1.0 - _BEFORE) * share)

        return fewest_marks.fewest_marks(
            self._known,
            {name: partial(_again, moves) for name, moves in found.items()},
            lambda surface, tell: self._fairing.faired(self._known, surface, tell),
            self._fairing.wanted,
            later,
        )

    def _found(self, tell):
        """{name of a way: its moves, or the ValueError with why it leads nowhere}; ValueError where
        none does. tell: called now and then."""
        ways = {
            SHIFTS: lambda: self._shifted().moves,
            LEAST: lambda: self._least.reached(lambda share: tell()).moves,
        }
        found = {}
        for name, way in ways.items():
            try:
                found[name] = way()
            except ValueError as refused:
                found[name] = refused
        if all(isinstance(one, ValueError) for one in found.values()):
            raise ValueError(". ".join(f"By {name}: {why}" for name, why in found.items()))
        return found

    def _shifted(self):
        found = self._shift.solve(**self._asked.volume, lcb=self._asked.lcb)
        if not found.converged:
            raise ValueError(section_shifts.NO_END)
        return found

    def write(self, scene):
        """Moves the hull's control points; returns Changed. ValueError when the hull is no longer
        what it was."""
        tried = self.result()
        state = self.moved(scene, tried[0].moves, self._known)
        found = parents.hydrostatics_of(state, self.parent.where)
        return Changed(tried, form_parameters.of_hydrostatics(found))


def _again(found):
    """The moves that were found, or the refusal."""
    if isinstance(found, ValueError):
        raise found
    return found


def summary(changed, scene):
    """Changed as (a sentence, whether new marks are left)."""
    best, *others = changed.tried
    text = f"{reports.form_parameters(changed.after, scene)}; by {best.name}: {_marks(best)}"
    for one in others:
        text += f"; by {one.name}: {'out of reach' if one.refusal else _marks(one)}"
    return text, bool(best.new)


def _marks(one):
    made, left = counted(one.made, "new mark"), len(one.new)
    if not one.rms and left == one.made:
        return made
    return f"{made}, faired to {left}"
