# SPDX-License-Identifier: GPL-3.0-or-later
"""Half hulls of the samples as triangles, and merged pairs of them."""

from functools import lru_cache
from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest
from morphing_checks import check_all
from morphing_discs import volume

ROOT = Path(__file__).resolve().parents[2]
# Those whose transom is part of the shell: their border turns by more than 60 degrees at the stem
# head and at the three corners of the transom, and nowhere else.
NAMES = ("bulk_carrier", "container_ship", "coaster", "naval_vessel", "research_vessel", "roro",
         "planing_boat")  # fmt: skip


@lru_cache(None)
def half_hull(name, divisions=2):
    shell = hull_io.shell_arrays(hull_io.read_hull(ROOT / "samples" / f"{name}.hull.json"))
    surface = hn.LimitSurface(hn.ControlMesh(*shell.arguments()))
    facets = surface.tessellate(n=divisions)
    quads = facets.quads
    return facets.points, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def corners_of(disc):
    """From the stem head along the border."""
    border = disc.points[disc.border]
    edges = np.roll(border, -1, axis=0) - border
    directions = edges / np.linalg.norm(edges, axis=1)[:, None]
    turns = np.einsum("ij,ij->i", directions, np.roll(directions, 1, axis=0))
    corners = disc.border[turns < np.cos(np.radians(60))]
    assert len(corners) == 4
    return np.roll(corners, -np.argmax(disc.points[corners, 0]))


def maps_of(*shapes, **options):
    discs = [hn.TriangleDisc(*shape) for shape in shapes]
    corners = [corners_of(disc) for disc in discs]
    lengths = [disc.side_lengths(named) for disc, named in zip(discs, corners)]
    polygon = hn.polygon_on_circle(sum(each / each.sum() for each in lengths))
    return [hn.DiscMap(*each, polygon, **options) for each in zip(discs, corners)]


@pytest.mark.parametrize("names", [*zip(NAMES[::2], NAMES[1::2]), NAMES[-2:]], ids="-".join)
def test_pairs_of_samples(names):
    maps = maps_of(*(half_hull(name) for name in names))
    merged = check_all(maps, exact=False)
    volumes = [volume(merged.points(t), merged.triangles) for t in (0, 0.5, 1)]
    assert volumes[0] > 0 and volumes[1] > 0 and volumes[2] > 0
    # The corners correspond, all the way.
    for corners in zip(*(map_.corners for map_ in maps)):
        at = np.flatnonzero((merged.origins == corners).all(axis=1))
        ends = [map_.disc.points[corner] for map_, corner in zip(maps, corners)]
        assert np.array_equal(merged.points(0.25)[at[0]], 0.75 * ends[0] + 0.25 * ends[1])


def test_thin_triangles_have_area():
    """By fractions, those that rounded places leave in doubt."""
    check_all(maps_of(half_hull("bulk_carrier", 1), half_hull("coaster", 1)), exact="thin")


def test_mean_values_do_as_well():
    names = ("container_ship", "bulk_carrier")
    check_all(maps_of(*(half_hull(name) for name in names), weights="mean_value"), exact=False)


def test_half_hulls_stay_half_hulls():
    """Borders in the centre plane stay there, transom corners and all."""
    first, second = maps_of(half_hull("naval_vessel"), half_hull("roro"))
    merged = hn.MergedDiscs(first, second)
    middle = merged.points(0.5)
    flat = [np.abs(p[:, 1]) < 1e-9 for p in (merged.first_points, merged.second_points)]
    both = flat[0] & flat[1]
    assert both.sum() > 100
    assert np.abs(middle[both, 1]).max() < 1e-9


def test_stl_parents(tmp_path):
    """A family of files: written, read, merged, and its members written and read again."""
    shapes = []
    for name in ("container_ship", "bulk_carrier"):
        hull_io.write_stl(tmp_path / f"{name}.stl", *half_hull(name))
        shapes.append(hull_io.read_stl(tmp_path / f"{name}.stl"))
    merged = check_all(maps_of(*shapes), exact=False)
    exact = hn.MergedDiscs(*maps_of(half_hull("container_ship"), half_hull("bulk_carrier")))
    assert volume(merged.points(0.5), merged.triangles) == pytest.approx(
        volume(exact.points(0.5), exact.triangles), rel=1e-6
    )
    hull_io.write_stl(tmp_path / "between.stl", merged.points(0.5), merged.triangles)
    points, triangles = hull_io.read_stl(tmp_path / "between.stl")
    assert volume(points, triangles) == pytest.approx(
        volume(merged.points(0.5), merged.triangles), rel=1e-6
    )


def test_no_part_turns_against_both_parents():
    """Of the paper's pair in kind."""
    first, second = maps_of(half_hull("container_ship"), half_hull("bulk_carrier"))
    merged = hn.MergedDiscs(first, second)

    def area_vectors(points):
        a, b, c = points[merged.triangles].transpose(1, 0, 2)
        return np.cross(b - a, c - a)

    ends = [area_vectors(points) for points in (merged.first_points, merged.second_points)]
    for t in (0.25, 0.5, 0.75):
        between = area_vectors(merged.points(t))
        with_ends = [np.einsum("ij,ij->i", between, end) for end in ends]
        assert not ((with_ends[0] < 0) & (with_ends[1] < 0)).any()
