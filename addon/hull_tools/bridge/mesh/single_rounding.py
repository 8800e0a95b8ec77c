# SPDX-License-Identifier: GPL-3.0-or-later
"""Control points rounded to single precision, in which Blender keeps them, so that a point of the
surface stays where it is."""

import numpy as np

# What rounding of the points before left is made up for as long as it takes a point no further than
# this many of its own roundings.
_MOST_STEPS = 8.0


def rounded(points, weights, is_free):
    """float32 (k, 3) near the points (k, 3), whose sum with weights (k,) is nearly the same.

    is_free (k, 3): coordinates that may be up to some roundings off; others are rounded to the
    nearest. Each point makes up for what is left of those before it, the coarsest first (coarse:
    its weight times its rounding), so that in the end the finest decides: a point of the surface is
    off by 1e-10 of a hull's size where a control point far away counts little, and 1e-8 at worst.
    """
    result = points.astype(np.float32)
    steps = np.abs(weights)[:, None] * np.spacing(np.abs(result)).astype(np.float64)
    for axis in range(3):
        left = 0.0
        for i in np.argsort(-steps[:, axis], kind="stable"):
            wanted, weight = points[i, axis], weights[i]
            is_used = is_free[i, axis] and abs(left) <= _MOST_STEPS * steps[i, axis]
            if is_used and weight != 0.0:
                result[i, axis] = wanted - left / weight
            left += weight * (float(result[i, axis]) - wanted)
    return result
