# SPDX-License-Identifier: GPL-3.0-or-later
"""What conversion costs where many faces meet and where all faces are triangles."""

import time

import hull_native as hn
import numpy as np
import pytest


def surface_of(points, faces):
    return hn.LimitSurface(
        hn.ControlMesh(
            np.array(points, float),
            np.array([len(face) for face in faces]),
            np.concatenate(faces),
            np.zeros((0, 2), int),
            np.array([], int),
        )
    )


def fan(valence):
    """Triangles around one point, and two rings of quadrilaterals; heights moved at random."""
    angles = 2.0 * np.pi * np.arange(valence) / valence
    rings = [
        np.stack([r * np.cos(angles), r * np.sin(angles), -0.05 * r**2 + 0.0 * angles], axis=1)
        for r in (1, 2, 3)
    ]
    points = np.concatenate([[[0.0, 0.0, 0.3]], *rings])
    points[:, 2] += 0.05 * np.random.default_rng(1).standard_normal(len(points))
    after = np.roll(np.arange(valence), -1)
    faces = [[0, 1 + i, 1 + after[i]] for i in range(valence)]
    for ring in (1, 1 + valence):
        faces += [
            [ring + i, ring + valence + i, ring + valence + after[i], ring + after[i]]
            for i in range(valence)
        ]
    return surface_of(points, faces)


def time_per_control_point(valence):
    surface = fan(valence)
    patches = hn.exact_patches(surface)
    begin = time.process_time()
    report = hn.measure_quality(surface, patches)
    return (time.process_time() - begin) / report.control_point_count


@pytest.mark.parametrize("valence", [64, 100])
def test_many_faces_around_a_point_are_measured_as_fast_as_few(valence):
    few, many = time_per_control_point(8), time_per_control_point(valence)
    print(f"{1e6 * few:.2f} and {1e6 * many:.2f} µs a control point")
    assert many < 4.0 * few


def time_of_crumpled(width, seed=2):
    """Seconds that measuring takes of a sheet of triangles all along one line, to `width`."""
    count = 4
    corners = np.arange(count * count).reshape(count, count)
    faces = []
    for i in range(count - 1):
        for j in range(count - 1):
            a, b, c, d = corners[[i, i + 1, i + 1, i], [j, j, j + 1, j + 1]]
            faces += [[a, b, c], [a, c, d]]
    random = np.random.default_rng(seed)
    along = random.uniform(0.0, 3.0, count * count)
    points = np.outer(along, [1.0, -1.01, -0.38])
    points += width * random.standard_normal(points.shape)
    surface = surface_of(points, faces)
    patches = hn.fit_per_cell(surface)
    begin = time.process_time()
    hn.measure_quality(surface, patches)
    return time.process_time() - begin


def test_a_sheet_crumpled_to_a_line_ends():
    """Much of it is as near to a patch as the place that is known to be."""
    wide, thin = time_of_crumpled(5e-2), time_of_crumpled(2e-5)
    print(f"{wide:.3f} and {thin:.3f} s")
    assert thin < 80.0 * wide


@pytest.fixture(scope="module")
def triangles():
    """A bulging sheet of 512 triangles, and its patches."""
    count = 16
    u, v = np.meshgrid(np.arange(count + 1), np.arange(count + 1), indexing="ij")
    height = 0.02 * (u**2 + u * v - v**2) + 0.3 * np.sin(0.4 * u)
    points = np.stack([u, v, height], axis=-1).reshape(-1, 3)
    faces = []
    for i in range(count):
        for j in range(count):
            a, b = i * (count + 1) + j, (i + 1) * (count + 1) + j
            faces += [[a, b, b + 1], [a, b + 1, a + 1]]
    surface = surface_of(points, faces)
    return surface, hn.exact_patches(surface)


def test_patches_of_triangles_keep_what_is_promised(triangles):
    surface, patches = triangles
    report = hn.measure_quality(surface, patches)
    assert report.largest_distance_per_length <= 1e-6
    assert np.degrees(report.largest_seam_angle) <= 0.02
    assert report.largest_gap <= 1e-13 * report.length
