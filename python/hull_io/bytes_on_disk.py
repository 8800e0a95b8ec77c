# SPDX-License-Identifier: GPL-3.0-or-later
"""Whole files in and out: bounded reading, and writing that can't leave half a file."""

import errno
import os
import secrets
import stat
from pathlib import Path

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
    """Write a file beside its final name and rename it: all of it, or nothing changed. A symbolic
    link stays one: the file it points to is replaced, or made.

    HullFileError where that can't be done, and where something else than a file has the name.
    """
    write_files({path: data})


def write_files(contents):
    """The same of several files, {path: bytes}: all of them are on the disk before the first one
    gets its name, so that a full disk leaves all as it was."""
    targets = {path: target_of(path) for path in contents}
    path, temporary = None, {}
    try:
        for path, data in contents.items():
            _write_beside(path, targets[path], data, temporary)
        for path, target in targets.items():
            os.replace(temporary[path], target)
            del temporary[path]
    except OSError as error:
        if error.errno == errno.ENAMETOOLONG:
            raise HullFileError(f"{path.name}: the name is too long; shorten it.") from error
        raise HullFileError(
            f"{path.name}: it can't be written ({error.strerror}); check the folder, your rights "
            "to it and the free space."
        ) from error
    finally:
        for left in temporary.values():
            if os.path.exists(left):
                os.unlink(left)


def target_of(path):
    """The file that is written when a Path is: where symbolic links end. HullFileError for names
    that are none, and for what is there and no file."""
    _check_name(path)
    target = Path(os.path.realpath(path))
    try:
        mode = os.stat(target).st_mode
    except OSError as error:
        if error.errno in (errno.ENOENT, errno.ENOTDIR, errno.ENAMETOOLONG, errno.EACCES):
            return target  # writing tells
        raise HullFileError(
            f"{path.name}: it can't be written ({error.strerror}); give another name."
        ) from error
    if stat.S_ISDIR(mode):
        raise HullFileError(f"{path.name}: it is a folder; give a file name.")
    if not stat.S_ISREG(mode):
        # To rename a file to a device's name would take the device away.
        raise HullFileError(f"{path.name}: it is a device or pipe and no file; give another name.")
    return target


def _check_name(path):
    if any(ord(letter) < 0x20 or ord(letter) == 0x7F for letter in path.name):
        raise HullFileError(
            f"{path.name!r}: a file's name can't have line breaks or control characters; give it "
            "another."
        )


def _write_beside(path, target, data, temporary):
    """Writes data into a file beside its target, which temporary[path] names as soon as it is
    there."""
    mode = _mode_of(target)
    # Of its own length: the final name may be as long as names can be.
    name = target.parent / f".hull-{secrets.token_hex(8)}"
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL
    # A new file gets what is usual for this user; one that is replaced may be secret.
    handle = os.open(name, flags, 0o666 if mode is None else 0o600)
    temporary[path] = name
    with os.fdopen(handle, "wb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())
    if mode is not None:
        os.chmod(name, mode)


def _mode_of(path):
    """The mode of the file being replaced, None where there is none."""
    try:
        return stat.S_IMODE(os.stat(path).st_mode)
    except FileNotFoundError:
        return None
