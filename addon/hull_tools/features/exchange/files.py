# SPDX-License-Identifier: GPL-3.0-or-later
"""Writing files so that a failure never leaves half of one."""

import contextlib
import os


@contextlib.contextmanager
def replacing(path):
    """Yields a path beside `path` to write to, and renames it to `path` if nothing failed."""
    folder, name = os.path.split(os.path.abspath(path))
    beside = os.path.join(folder, f".{os.getpid()}-{name}")
    try:
        yield beside
        os.replace(beside, path)
    except BaseException:
        with contextlib.suppress(FileNotFoundError):
            os.remove(beside)
        raise
