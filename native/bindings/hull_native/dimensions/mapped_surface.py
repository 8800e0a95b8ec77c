# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface brought to where a smooth map of space takes it. Lengths are in metres.

Control points go where the map takes them, which brings the surface there exactly where the map is
affine over all that it depends on. Elsewhere a Reshape moves them by what is left, across the
surface: how its points slide along it does not count.
"""

from dataclasses import dataclass

import numpy as np

from .._core import (
    LimitSurface,
    Reshape,
    SurfacePlaces,
    SurfaceTree,
    point_weights,
    square_sums,
    square_ties,
)

# Of the mesh's size: ends that are met so far are met.
_ENDS_MET = 1e-11
# Of a Reshape: without it control points that the shape hardly tells apart run away.
_STIFFNESS = 1e-3
# Passes, and what each leaves of the distance at the most, to be worth it.
_PASSES, _GAIN = 2, 0.9
# More control points follow the map closely by themselves, and would take a Reshape some seconds.
_MOST_POINTS = 2000
# Places that are looked for at a time, between words of progress: some tenths of a second.
_AT_A_TIME = 10_000
# Divisions of a cell's side where ends are sought first, and around the furthest place then.
_FIRST, _CLOSER, _ROUNDS = 8, 4, 16


@dataclass(frozen=True, eq=False)
class MappedSurface:
    """points (n, 3): of the control mesh. planes: (normal (3,), offset) of each flat. rms, largest:
    distances of the surface from where the map takes it, largest_place (3,) where on it.
    ends_missed: the largest distance of its ends along x, y and z from where theirs go. All in m.
    """

    points: np.ndarray
    planes: list
    rms: float
    largest: float
    largest_place: np.ndarray
    ends_missed: float


def map_surface(
    surface, stretch, *, locked=(), held_points=(), held_normals=(), flats=(), progress=None
):
    """The MappedSurface of a LimitSurface under a hull_io.stretching.Stretch.

    locked (l,): control points that go where the map takes them and no further. held_points (h,),
    held_normals (h, 3): as of Reshape, of now; their planes go along. flats: [(control points,
    normal (3,), offset)], each kept in its plane. Coordinates of control points in kept ranges
    move as one. progress: a callable that takes the share done, 0 to 1; what it raises ends it.
    """
    telling = _Telling(progress)
    size = float(np.ptp(surface.mesh.points, axis=0).max())
    normals = np.array(held_normals, dtype=np.float64).reshape(-1, 3)
    held = np.asarray(held_points, dtype=np.int64)
    planes = [stretch.plane_at(surface.mesh.points[points], *own) for points, *own in flats]
    for (points, normal, _), (turned, _) in zip(flats, planes):
        normals[np.isin(held, points) & (normals == normal).all(axis=1)] = turned
    points = _into_planes(stretch.points(surface.mesh.points), flats, planes)
    start = LimitSurface(surface.mesh.with_points(points), surface.scheme)
    target = _Target(surface, stretch, telling)
    first = _Tried(start, planes, SurfacePlaces(start), target)
    if len(points) > _MOST_POINTS:
        return first.outcome
    telling.next_part()
    kept, across, rigid = _kept_coordinates(surface.mesh.points, stretch)
    tied, directions = square_ties(start)
    reshape = Reshape(
        start,
        locked=np.unique(np.concatenate([np.asarray(locked, int), rigid, target.end_points()])),
        held_points=np.concatenate([held, kept]),
        held_normals=np.concatenate([normals, across]),
        tied=tied,
        tied_directions=directions,
        kept=square_sums(start),
        stiffness=_STIFFNESS,
    )
    return _nearest(start, first, reshape, target, _ENDS_MET * size, telling)


class _Telling:
    """Tells how much is done: a part for what is mapped first, and for each pass and what it is
    prepared by."""

    def __init__(self, progress):
        self._progress, self._part = progress or (lambda share: None), 0

    def next_part(self):
        self._part += 1
        self.within(0.0)

    def within(self, share):
        """Of the part at hand; what is done sooner than was thought stays within all."""
        self._progress(min(1.0, (self._part + share) / (2 + _PASSES)))


def _kept_coordinates(points, stretch):
    """(control points, normals) of coordinates that lie in kept ranges, and the control points of
    which all do that are stretched."""
    found = [(np.empty(0, dtype=np.int64), np.empty((0, 3)))]
    rigid = np.ones(len(points), dtype=bool)
    for axis, own in enumerate(stretch.axes):
        if own is not None:
            is_kept = own.weight(points[:, axis]) == 0.0
            rigid &= is_kept
            kept = np.flatnonzero(is_kept)
            found.append((kept, np.tile(np.eye(3)[axis], (len(kept), 1))))
    held, normals = (np.concatenate(parts) for parts in zip(*found))
    return held, normals, np.flatnonzero(rigid)


class _Target:
    """Where the map takes a surface, as a shape: how its points slide along it does not count."""

    def __init__(self, surface, stretch, telling):
        self._surface, self._stretch, self._telling = surface, stretch, telling
        self._tree = SurfaceTree(surface)
        self._low, self._high = surface_ends(surface)
        self._ends = stretch.points(np.array([self._low, self._high]))

    def off(self, points):
        """(k, 3) from points to the tangent planes of the wanted shape where it is nearest, as
        nearness is before the map."""
        found = np.empty_like(points)
        for begin in range(0, len(points), _AT_A_TIME):
            self._telling.within(begin / len(points))
            part = slice(begin, begin + _AT_A_TIME)
            found[part] = self._off(points[part])
        return found

    def _off(self, points):
        before = self._stretch.points_before(points)
        near = self._tree.closest_points(before)
        normals = self._surface.normals(near.cells, near.uv) / self._stretch.slopes(near.points)
        lengths = np.linalg.norm(normals, axis=1, keepdims=True)
        normals /= np.where(lengths > 0.0, lengths, 1.0)
        apart = self._stretch.points(near.points) - points
        return (apart * normals).sum(axis=1, keepdims=True) * normals

    def missed(self, surface):
        """By what the ends of a surface are not where they are to be, m, at the most."""
        return float(np.abs(self._ends - np.array(surface_ends(surface))).max())

    def end_points(self):
        """The control points that shape the surface's ends."""
        surface = self._surface
        grid = surface.evaluate_grid(_FIRST)[0].reshape(-1, 3)
        near = _ENDS_MET * np.ptp(grid, axis=0).max()
        is_end = ((grid <= self._low + near) | (grid >= self._high - near)).any(axis=1)
        cells, place = np.divmod(np.flatnonzero(is_end), (_FIRST + 1) ** 2)
        uv = np.stack(np.divmod(place, _FIRST + 1), axis=1) / _FIRST
        return np.unique(point_weights(surface, cells, uv)[1])


