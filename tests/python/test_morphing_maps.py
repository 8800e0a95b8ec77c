# SPDX-License-Identifier: GPL-3.0-or-later
"""Discs of triangles laid into convex polygons (Floater 1997)."""

import hull_native as hn
import numpy as np
import pytest
from morphing_discs import KITE, SQUARE, exact_area, grid, in_polygon, mapped, random_disc, star

SEED = 20261124


def plane_errors(polygon, weights):
    points, triangles, corners = grid(11, 8, np.random.default_rng(SEED))
    points = in_polygon(points, polygon)
    turned = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])
    places = mapped(100 * points @ turned, triangles, corners, polygon, weights=weights).places
    return np.abs(places[: len(points)] - points[:, :2]).max()


@pytest.mark.parametrize("polygon", [SQUARE, KITE])
def test_plane_meshes_keep_their_shape(polygon):
    """To rounding; uniform weights, of the same solution, do not."""
    assert plane_errors(polygon, "shape_preserving") < 1e-12
    assert plane_errors(polygon, "mean_value") < 1e-12
    assert plane_errors(polygon, "uniform") > 1e-3


@pytest.mark.parametrize("weights", ["shape_preserving", "mean_value", "uniform"])
def test_random_discs_have_no_flips(weights):
    """By fractions of the places as they are."""
    random = np.random.default_rng([SEED, len(weights)])
    split = 0
    for trial in range(40):
        points, triangles, corners = random_disc(
            random, random.integers(3, 20), random.integers(0, 30)
        )
        polygon = hn.polygon_on_circle(random.uniform(0.1, 1, len(corners)))
        map_ = mapped(points, triangles, corners, polygon, weights=weights)
        split += len(map_.split_edges)
        for corners_of in map_.disc.triangles:
            assert exact_area(*map_.places[corners_of]) > 0, f"seed {SEED}, trial {trial}"
        whole = sum(exact_area(*map_.places[each]) for each in map_.disc.triangles)
        lines = np.asarray(polygon)
        ahead = np.roll(lines, -1, axis=0)
        exact = (lines[:, 0] * ahead[:, 1] - lines[:, 1] * ahead[:, 0]).sum()
        assert float(whole) == pytest.approx(exact, rel=1e-12)
    assert split > 20


def test_edges_between_points_of_a_side_are_divided():
    """A triangle with two edges on the side of a square, and one with three points on it."""
    points = [(x, 0, x * (4 - x)) for x in (0, 1, 2, 3, 4)] + [(4, 4, 0), (0, 4, 0)]
    triangles = [(0, 1, 2), (2, 3, 4), (0, 2, 4), (0, 4, 5), (0, 5, 6)]
    map_ = mapped(points, triangles, [0, 4, 5, 6], 4 * np.array(SQUARE))
    assert sorted(map(sorted, map_.split_edges.tolist())) == [[0, 2], [0, 4], [2, 4]]
    assert np.array_equal(map_.disc.points[:7], points)
    assert np.array_equal(map_.disc.points[7:], np.array(points)[map_.split_edges].mean(axis=1))
    assert all(exact_area(*map_.places[each]) > 0 for each in map_.disc.triangles)


def test_borders_go_by_chord_length():
    points, triangles, corners = grid(6, 4, np.random.default_rng(SEED))
    points[:7, 0] = points[:7, 0] ** 2
    places = mapped(points, triangles, corners, KITE).places
    a, b = np.array(KITE[0]), np.array(KITE[1])
    assert np.abs(places[:7] - (a + points[:7, :1] * (b - a))).max() < 1e-15


def test_points_are_renumbered_and_moved_without_a_change():
    random = np.random.default_rng(SEED)
    points, triangles, corners = random_disc(random, 14, 30)
    polygon = hn.polygon_on_circle(np.ones(len(corners)))
    places = mapped(points, triangles, corners, polygon).places
    order = random.permutation(len(points))
    number = np.argsort(order)
    again = mapped(
        3 * points[order] + (7, 8, 9), number[triangles], number[np.array(corners)], polygon
    )
    assert np.abs(again.places[number[: len(points)]] - places[: len(points)]).max() < 1e-12


def test_discs_find_their_places():
    random = np.random.default_rng(SEED)
    points, triangles, corners = random_disc(random, 12, 60)
    map_ = mapped(points, triangles, corners, hn.polygon_on_circle(np.ones(len(corners))))
    search = hn.PlaceSearch(map_)
    weights = random.dirichlet((1, 1, 1), 500)
    inside = random.integers(0, len(map_.disc.triangles), 500)
    places = map_.places_at(inside, weights)
    found, with_ = search.find(places)
    clear = weights.min(axis=1) > 1e-6
    assert np.array_equal(found[clear], inside[clear])
    assert (with_ >= 0).all()
    assert np.abs(map_.places_at(found, with_) - places).max() < 1e-14
    assert np.abs(map_.positions_at(found, with_) - map_.positions_at(inside, weights)).max() < 1e-9
    # Points themselves: the triangle of least number that has them, and no other corner's weight.
    found, with_ = search.find(map_.places)
    for point, (triangle, shares) in enumerate(zip(found, with_)):
        at = np.flatnonzero((map_.disc.triangles == point).any(axis=1))
        assert triangle == at.min()
        assert np.array_equal(shares, map_.disc.triangles[triangle] == point)


