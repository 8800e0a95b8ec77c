# SPDX-License-Identifier: GPL-3.0-or-later
"""Letters that Blender takes in names and sentences."""


def taken(text):
    """A text with a question mark for what is no letter: bytes of file names that are no UTF-8."""
    return text.encode("utf-8", "replace").decode("utf-8")
