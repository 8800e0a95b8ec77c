# SPDX-License-Identifier: GPL-3.0-or-later
"""Long work in a thread, which tells how far it is and ends early when it is asked to.

One job runs after the other. None knows anything of Blender, so that only the main thread ever
touches what Blender and the add-on keep. Their thread is not that of the `worker`, whose numbers
would wait for minutes behind a job.
"""

from .work_queue import WorkQueue

_queue = WorkQueue("hull job")
_unfinished = set()


class Cancelled(Exception):
    """The work was ended early because it was asked to."""


class Job:
    """work(progress) is called in the thread; it calls progress(share) now and then, and lets
    through what that raises.

    share: of the work that is done, 0 to 1.
    """

    def __init__(self, work):
        self.share = 0.0
        self._is_cancelled = False
        _unfinished.add(self)
        self._future = _queue.submit(self._run, work)

    def _run(self, work):
        try:
            self._tell(0.0)
            result = work(self._tell)
            self._tell(1.0)
            return result
        finally:
            _unfinished.discard(self)

    def _tell(self, share):
        if self._is_cancelled:
            raise Cancelled
        self.share = share

    def cancel(self):
        """From any thread. The job ends at its next word of progress."""
        self._is_cancelled = True
        if self._future.cancel():
            _unfinished.discard(self)

    def is_done(self):
        return self._future.done()

    def result(self):
        """What the work returned, when it is done; raises what the work raised, or Cancelled."""
        from concurrent.futures import CancelledError

        try:
            return self._future.result()
        except CancelledError as error:
            raise Cancelled from error


class JobTask:
    """What is done by one Job, which a subclass sets as _job; it says what its result is."""

    @property
    def share(self):
        return self._job.share

    def is_done(self):
        return self._job.is_done()

    def cancel(self):
        self._job.cancel()

    def result(self):
        """What the Job returned, which is waited for; raises what its work raised, ValueError and
        OSError with the reason among that, or Cancelled."""
        return self._job.result()


def stop():
    """Cancels all jobs; when this returns none runs."""
    for job in list(_unfinished):
        job.cancel()
    _queue.stop()