def test_edges_are_found_exactly():
    """On spokes whose places are on them to the last bit: the triangle of least number of the two,
    and no weight of the third corner."""
    map_ = star((0, 0), (0.5, 0), (1, 0), (1, 0.5), (1, 1), (0.5, 1), (0, 1), (0, 0.5))
    search = hn.PlaceSearch(map_)
    for spoke in range(8):
        found, weights = search.find([0.25 * map_.places[spoke] + 0.75 * map_.places[8]])
        assert found[0] == min(spoke, (spoke - 1) % 8)
        corners = map_.disc.triangles[found[0]]
        assert np.array_equal(weights[0], np.select([corners == spoke, corners == 8], [0.25, 0.75]))
    found, weights = search.find([(1 + 1e-14, 0.3)])
    assert np.abs(map_.places_at(found, weights) - [(1, 0.3)]).max() < 1e-15
    with pytest.raises(ValueError, match=r"\(1.1, 0.3\) is outside of the polygon"):
        search.find([(0.5, 0.5), (1.1, 0.3)])


def square(**changes):
    points, triangles, corners = grid(2, 2)
    return {
        "points": points,
        "triangles": triangles,
        "corners": corners,
        "polygon": SQUARE,
    } | changes


NINE = grid(2, 2)[0]
CELLS = grid(2, 2)[1]
TWO_PARTS = {
    "points": np.vstack([NINE, NINE]) + np.arange(18)[:, None],
    "triangles": np.vstack([CELLS, CELLS + 9]),
}
HOLE = {
    "points": grid(3, 3)[0],
    "triangles": [corners for corners in grid(3, 3)[1] if not set(corners) <= {5, 6, 9, 10}],
}
TETRAHEDRON = {
    "points": np.eye(4)[:, :3],
    "triangles": [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)],
}
TURNED = [corners[::-1] if k == 3 else corners for k, corners in enumerate(CELLS.tolist())]


@pytest.mark.parametrize(
    "words, changes",
    [
        ("Edge 0–1 has no length", {"points": NINE * (0, 1, 1)}),
        ("Point 9 belongs to no triangle", {"points": np.vstack([NINE, [(5, 5, 5)]])}),
        ("is not joined with triangle 0", TWO_PARTS),
        ("more than one border", HOLE),
        ("have no border", TETRAHEDRON),
        ("same direction", {"triangles": TURNED}),
        ("names point 99", {"triangles": [(0, 1, 99)]}),
        ("has no faces", {"triangles": np.empty((0, 3), dtype=int)}),
        ("Corner 1, point 4, is not on the border", {"corners": [0, 4, 8, 6]}),
        ("Corner 2, point 2, comes too late", {"corners": [0, 8, 2, 6]}),
        ("Corner 3, point 0, comes too late", {"corners": [0, 2, 8, 0]}),
        ("2 corners: name three", {"corners": [0, 2]}),
        ("3 corners, the polygon 4", {"corners": [0, 2, 8]}),
        ("to the left at corner 2", {"polygon": [(0, 0), (1, 0), (0.2, 0.2), (0, 1)]}),
        ("to the left at corner 1", {"polygon": [(0, 0), (0.5, 0), (1, 0), (0, 1)]}),
        ("does not turn to the left", {"polygon": SQUARE[::-1]}),
        ("is no place", {"polygon": [(0, 0), (1, 0), (np.nan, 1), (0, 1)]}),
        ("must have shape", {"polygon": [(0, 0, 0), (1, 0, 0), (1, 1, 0)]}),
        ("not 'tutte'", {"weights": "tutte"}),
    ],
)
def test_what_is_no_disc_is_refused(words, changes):
    with pytest.raises(ValueError, match=words):
        mapped(**square(**changes))


def test_polygons_that_go_round_twice_are_refused():
    corners = [(np.cos(angle), np.sin(angle)) for angle in 4 * np.pi * np.arange(5) / 5]
    disc = hn.TriangleDisc(*grid(2, 2)[:2])
    with pytest.raises(ValueError, match="more than once"):
        hn.DiscMap(disc, [0, 2, 5, 8, 6], corners)


def test_short_border_edges_are_refused():
    points, triangles, corners = grid(4, 2)
    points[1, 0] = 1e-9
    with pytest.raises(ValueError, match="Border edge 0–1 has less than 1e-8"):
        mapped(points, triangles, corners, SQUARE)


def test_mean_values_refuse_triangles_without_area():
    """A point in the middle of the edge between two of its neighbours."""
    points, triangles, corners = grid(4, 4)
    points[12] = 0.5 * (points[6] + points[7])
    with pytest.raises(ValueError, match="The triangle of points 12, 6 and 7 has no area"):
        mapped(points, triangles, corners, SQUARE, weights="mean_value")


def test_polygons_on_circles():
    polygon = hn.polygon_on_circle([1, 2, 3])
    angles = np.degrees(np.arctan2(polygon[:, 1], polygon[:, 0])) % 360
    assert np.abs(angles - [0, 60, 180]).max() < 1e-12
    with pytest.raises(ValueError, match="Side 1 of the polygon must have a length"):
        hn.polygon_on_circle([1, 0, 3])
    points, triangles, corners = grid(4, 2)
    points[:, 0] *= 3
    assert np.allclose(hn.TriangleDisc(points, triangles).side_lengths(corners), [3, 1, 3, 1])
