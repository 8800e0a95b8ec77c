# SPDX-License-Identifier: GPL-3.0-or-later
"""Several files that are all written, or none is."""

import errno
import os
import shutil
import tempfile
from pathlib import Path


class FolderBeside:
    """A folder beside targets in which files are made before they get their names."""

    def __init__(self, targets):
        self._targets = [Path(os.path.realpath(target)) for target in targets]

    def __enter__(self):
        parent = self._targets[0].parent
        for target in self._targets:
            if target.is_dir():
                raise OSError(errno.EISDIR, f"{target} is a folder: choose another name")
            if target.exists() and not target.is_file():
                raise OSError(errno.EEXIST, f"{target} is no file: choose another name")
        try:
            self._path = Path(tempfile.mkdtemp(prefix=".hull-", dir=parent))
        except OSError as error:
            raise OSError(
                error.errno, f"Nothing can be written to the folder {parent}: {error.strerror}"
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
