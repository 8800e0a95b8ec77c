# SPDX-License-Identifier: GPL-3.0-or-later
"""The units of FREE!ship's files: metric ones, and its own imperial ones."""

import numpy as np

FOOT = 0.3048
# FREE!ship's own: it takes a tonne for a long ton, so that 1.025 t/m3 are 65.016 there.
POUND_PER_CUBIC_FOOT = 1.0 / (2240 * FOOT**3)


def plating_units(imperial):
    """(m of a unit of a layer's thickness, t/m3 of one of its density): millimetres and t/m3, or
    inches and pounds per cubic foot."""
    return (FOOT / 12.0, POUND_PER_CUBIC_FOOT) if imperial else (1e-3, 1.0)


def as_typed(value):
    """A single-precision number as the decimal that was typed: 5.3, not 5.300000190734863."""
    return float(str(np.float32(value)))
