# SPDX-License-Identifier: GPL-3.0-or-later
"""Whole files in and out: bounded reading, and writing that can't leave half a file."""

import os
import stat
import tempfile

from .errors import HullFileError


def read_bytes(path, largest):
    """The bytes of a regular file of at most `largest` bytes; HullFileError otherwise."""
    try:
        status = os.stat(path)
        if not stat.S_ISREG(status.st_mode):
            raise HullFileError(f"{path.name}: it is not a file; choose a hull file.")
        if status.st_size > largest:
            raise HullFileError(
                f"{path.name}: it has {status.st_size / 2**20:.0f} MB, and no hull file has more "
                f"than {largest / 2**20:.0f} MB; choose another file."
            )
        with open(path, "rb") as file:
            return file.read(largest)
    except (OSError, MemoryError) as error:
        reason = getattr(error, "strerror", None) or "there is not enough memory"
        raise HullFileError(
            f"{path.name}: it can't be opened ({reason}); check its place and your rights to it."
        ) from error


def write_bytes(path, data):
    """Write a file beside its final name and rename it: all of it, or nothing changed."""
    handle, temporary = None, None
    try:
        handle, temporary = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
        with os.fdopen(handle, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        os.chmod(temporary, _usual_mode(path))
        os.replace(temporary, path)
    except OSError as error:
        if temporary is not None and os.path.exists(temporary):
            os.unlink(temporary)
        raise HullFileError(
            f"{path.name}: it can't be written ({error.strerror}); check the folder, your rights "
            "to it and the free space."
        ) from error


def _usual_mode(path):
    """The mode of the file being replaced, else what a new file of this user gets."""
    try:
        return stat.S_IMODE(os.stat(path).st_mode)
    except FileNotFoundError:
        mask = os.umask(0)
        os.umask(mask)
        return 0o666 & ~mask
