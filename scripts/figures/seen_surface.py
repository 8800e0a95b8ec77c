# SPDX-License-Identifier: GPL-3.0-or-later
"""What of a hull is seen from far away, dot by dot: points and normals of exact surfaces, of their
patches and of triangles, sampled more closely than the dots."""

import math

import hull_native as hn
import numpy as np

# Samples a dot apart, at most.
SPACING = 0.6
MOST_SAMPLES = 400000
# Along each side of a piece that is measured before it is sampled.
_COARSE = 3


class View:
    """A parallel projection: bearing from the bow to port and elevation in degrees, the part of
    the page (x from, x to, y from, y to; m), and the width in dots."""

    def __init__(self, bearing_deg, elevation_deg, window, width):
        bearing, elevation = math.radians(bearing_deg), math.radians(elevation_deg)
        self.eye = np.array(
            [
                math.cos(bearing) * math.cos(elevation),
                math.sin(bearing) * math.cos(elevation),
                math.sin(elevation),
            ]
        )
        self.right = np.array([-math.sin(bearing), math.cos(bearing), 0.0])
        self.up = np.cross(self.eye, self.right)
        self.window, self.width = window, width
        self.dots_per_metre = width / (window[1] - window[0])
        self.height = round((window[3] - window[2]) * self.dots_per_metre)

    def dots(self, points):
        """(..., 2): columns and rows, from the left and from above."""
        x = (points @ self.right - self.window[0]) * self.dots_per_metre
        y = (self.window[3] - points @ self.up) * self.dots_per_metre
        return np.stack([x, y], axis=-1)

    def shown(self, colours, finer):
        """(height, width, 3) of the colours (dots, 3): finer x finer dots made one."""
        height, width = self.height // finer, self.width // finer
        fine = colours.reshape(self.height, self.width, 3)[: height * finer, : width * finer]
        return fine.reshape(height, finer, width, finer, 3).mean(axis=(1, 3))


class Seen:
    """The nearest point and its normal for each dot of a view; NaN where nothing is."""

    def __init__(self, view):
        self.view = view
        count = view.width * view.height
        self.depth = np.full(count, -np.inf)
        self.points = np.full((count, 3), np.nan)
        self.normals = np.full((count, 3), np.nan)

    def add(self, points, normals):
        """Both (n, 3)."""
        at, inside = self._dot_numbers(points)
        points, normals = points[inside], normals[inside]
        depth = points @ self.view.eye
        near = np.flatnonzero(depth > self.depth[at])
        # Of several at one dot the nearest is written last.
        near = near[np.argsort(depth[near], kind="stable")]
        at = at[near]
        self.depth[at] = depth[near]
        self.points[at] = points[near]
        self.normals[at] = normals[near]

    def is_seen(self, points, reach):
        """Whether points are nearer than what is there, or farther by less than `reach` (m)."""
        at, inside = self._dot_numbers(points)
        seen = np.zeros(len(points), dtype=bool)
        seen[inside] = points[inside] @ self.view.eye > self.depth[at] - reach
        return seen

    def _dot_numbers(self, points):
        """Of those within the page, and which these are."""
        columns, rows = np.floor(self.view.dots(points)).astype(int).T
        inside = (columns >= 0) & (columns < self.view.width)
        inside &= (rows >= 0) & (rows < self.view.height)
        return rows[inside] * self.view.width + columns[inside], inside


def see_surface(seen, surface):
    """Adds a LimitSurface, both sides of a half hull."""

    def evaluate(cell, uv):
        cells = np.full(len(uv), cell)
        return surface.positions(cells, uv), surface.normals(cells, uv)

    breaks = np.linspace(0.0, 1.0, _COARSE)
    for cell in range(surface.cell_count):
        _see_piece(seen, cell, breaks, breaks, evaluate)


def see_patches(seen, patches):
    """Adds a PatchSet, both sides of a half hull."""

    def evaluate(patch, uv):
        point, du, dv = patches.evaluate(np.full(len(uv), patch), uv)[:3]
        normal = np.cross(du, dv)
        return point, normal / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]

    for patch in range(patches.patch_count):
        u, v = (_breaks(knots) for knots in patches.knots(patch))
        _see_piece(seen, patch, u, v, evaluate)


def _breaks(knots):
    """The knots, and places between so that none is farther than half of [0, 1] from the next."""
    return np.unique(np.concatenate([knots, np.linspace(0.0, 1.0, _COARSE)]))


