# SPDX-License-Identifier: GPL-3.0-or-later
"""What follows a surface whose points move: shown points, and which sections can stay."""

import hull_native as hn
import numpy as np
import pytest


def grid_surface(columns=8, rows=4):
    """A sheet over [0, columns] x [0, rows] that bulges upwards; its border y = 0 stays."""
    points = [
        (i, j, np.sin(0.4 * i) * np.sin(0.5 * j))
        for j in range(rows + 1)
        for i in range(columns + 1)
    ]
    faces = [
        (a, a + 1, a + columns + 2, a + columns + 1)
        for j in range(rows)
        for a in range(j * (columns + 1), j * (columns + 1) + columns)
    ]
    mesh = hn.ControlMesh(np.array(points), [4] * len(faces), np.array(faces).reshape(-1))
    return hn.LimitSurface(mesh)


def moved_points(surface, index, by):
    points = surface.mesh.points.copy()
    points[index] += by
    return points


def test_shown_points_are_those_of_the_tessellation_and_their_images():
    surface = grid_surface()
    shown = hn.ShownPoints(surface, 3, mirrored=True, metres_per_unit=0.5)
    for step in range(3):
        surface.set_points(moved_points(surface, 20 + step, (0.1, 0.2, -0.3)))
        assert shown.update()
        points = surface.tessellate(3).points
        on_plane = np.abs(points[:, 1]) <= 1e-9 * surface.mesh.size
        points[on_plane, 1] = 0.0
        wanted = np.concatenate([points, points[~on_plane] * [1.0, -1.0, 1.0]]) / 0.5
        assert shown.coordinates.dtype == np.float32
        assert np.array_equal(shown.shared, on_plane)
        assert np.abs(shown.coordinates - wanted).max() < 2e-6
    assert surface.revision == 3


def test_the_view_of_coordinates_cannot_be_written_and_outlives_its_owner():
    shown = hn.ShownPoints(grid_surface(), 2, mirrored=False)
    view = shown.coordinates
    kept = view.copy()
    del shown
    assert np.array_equal(view, kept)
    with pytest.raises(ValueError, match="read-only"):
        view[0] = 0.0


def test_the_watch_tells_sections_that_stay():
    surface = grid_surface(30, 4)
    watch = hn.MoveWatch(surface)
    planes = np.array([(1.0, 0.0, 0.0, x) for x in np.linspace(0.0, 30.0, 31)])
    assert not watch.comes_near(planes, margin=0.0).any()
    surface.set_points(moved_points(surface, 31 + 10, (0.0, 0.0, 1.0)))
    watch.update()
    near = watch.comes_near(planes, margin=0.0)
    assert near[10] and not near[:7].any() and not near[14:].any()
    assert len(watch.cells) < surface.cell_count / 3
    assert watch.comes_near(planes, margin=100.0).all()
    for margin in (-1.0, float("nan")):
        with pytest.raises(ValueError, match="margin"):
            watch.comes_near(planes, margin=margin)
