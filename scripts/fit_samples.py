# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits a sample's control mesh to the published surface it was made after, and prints the points.

PYTHONPATH=build/dev/python:samples python3 scripts/fit_samples.py container_ship|bulk_carrier

It starts from the coordinates in samples/sources/NAME.py, so that after a change there (another
row, another draft of a section) the fit is run again and its points are put into the source.
"""

import argparse

import hull_native as hn
import numpy as np
import target_hulls
import vessels

COUNT = 60000
# Stiffness of the moves and thin-plate fairness, step by step.
STEPS = ((1e-3, 2e-5), (1e-4, 1e-5), (1e-5, 8e-6))
_IN_PLANE = 1e-6


def held(data):
    """Points and directions in which they stay: the centre plane, the bar, flats, deck, transom;
    and the sections of a parallel middle body, which have their points in common."""
    source_bar = np.min(data.points[data.points[:, 1] > _IN_PLANE, 1])
    low, high = data.points.min(axis=0), data.points.max(axis=0)
    planes = [(1, 0.0), (1, source_bar), (1, high[1]), (2, 0.0), (2, high[2]), (0, low[0])]
    points, normals = [], []
    for axis, place in planes:
        for point in np.flatnonzero(np.abs(data.points[:, axis] - place) < _IN_PLANE):
            points.append(point)
            normals.append(np.eye(3)[axis])
    for point in _parallel(data.points):
        points += [point, point]
        normals += [np.eye(3)[1], np.eye(3)[2]]
    return np.array(points), np.array(normals)


def _parallel(points):
    """The points that have y and z with another one in common."""
    _, which, counts = np.unique(
        points[:, 1:].round(6), axis=0, return_inverse=True, return_counts=True
    )
    return np.flatnonzero(counts[which.ravel()] > 1)


def twins(points):
    """Pairs of points with the same x and z: in the centre plane, and beside it in the bar."""
    middle = np.flatnonzero(np.abs(points[:, 1]) < _IN_PLANE)
    for a in middle:
        apart = np.linalg.norm(points[:, [0, 2]] - points[a, [0, 2]], axis=1)
        for b in np.flatnonzero((apart < _IN_PLANE) & (points[:, 1] > _IN_PLANE)):
            if points[b, 1] < 1.0:
                yield a, b


def targets(name, data):
    """Points of the target's port half below the deck, with weights: more at the ends."""
    points, normals = target_hulls.samples(target_hulls.triangles(name), COUNT)
    low, high = data.points.min(axis=0), data.points.max(axis=0)
    shell = (points[:, 1] >= 0.0) & (points[:, 2] < high[2] - 0.02)
    shell &= (points[:, 0] > low[0] + 0.02) & (np.abs(normals[:, 2]) < 1.0 + (points[:, 2] < 14.0))
    points = points[shell]
    weights = np.where(points[:, 2] < data.particulars.draft + 0.5, 1.0, 0.2)
    ends = (points[:, 0] < 45.0) | (points[:, 0] > high[0] - 41.0)
    return points, weights * np.where(ends, 4.0, 1.0)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("name", choices=target_hulls.FILES)
    name = parser.parse_args().name
    data = vessels.vessel(name).data
    points, weights = targets(name, data)
    held_points, held_normals = held(data)
    pairs = list(twins(data.points))
    for stiffness, fairness in STEPS:
        found = hn.fit_surface(
            vessels.surface_of(data),
            points,
            weights=weights,
            held_points=held_points,
            held_normals=held_normals,
            stiffness=stiffness,
            fairness=fairness,
            reach=3.0,
        )
        data.points = found.points.copy()
        for a, b in pairs:
            data.points[a, [0, 2]] = data.points[b, [0, 2]]
        print(f"RMS {1e3 * found.rms:.1f} mm, largest {found.largest:.3f} m")
    for point in np.round(data.points, 3).tolist():
        print(tuple(point))


if __name__ == "__main__":
    main()
