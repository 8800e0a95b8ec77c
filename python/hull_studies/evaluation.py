# SPDX-License-Identifier: GPL-3.0-or-later
"""One variant's row, of plain data alone: the same in whatever process, in whatever order.

A row's status is "made", "missed" where not all that was wanted is met (its numbers are those of
the hull that is nearest), or "refused" where there is no such hull. Reasons are sentences.
"""

import threading
from dataclasses import dataclass
from math import isfinite
from operator import attrgetter

import hull_native as hn

from .changes import column_names, told_numbers
from .hull_set import HullSet
from .making import DIMENSIONS, Maker
from .values import resolved

MADE, MISSED, REFUSED = STATUSES = ("made", "missed", "refused")
WATER_DRAFT = "water_draft"


@dataclass(frozen=True)
class Row:
    """What became of a variant: numbers by the columns of the task, None of one that is not
    defined; none at all where the variant is refused."""

    status: str
    reason: str
    numbers: dict


@dataclass(frozen=True, eq=False)
class Task:
    """What a worker needs to make rows: plain data and arrays. digest: of the Study, and of the
    HullSet; variables: their names; changes, water, numbers: as the Study has them."""

    digest: tuple
    variables: tuple
    changes: list
    water: dict
    numbers: tuple
    hulls: HullSet

    @property
    def columns(self):
        """Names of all numbers of a row, in their order."""
        told = told_numbers(self.changes, len(self.hulls.parents))
        return [*DIMENSIONS, WATER_DRAFT, *self.numbers, *told]


def task_of(study, hulls):
    """The Task of a Study and its HullSet."""
    digest = (study.digest, hulls.digest)
    return Task(digest, tuple(study.variables), study.changes, study.water, study.numbers, hulls)


class Evaluator:
    """Makes the rows of a Task in one thread; what depends on topology alone is prepared once."""

    def __init__(self, task):
        self.task = task
        self._maker = Maker(task.hulls, task.water["openings"])
        self._names = column_names(task.changes)
        self._get = {name: attrgetter(name) for name in task.numbers}

    def row(self, values):
        """The Row of a variant's values, a tuple in the order of the variables."""
        named = dict(zip(self.task.variables, values))
        changes, water = resolved(self.task.changes, named), resolved(self.task.water, named)
        try:
            form, told = self._maker.made(changes, self._names, water)
            afloat = hn.hydrostatics(self._maker.placed(form), **self._maker.afloat(form, water))
        except ValueError as error:
            return Row(REFUSED, str(error), {})
        except Exception as error:
            error.add_note(f"That was of the study's variant {named}.")
            raise
        numbers = {name: getattr(form, name) for name in (*DIMENSIONS, WATER_DRAFT)}
        numbers |= {name: get(afloat) for name, get in self._get.items()}
        numbers |= told.numbers
        status = MISSED if told.misses else MADE
        found = {name: _defined(numbers.get(name)) for name in self.task.columns}
        return Row(status, " ".join(told.misses), found)


def _defined(value):
    """A float, or None for what is no number."""
    return float(value) if value is not None and isfinite(value) else None


# Of each thread the Evaluator that it used last: workers of a cluster may have several.
_kept = threading.local()


def evaluate(task, batch):
    """[Row] of a batch of variants, tuples of values. A function of its arguments alone: the last
    task's Evaluator is kept because making it takes as long as some rows."""
    evaluator = getattr(_kept, "evaluator", None)
    if evaluator is None or evaluator.task.digest != task.digest:
        evaluator = _kept.evaluator = Evaluator(task)
    return [evaluator.row(values) for values in batch]
