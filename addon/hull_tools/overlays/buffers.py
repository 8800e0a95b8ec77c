# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays brought to the graphics card as they are, without a Python number for each of theirs."""

import numpy as np
from gpu.types import GPUBatch, GPUVertBuf


def batch(shader, form, **columns):
    """Points to draw with a shader as "LINES", "TRIS" or "POINTS": for each of its inputs, such as
    `pos`, an array of a row a point. None where there are no points."""
    count = len(columns["pos"])
    if not count:
        return None
    points = GPUVertBuf(shader.format_calc(), count)
    for name, values in columns.items():
        points.attr_fill(name, np.ascontiguousarray(values, dtype=np.float32))
    return GPUBatch(type=form, buf=points)
