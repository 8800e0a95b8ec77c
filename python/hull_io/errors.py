# SPDX-License-Identifier: GPL-3.0-or-later
"""The one error that every reader and writer of hull files raises."""


class HullFileError(ValueError):
    """A hull file can't be read or written.

    The message is one sentence fit for the user's eyes: the file's name, what is wrong, where in
    the file (byte offset, line or key), and what to do about it.
    """
