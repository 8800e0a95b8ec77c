# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinks and waves of mirrored lines that an eye sees.

A kink is a place where a line turns by KINK_TURN within REACH of the beam, since the gradient
across it, the surface's curvature, changes there by most of what it changes within WIDER times as
far: where it changes evenly, at the tip of a loop around a hollow, a line turns as it should. A
wave is a place where a line, evened out over REACH, has turned by WAVE_TURN one way and turns as
far back, both within WAVE_REACH.

Not seen is what is nearer than REACH to the line's end at a crease or border, and what lies where
lights are nearer together than CLOSE, a dot of the pictures: they are grey there.
"""

from dataclasses import dataclass

import numpy as np

from .lights import BANDS
from .reflections import STEP, runs

KINK, WAVE = "kink", "wave"
KINK_TURN, WAVE_TURN = np.radians(30.0), np.radians(20.0)
# Of the beam.
REACH, WAVE_REACH, CLOSE = 1.0 / 50.0, 1.0 / 10.0, 1.0 / 200.0
WIDER, MOST = 4, 0.65


@dataclass(frozen=True)
class Turn:
    """A kink or wave at an index of the samples, and how far the line turns there, rad."""

    kind: str
    index: int
    angle: float


def turns(line, beam, eye=1.0):
    """The Turns that are seen of a reflections.Turning, in their order; beam in m; eye: see
    lines.judged."""
    reach = round(REACH / STEP)
    if len(line.turned) <= 2 * reach + 1:
        return []
    angles = np.stack([np.cos(line.turned), np.sin(line.turned)], axis=1)
    near = _across(line.gradients[:, None] * angles, reach // 2)
    wide = _across(line.gradients[:, None] * angles, WIDER * reach // 2)
    change = np.abs(_across(line.turned, reach // 2))
    sharp = np.linalg.norm(near, axis=1) > eye * MOST * np.linalg.norm(wide, axis=1)
    back = _turned_back(line.turned, reach, round(WAVE_REACH / STEP))
    seen = np.zeros(len(change), dtype=bool)
    seen[reach:-reach] = True
    seen &= line.gradients * CLOSE * beam < np.pi / BANDS
    found = [
        Turn(kind, index, float(sizes[index]))
        for kind, sizes, where in (
            (KINK, change, sharp & (change >= eye * KINK_TURN) & seen),
            (WAVE, back, (back >= eye * WAVE_TURN) & seen),
        )
        for index in _peaks(sizes, where)
    ]
    return sorted(found, key=lambda turn: turn.index)


def _across(values, half):
    """Of each sample: what changes from `half` samples before it to `half` after it."""
    index = np.arange(len(values))
    return values[np.minimum(index + half, len(values) - 1)] - values[np.maximum(index - half, 0)]


def _turned_back(turned, evened, reach):
    """Of each sample: how far a line, evened out over some samples, turns towards it within
    `reach` samples, and back after it; the lesser of both."""
    padded = np.pad(turned, evened // 2, mode="edge")
    even = np.convolve(padded, np.full(evened + 1, 1.0 / (evened + 1)), mode="valid")
    sides = np.lib.stride_tricks.sliding_window_view(np.pad(even, reach, mode="edge"), reach + 1)
    before, after = sides[: len(even)], sides[reach:]
    most = np.minimum(even - before.min(axis=1), even - after.min(axis=1))
    least = np.minimum(before.max(axis=1) - even, after.max(axis=1) - even)
    return np.maximum(most, least)


def _peaks(sizes, where):
    """The index of the largest of each run of samples where it is true."""
    for first, last in runs(where):
        yield first + int(np.argmax(sizes[first:last]))
