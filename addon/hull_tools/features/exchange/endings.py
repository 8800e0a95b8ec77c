# SPDX-License-Identifier: GPL-3.0-or-later
"""What files' names end in."""

from pathlib import Path


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