def _nearest(start, first, reshape, target, met, telling):
    """The MappedSurface nearest to the target, of the first _Tried and of some passes that meet its
    ends."""
    made, tried = LimitSurface(start.mesh, start.scheme), first
    best = first.outcome
    for _ in range(_PASSES):
        telling.next_part()
        result = reshape.solve(tried.positions + tried.off - reshape.positions)
        if result.folded_place is not None:
            break
        made.set_points(start.mesh.points + result.moves)
        places = SurfacePlaces(made, places=reshape.places)
        tried = _Tried(made, best.planes, places, target)
        outcome = tried.outcome
        if outcome.ends_missed > max(met, best.ends_missed) or outcome.rms > _GAIN * best.rms:
            break
        best = outcome
    return best


class _Tried:
    """A surface beside the target: positions (k, 3) of its places, off (k, 3) from there to the
    target, and its outcome, a MappedSurface."""

    def __init__(self, surface, planes, places, target):
        self.positions = places.positions
        self.off = target.off(self.positions)
        left = np.linalg.norm(self.off, axis=1)
        worst = int(left.argmax())
        rms = float(np.sqrt(places.areas @ left**2 / places.areas.sum()))
        self.outcome = MappedSurface(
            surface.mesh.points, planes, rms, float(left[worst]), self.positions[worst],
            target.missed(surface),
        )  # fmt: skip


def _into_planes(points, flats, planes):
    """Points brought into the planes of their flats, each by the shortest way."""
    of_points = {}
    for (indices, *_), plane in zip(flats, planes):
        for index in np.asarray(indices).tolist():
            of_points.setdefault(index, []).append(plane)
    for index, own in of_points.items():
        normals = np.array([normal for normal, _ in own])
        off = np.array([offset for _, offset in own]) - normals @ points[index]
        points[index] += np.linalg.lstsq(normals, off, rcond=None)[0]
    return points


def surface_ends(surface):
    """(least, greatest) of the surface's x, y and z, (3,) each, m, to rounding."""
    sign = np.array([-1.0, 1.0])
    grid = surface.evaluate_grid(_FIRST)[0]
    found = np.empty((2, 3))
    for side in range(2):
        for axis in range(3):
            found[side, axis] = _end(surface, grid[..., axis], axis, sign[side])
    return found[0], found[1]


def _end(surface, grid, axis, sign):
    heights = sign * grid.reshape(len(grid), -1)
    cells = np.argsort(heights.max(axis=1))[-4:]
    uv = np.stack(np.unravel_index(heights[cells].argmax(axis=1), (_FIRST + 1,) * 2), axis=1)
    uv = uv / _FIRST
    best, step = heights[cells].max(), 1.0 / _FIRST
    offsets = np.stack(np.meshgrid(*[np.linspace(-1.0, 1.0, 2 * _CLOSER + 1)] * 2), -1)
    offsets = offsets.reshape(-1, 2)
    for _ in range(_ROUNDS):
        around = np.clip(uv[:, None] + step * offsets, 0.0, 1.0)
        count = len(offsets)
        points = surface.positions(np.repeat(cells, count), around.reshape(-1, 2))
        values = sign * points[:, axis].reshape(len(cells), count)
        chosen = values.argmax(axis=1)
        uv = around[np.arange(len(cells)), chosen]
        best = max(best, values.max())
        step *= 2.0 / _CLOSER
    return sign * best
