# SPDX-License-Identifier: GPL-3.0-or-later
"""A frigate of few curves: what further curves are worth where the surface is farthest off."""

from functools import lru_cache

import hull_native as hn
import numpy as np
import pytest

pytest.importorskip(
    "cairo", reason="pictures of the network are drawn by cairo, which is not there"
)
import frigate_network  # noqa: E402


@lru_cache(maxsize=None)
def made():
    surface = frigate_network.known_hull()
    return surface, frigate_network.steps(surface)


def test_the_known_hull_has_the_dimensions():
    points = made()[0].tessellate(6).points
    # Of the surface; its control points are a little farther out.
    assert np.ptp(points[:, 0]) == pytest.approx(96.0, rel=1e-9)
    assert 2.0 * points[:, 1].max() == pytest.approx(11.5, rel=5e-3)


def test_nine_curves_and_two_more_come_nearer():
    surface, steps = made()
    assert [len(step.network.curves) for step in steps] == [9, 10, 11]
    kinds = [curve.kind for curve in steps[0].network.curves]
    assert kinds.count("station") == 5 and kinds.count("waterline") == 1
    for step in steps:
        assert [problem.what for problem in step.network.problems if not problem.is_note] == []
        assert step.made.problems == []
        # The ends of all curves are on others: nothing is left out of the surface.
        assert step.made.patches.largest_gap <= 1e-9 * surface.mesh.size
    assert steps[1].rms < 0.75 * steps[0].rms and steps[2].rms < 0.75 * steps[1].rms
    assert steps[0].largest > steps[1].largest > steps[2].largest


def test_sectional_areas_come_nearer_too():
    # By another way than distances: areas of the same sections, to the centre plane.
    surface, steps = made()
    known = _areas(hn.sections, surface)
    off = [np.abs(_areas(hn.patch_sections, step.made.patches) - known).sum() for step in steps]
    assert off[1] < off[0] and off[2] < 0.5 * off[0]


def _areas(cut, of):
    """m², of half sections, from the centre plane to the hull."""
    planes = [
        hn.plane_across("x", share * frigate_network.LENGTH) for share in frigate_network.HELD_OUT
    ]
    return np.array(
        [sum(_area(np.asarray(c.points)) for c in curves) for curves in cut(of, planes)]
    )


def _area(line):
    across = 0.5 * (line[1:, 1] + line[:-1, 1])
    return abs(float(across @ np.diff(line[:, 2])))
