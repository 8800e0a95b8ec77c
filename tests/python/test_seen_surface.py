# SPDX-License-Identifier: GPL-3.0-or-later
"""What the pictures of patches show: the nearest surface at each dot, without holes."""

import hull_native as hn
import numpy as np
import pytest
from figures import seen_surface

CORNERS = [(x, y, z) for x in (0, 2) for y in (-1, 1) for z in (0, 1)]
FACES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
TRIANGLES = np.array(CORNERS, float)[[[f[0], f[i], f[i + 1]] for f in FACES for i in (1, 2)]]


@pytest.fixture(scope="module")
def box():
    """2 x 2 x 1 m, its edges creases."""
    edges = [(a, a | bit) for a in range(8) for bit in (1, 2, 4) if not a & bit]
    mesh = hn.ControlMesh(np.array(CORNERS, float), [4] * 6, np.ravel(FACES), creases=edges)
    return hn.LimitSurface(mesh)


def view(window=(-3.0, 3.0, -3.0, 3.0), width=150):
    return seen_surface.View(40.0, 25.0, window, width)


def shown_by(see, *arguments, **named):
    seen = seen_surface.Seen(view(**named))
    see(seen, *arguments)
    return seen


def entries(seen):
    """Where the eye's ray through each dot's middle enters the box; NaN where it misses."""
    v = seen.view
    row, column = np.divmod(np.arange(v.width * v.height), v.width)
    x = v.window[0] + (column + 0.5) / v.dots_per_metre
    y = v.window[3] - (row + 0.5) / v.dots_per_metre
    starts = x[:, None] * v.right + y[:, None] * v.up + 10.0 * v.eye
    low, high = np.array([0.0, -1.0, 0.0]), np.array([2.0, 1.0, 1.0])
    ends = np.stack([(low - starts) / -v.eye, (high - starts) / -v.eye])
    enter, leave = ends.min(axis=0).max(axis=1), ends.max(axis=0).min(axis=1)
    points = starts - enter[:, None] * v.eye
    points[enter > leave] = np.nan
    return points


@pytest.mark.parametrize("kind", ["surface", "patches", "triangles"])
@pytest.mark.parametrize("window", [(-3.0, 3.0, -3.0, 3.0), (-0.5, 0.3, 0.2, 1.0)])
def test_each_dot_shows_what_a_ray_meets_first(box, kind, window):
    sees = {
        "surface": (seen_surface.see_surface, box),
        "patches": (seen_surface.see_patches, hn.exact_patches(box)),
        "triangles": (seen_surface.see_triangles, TRIANGLES),
    }
    seen = shown_by(*sees[kind], window=window)
    met = entries(seen)
    there, wanted = np.isfinite(seen.depth), np.isfinite(met[:, 0])
    # But for dots that the outline goes through.
    assert (there != wanted).mean() < 0.02
    both = there & wanted
    assert both.sum() > 1000
    apart = np.linalg.norm(seen.points[both] - met[both], axis=1)
    assert np.percentile(apart, 97) < 3.0 / seen.view.dots_per_metre
    np.testing.assert_allclose(np.linalg.norm(seen.normals[both], axis=1), 1.0, atol=1e-12)
    assert np.abs(seen.normals[both]).max(axis=1).min() > 0.999


def test_borders_behind_are_not_seen(box):
    seen = shown_by(seen_surface.see_surface, box)
    corners = np.array([[2.0, 1.0, 1.0], [0.0, -1.0, 0.0]])
    assert seen.is_seen(corners, 0.1).tolist() == [True, False]


def test_distances_are_from_the_surface(box):
    seen = shown_by(seen_surface.see_triangles, TRIANGLES + [0.0, 0.0, 0.01])
    apart = seen_surface.distances(seen.points, box)
    on_top = np.isfinite(apart) & (seen.normals[:, 2] > 0.9)
    np.testing.assert_allclose(apart[on_top], 0.01, atol=1e-12)
