# SPDX-License-Identifier: GPL-3.0-or-later
"""Engines that carry out a study: here, by processes, or on a Dask cluster.

Each has `finished(task, batches)`: it yields (number of a batch, [Row] of it) as they are done, in
any order. batches: lists of variants. What is under way is a few batches a worker, so that a study
of any size can be stopped at once. All give the same rows, bit by bit: a row depends on its task
and its variant alone.
"""

import concurrent.futures
import multiprocessing
import os
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass

from .evaluation import evaluate
from .parent_death import end_with_parent

# Batches for each worker that are under way or waiting: while results come back none is idle.
_AHEAD = 3
_ENDED = (
    "A worker ended before its time, as when memory runs out. What is done is kept: go on with the "
    "same journal, with fewer processes."
)


@dataclass(frozen=True)
class Serial:
    """In this process, one after the other."""

    def finished(self, task, batches):
        for number, batch in enumerate(batches):
            yield number, evaluate(task, batch)


@dataclass(frozen=True)
class Processes:
    """Processes on this machine, as many as it has processors where none are said. They are
    started afresh ("spawn"): a script that uses them keeps its work below
    `if __name__ == "__main__":`."""

    workers: int = 0

    def finished(self, task, batches):
        workers = _workers(self.workers)
        pool = concurrent.futures.ProcessPoolExecutor(
            workers, multiprocessing.get_context("spawn"), initializer=_begin, initargs=(task,)
        )
        try:
            yield from _spread(
                batches,
                _AHEAD * workers,
                lambda batch: pool.submit(_of_batch, batch),
                lambda waiting: concurrent.futures.wait(
                    waiting, return_when=concurrent.futures.FIRST_COMPLETED
                ).done,
            )
        except BrokenProcessPool as error:
            raise RuntimeError(_ENDED) from error
        finally:
            pool.shutdown(wait=False, cancel_futures=True)


@dataclass(frozen=True)
class Dask:
    """A Dask cluster: that at an address, such as "tcp://host:8786", whose workers find hull_native
    and the packages beside it on their path; without one, of so many processes on this machine."""

    address: str = ""
    workers: int = 0

    def finished(self, task, batches):
        distributed = _distributed()
        with self._client(distributed) as client:
            ahead = _AHEAD * max(len(client.scheduler_info()["workers"]), 1)
            # The task goes with each batch, some dozen kilobytes: what is kept on workers goes with
            # them, and a worker that ends is replaced, and its batches are made by others.
            try:
                yield from _spread(
                    batches,
                    ahead,
                    lambda batch: client.submit(evaluate, task, batch, pure=False),
                    lambda waiting: distributed.wait(
                        list(waiting), return_when="FIRST_COMPLETED"
                    ).done,
                )
            except distributed.KilledWorker as error:
                raise RuntimeError(_ENDED) from error

    def _client(self, distributed):
        if self.address:
            return distributed.Client(self.address)
        cluster = distributed.LocalCluster(
            n_workers=_workers(self.workers),
            threads_per_worker=1,
            processes=True,
            dashboard_address=None,
        )
        return _ClientOfCluster(distributed, cluster)


class _ClientOfCluster:
    """A client that ends its cluster with it."""

    def __init__(self, distributed, cluster):
        self._distributed, self._cluster = distributed, cluster

    def __enter__(self):
        self._cluster.__enter__()
        self._client = self._distributed.Client(self._cluster)
        return self._client.__enter__()

    def __exit__(self, *error):
        self._client.__exit__(*error)
        self._cluster.__exit__(*error)


def _distributed():
    try:
        import distributed
    except ImportError as error:
        raise ValueError(
            "There is no Dask here: install python3-distributed, or use processes."
        ) from error
    return distributed


def _workers(wanted):
    return wanted if wanted > 0 else len(os.sched_getaffinity(0))


def _spread(batches, ahead, submit, wait):
    """Submits batches so that `ahead` of them are under way; yields (number, result)."""
    waiting, left = {}, enumerate(batches)
    while True:
        for number, batch in left:
            waiting[submit(batch)] = number
            if len(waiting) >= ahead:
                break
        if not waiting:
            return
        for done in wait(waiting):
            yield waiting.pop(done), done.result()


_task = None  # of a worker of Processes


def _begin(task):
    global _task
    _task = task
    end_with_parent()


def _of_batch(batch):
    return evaluate(_task, batch)
