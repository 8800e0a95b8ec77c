# SPDX-License-Identifier: GPL-3.0-or-later
"""Bilges nearest to a circle: measured on sections of real surfaces, and compared with others."""

import hull_native as hn
import numpy as np
import pytest

SEED = 4112026


def midbody(arc, angle):
    """A half hull of equal sections: centre line, border, bilge, border, deck; borders creases."""
    along = np.array([np.cos(angle), np.sin(angle)])
    touch = np.array([np.sin(angle), -np.cos(angle)])
    section = np.concatenate([[(-1.5, -1.0)], arc, [touch + 1.5 * along]])
    return extruded(section, (1, len(section) - 2))


def extruded(section, creased, stations=6):
    """(LimitSurface, x amidships) of equal sections (k, 2); creases run along points of these."""
    k = len(section)
    x = np.arange(stations) * 2.0
    points = np.concatenate([np.column_stack([np.full(k, at), section]) for at in x])
    faces, creases = [], []
    for i in range(stations - 1):
        for j in range(k - 1):
            a = i * k + j
            faces.append((a, a + 1, a + k + 1, a + k))
        creases += [(i * k + j, i * k + k + j) for j in creased]
    mesh = hn.ControlMesh(points, [4] * len(faces), np.ravel(faces), creases=creases)
    return hn.LimitSurface(mesh), x[2]


def deviation(points, angle):
    """Of points (k, 2) from the bottom line, the circle and the side line."""
    inside = np.hypot(*points.T) - 1
    bottom = -points[:, 1] - 1
    outwards = np.array([np.sin(angle), -np.cos(angle)])
    side = points @ outwards - 1
    turn = np.arctan2(points[:, 0], -points[:, 1])
    return np.where(turn < 0, bottom, np.where(turn > angle, side, inside))


def spline_matrix(count, samples=100):
    """Points of the clamped spline with reflected ends from count + 2 control points."""
    size = count + 2
    unit = np.eye(size)
    wide = np.vstack([2 * unit[0] - unit[1], unit, 2 * unit[-1] - unit[-2]])
    rows = []
    for span in range(size - 1):
        for t in np.arange(samples + 1) / samples:
            s = 1 - t
            weights = (s**3, 4 - 6 * t**2 + 3 * t**3, 4 - 6 * s**2 + 3 * s**3, t**3)
            rows.append(np.array(weights) / 6 @ wide[span : span + 4])
    return np.array(rows)


# What the user's page says: largest deviation in per cent of the radius.
STATED = {4: (0.0843, 0.0310), 5: (0.0345, 0.0143), 6: (0.0166, 0.0075)}


@pytest.mark.parametrize("count", [4, 5, 6])
@pytest.mark.parametrize("move_borders", [False, True])
def test_a_section_of_the_surface_deviates_as_stated(count, move_borders):
    arc = hn.bilge_arc(count, move_borders=move_borders)
    assert 100 * arc.deviation == pytest.approx(STATED[count][move_borders], abs=6e-5)
    surface, x = midbody(arc.points, np.pi / 2)
    (curve,) = hn.sections(surface, [hn.plane_across("x", x)], 1e-7)[0]
    found = np.abs(deviation(curve.points[:, 1:], np.pi / 2)).max()
    assert found == pytest.approx(arc.deviation, rel=2e-3)
    assert curve.curvatures.max() == pytest.approx(arc.greatest_curvature, rel=1e-2)


