# SPDX-License-Identifier: GPL-3.0-or-later
"""A thread that does one piece of work after the other: one for jobs, one for the worker, so that
neither waits for the other."""


class WorkQueue:
    """Its thread is there from the first piece of work on until it is stopped."""

    def __init__(self, name):
        self._name = name
        self._pool = None

    def submit(self, work, *arguments):
        """The Future of work(*arguments)."""
        if self._pool is None:
            # Not before there is work: much of Python's library comes with it.
            from concurrent.futures import ThreadPoolExecutor

            self._pool = ThreadPoolExecutor(1, thread_name_prefix=self._name)
        return self._pool.submit(work, *arguments)

    def stop(self):
        """Drops what has not begun; when this returns nothing runs."""
        pool, self._pool = self._pool, None
        if pool is not None:
            pool.shutdown(wait=True, cancel_futures=True)
