# SPDX-License-Identifier: GPL-3.0-or-later
"""What hull_native says to meshes that cannot be, and what it makes of odd ones that can."""

import hull_native as hn
import numpy as np
import pytest

POINTS = np.array([[x, y, 0.1 * x * y] for y in range(3) for x in range(3)], dtype=float)
FACES = [[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6], [4, 5, 8, 7]]


def arrays(faces, points=POINTS):
    return (
        points,
        np.array([len(face) for face in faces]),
        np.array([vertex for face in faces for vertex in face]),
    )


def with_point(index, position):
    points = POINTS.copy()
    points[index] = position
    return points


def fan(faces):
    """So many triangles around the last point."""
    angles = 2 * np.pi * np.arange(faces) / faces
    rim = np.stack([np.cos(angles), np.sin(angles), np.zeros(faces)], axis=1)
    corners = np.stack([np.arange(faces), np.roll(np.arange(faces), -1), np.full(faces, faces)], 1)
    return np.vstack([rim, np.zeros(3)]), np.full(faces, 3), corners.ravel()


def polygon(corners):
    angles = 2 * np.pi * np.arange(corners) / corners
    points = np.stack([np.cos(angles), np.sin(angles), np.zeros(corners)], axis=1)
    return points, np.array([corners]), np.arange(corners)


ERRORS = {
    "edge of three faces": (arrays(FACES + [[1, 4, 8]]), "Edge 1–4 belongs to more than two"),
    "repeated vertex": (arrays([[0, 1, 1, 3]]), "Face 0 has the same point twice"),
    "index too large": (arrays([[0, 1, 4, 9]]), "Face corner 3 names point 9"),
    "index below zero": (arrays([[0, 1, 4, -1]]), "Face corner 3 names point -1"),
    "two corners": (arrays(FACES + [[0, 1]]), "Face 4 has fewer than three corners"),
    "no corners": (arrays(FACES + [[]]), "Face 4 has fewer than three corners"),
    "million-gon": (polygon(10**6), "Face 0 has more than 128 corners"),
    "great fan": (fan(10**5), "Point 100000 has more than 128 faces"),
    "not a number": (arrays(FACES, with_point(4, [0, np.nan, 0])), "Point 4 has a coordinate"),
    "infinite": (arrays(FACES, with_point(4, [-np.inf, 0, 0])), "Point 4 has a coordinate"),
    "too far": (arrays(FACES, with_point(4, [0, 0, 1e300])), "Point 4 lies more than 1e9 m"),
    "face twice": (arrays(FACES + [FACES[0]]), "more than two faces"),
    "turned face": (arrays(FACES[:3] + [FACES[3][::-1]]), "in the same direction"),
    "bow-tie": (arrays([FACES[0], FACES[3]]), "Point 4 joins faces that share no edge"),
    "sizes that do not add up": (
        (POINTS, np.array([4, 4]), np.array(FACES).ravel()),
        "add up to 8, but there are 16",
    ),
    "size below zero": (
        (POINTS, np.array([4, -4]), np.array(FACES[0])),
        "Face 1 has fewer than three",
    ),
    "no size": (
        arrays(FACES, np.tile([1.0, 2.0, 3.0], (9, 1))),
        "has no size: all points of its faces lie at (1, 2, 3) m",
    ),
    "too small to have a size": (arrays(FACES, 1e-12 * POINTS), "has no size"),
    "no faces": ((POINTS, np.zeros(0, int), np.zeros(0, int)), "has no faces"),
}


@pytest.mark.parametrize("mesh, words", ERRORS.values(), ids=ERRORS.keys())
def test_broken_meshes_are_refused_by_name(mesh, words):
    problems = hn.check_mesh(*mesh)
    assert problems[0].severity == "error"
    assert words in problems[0].message
    with pytest.raises(ValueError) as refused:
        hn.ControlMesh(*mesh)
    assert str(refused.value) == problems[0].message


WARNINGS = {
    "isolated point": (
        arrays(FACES, np.vstack([POINTS, [9, 9, 9]])),
        "Point 9 belongs to no face",
    ),
    "face without area": (
        arrays(FACES, with_point([0, 1, 3, 4], [[0, 0, 0], [1, 0, 0], [0.2, 0, 0], [1.1, 0, 0]])),
        "Face 0 has no area",
    ),
}


@pytest.mark.parametrize("mesh, words", WARNINGS.values(), ids=WARNINGS.keys())
def test_odd_meshes_are_evaluated_with_a_warning(mesh, words):
    problems = hn.check_mesh(*mesh)
    assert [problem.severity for problem in problems] == ["warning"]
    assert words in problems[0].message
    surface = hn.LimitSurface(hn.ControlMesh(*mesh))
    cells = np.arange(surface.cell_count)
    centre = np.full((surface.cell_count, 2), 0.5)
    assert np.isfinite(surface.positions(cells, centre)).all()
    assert surface.positions(cells, centre).max() < 9
    # Zero where there is no tangent plane.
    lengths = np.linalg.norm(surface.normals(cells, centre), axis=1)
    assert np.all((np.abs(lengths - 1) < 1e-12) | (lengths == 0))


def test_moved_points_are_checked_too():
    surface = hn.LimitSurface(hn.ControlMesh(*arrays(FACES)))
    for wrong in (np.nan, np.inf, 1e300):
        with pytest.raises(ValueError, match="point 4"):
            surface.set_points(with_point(4, [0, wrong, 0]))
    with pytest.raises(ValueError, match="no size"):
        surface.set_points(0.0 * POINTS)
    with pytest.raises(ValueError, match="9 points, but 8"):
        surface.set_points(POINTS[:8])
    np.testing.assert_array_equal(surface.mesh.points, POINTS)
