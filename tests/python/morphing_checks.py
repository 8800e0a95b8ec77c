# SPDX-License-Identifier: GPL-3.0-or-later
"""What holds of any two merged discs."""

from fractions import Fraction

import hull_native as hn
import numpy as np
import pytest
from morphing_discs import area, euler, exact_area, volume


def check_counts(merged, maps):
    counts = [len(map_.places) for map_ in maps]
    assert len(merged.places) == sum(counts) - merged.shared_count + merged.crossing_count
    assert euler(merged.triangles) == 1
    origins = merged.origins
    assert (origins >= 0).all(axis=1).sum() == merged.shared_count
    assert (origins < 0).all(axis=1).sum() == merged.crossing_count
    for disc, count in enumerate(counts):
        assert np.array_equal(np.unique(origins[origins[:, disc] >= 0, disc]), np.arange(count))


def check_shapes(merged, maps):
    """Each parent is what it was, as measured and point by point; so are the ends of the family."""
    for disc, (points, map_, t) in enumerate(
        zip((merged.first_points, merged.second_points), maps, (0, 1))
    ):
        own = map_.disc
        size = np.ptp(own.points, axis=0).max()
        assert area(points, merged.triangles) == pytest.approx(
            area(own.points, own.triangles), rel=1e-12
        )
        assert volume(points, merged.triangles) == pytest.approx(
            volume(own.points, own.triangles), rel=1e-12
        )
        kept = merged.origins[:, disc] >= 0
        assert np.array_equal(points[kept], own.points[merged.origins[kept, disc]])
        assert np.array_equal(merged.points(t), points)
        # Each corner of a part is in the plane of its triangle of the parent, and within it.
        a, b, c = own.points[own.triangles[merged.parents[:, disc]]].transpose(1, 0, 2)
        normal = np.cross(b - a, c - a)
        twice = np.linalg.norm(normal, axis=1)
        for corner in range(3):
            p = points[merged.triangles[:, corner]]
            off = np.einsum("ij,ij->i", p - a, normal) / twice
            assert np.abs(off).max() < 1e-12 * size
            for e, f in ((a, b), (b, c), (c, a)):
                inside = np.einsum("ij,ij->i", np.cross(f - e, p - e), normal) / twice
                assert (inside / np.linalg.norm(f - e, axis=1)).min() > -1e-12 * size


def _exact_place(point, merged, maps, around, place_of):
    """A crossing without rounding: where edges of the parents of the triangles around it cross."""
    place = [Fraction(number) for number in merged.places[point]]
    if (merged.origins[point] >= 0).any():
        return place
    ends = []
    for disc, map_ in enumerate(maps):
        parents = {merged.parents[t, disc] for t in around[point]}
        shared = set.intersection(*(set(map_.disc.triangles[t]) for t in parents))
        ends += [place_of[disc][each] for each in sorted(shared)]
    p, q, r, s = ends
    from_r, from_s = exact_area(p, q, r), exact_area(p, q, s)
    along = from_r / (from_r - from_s)
    exact = [Fraction(x) + along * (Fraction(y) - Fraction(x)) for x, y in zip(r, s)]
    assert max(abs(float(x - y)) for x, y in zip(exact, place)) < 1e-12
    return exact


def check_areas(merged, maps, thinner=np.inf):
    """All triangles turn to the left in the plane: those of less than an area by fractions, of
    crossings before rounding; the others as they are."""
    # Border points of both discs have one place, which is that of the merged mesh.
    place_of = [
        {origin: merged.places[point] for point, origin in enumerate(merged.origins[:, disc])}
        for disc in range(2)
    ]
    around = [[] for _ in merged.places]
    for t, corners in enumerate(merged.triangles):
        for point in corners:
            around[point].append(t)
    a, b, c = merged.places[merged.triangles].transpose(1, 0, 2)
    rounded = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    thin = np.flatnonzero(rounded < thinner)
    places = {
        point: _exact_place(point, merged, maps, around, place_of)
        for point in np.unique(merged.triangles[thin])
    }
    assert all(exact_area(*(places[each] for each in merged.triangles[t])) > 0 for t in thin)
    return len(thin)


def check_all(maps, exact=True):
    """exact: areas of all triangles by fractions, of none (False), or of the "thin" ones, of which
    there are to be some."""
    merged = hn.MergedDiscs(*maps)
    check_counts(merged, maps)
    check_shapes(merged, maps)
    if exact:
        assert check_areas(merged, maps, 1e-9 if exact == "thin" else np.inf) > 0
    return merged
