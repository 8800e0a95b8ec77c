# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines cut where they turn sharply."""

import numpy as np

# They do where the cosine of the turn is below this.
TURNS = 0.6


def parts_between_turns(line):
    """Of a line (n, 3), from one sharp turn to the next."""
    ways = np.diff(line, axis=0)
    ways /= np.maximum(np.linalg.norm(ways, axis=1), 1e-300)[:, None]
    cuts = 1 + np.flatnonzero((ways[1:] * ways[:-1]).sum(axis=1) < TURNS)
    ends = [0, *cuts.tolist(), len(line) - 1]
    return [line[low : high + 1] for low, high in zip(ends, ends[1:]) if high > low]
