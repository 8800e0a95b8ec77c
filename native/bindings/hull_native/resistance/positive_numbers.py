# SPDX-License-Identifier: GPL-3.0-or-later
"""What methods of resistance are given that has to be above zero."""

import math


def require_positive(**numbers):
    """ValueError, with the name, for the first that is not finite and above zero; `speed` is called
    The speed."""
    for name, value in numbers.items():
        if not (value > 0.0 and math.isfinite(value)):
            name = "The speed" if name == "speed" else name
            raise ValueError(f"{name} must be a number above zero, not {value}.")


def check_positive(thing, whose, names):
    """ValueError, with the name, unless these fields of a thing are finite and above zero, or
    None. whose: how a sentence about one begins."""
    for name in names:
        value = getattr(thing, name)
        if value is not None and not (value > 0.0 and math.isfinite(value)):
            raise ValueError(f"{whose} {name} must be above zero, not {value}.")
