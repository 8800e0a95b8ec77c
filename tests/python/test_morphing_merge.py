# SPDX-License-Identifier: GPL-3.0-or-later
"""Two discs merged to one mesh, and the surfaces between them (Kang & Lee 2012)."""

import hull_native as hn
import numpy as np
import pytest
from morphing_checks import check_all
from morphing_discs import KITE, SQUARE, bent, grid, in_polygon, mapped, random_disc, star, volume

SEED = 20261124


def pair(first, second, polygon, seed=SEED):
    """Bent grids of two sizes on one polygon."""
    maps = []
    for waves, size in ((3, first), (5, second)):
        random = np.random.default_rng([seed, waves])
        points, triangles, corners = grid(*size, random)
        maps.append(mapped(bent(points, waves), triangles, corners, polygon))
    return maps


@pytest.mark.parametrize("polygon", [SQUARE, KITE])
def test_bent_grids(polygon):
    maps = pair((7, 5), (4, 9), polygon)
    merged = check_all(maps)
    assert merged.shared_count >= 4 and merged.crossing_count > 50


def test_random_discs():
    random = np.random.default_rng(SEED)
    for _ in range(12):
        sides = random.integers(3, 6)
        polygon = hn.polygon_on_circle(random.uniform(0.2, 1, sides))
        maps = []
        while len(maps) < 2:
            points, triangles, corners = random_disc(
                random, random.integers(sides, 12), random.integers(0, 14)
            )
            if len(corners) == sides:
                maps.append(mapped(points, triangles, corners, polygon))
        check_all(maps)


CROSS = star(*SQUARE)
JACK = star((0, 0), (0.5, 0), (1, 0), (1, 0.5), (1, 1), (0.5, 1), (0, 1), (0, 0.5))
DIAGONAL = mapped([(*p, 0.0) for p in SQUARE], [(0, 1, 2), (0, 2, 3)], range(4), SQUARE)
# Through the middle beside all edges of the star.
SLANT = mapped(
    [(0, 0, 0), (1, 0, 0), (1, 0.75, 0), (1, 1, 0), (0, 1, 0), (0, 0.25, 0)],
    [(0, 1, 2), (0, 2, 5), (5, 2, 3), (5, 3, 4)],
    [0, 1, 3, 4],
    SQUARE,
)


@pytest.mark.parametrize(
    "maps, shared, points, triangles",
    [
        ((CROSS, JACK), 5, 9, 8),
        ((JACK, DIAGONAL), 4, 9, 8),
        ((CROSS, DIAGONAL), 4, 5, 4),
        ((CROSS, SLANT), 4, 9, 10),
    ],
)
def test_edges_and_points_that_lie_on_one_another(maps, shared, points, triangles):
    for order in (maps, maps[::-1]):
        merged = check_all(order)
        assert (merged.shared_count, len(merged.places)) == (shared, points)
        assert len(merged.triangles) == triangles


def test_a_disc_with_itself_is_itself():
    random = np.random.default_rng(SEED)
    points, triangles, corners = random_disc(random, 14, 40)
    polygon = hn.polygon_on_circle(np.ones(len(corners)))
    map_ = mapped(points, triangles, corners, polygon)
    merged = check_all((map_, map_))
    assert merged.crossing_count == 0 and merged.shared_count == len(map_.places)
    assert len(merged.triangles) == len(map_.disc.triangles)
    # Renumbered, the places differ by rounding: points that are not quite the same, and yet all
    # holds. Triangles of 1e-15 are there, but exact, and nothing moves.
    order = random.permutation(len(points))
    number = np.argsort(order)
    other = mapped(points[order], number[triangles], number[np.array(corners)], polygon)
    merged = check_all((map_, other))
    assert np.abs(merged.points(0.5) - merged.first_points).max() < 1e-11


def test_the_order_of_parents_is_nothing():
    """M of A and B at t is M of B and A at 1 - t: the same points and triangles, to the bit."""
    maps = pair((9, 6), (5, 8), KITE)
    one, other = hn.MergedDiscs(*maps), hn.MergedDiscs(*maps[::-1])

    def as_set(merged, points):
        keys = [tuple(p) for p in np.column_stack([merged.places, points]).tolist()]
        return {tuple(keys[corner] for corner in corners) for corners in merged.triangles}

    for t in (-0.25, 0.0, 0.25, 0.5, 1.0):
        triangles = as_set(one, one.points(t))
        assert len(triangles) == len(one.triangles)
        assert triangles == as_set(other, other.points(1 - t))