@pytest.mark.parametrize("count", [3, 4, 5, 6, 8])
@pytest.mark.parametrize("degrees", [20, 75, 90, 130])
@pytest.mark.parametrize("move_borders", [False, True])
def test_nothing_near_by_is_nearer_to_the_circle(count, degrees, move_borders):
    angle = np.radians(degrees)
    arc = hn.bilge_arc(count, angle, move_borders=move_borders)
    matrix = spline_matrix(count)
    worst = np.abs(deviation(matrix @ arc.points, angle)).max()
    assert worst == pytest.approx(arc.deviation, rel=2e-3)
    random = np.random.default_rng(SEED + count)
    side = np.array([np.cos(angle), np.sin(angle)])
    for scale in np.repeat(np.geomspace(1e-5, 0.1, 9), 60):
        moved = arc.points.copy()
        moved[2:-2] += random.normal(0, scale, moved[2:-2].shape)
        moved[1, 0] += random.normal(0, scale)
        moved[-2] += random.normal(0, scale) * side
        if move_borders:
            moved[0, 0] += random.normal(0, scale)
            moved[-1] += random.normal(0, scale) * side
        assert np.abs(deviation(matrix @ moved, angle)).max() > worst * (1 - 2e-3)


@pytest.mark.parametrize("count", [3, 4, 5])
@pytest.mark.parametrize("outer_bottom, outer_side", [(0.2, 0.2), (1.0, 0.5), (0.3, 1.2)])
def test_smooth_borders_with_control_points_beyond_them(count, outer_bottom, outer_side):
    arc = hn.bilge_arc(count, outer_bottom=outer_bottom, outer_side=outer_side)
    beyond = [(-outer_bottom - 1.0, -1.0), (-outer_bottom, -1.0)]
    above = [(1.0, outer_side), (1.0, outer_side + 1.0)]
    surface, x = extruded(np.concatenate([beyond, arc.points, above]), ())
    (curve,) = hn.sections(surface, [hn.plane_across("x", x)], 1e-7)[0]
    found = np.abs(deviation(curve.points[:, 1:], np.pi / 2)).max()
    assert found == pytest.approx(arc.deviation, rel=2e-3)
    assert found < 2e-3


def test_control_points_far_away_are_refused():
    with pytest.raises(ValueError, match="too far away"):
        hn.bilge_arc(6, outer_bottom=5.0, outer_side=5.0)
    with pytest.raises(ValueError, match="too short"):
        hn.bilge_arc(4, outer_bottom=0.01)


def test_more_points_are_nearer_and_borders_apart_too():
    by_count = [hn.bilge_arc(count).deviation for count in range(3, 9)]
    assert (np.diff(by_count) < 0).all()
    for count in range(3, 9):
        assert hn.bilge_arc(count, move_borders=True).deviation < 0.6 * by_count[count - 3]


def test_the_points_lie_in_the_flats_and_are_their_own_mirror_image():
    angle = np.radians(70)
    arc = hn.bilge_arc(5, angle)
    np.testing.assert_allclose(arc.points[0], (0, -1), atol=1e-15)
    assert arc.points[1, 1] == -1
    outwards = np.array([np.sin(angle), -np.cos(angle)])
    np.testing.assert_allclose(arc.points[-2:] @ outwards, 1, atol=1e-14)
    axis = np.array([np.sin(angle / 2), -np.cos(angle / 2)])
    image = 2 * np.outer(arc.points @ axis, axis) - arc.points
    np.testing.assert_allclose(image[::-1], arc.points, atol=1e-14)


@pytest.mark.parametrize("count, angle", [(2, 1.5), (9, 1.5), (4, 0.1), (4, 3.1), (4, np.nan)])
def test_what_is_no_bilge_is_refused(count, angle):
    with pytest.raises(ValueError):
        hn.bilge_arc(count, angle)


@pytest.mark.parametrize("degrees, outer", [(90, 0.6), (160, 2.5), (170, 0.6), (170, 1.5)])
def test_the_side_is_the_image_of_the_bottom(degrees, outer):
    angle = np.radians(degrees)
    axis = np.array([np.sin(0.5 * angle), -np.cos(0.5 * angle)])
    below, beside = hn.bilge_arc(3, angle, outer_bottom=outer), hn.bilge_arc(
        3, angle, outer_side=outer
    )
    image = 2.0 * np.outer(beside.points @ axis, axis) - beside.points
    # Two searches, each to about 1e-3 of the deviation.
    assert beside.deviation == pytest.approx(below.deviation, rel=2e-3)
    np.testing.assert_allclose(image[::-1], below.points, atol=5.0 * below.deviation)
