# SPDX-License-Identifier: GPL-3.0-or-later
"""Points as readers and writers take them: real numbers, in the words of hull_native."""

import numpy as np

_FOUND = {"c": ", not of complex ones", "U": ", not of text", "S": ", not of text"}


def real_points(points):
    """(n, 3) double. ValueError for what is no array of real numbers, and for another shape: NumPy
    would make numbers of texts, and take the real part of complex ones."""
    array = real_array(points)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"points must have shape (n, 3), not {array.shape}.")
    return array


def real_array(points):
    """The same of any shape."""
    try:
        array = np.asarray(points)
        kind = array.dtype.kind
        if kind == "O" and any(isinstance(one, (str, bytes)) for one in array.flat):
            kind = "U"
        if kind in "biufO" and points is not None:
            return array.astype(float, copy=False)
    except (TypeError, ValueError):  # lists of different lengths, objects that are no numbers
        kind = "O"
    raise ValueError(f"points must be an array of real numbers{_FOUND.get(kind, '')}.")
