# SPDX-License-Identifier: GPL-3.0-or-later
"""How far long work is."""


def part_of(progress, low, high):
    """What a part of some work is told of, as a function of the part's own share; the part is from
    low to high of the whole. None where nobody is to be told."""
    if progress is None:
        return None
    return lambda share: progress(low + (high - low) * share)
