# SPDX-License-Identifier: GPL-3.0-or-later
"""Names of files that are written, and what they end in."""

import os
from pathlib import Path


def check_named(path):
    """ValueError for a path of a file, a text, that ends in no name."""
    if not os.path.basename(path):
        raise ValueError("The file has no name: give one")


def checked_ending(path, endings, what):
    """The ending of a file's name, in small letters; ValueError for one that is none of them."""
    ending = Path(path).suffix.lower()
    if ending not in endings:
        known = " or ".join(filter(None, (", ".join(endings[:-1]), endings[-1])))
        raise ValueError(
            f'"{Path(path).name}" does not say how {what} is written: give it a name that ends in '
            f"{known}"
        )
    return ending
