# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields of what methods of resistance are given, which have to be above zero."""

import math


def check_positive(thing, whose, names):
    """ValueError, with the name, unless these fields of a thing are finite and above zero, or
    None. whose: how a sentence about one begins."""
    for name in names:
        value = getattr(thing, name)
        if value is not None and not (value > 0.0 and math.isfinite(value)):
            raise ValueError(f"{whose} {name} must be above zero, not {value}.")
