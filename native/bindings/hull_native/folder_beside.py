# SPDX-License-Identifier: GPL-3.0-or-later
"""Several files that are all written, or none is."""

import errno
import os
import shutil
import stat
import tempfile
from pathlib import Path


class FolderBeside:
    """A folder beside the files of these paths, the targets, in which files are made before they
    get their names: `folder / name` is a path in it. Used with `with`, at whose end it is gone,
    and what was not handed over with it.

    A symbolic link stays one: the file it points to is replaced, or made. OSError with what to do
    for names that are none, for what is there and no file, for files that are the same, and where
    nothing can be written; ValueError for no targets.
    """

    def __init__(self, targets):
        self._targets = [Path(os.path.realpath(target)) for target in targets]
        if not self._targets:
            raise ValueError("There is no file to be written: give one at least.")
        for place, target in enumerate(self._targets):
            _check(target)
            if target in self._targets[:place]:
                raise OSError(f'Cannot write "{target}": it is given twice; give another name')
        self._folders = {}

    def __enter__(self):
        self._in(self._targets[0].parent)
        return self

    def __truediv__(self, name):
        return self._in(self._targets[0].parent) / name

    def hand_over(self, made):
        """Gives files, in the order of the targets, their names: all of them are on the disk before
        the first one gets its own. One that takes the place of another has the mode of that."""
        ready = [self._ready(Path(one), target) for one, target in zip(made, self._targets)]
        for one, target in zip(ready, self._targets):
            os.replace(one, target)

    def __exit__(self, *unused):
        for path in self._folders.values():
            shutil.rmtree(path, ignore_errors=True)

    def _in(self, parent):
        """The folder in a folder."""
        if parent not in self._folders:
            try:
                self._folders[parent] = Path(tempfile.mkdtemp(prefix=".hull-", dir=parent))
            except OSError as error:
                raise OSError(
                    f"Nothing can be written to the folder {parent} ({error.strerror}): choose one "
                    "that is there and that you may write to"
                ) from error
        return self._folders[parent]

    def _ready(self, one, target):
        """A file that only needs the target's name."""
        if target.parent != self._targets[0].parent:  # a link may lead to another disk
            one = Path(shutil.copy(one, self._in(target.parent) / str(self._targets.index(target))))
        if target.exists():
            os.chmod(one, stat.S_IMODE(target.stat().st_mode))
        with open(one, "rb") as file:
            os.fsync(file.fileno())
        return one


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
        # To rename a file to a device's name would take the device away.
        raise OSError(
            f'Cannot write "{target}": it is a device or pipe and no file; give another name'
        )