def _see_piece(seen, number, u, v, evaluate):
    """Samples a piece over [0, 1]^2 as closely as its size in dots between breaks asks for."""
    coarse, normals = evaluate(number, _tensor(u, v))
    for side in (1.0, -1.0):
        mirror = np.array([1.0, side, 1.0])
        if ((normals * mirror) @ seen.view.eye).max() < -0.1:
            continue
        dots = seen.view.dots(coarse * mirror).reshape(len(u), len(v), 2)
        parts = _parts_on_page(dots, seen.view)
        if not parts.any():
            continue
        at_u = _refined(u, _steps(dots, 0, parts), parts.any(axis=1))
        at_v = _refined(v, _steps(dots, 1, parts), parts.any(axis=0))
        rows = max(1, MOST_SAMPLES // len(at_v))
        for begin in range(0, len(at_u), rows):
            points, there = evaluate(number, _tensor(at_u[begin : begin + rows], at_v))
            seen.add(points * mirror, there * mirror)


def _parts_on_page(dots, view):
    """(u - 1, v - 1): whether rectangles between breaks, at dots (u, v, 2), may be on the page."""
    corners = np.stack([dots[:-1, :-1], dots[1:, :-1], dots[:-1, 1:], dots[1:, 1:]])
    return _are_on_page(corners.min(axis=0), corners.max(axis=0), view)


def _are_on_page(low, high, view):
    margin = 0.5 * (high - low) + 1.0
    inside = (high + margin > 0.0).all(axis=-1)
    return inside & (low - margin < (view.width, view.height)).all(axis=-1)


def _steps(dots, axis, parts):
    """The longest step in dots of each interval along an axis, among parts on the page."""
    steps = np.linalg.norm(np.diff(dots, axis=axis), axis=2)
    if axis == 0:
        return np.where(parts, np.maximum(steps[:, :-1], steps[:, 1:]), 0.0).max(axis=1)
    return np.where(parts, np.maximum(steps[:-1], steps[1:]), 0.0).max(axis=0)


def _tensor(u, v):
    return np.stack(np.meshgrid(u, v, indexing="ij"), axis=-1).reshape(-1, 2)


def _refined(breaks, sizes, wanted):
    """Breaks of the wanted intervals, each divided by its size in dots."""
    counts = np.ceil(sizes / SPACING).astype(int) + 1
    ends = zip(breaks[:-1][wanted], breaks[1:][wanted], counts[wanted])
    return np.unique(np.concatenate([np.linspace(a, b, count + 1) for a, b, count in ends]))


def see_triangles(seen, corners, smooth_deg=35.0):
    """Adds triangles (n, 3, 3), with normals that turn evenly between neighbours that meet at less
    than smooth_deg."""
    normals = _corner_normals(corners, math.cos(math.radians(smooth_deg)))
    facing = (normals @ seen.view.eye).max(axis=1) > -0.1
    corners, normals = corners[facing], normals[facing]
    dots = seen.view.dots(corners)
    sizes = np.linalg.norm(dots - np.roll(dots, 1, axis=1), axis=2).max(axis=1)
    low, high = dots.min(axis=1), dots.max(axis=1)
    inside = (high >= 0.0).all(axis=1) & (low <= (seen.view.width, seen.view.height)).all(axis=1)
    counts = 2 ** np.ceil(np.log2(np.maximum(sizes / SPACING, 1.0))).astype(int)
    for count in np.unique(counts[inside]):
        shares = _shares(count)
        alike = np.flatnonzero(inside & (counts == count))
        step = max(1, MOST_SAMPLES // len(shares))
        for begin in range(0, len(alike), step):
            some = alike[begin : begin + step]
            points = np.einsum("sk,nkd->nsd", shares, corners[some]).reshape(-1, 3)
            there = np.einsum("sk,nkd->nsd", shares, normals[some]).reshape(-1, 3)
            seen.add(points, there / np.linalg.norm(there, axis=1)[:, None])


def _shares(count):
    """Barycentric grid of count divisions."""
    i, j = np.meshgrid(np.arange(count + 1), np.arange(count + 1), indexing="ij")
    i, j = i[i + j <= count], j[i + j <= count]
    return np.stack([i, j, count - i - j], axis=1) / count


def _corner_normals(corners, least_cosine):
    """(n, 3, 3): at each corner the mean, weighted by area, of the triangles there that are turned
    no more than this from the corner's own."""
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    own = cross / np.maximum(np.linalg.norm(cross, axis=1), 1e-300)[:, None]
    size = np.ptp(corners.reshape(-1, 3), axis=0).max()
    places = np.round(corners.reshape(-1, 3) / (1e-7 * size)).astype(np.int64)
    _, vertex, counts = np.unique(places, axis=0, return_inverse=True, return_counts=True)
    by_vertex = np.argsort(vertex.reshape(-1), kind="stable")
    begins = np.cumsum(counts) - counts
    sums = np.empty((len(by_vertex), 3))
    for count in np.unique(counts):
        alike = by_vertex[begins[counts == count][:, None] + np.arange(count)]
        normals, areas = own[alike // 3], cross[alike // 3]
        near = normals @ normals.transpose(0, 2, 1) >= least_cosine
        sums[alike] = near @ areas
    sums = sums.reshape(-1, 3, 3)
    return sums / np.maximum(np.linalg.norm(sums, axis=2), 1e-300)[..., None]


def border_points(patches, view):
    """(n, 3) points of all patches' sides, less than a dot apart, where they may be on the page."""
    lines = [
        (number, along, end)
        for number in range(patches.patch_count)
        for along in (0, 1)
        for end in (0.0, 1.0)
    ]
    return np.concatenate([_border(patches, view, *line) for line in lines])


def _border(patches, view, number, along, end):
    breaks = _breaks(patches.knots(number)[along])
    coarse = _line(patches, number, along, end, breaks)
    wanted, sizes = np.zeros(len(breaks) - 1, dtype=bool), np.zeros(len(breaks) - 1)
    for side in (1.0, -1.0):
        dots = view.dots(coarse * [1.0, side, 1.0])
        low, high = np.minimum(dots[:-1], dots[1:]), np.maximum(dots[:-1], dots[1:])
        wanted |= _are_on_page(low, high, view)
        sizes = np.maximum(sizes, np.linalg.norm(np.diff(dots, axis=0), axis=1))
    if not wanted.any():
        return np.zeros((0, 3))
    return _line(patches, number, along, end, _refined(breaks, sizes, wanted))


def _line(patches, number, along, end, t):
    uv = np.full((len(t), 2), end)
    uv[:, along] = t
    return patches.positions(np.full(len(t), number), uv)


def distances(points, surface):
    """Of points (n, 3) from the surface or its mirror image, m; NaN where they are."""
    found = np.full(len(points), np.nan)
    there = np.isfinite(points[:, 0])
    to_port = points[there]
    to_port[:, 1] = np.abs(to_port[:, 1])
    found[there] = hn.SurfaceTree(surface).closest_points(to_port).distances
    return found
