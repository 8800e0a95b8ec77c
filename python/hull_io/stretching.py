# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls brought to main dimensions while ranges of them keep their shape.

Along an axis a coordinate x becomes f(x), with f' = 1 + extra · w(x). In kept ranges the weight w
is 0: they move as a whole. Between them it rises to 1 by the smoothstep 6t⁵ - 15t⁴ + 10t³, whose
first two derivatives vanish at its ends, so that f has three continuous derivatives and no knuckle
arises.
"""

from dataclasses import dataclass
from math import inf, isfinite

import numpy as np

from .scale import Scale
from .scaling import factors

# Of each free range, that the weight rises over at each of its ends that meets a kept range.
_FADE = 0.5
# What f' is at the least and the most: beyond, the hull would be crumpled or torn.
SLOPES = (0.1, 10.0)
# A smaller part of the hull left to be stretched is none.
_LEAST_FREE = 1e-3
# Halvings before a step of Newton's that leaves rounding.
_HALVINGS = 40


@dataclass(frozen=True)
class FreeRange:
    """low, high: may be infinite. fade: over what the weight rises at the ends that are not."""

    low: float
    high: float
    fade: float

    def weight(self, x):
        rising = _smoothstep((x - self.low) / self.fade) if isfinite(self.low) else 1.0
        falling = _smoothstep((self.high - x) / self.fade) if isfinite(self.high) else 1.0
        inside = (x > self.low) & (x < self.high)
        return np.where(inside, rising * falling, 0.0)

    def integral(self, x):
        """Of the weight from the coordinate 0 to x."""
        return self._primitive(x) - self._primitive(np.zeros(()))

    def _primitive(self, x):
        # Where one end fades, the other is 1: the product is the sum less one.
        x = np.clip(x, self.low, self.high)
        rising = falling = x
        if isfinite(self.low):
            rising = self.fade * _smoothstep_integral((x - self.low) / self.fade)
        if isfinite(self.high):
            falling = -self.fade * _smoothstep_integral((self.high - x) / self.fade)
        return rising + falling - x


def _smoothstep(t):
    t = np.clip(t, 0.0, 1.0)
    return t * t * t * (10.0 + t * (6.0 * t - 15.0))


def _smoothstep_integral(t):
    """From 0 to t ≥ 0 of the smoothstep, which is 1 beyond 1."""
    begun = np.minimum(t, 1.0)
    return begun**4 * (2.5 + begun * (begun - 3.0)) + np.maximum(t - 1.0, 0.0)


def free_ranges(kept, low, high):
    """The FreeRanges between kept ranges [(from, to)] of what is from low to high; ends of kept
    ranges may be infinite."""
    found, begin = [], -inf
    for start, end in [*sorted(kept), (inf, inf)]:
        width = min(start, high) - max(begin, low)
        if start > begin and width > 0.0:
            found.append(FreeRange(begin, start, _FADE * width))
        begin = max(begin, end)
    return tuple(found)


@dataclass(frozen=True)
class AxisStretch:
    """The map f of a coordinate in m, with f(0) = 0. mirrored: f(-x) = -f(x)."""

    free: tuple
    extra: float
    mirrored: bool = False

    def __call__(self, x):
        return np.asarray(x, dtype=np.float64) + self.extra * self.stretched(x)

    def inverse(self, y):
        """x of f(x) = y, to rounding."""
        y = np.asarray(y, dtype=np.float64)
        reach = np.abs(y) / min(SLOPES) + 1.0
        low, high = -reach, reach
        for _ in range(_HALVINGS):
            middle = 0.5 * (low + high)
            below = self(middle) < y
            low, high = np.where(below, middle, low), np.where(below, high, middle)
        x = 0.5 * (low + high)
        return x - (self(x) - y) / self.slope(x)

    def weight(self, x):
        x = self._side(x)
        return sum((part.weight(x) for part in self.free), np.zeros(np.shape(x)))

    def slope(self, x):
        return 1.0 + self.extra * self.weight(x)

    def stretched(self, x):
        """The integral of the weight from 0 to x: what f adds, by the unit of extra."""
        side = self._side(x)
        sums = sum((part.integral(side) for part in self.free), np.zeros(np.shape(side)))
        return np.sign(x) * sums if self.mirrored else sums

    def _side(self, x):
        x = np.asarray(x, dtype=np.float64)
        return np.abs(x) if self.mirrored else x


def _left(free, first, last):
    """The length that is free between two coordinates, m."""
    low, high = min(first, last), max(first, last)
    return sum(max(0.0, min(part.high, high) - max(part.low, low)) for part in free)


def axis_stretch(name, kept, *, extent, anchors, present, wanted, mirrored=False):
    """The AxisStretch by which the dimension of this name becomes wanted instead of present, both
    in m: the distance of the anchors, two coordinates, grows in that proportion.

    kept: [(from, to)], extent: (low, high) of the hull. ValueError, with what can be reached, where
    the hull would be crumpled or torn, or nothing is left to be stretched.
    """
    stretch = AxisStretch(free_ranges(kept, *extent), 0.0, mirrored)
    first, last = anchors
    share = float(stretch.stretched(last) - stretch.stretched(first)) / (last - first)
    if not share > _LEAST_FREE:
        raise ValueError(f"Nothing is left that the {name} could be changed by: keep less")
    extra = (wanted / present - 1.0) / share
    if not SLOPES[0] <= 1.0 + extra <= SLOPES[1]:
        reach = [present * (1.0 + (slope - 1.0) * share) for slope in SLOPES]
        left = _left(stretch.free, first, last)
        raise ValueError(
            f"What is kept leaves {left:.3g} m of the {name} of {present:.5g} m to be changed: the "
            f"{name} can become {reach[0]:.5g} to {reach[1]:.5g} m, not {wanted:.5g}; ask for that "
            "or keep less"
        )
    return AxisStretch(stretch.free, extra, mirrored)


@dataclass(frozen=True)
class Stretch(Scale):
    """A Scale of which coordinates go by an AxisStretch each, None: by the factor. Lengths, areas
    and volumes, and planes that lie askew, go by the factors. metres: of a unit of all places that
    are given and returned."""

    axes: tuple = (None, None, None)
    metres: float = 1.0

    def in_units(self, metres):
        """The same for places in units of so many metres."""
        return Stretch(self.factors, self.shift, self.axes, metres)

    def place(self, axis, value):
        stretch = self.axes[axis]
        if stretch is None:
            return super().place(axis, value)
        moved = stretch(np.asarray(value) * self.metres) / self.metres
        return moved if np.ndim(value) else float(moved)

    def points(self, points):
        points = np.asarray(points, dtype=np.float64)
        columns = [self.place(axis, points[..., axis]) for axis in range(3)]
        return np.stack(columns, axis=-1)

    def points_before(self, points):
        """(…, 3) places that points() takes to these, in m."""
        columns = [
            np.asarray(points)[..., axis] / factor if own is None
            else own.inverse(np.asarray(points)[..., axis])
            for axis, (factor, own) in enumerate(zip(self.factors, self.axes))
        ]  # fmt: skip
        return np.stack(columns, axis=-1)

    def plane(self, normal, offset):
        normal = np.asarray(normal, dtype=np.float64)
        across = np.flatnonzero(normal)
        if len(across) == 1:
            axis = across[0]
            return normal, normal[axis] * self.place(axis, offset / normal[axis])
        return super().plane(normal, offset)

    def slopes(self, points):
        """(…, 3) by what lengths along x, y and z grow at places (…, 3)."""
        points = np.asarray(points, dtype=np.float64)
        columns = [
            np.full(points.shape[:-1], factor) if own is None
            else own.slope(points[..., axis] * self.metres)
            for axis, (factor, own) in enumerate(zip(self.factors, self.axes))
        ]  # fmt: skip
        return np.stack(columns, axis=-1)

    def plane_at(self, points, normal, offset):
        """(normal (3,), offset), in m, of the plane nearest to where points (n, 3) of this plane
        go: exact where that is a plane."""
        if np.count_nonzero(normal) == 1 or not len(points):
            return self.plane(normal, offset)
        slopes = self.slopes(np.mean(points, axis=0))
        turned = np.asarray(normal) / slopes
        turned /= np.linalg.norm(turned)
        return turned, float(np.mean(self.points(points) @ turned))


_NAMES = ("length", "beam", "depth")


def stretch_to(present, kept, low, high, *, of_surface=False, **wanted):
    """The Stretch that brings a hull to dimensions in m, while kept ranges, [(from, to)] along each
    of x, y and z, keep their shape; None where it is a Scale by factors alone.

    present, and length, beam, draft and depth wanted: as scaling.factors has them; heights between
    the base and the depth, or where there is none the highest point, grow as told. low, high (3,):
    ends of the surface. of_surface: its length, between these, is meant. ValueError as there and
    as axis_stretch.
    """
    found = factors(present, **wanted)
    top = present.depth if present.depth > 0.0 else high[2]
    side = max(abs(low[1]), abs(high[1]))
    ends = (
        (low[0], high[0]) if of_surface else (0.0, present.length_pp),
        (0.0, side if of_surface else 0.5 * present.beam),
        (0.0, top),
    )
    extents = ((low[0], high[0]), (0.0, side), (low[2], high[2]))
    sizes = [present.length_pp, present.beam, present.depth]
    names = list(_NAMES)
    if wanted.get("depth") is None:
        sizes[2], names[2] = present.draft, "draft"
    axes = [
        axis_stretch(
            names[axis], kept[axis], extent=extents[axis], anchors=ends[axis],
            present=sizes[axis], wanted=found[axis] * sizes[axis], mirrored=axis == 1,
        )
        if kept[axis] and found[axis] != 1.0
        else None
        for axis in range(3)
    ]  # fmt: skip
    return Stretch(found, axes=tuple(axes)) if any(axes) else None