def test_parts_stay_flat_between_the_parents():
    """A part of two triangles is flat on both, and all the way between: how it is cut into
    triangles does not matter."""
    maps = pair((6, 5), (5, 7), SQUARE)
    merged = hn.MergedDiscs(*maps)
    points = merged.points(0.37)
    parents, part = np.unique(merged.parents, axis=0, return_inverse=True)
    a, b, c = points[merged.triangles].transpose(1, 0, 2)
    area_vectors = np.cross(b - a, c - a)
    for k in np.flatnonzero(np.bincount(part.ravel(), minlength=len(parents)) > 1):
        inside = np.flatnonzero(part.ravel() == k)
        corners = points[np.unique(merged.triangles[inside])]
        normal = area_vectors[inside].sum(axis=0)
        off = (corners - corners.mean(axis=0)) @ normal / np.linalg.norm(normal)
        assert np.abs(off).max() < 1e-9


def test_volume_is_cubic_in_t():
    maps = pair((6, 5), (5, 7), SQUARE)
    merged = hn.MergedDiscs(*maps)
    volumes = [volume(merged.points(t), merged.triangles) for t in (0, 0.3, 0.7, 1, 1.5, -1)]
    cubic = np.polyfit((0, 0.3, 0.7, 1), volumes[:4], 3)
    assert np.polyval(cubic, (1.5, -1)) == pytest.approx(volumes[4:], rel=1e-11)


def test_different_polygons_are_refused():
    points, triangles, corners = grid(2, 2)
    maps = [mapped(points, triangles, corners, polygon) for polygon in (SQUARE, KITE)]
    with pytest.raises(ValueError, match="mapped onto different polygons"):
        hn.MergedDiscs(*maps)


def test_border_points_that_are_nearly_one_are_one():
    """Within 1e-9 of the side; each parent keeps its own place in space."""
    points, triangles, corners = grid(4, 4)
    near = points.copy()
    near[1, 0] += 3e-10
    near[2, 0] += 3e-9
    for polygon in (SQUARE, KITE):
        maps = [mapped(bent(p, 3), triangles, corners, polygon) for p in (points, near)]
        merged = check_all(maps, exact=False)
        both = (merged.origins[:, 0] == 1) & (merged.origins[:, 1] == 1)
        assert both.sum() == 1
        assert not ((merged.origins[:, 0] == 2) & (merged.origins[:, 1] == 2)).any()


@pytest.mark.parametrize("weights", ["shape_preserving", "mean_value"])
def test_planes_on_one_polygon_stay_as_they_are(weights):
    """Two plane meshes of one outline are mapped as they are: nothing moves between them."""
    random = np.random.default_rng(SEED)
    maps = []
    for size in ((9, 7), (6, 8)):
        points, triangles, corners = grid(*size, random)
        maps.append(mapped(in_polygon(points, KITE), triangles, corners, KITE, weights=weights))
    merged = check_all(maps)
    for t in (0, 0.4, 1):
        assert np.abs(merged.points(t)[:, :2] - merged.places).max() < 1e-12


def test_parts_that_are_merged_apart_fit_together():
    """Two parents cut along a bent line: each pair of parts has the same points along it."""
    parts = [[], []]
    for waves, size in ((3, (8, 6)), (5, (6, 9))):
        points, triangles, _ = grid(*size, np.random.default_rng([SEED, waves]))
        points = bent(points, waves)
        column = size[0] // 2
        is_left = (triangles % (size[0] + 1) <= column).all(axis=1)
        for part, chosen in zip(parts, (is_left, ~is_left)):
            kept, own = np.unique(triangles[chosen], return_inverse=True)
            first, last = (0, column) if part is parts[0] else (column, size[0])
            row = size[1] * (size[0] + 1)
            corners = np.searchsorted(kept, [first, last, row + last, row + first])
            part.append(mapped(points[kept], own.reshape(-1, 3), corners, KITE))
    left, right = (check_all(part) for part in parts)
    along = []
    for merged, (corner, far) in ((left, (1, 2)), (right, (0, 3))):
        a, b = np.array(KITE[corner]), np.array(KITE[far])
        across, ahead = merged.places - a, (b - a) / np.linalg.norm(b - a)
        on_it = np.abs(across[:, 0] * ahead[1] - across[:, 1] * ahead[0]) < 1e-12
        order = np.argsort(across[on_it] @ ahead)
        along.append([p[on_it][order] for p in (merged.first_points, merged.second_points)])
    assert len(along[0][0]) > 12
    assert np.abs(np.subtract(*along)).max() < 1e-13
