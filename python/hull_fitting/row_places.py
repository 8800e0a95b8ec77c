# SPDX-License-Identifier: GPL-3.0-or-later
"""Where along the ship rows of control points are laid."""

import numpy as np

from .beside import bend_shares, keel_range, points_at

# Trial sections, and how much of the places is by the turning of lines along the ship between them.
_TRIALS, _BY_TURNING = 80, 0.6
# Places along a trial section; trials over which the turning is averaged.
_ALONG, _AVERAGED = 12, 7
# Of an even spacing: from where whole sections begin to the first row, where no transom is a row.
_FIRST = 0.35


def row_places(outline, girths, count):
    """(count,) m: x of rows, closer where the surface turns along the ship, from the aft end of the
    whole sections to the fore one."""
    low, high = keel_range(outline)
    margin = 0.01 * (high - low)
    at = np.linspace(low + margin, high - margin, _TRIALS)
    shares = np.linspace(0.0, 1.0, _ALONG + 1)
    lines = [girths.at(float(x)) for x in at]
    trial = np.array([points_at(line, bend_shares(line), shares) for line in lines])
    ways = np.diff(trial, axis=0)
    ways /= np.linalg.norm(ways, axis=2)[:, :, None]
    turns = np.arccos(np.clip((ways[1:] * ways[:-1]).sum(axis=2), -1.0, 1.0)).sum(axis=1)
    turns = np.pad(turns, 1 + _AVERAGED // 2, "edge")
    turns = np.convolve(turns, np.full(_AVERAGED, 1.0 / _AVERAGED), "valid")
    density = (1.0 - _BY_TURNING) / _TRIALS + _BY_TURNING * turns / max(turns.sum(), 1e-12)
    reached = np.concatenate([[0.0], np.cumsum(0.5 * (density[1:] + density[:-1]))])
    first = 1.0 if outline.aft is not None and outline.arch is None else _FIRST
    inner = np.linspace(first / count, 1.0, count)
    return np.interp(inner, reached / reached[-1], at)
