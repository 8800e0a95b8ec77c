# SPDX-License-Identifier: GPL-3.0-or-later
"""Work done in a thread, one piece after the other, while Blender goes on.

The pieces know nothing of Blender. Their results wait until they are fetched, so that only the main
thread ever touches what Blender and the add-on keep.

Its thread is not that of `jobs`: numbers and plots that are looked at must not wait behind a
conversion or a fit of minutes. These are asked for anew with each change, and the last one counts;
a job is one that somebody waits for, and that can be cancelled.
"""

from .work_queue import WorkQueue

_jobs = []  # (what for, of what, Future) in the order in which they were asked for
_queue = WorkQueue("hull analysis")


def ask(purpose, key, work):
    """Has `work()` done, unless the last piece for the same purpose has an equal key and was not
    fetched yet; a piece for the purpose that has not begun is dropped for it.

    One that has begun cannot be stopped: its result comes before the new one's.
    """
    if [job[1] for job in _jobs if job[0] == purpose][-1:] == [key]:
        return
    _jobs[:] = [job for job in _jobs if job[0] != purpose or not job[2].cancel()]
    _jobs.append((purpose, key, _queue.submit(work)))


def fetch():
    """The results that have come since the last time, in order; raises what the work raised."""
    while _jobs and _jobs[0][2].done():
        _, _, done = _jobs.pop(0)
        yield done.result()


def is_busy():
    """Whether there is work that was not fetched."""
    return bool(_jobs)


def finish():
    """Waits until all work is done, without fetching it."""
    for _, _, job in list(_jobs):
        job.exception()


def stop():
    """Drops all work; when this returns nothing runs."""
    _jobs.clear()
    _queue.stop()
