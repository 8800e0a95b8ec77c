# SPDX-License-Identifier: GPL-3.0-or-later
"""The quality report of patches: its numbers, its text and its JSON."""

import json
import math
import re

import hull_native as hn
import numpy as np
import pytest


def pyramid(n):
    """A double pyramid: irregular points of valence n and 4, and 3 in the faces."""
    angles = 2.0 * np.pi * np.arange(n) / n
    ring = np.stack([3.0 * np.cos(angles), np.sin(angles), np.zeros(n)], axis=1)
    points = np.concatenate([ring, [[0, 0, 1], [0, 0, -1.2]]])
    after = (np.arange(n) + 1) % n
    faces = [(i, j, n) for i, j in zip(range(n), after)]
    faces += [(j, i, n + 1) for i, j in zip(range(n), after)]
    return hn.LimitSurface(hn.ControlMesh(points, np.full(2 * n, 3), np.concatenate(faces)))


@pytest.fixture(scope="module")
def surface():
    return pyramid(5)


@pytest.fixture(scope="module")
def report(surface):
    return hn.measure_quality(surface, hn.fit_per_cell(surface))


def test_values_belong_together(surface, report):
    assert report.length == pytest.approx(np.ptp(surface.mesh.points[:, 0]), rel=1e-15)
    assert report.normal_reach == pytest.approx(1e-6 * report.length)
    assert report.largest_distance_per_length == report.largest_distance / report.length
    assert 0.0 < report.rms_distance < report.largest_distance
    assert 0.0 <= report.exact_share < 1.0
    assert report.patch_count == surface.cell_count == len(report.patches)
    assert report.control_point_count == 25 * surface.cell_count
    assert len(report.seams) == 2 * surface.cell_count  # closed
    for patches, whole in (("largest_distance", report.patches), ("largest_gap", report.seams)):
        assert max(part[patches] for part in whole) == getattr(report, patches)
    for name in ("largest_seam_angle", "largest_curvature_jump"):
        assert max(seam[name] for seam in report.seams) == getattr(report, name)
    areas = sum(patch["area"] for patch in report.patches)
    assert areas == pytest.approx(report.area, rel=1e-13)


def test_worst_point_is_that_far_from_the_surface(surface, report):
    tree = hn.SurfaceTree(surface)
    found = tree.closest_points(report.worst_point[None])
    assert found.distances[0] == pytest.approx(report.largest_distance, rel=1e-9)
    cell, u, v = report.worst_place
    place = surface.positions(np.array([cell]), np.array([[u, v]]))[0]
    assert np.linalg.norm(place - report.worst_point) == pytest.approx(
        report.largest_distance, rel=1e-9
    )


def test_area_is_the_surfaces(surface, report):
    expected = hn.HullBody(surface, mirrored=False).shell_area
    assert report.area == pytest.approx(expected, rel=1e-4)
    exact = hn.measure_quality(surface, hn.exact_patches(surface))
    assert exact.area == pytest.approx(expected, rel=1e-6)


def test_more_samples_find_no_less_to_speak_of(surface, report):
    more = hn.measure_quality(surface, hn.fit_per_cell(surface), samples=9)
    assert more.largest_distance == pytest.approx(report.largest_distance, rel=0.1)
    assert more.rms_distance == pytest.approx(report.rms_distance, rel=0.02)
    assert more.largest_seam_angle == pytest.approx(report.largest_seam_angle, rel=0.1)


def test_json_is_complete(report):
    data = json.loads(report.json(), parse_constant=lambda name: pytest.fail(name))
    assert data["length_m"] == report.length
    assert data["largest_distance_m"] == report.largest_distance
    assert data["largest_distance_at_m"] == list(report.worst_point)
    assert data["largest_distance_at_cell"] == report.worst_place[0]
    assert math.radians(data["largest_seam_angle_deg"]) == pytest.approx(
        report.largest_seam_angle, rel=1e-14
    )
    assert data["largest_curvature_jump_per_m"] == report.largest_curvature_jump
    assert data["largest_gap_m"] == report.largest_gap
    assert data["patch_count"] == len(data["patches"]) == report.patch_count
    assert data["theoretical_patch_count"] == report.theoretical_patch_count
    assert len(data["seams"]) == len(report.seams)
    for mine, theirs in zip(data["patches"], report.patches):
        assert mine["largest_distance_m"] == theirs["largest_distance"]
        assert mine["exact_area_m2"] == theirs["exact_area"]
    for mine, theirs in zip(data["seams"], report.seams):
        assert tuple(mine["patches"]) == theirs["patches"]
        assert mine["largest_curvature_jump_per_m"] == theirs["largest_curvature_jump"]


def test_json_says_null_where_nothing_was_measured():
    points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    surface = hn.LimitSurface(hn.ControlMesh(np.array(points, float), [4], [0, 1, 2, 3]))
    report = hn.measure_quality(surface, hn.exact_patches(surface))
    data = json.loads(report.json(), parse_constant=lambda name: pytest.fail(name))
    assert data["seams"] == []
    assert data["largest_seam_angle_deg"] is None
    assert data["largest_seam_angle_at_m"] is None
    assert np.isnan(report.worst_seam_point).all()
    assert "-" in report.text()


def test_text_tells_the_same(report):
    text = report.text()
    line = next(line for line in text.splitlines() if line.startswith("Distance"))
    value, *place = (float(word) for word in re.findall(r"-?\d+\.?\d*(?:e-?\d+)?", line))
    assert value == pytest.approx(1e3 * report.largest_distance, rel=6e-3)
    assert place == pytest.approx(report.worst_point, abs=6e-4)
    line = next(line for line in text.splitlines() if line.startswith("Angle"))
    value = float(re.findall(r"\d+\.?\d*(?:e-?\d+)?", line)[0])
    assert value == pytest.approx(math.degrees(report.largest_seam_angle), rel=6e-3)
    assert f"{report.patch_count} (at least {report.theoretical_patch_count})" in text


def test_progress_is_told_and_can_end_it(surface):
    patches = hn.exact_patches(surface)
    shares = []
    hn.measure_quality(surface, patches, progress=shares.append)
    assert shares == sorted(shares)
    assert shares[-1] == 1.0

    class Enough(Exception):
        pass

    def end(share):
        if share > 0.3:
            raise Enough

    with pytest.raises(Enough):
        hn.measure_quality(surface, patches, progress=end)


def test_refuses_what_does_not_fit(surface):
    patches = hn.exact_patches(surface)
    with pytest.raises(ValueError, match="from 1 to 16, not 0"):
        hn.measure_quality(surface, patches, samples=0)
    with pytest.raises(ValueError, match="reach"):
        hn.measure_quality(surface, patches, normal_reach=-1.0)
    moved = hn.LimitSurface(surface.mesh.with_points(surface.mesh.points * [1.0, 1.0, 1.1]))
    with pytest.raises(ValueError, match="out of date"):
        hn.measure_quality(moved, patches)
    other = pyramid(3)
    with pytest.raises(ValueError, match="not of this surface"):
        hn.measure_quality(other, patches)
