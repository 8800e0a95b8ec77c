# SPDX-License-Identifier: GPL-3.0-or-later
"""Inflections and flat spots of a plane curve that an eye sees, from its curvature.

A mark counts by how far the curve had to move for it to vanish, its depth. A hollow is as deep as
the curve lies below its chord. A dip is the place of least bend between two where it bends more to
the same side; it vanishes with the lesser of the two when both are made one even bend, and its
depth is how far that moves the curve. What is less deep than a given length, or than SHALLOWEST of
its own length, is not seen: splines ripple by that about circles.

A mark extends along the curve: a dip as far as it bends hardly more than there, as along a flat
bottom; an inflection as far to either side as the curve goes straight on for all that is seen.
"""

from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

# A depth over the length it stretches along: a batten bent by a quarter of a degree.
SHALLOWEST = 1.0 / 2000.0
# Curvatures over the largest that differ by no more are the same.
_ROUNDING = 1e-9
_BISECTIONS = 30
# Waves whose heights differ by less are of one height.
_ABOUT = 0.05
# Of the lesser bend beside a dip: with less more than in it the curve bends hardly more.
_HARDLY = 0.01

INFLECTION, DIP = "inflection", "dip"


@dataclass(frozen=True, eq=False)
class Lever:
    """By what a mark goes: `depth`, m, is to first order the sum of factors (n,) · curvatures from
    the sample `first` on; where it is less than `unseen`, m, nothing is seen."""

    first: int
    factors: np.ndarray
    depth: float
    unseen: float


@dataclass(frozen=True)
class Mark:
    """An inflection or a dip, at an index of the samples; its depth in m. first, last: the indices
    up to which it extends. lever: its Lever; a dip goes with either bend beside it, and this is the
    one that takes less."""

    kind: str
    index: int
    depth: float
    first: int
    last: int
    lever: Lever = field(repr=False, compare=False)


def marks(lengths, curvatures, least_depth, shallowest=SHALLOWEST):
    """The visible Marks of a curve without knuckles: lengths (n,) along it in m, rising, and signed
    curvatures (n,) in 1/m; in their order along it. least_depth in m; shallowest: of their length.
    """
    curve = _Curve(lengths, curvatures, least_depth, shallowest)
    sides, inflections = _sides(curve)
    dips = [mark for side in sides for mark in _dips(curve, *side)]
    return sorted(inflections + dips, key=lambda mark: mark.index)


class _Curve:
    def __init__(self, lengths, curvatures, least_depth, shallowest):
        self.s = np.asarray(lengths, dtype=float)
        step = _ROUNDING * max(np.abs(curvatures).max(initial=0.0), _ROUNDING)
        self.k = np.round(np.asarray(curvatures) / step) * step
        self.least_depth, self.shallowest = least_depth, shallowest

    def depth(self, first, last, bend):
        """(depth in m, depth over the least that is seen) of bends in 1/m more than wanted, given
        from one index to another."""
        s = self.s[first : last + 1]
        if not s[-1] > s[0]:
            return 0.0, 0.0
        depth = float(np.abs(_below_chord(s, bend)).max())
        return depth, depth / self.unseen(first, last)

    def unseen(self, first, last):
        """m: what is less deep between two indices is not seen."""
        return max(self.least_depth, self.shallowest * (self.s[last] - self.s[first]))

    def lever(self, first, last, bend, change):
        """The Lever of depth(first, last, bend). change: of factors by the bend, those by the
        curvatures."""
        s = self.s[first : last + 1]
        if not s[-1] > s[0]:
            return Lever(first, np.zeros(len(s)), 0.0, self.unseen(first, last))
        below = _below_chord(s, bend)
        at = int(np.abs(below).argmax())
        share = (s[at] - s[0]) / (s[-1] - s[0])
        by_bend = share * _integrated_twice(s, len(s) - 1) - _integrated_twice(s, at)
        factors = change(np.sign(below[at]) * by_bend)
        return Lever(first, factors, float(abs(below[at])), self.unseen(first, last))

    def is_seen(self, first, last, sign):
        """Whether what bends to one side between two indices is as deep as is seen."""
        bend = np.maximum(sign * self.k[first : last + 1], 0.0)
        return self.depth(first, last, bend)[1] >= 1.0

    def hollow(self, first, last, sign):
        """depth() of all that bends to one side between two indices."""
        return self.depth(*self._hollow(first, last, sign))

    def hollow_lever(self, first, last, sign):
        """The Lever of hollow()."""
        first, last, bend = self._hollow(first, last, sign)
        return self.lever(first, last, bend, lambda factors: sign * np.where(bend, factors, 0.0))

    def _hollow(self, first, last, sign):
        bend = np.maximum(sign * self.k[first : last + 1], 0.0)
        bent = np.flatnonzero(bend)
        # One sample more at either end: there it is down to nothing.
        low, high = max(bent[0] - 1, 0), min(bent[-1] + 1, last - first)
        return first + low, first + high, bend[low : high + 1]


