# SPDX-License-Identifier: GPL-3.0-or-later
"""A study carried out, or on from where its journal ends."""

import time
from contextlib import nullcontext
from dataclasses import dataclass

from .engines import Processes
from .evaluation import task_of
from .hull_set import hull_set
from .journal import Expected, Journal, variant_key
from .tables import Table

# Variants that a worker gets at once: enough that handing them over takes no time to speak of, few
# enough that little is done again when a run is killed.
BATCH = 8
_TELL_SECONDS = 1.0


@dataclass(frozen=True)
class Progress:
    """How far a run is: rows that are there, of how many, of which so many were in the journal;
    seconds since it began to make others."""

    done: int
    total: int
    resumed: int
    seconds: float

    @property
    def per_second(self):
        """Rows made a second by this run."""
        made = self.done - self.resumed
        return made / self.seconds if made and self.seconds > 0.0 else 0.0


def run_study(study, journal=None, engine=None, *, hulls=None, progress=None):
    """The Table of a Study, whose rows are in the order of its variants.

    journal: path of a file that keeps rows as they come; with one of the same study the rows that
    are in it are not made again. engine: Processes() if none is given. hulls: the HullSet, if it
    is known already. progress: called with a Progress about once a second, and at both ends; what
    it raises ends the run, and rows that are done are kept. ValueError for a journal that is
    another study's, for hulls that are none; what becomes of a variant is a row, whatever it is.
    """
    task = task_of(study, hulls or hull_set(study))
    keys = [variant_key(study.digest, values) for values in study.variants]
    wanted = dict(zip(keys, study.variants))
    expected = Expected(study, frozenset(wanted), tuple(task.columns), task.hulls.digest)
    with Journal(journal, expected) if journal is not None else nullcontext() as kept:
        rows = dict(kept.rows) if kept else {}
        left = {key: values for key, values in wanted.items() if key not in rows}
        teller = _Teller(progress, len(wanted), len(rows))
        for fresh in _made(task, engine or Processes(), left):
            rows |= fresh
            if kept:
                kept.add(fresh)
            teller.tell(len(rows))
        teller.tell(len(rows), is_last=True)
    return Table(study, task.columns, [rows[key] for key in keys])


def _made(task, engine, left):
    """Yields {key: Row} of batches of {key: values}."""
    if not left:
        return
    keys = list(left)
    batches = [keys[k : k + BATCH] for k in range(0, len(keys), BATCH)]
    values = [[left[key] for key in batch] for batch in batches]
    for number, rows in engine.finished(task, values):
        yield dict(zip(batches[number], rows, strict=True))


class _Teller:
    def __init__(self, progress, total, resumed):
        self._progress, self._total, self._resumed = progress, total, resumed
        self._begun = self._told = time.monotonic()
        self.tell(resumed, is_last=True)

    def tell(self, done, is_last=False):
        now = time.monotonic()
        if self._progress is None or (now - self._told < _TELL_SECONDS and not is_last):
            return
        self._told = now
        self._progress(Progress(done, self._total, self._resumed, now - self._begun))
