# SPDX-License-Identifier: GPL-3.0-or-later
"""Ranges of numbers as a user gives them."""

import numpy as np

_MOST = 1000


def stepped(first, last, step, name):
    """first, first + step ... and last, which need not be a whole step away; rising."""
    if not last > first:
        raise ValueError(f"The last {name}, {last:g}, must be greater than the first, {first:g}")
    if not step > 0.0:
        raise ValueError(f"The step between {name} is {step:g}: it must be more than 0")
    if not (last - first) / step <= _MOST:
        raise ValueError(f"A step of {step:g} gives more than {_MOST} of {name}: widen it")
    count = int(np.floor((last - first) / step * (1.0 + 1e-9)))
    values = [first + step * k for k in range(count + 1)]
    if last - values[-1] > 1e-6 * step:
        values.append(last)
    return tuple(values)