def _integral(s, values):
    steps = 0.5 * np.diff(s) * (values[1:] + values[:-1])
    return np.concatenate([[0.0], np.cumsum(steps)])


def _below_chord(s, bend):
    """How far a curve that bends so lies below its chord, at each of its samples."""
    rise = _integral(s, _integral(s, bend))
    return rise[-1] * (s - s[0]) / (s[-1] - s[0]) - rise


def _integrated_twice(s, at):
    """The factors (n,) of values in their integral's integral up to a sample."""
    halves = 0.5 * np.diff(s)
    once = np.zeros(len(s))
    once[:at] += halves[:at]
    once[1 : at + 1] += halves[:at]
    later = np.concatenate([np.cumsum(once[:0:-1])[::-1], [0.0]])
    twice = halves * later[:-1]
    return np.concatenate([twice, [0.0]]) + np.concatenate([[0.0], twice])


def _sides(curve):
    """[(first, last, sign)] of the parts that bend to one side as far as is seen, and the Marks of
    the inflections between them."""
    signs = np.sign(curve.k)
    bent = np.flatnonzero(signs)
    if not len(bent):
        return [], []
    turns = np.flatnonzero(signs[bent[1:]] != signs[bent[:-1]])
    # Where it is straight between two sides, the inflection is in the middle.
    borders = [0, *((bent[turns] + bent[turns + 1] + 1) // 2), len(signs) - 1]
    sign = signs[bent[0]]
    sides = [(a, b, sign * (-1) ** i) for i, (a, b) in enumerate(zip(borders, borders[1:]))]
    depths = [curve.hollow(*side) for side in sides]
    while len(sides) > 1:
        least = min(range(len(sides)), key=lambda i: depths[i][1])
        if depths[least][1] >= 1.0:
            break
        # It goes to its neighbours, which bend to one side.
        around = slice(max(least - 1, 0), least + 2)
        first, last = sides[around][0][0], sides[around][-1][1]
        one = first, last, sides[least - 1 if least else 1][2]
        sides[around], depths[around] = [one], [curve.hollow(*one)]
    found = [
        Mark(
            INFLECTION,
            int(a[1]),
            min(one, other),
            *_straight_part(curve, *a, b[1]),
            curve.hollow_lever(*(a if one_seen < other_seen else b)),
        )
        for (a, b), ((one, one_seen), (other, other_seen)) in zip(pairwise(sides), pairwise(depths))
    ]
    return sides, found


def _straight_part(curve, first, border, sign, last):
    """The indices up to which nothing is seen of how it bends to one side from `first` up to a
    border, and to the other side from there on."""
    low = _halved(border, first, lambda at: curve.is_seen(at, border, sign))
    return low, _halved(border, last, lambda at: curve.is_seen(border, at, -sign))


def _halved(near, far, is_beyond):
    """The index farthest from `near` on the way to `far`, which is beyond, that is not."""
    while abs(far - near) > 1:
        middle = (near + far) // 2
        if is_beyond(middle):
            far = middle
        else:
            near = middle
    return near


def _dips(curve, first, last, sign):
    """The Marks of the dips of a part that bends to one side."""
    bend = sign * curve.k[first : last + 1]
    while True:
        at = _extremes(bend)
        dips = [i for i in range(1, len(at) - 1) if bend[at[i]] < bend[at[i - 1]]]
        if not dips:
            return []
        evened = [_Evened(curve, first, bend, at, i) for i in _pairs(bend, at)]
        if not _make_even(bend, [one for one in evened if one.ratio < 1.0]):
            break
    marks = []
    for i in dips:
        both = [_Evened(curve, first, bend, at, pair) for pair in (i - 1, i)]
        low, high = _level_part(bend, *at[i - 1 : i + 2])
        marks.append(
            Mark(
                DIP,
                first + (low + high) // 2,
                max(one.depth for one in both),
                first + low,
                first + high,
                min(both, key=lambda one: one.ratio).lever(curve, first, bend, sign),
            )
        )
    return marks


def _make_even(bend, evened):
    """Makes each _Evened so, the shallowest first, but none beside another; whether any was."""
    changed = np.zeros(len(bend), dtype=bool)
    for one in sorted(evened, key=lambda one: one.ratio):
        around = slice(max(one.part.start - 1, 0), one.part.stop + 1)
        if not changed[around].any():
            bend[one.part] = one.level
            changed[one.part] = True
    return bool(evened)


def _extremes(bend):
    """Indices of the ends and of the maxima and minima between them, in turn."""
    steps = np.sign(np.diff(bend))
    moving = np.flatnonzero(steps)
    turns = moving[:-1][steps[moving[1:]] != steps[moving[:-1]]] + 1
    return [0, *turns.tolist(), len(bend) - 1]


def _pairs(bend, at):
    """Each i with at[i] and at[i + 1] between neighbours that go about as far or further."""
    for i in range(len(at) - 1):
        fall = bend[at[i]] - bend[at[i + 1]]
        slack = _ABOUT * fall * fall
        before = i == 0 or (bend[at[i - 1]] - bend[at[i + 1]]) * fall <= slack
        after = i + 2 == len(at) or (bend[at[i + 2]] - bend[at[i]]) * fall >= -slack
        if before and after:
            yield i


class _Evened:
    """A maximum and a minimum beside it made one even bend, that turns the curve as far."""

    def __init__(self, curve, first, bend, at, pair):
        self.pair = pair
        low = at[max(pair - 1, 0)]
        high = at[min(pair + 2, len(at) - 1)]
        one, other = at[pair], at[pair + 1]
        levels = [bend[one], bend[other]]
        for _ in range(_BISECTIONS):
            self.level = 0.5 * sum(levels)
            self.part = _beyond(bend, self.level, low, one, other, high)
            turned = _integral(curve.s[first:][self.part], bend[self.part] - self.level)[-1]
            levels[0 if turned * (levels[0] - levels[1]) < 0.0 else 1] = self.level
        a, b = first + self.part.start, first + self.part.stop - 1
        self.depth, self.ratio = curve.depth(a, b, bend[self.part] - self.level)

    def lever(self, curve, first, bend, sign):
        """The Lever of the depth."""
        s = curve.s[first:][self.part]
        ends = np.concatenate([[0.0], 0.5 * np.diff(s), [0.0]])
        shares = ends[1:] + ends[:-1]

        def change(factors):
            # It turns the curve as far: the level is the mean.
            return sign * (factors - factors.sum() * shares / shares.sum())

        a, b = first + self.part.start, first + self.part.stop - 1
        return curve.lever(a, b, bend[self.part] - self.level, change)


def _beyond(bend, level, low, one, other, high):
    """The indices around an extreme `one` and the next, from where the bend leaves a level before
    them to where it is back."""
    sign = 1.0 if bend[one] > bend[other] else -1.0
    before = np.flatnonzero(sign * (bend[low:one] - level) <= 0.0)
    after = np.flatnonzero(sign * (bend[other : high + 1] - level) >= 0.0)
    start = low + before[-1] + 1 if len(before) else low
    stop = other + after[0] if len(after) else high + 1
    return slice(start, stop)


def _level_part(bend, before, dip, after):
    """The indices up to which it bends hardly more than in a dip."""
    level = bend[dip] + _HARDLY * (min(bend[before], bend[after]) - bend[dip])
    more = np.flatnonzero(bend[before : after + 1] > level) + before
    return int(more[more < dip].max(initial=before)), int(more[more > dip].min(initial=after))
