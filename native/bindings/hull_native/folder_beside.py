# SPDX-License-Identifier: GPL-3.0-or-later
"""Several files that are all written, or none is."""

import errno
import os
import shutil
import stat
import tempfile
from pathlib import Path


class FolderBeside:
    """A folder beside targets in which files are made before they get their names."""

    def __init__(self, targets):
        self._targets = [Path(os.path.realpath(target)) for target in targets]

    def __enter__(self):
        parent = self._targets[0].parent
        for target in self._targets:
            _check(target)
        try:
            self._path = Path(tempfile.mkdtemp(prefix=".hull-", dir=parent))
        except OSError as error:
            raise OSError(
                f"Nothing can be written to the folder {parent} ({error.strerror}): choose one "
                "that is there and that you may write to"
            ) from error
        return self

    def __truediv__(self, name):
        return self._path / name

    def hand_over(self, made):
        """Gives files their names; all of them are on the disk."""
        for one, target in zip(made, self._targets):
            os.replace(one, target)

    def __exit__(self, *unused):
        shutil.rmtree(self._path, ignore_errors=True)


def _check(target):
    """OSError, in the words of all writers, for what can't be a file's name, and for what is there
    and no file. It has no number, which would stand before the words."""
    if any(ord(letter) < 0x20 or ord(letter) == 0x7F for letter in target.name):
        raise OSError(
            f"Cannot write {str(target)!r}: a file's name can't have line breaks or control "
            "characters; give it another"
        )
    try:
        mode = os.stat(target).st_mode
    except OSError as error:
        if error.errno in (errno.ENOENT, errno.ENOTDIR, errno.EACCES):
            return  # there is nothing, or the folder tells
        is_long = error.errno == errno.ENAMETOOLONG
        reason = (
            "the name is too long; shorten it" if is_long else f"{error.strerror}; give another"
        )
        raise OSError(f'Cannot write "{target}": {reason}') from error
    if stat.S_ISDIR(mode):
        raise OSError(f'Cannot write "{target}": it is a folder; give a file name')
    if not stat.S_ISREG(mode):
        raise OSError(
            f'Cannot write "{target}": it is a device or pipe and no file; give another name'
        )
