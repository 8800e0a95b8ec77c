# SPDX-License-Identifier: GPL-3.0-or-later
"""What of lines in space is seen from somewhere, past what is in front of them."""

import numpy as np

# Of the drawing's size: how far apart places on lines are that are looked at, and how exactly the
# ends of what is seen are found.
_STEP, _END = 1 / 800, 1e-5


def view_axes(azimuth, elevation):
    """(3, 3): rows to the right, up and towards the eye of a view from so many rad from ahead to
    port and above the hull. 0, 0: from ahead; pi / 2, 0: from port; 0, pi / 2: from above."""
    ca, sa, ce, se = np.cos(azimuth), np.sin(azimuth), np.cos(elevation), np.sin(elevation)
    eye = np.array([ca * ce, sa * ce, se])
    right = np.array([-sa, ca, 0.0])
    return np.stack([right, np.cross(eye, right), eye])


class Eye:
    """Where it is, and what it makes of places: so that rays to it are parallel to z. In
    perspective that is the map (x, y, z) -> (x, y, 1) / w, w the distance along the view, which
    leaves lines straight and planes plane."""

    def __init__(self, axes, points, distance):
        self._axes, self._distance = axes, distance
        self._middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
        self.depth_scale = 1.0
        if distance is None:
            return
        depth = distance - ((points - self._middle) @ axes.T)[:, 2]
        if not depth.min() > 0.05 * distance:
            raise ValueError("The eye is in the hull or next to it: give it a larger distance.")
        self.depth_scale = (distance / depth.min()) ** 2

    def seen(self, points):
        local = (np.asarray(points) - self._middle) @ self._axes.T
        if self._distance is None:
            return local
        depth = self._distance - local[:, 2]
        share = self._distance / depth
        # The third coordinate grows towards the eye.
        return np.column_stack([local[:, :2] * share[:, None], self._distance * (share - 1.0)])

    def facing(self, points, normals):
        """How much normals at places look to the eye, above 0 where they do."""
        if self._distance is None:
            return np.asarray(normals) @ self._axes[2]
        eye = self._middle + self._distance * self._axes[2]
        return np.einsum("ij,ij->i", normals, eye - points)

    def flat(self, seen):
        """On the drawing."""
        return np.asarray(seen)[:, :2]


class Sight:
    """What of lines is seen, from +z, past a model that tells what it `covers`; size: of the
    drawing.

    Lines are places (n, 3), which are moved by in_front of depth towards the eye before it is asked
    what is in front of them; or (n, 3 + 4 k): behind each place k that are asked in its stead, and
    of each how much it faces the eye. A place is seen where one of them does and is not covered."""

    def __init__(self, model, size, in_front=0.0):
        self._model, self._step, self._end = model, _STEP * size, _END * size
        self._off = np.array([0.0, 0.0, in_front])

    def _sees(self, places):
        if places.shape[1] == 3:
            return ~self._model.covers(places + self._off)
        sees = np.zeros(len(places), dtype=bool)
        for asked in np.split(places[:, 3:], (places.shape[1] - 3) // 4, axis=1):
            is_open = ~sees & (asked[:, 3] > 0.0)
            sees[is_open] = ~self._model.covers(asked[is_open, :3])
        return sees

    def pieces(self, lines):
        """For each of polylines its pieces from end to end, (whether it is seen, polyline of the
        same columns). All are looked at together: what hides them is sorted once for a look."""
        dense = [_dense(line, self._step) for line in lines]
        counts = [max(0, len(line) - 1) for line in dense]
        middles = [0.5 * (line[1:] + line[:-1]) for line in dense]
        looks = np.split(self._sees(np.vstack(middles)), np.cumsum(counts)[:-1])
        turns = [np.flatnonzero(look[1:] != look[:-1]) + 1 for look in looks]
        ends = np.split(self._turns(dense, middles, looks, turns), np.cumsum([*map(len, turns)]))
        for line, look, turn, end in zip(dense, looks, turns, ends):
            yield list(_parts(line, look, turn, end)) if len(look) else []

    def _turns(self, dense, middles, looks, turns):
        """Where seen turns to hidden or back, of all lines one after the other."""
        before = np.vstack([m[t - 1] for m, t in zip(middles, turns)])
        corner = np.vstack([line[t] for line, t in zip(dense, turns)])
        after = np.vstack([m[t] for m, t in zip(middles, turns)])
        first = np.concatenate([look[t - 1] for look, t in zip(looks, turns)])
        if not len(first):
            return before
        is_later = (self._sees(corner) == first)[:, None]
        low, high = np.where(is_later, corner, before), np.where(is_later, after, corner)
        for _ in range(int(np.ceil(np.log2(self._step / self._end)))):
            middle = 0.5 * (low + high)
            is_low = (self._sees(middle) == first)[:, None]
            low, high = np.where(is_low, middle, low), np.where(is_low, high, middle)
        return 0.5 * (low + high)


def _parts(line, look, turns, ends):
    start = line[:1]
    for k, (begin, end) in enumerate(zip([0, *turns], [*turns, len(look)])):
        last = ends[k : k + 1] if k < len(turns) else line[-1:]
        yield bool(look[begin]), np.vstack([start, line[begin + 1 : end], last])
        start = last


def _dense(line, step):
    """The polyline with no two points further apart than step, seen; without double points."""
    lengths = np.linalg.norm(np.diff(line[:, :2], axis=0), axis=1)
    counts = np.maximum(1, np.ceil(lengths / step).astype(int))
    shares = np.concatenate([np.arange(n) / n for n in counts] + [[0.0]])
    begins = np.append(np.repeat(np.arange(len(counts)), counts), len(line) - 1)
    ends = np.minimum(begins + 1, len(line) - 1)
    return line[begins] + shares[:, None] * (line[ends] - line[begins])
