# SPDX-License-Identifier: GPL-3.0-or-later
"""Isophotes, outlines and reflection lines, against closed forms and mirrored rays."""

import hull_native as hn
import numpy as np
import pytest
from height_fields import SIDE, grid


def wavy():
    return hn.LimitSurface(grid(lambda x, y: 0.3 * np.sin(x) + 0.2 * np.cos(0.7 * y + x)))


def check_places(surface, curve):
    assert len(curve.points) == len(curve.cells) == len(curve.uv)
    positions = surface.positions(curve.cells, curve.uv)
    assert np.abs(positions - curve.points).max() < 1e-12
    if curve.closed:
        np.testing.assert_array_equal(curve.points[0], curve.points[-1])


def test_isophotes_of_a_bowl_are_ellipses():
    a, b = 0.1, 0.07
    surface = hn.LimitSurface(grid(lambda x, y: a * x * x + b * y * y))
    angles = np.radians([10, 15, 20])
    curves = hn.isophotes(surface, direction=(0, 0, 2), angles=angles, chord_tolerance=1e-4)
    assert [c.level for c in curves] == list(angles)
    for curve in curves:
        check_places(surface, curve)
        assert curve.closed
        x, y = curve.points[:, 0], curve.points[:, 1]
        np.testing.assert_allclose(4 * (a * a * x * x + b * b * y * y), np.tan(curve.level) ** 2)
        # n·d is greatest at the bottom, which lies on the left.
        turn = np.cross(curve.points[:-1, :2], curve.points[1:, :2])
        assert (turn > 0).all()
        # Between its points the ellipse is no further than the tolerance, but for a little.
        middle = 0.5 * (curve.points[1:, :2] + curve.points[:-1, :2])
        r = np.sqrt(4 * (a * a * middle[:, 0] ** 2 + b * b * middle[:, 1] ** 2))
        assert ((1 - r / np.tan(curve.level)) * np.linalg.norm(middle, axis=1)).max() < 2e-4


@pytest.mark.parametrize("divisions", [4, 8, 16])
def test_levels_are_exact_on_any_grid(divisions):
    surface = wavy()
    direction = np.array([0.2, -0.1, 0.8])
    angles = np.radians([10.0, 20, 25, 30])
    curves = hn.isophotes(surface, direction=direction, angles=angles, divisions=divisions)
    assert {c.level for c in curves} == set(angles)
    for curve in curves:
        check_places(surface, curve)
        cosine = surface.normals(curve.cells, curve.uv) @ direction / np.linalg.norm(direction)
        assert np.abs(cosine - np.cos(curve.level)).max() < 1e-10
        if not curve.closed:
            ends = np.abs(curve.points[[0, -1], :2]).max(axis=1)
            np.testing.assert_allclose(ends, SIDE / 2, atol=1e-12)
    # All of them: as many crossings of lines across the sheet as the normals change sides.
    t = np.linspace(-SIDE / 2, SIDE / 2, 4001)
    tree = hn.SurfaceTree(surface)
    for y in (-2.3, 0.41, 3.1):
        at = tree.ray_hits(
            np.stack([t, 0 * t + y, 0 * t + 9], axis=1), np.tile([0.0, 0, -1], (4001, 1))
        )
        cosine = surface.normals(at.cells, at.uv) @ direction / np.linalg.norm(direction)
        for angle in angles:
            side = cosine > np.cos(angle)
            expected = (side[1:] != side[:-1]).sum()
            found = 0
            for curve in curves:
                if curve.level == angle:
                    left = curve.points[:, 1] > y
                    found += (left[1:] != left[:-1]).sum()
            assert found == expected


def test_isophotes_turn_with_the_surface():
    mesh = grid(lambda x, y: 0.3 * np.sin(x) + 0.2 * np.cos(0.7 * y + x))
    q, _ = np.linalg.qr(np.random.default_rng(7).normal(size=(3, 3)))
    q *= np.sign(np.linalg.det(q))
    other = hn.ControlMesh(mesh.points @ q.T, mesh.face_sizes, mesh.face_vertices)
    direction = np.array([0.2, -0.1, 0.8])
    before = hn.isophotes(hn.LimitSurface(mesh), direction=direction, angles=[0.3])
    after = hn.isophotes(hn.LimitSurface(other), direction=q @ direction, angles=[0.3])
    assert len(before) == len(after)
    for one, two in zip(before, after):
        np.testing.assert_allclose(one.points @ q.T, two.points, atol=1e-9)


def test_outlines_of_a_dome():
    c = 0.3
    surface = hn.LimitSurface(grid(lambda x, y: -c * (x * x + y * y)))
    (curve,) = hn.silhouette(surface, eye_direction=(1, 0, 1))
    check_places(surface, curve)
    inner = np.abs(curve.points[:, 1]) < SIDE / 2 - 1
    np.testing.assert_allclose(curve.points[inner, 0], -1 / (2 * c), atol=1e-12)
    eye = np.array([1.0, 2.0, 3.0])
    found = 0
    for curve in hn.silhouette(surface, eye=eye):
        check_places(surface, curve)
        x, y, z = curve.points[np.abs(curve.points[:, :2]).max(axis=1) < SIDE / 2 - 1].T
        found += len(x)
        np.testing.assert_allclose(
            2 * c * x * (eye[0] - x) + 2 * c * y * (eye[1] - y) + eye[2] - z, 0, atol=1e-10
        )
    assert found > 10


def test_outline_along_a_crease():
    """Two slopes that meet in a ridge."""
    n = SIDE + 1
    ridge = [(j * n + SIDE // 2, (j + 1) * n + SIDE // 2) for j in range(SIDE)]
    surface = hn.LimitSurface(grid(lambda x, y: -0.5 * np.abs(x), creases=ridge))
    (curve,) = hn.silhouette(surface, eye_direction=(1, 0, 0))
    np.testing.assert_allclose(curve.points[:, 0], 0, atol=1e-13)
    np.testing.assert_allclose(np.sort(curve.points[[0, -1], 1]), [-SIDE / 2, SIDE / 2])
    assert hn.silhouette(surface, eye_direction=(0, 0, 1)) == []


def mirrored(surface, curve, eye):
    """Rays from the eye as the surface sends them on."""
    normals = surface.normals(curve.cells, curve.uv)
    return 2 * (normals * eye).sum(axis=1)[:, None] * normals - eye


def test_reflected_rays_meet_the_lines():
    surface = wavy()
    line = np.array([1.0, 0.2, 0.0]) / np.hypot(1.0, 0.2)
    light = np.array([0.0, 0.3, 1.0])
    up = light - light @ line * line
    up /= np.linalg.norm(up)
    across = np.cross(line, up)
    eye = np.array([0.1, -0.4, 0.9]) / np.linalg.norm([0.1, -0.4, 0.9])
    curves = hn.reflection_lines(
        surface,
        line_direction=3 * line,
        light_direction=light,
        spacing=1.5,
        distance=10.0,
        phase=0.25,
        eye_direction=eye,
    )
    assert len(curves) > 5
    for curve in curves:
        check_places(surface, curve)
        rays = mirrored(surface, curve, eye)
        t = (10 - curve.points @ up) / (rays @ up)
        hits = curve.points + t[:, None] * rays
        np.testing.assert_allclose(hits @ up, 10, atol=1e-9)
        np.testing.assert_allclose(hits @ across, 1.5 * (curve.level + 0.25), atol=1e-8)
    far = hn.reflection_lines(
        surface, line_direction=line, light_direction=light, spacing=0.1, eye_direction=eye
    )
    assert len(far) > 5
    for curve in far:
        rays = mirrored(surface, curve, eye)
        np.testing.assert_allclose(
            np.arctan2(rays @ across, rays @ up), 0.1 * curve.level, atol=1e-9
        )


def test_a_flat_mirror_shows_straight_lines():
    surface = hn.LimitSurface(grid(lambda x, y: 0 * x))
    eye = np.array([0.0, 0.6, 0.8])
    curves = hn.reflection_lines(
        surface,
        line_direction=(1, 0, 0),
        light_direction=(0, 0, 1),
        spacing=1.0,
        distance=4.0,
        eye_direction=eye,
    )
    assert len(curves) in (8, 9)  # one may be on the border
    for curve in curves:
        assert np.ptp(curve.points[:, 1]) < 1e-12 and abs(np.ptp(curve.points[:, 0]) - 8) < 1e-12
    perspective = hn.reflection_lines(
        surface,
        line_direction=(1, 0, 0),
        light_direction=(0, 0, 1),
        spacing=1.0,
        distance=4.0,
        eye=(0, 0.1, 4),
    )
    # From an eye among the lights a line is seen half way between it and the eye's place.
    np.testing.assert_allclose(
        sorted(c.points[0, 1] for c in perspective), (np.arange(-8, 8) + 0.1) / 2, atol=1e-9
    )


def test_stripes_of_the_field_are_where_the_lines_are():
    surface = wavy()
    tess = surface.tessellate(8)
    light = dict(
        line_direction=(1, 0, 0), light_direction=(0, 0, 1), spacing=0.1, eye_direction=(0, -1, 2)
    )
    field = hn.reflection_field(tess, **light)
    at = surface.positions(tess.normal_cells, tess.normal_uv)
    normals = tess.normals
    eye = np.array([0, -1, 2]) / np.sqrt(5)
    rays = 2 * (normals @ eye)[:, None] * normals - eye
    angle = np.arctan2(rays @ np.cross([1, 0, 0], [0, 0, 1]), rays[:, 2])
    np.testing.assert_allclose(field, angle / 0.1, atol=1e-9)
    tree = {tuple(np.round(p, 9)): f for p, f in zip(at, field)}
    assert len(tree) == len(at)


def test_no_lines_beside_the_jump_of_angles():
    """A full turn of the mirrored ray, over a bump that faces all ways, has every line once or in
    pairs, and none along the line where the angle jumps from pi to -pi."""
    angle = 2 * np.pi * np.arange(16) / 16
    points = np.concatenate(
        [np.stack([np.cos(angle), np.sin(angle), 0 * angle + z], axis=1) for z in np.arange(5.0)]
    )
    k = np.arange(16)
    faces = np.concatenate(
        [
            np.stack(
                [j * 16 + k, j * 16 + (k + 1) % 16, j * 16 + 16 + (k + 1) % 16, j * 16 + 16 + k], 1
            )
            for j in range(4)
        ]
    )
    surface = hn.LimitSurface(hn.ControlMesh(points, np.full(64, 4), faces.ravel()))
    spacing = 2 * np.pi / 9
    curves = hn.reflection_lines(
        surface,
        line_direction=(0, 0, 1),
        light_direction=(1, 0, 0),
        spacing=spacing,
        eye_direction=(1, 0, 0),
        lines=9,
    )
    # The ray turns twice as fast as the normal: each of nine lines is seen twice.
    assert sorted(c.level for c in curves) == sorted(2 * list(range(-4, 5)))
    for curve in curves:
        phi = np.arctan2(curve.points[:, 1], curve.points[:, 0])
        assert abs(np.ptp(curve.points[:, 2]) - 4) < 1e-9 and np.ptp(phi) < 1e-6


@pytest.mark.parametrize(
    "changes, message",
    [
        ({"eye_direction": None}, "eye_direction"),
        ({"eye": (0, 0, 1)}, "either"),
        ({"eye_direction": (0, 0, 0)}, "zero"),
        ({"light_direction": (2, 0, 0)}, "across"),
        ({"spacing": 0.0}, "above zero"),
        ({"distance": -1.0}, "above zero"),
        ({"lines": -1}, "0 to 2000"),
        ({"divisions": 0}, "1 to 64"),
        ({"chord_tolerance": 0.0}, "positive"),
        ({"phase": float("inf")}, "finite"),
    ],
)
def test_banks_out_of_range(changes, message):
    options = dict(
        line_direction=(1, 0, 0), light_direction=(0, 0, 1), spacing=0.1, eye_direction=(0, 0, 1)
    )
    with pytest.raises(ValueError, match=message):
        hn.reflection_lines(wavy(), **{**options, **changes})


def test_isophotes_out_of_range():
    with pytest.raises(ValueError, match="between 0 and pi"):
        hn.isophotes(wavy(), direction=(0, 0, 1), angles=[4.0])
    with pytest.raises(ValueError, match="direction"):
        hn.isophotes(wavy(), direction=(0, 0, 0), angles=[1.0])


def test_lines_end_where_the_reflection_is_along_the_light():
    """A crumpled mesh whose normals turn so fast that this comes between two points of the grid."""
    points = [(-82, 4, 5), (-2, 4, 5), (-2, 5, 6), (-2, 5, 7), (-2, 5, 8), (4, 6, 7), (4, 6, 8),
              (-2, 4, 8)]  # fmt: skip
    faces = [3, 4, 6, 5, 0, 7, 4, 1, 1, 4, 3, 2]
    creases = np.array([(1, 2), (3, 4), (0, 1)])
    mesh = hn.ControlMesh(np.array(points, dtype=float), [4, 4, 4], faces, creases)
    surface = hn.LimitSurface(mesh)
    curves = hn.reflection_lines(
        surface,
        line_direction=(1, 0, 0),
        light_direction=(0, 1, 0.5),
        eye_direction=(0, 1, 0),
        spacing=np.radians(5),
    )
    assert curves
    for curve in curves:
        assert np.isfinite(curve.points).all()
        check_places(surface, curve)
