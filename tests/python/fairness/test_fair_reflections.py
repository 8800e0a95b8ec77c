# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinks and waves of mirrored lines: of lines with known turns, of smooth and dented surfaces."""


import hull_native as hn
import numpy as np
import pytest
import vessels
from hull_fairness import kinks
from hull_fairness.kinks import KINK, WAVE
from hull_fairness.lines import judged
from hull_fairness.reflections import STEP, Turning, reflection_lines


def marks_of(turned, gradients=1.0):
    """Of a line on a beam of 1 m."""
    points = np.zeros((len(turned), 3))
    line = Turning(points, turned, np.broadcast_to(gradients, len(turned)))
    return kinks.turns(line, 1.0)


def along(length):
    return np.arange(0.0, length, STEP)


@pytest.mark.parametrize("degrees, count", [(25.0, 0), (35.0, 1), (-35.0, 1)])
def test_a_corner_is_a_kink(degrees, count):
    s = along(0.5)
    found = marks_of(np.where(s < 0.2, 0.0, np.radians(degrees)))
    assert [mark.kind for mark in found] == [KINK] * count
    for mark in found:
        assert s[mark.index] == pytest.approx(0.2, abs=kinks.REACH)
        assert mark.angle == pytest.approx(np.radians(abs(degrees)))


def test_an_even_bend_and_a_corner_at_the_end_are_none():
    s = along(0.5)
    assert marks_of(s / 0.1) == []
    assert marks_of(np.where(s < 0.49, 0.0, 1.0)) == []


@pytest.mark.parametrize("sharpness", [1.0, 10.0, 100.0])
def test_the_tip_of_a_loop_is_none(sharpness):
    """Of the angle a y² - x a level line is a parabola, which turns however sharply at its tip."""
    y = np.linspace(-1.0, 1.0, 20001)
    lengths = np.cumsum(np.hypot(np.gradient(sharpness * y * y), np.gradient(y)))
    y = np.interp(np.arange(lengths[0], lengths[-1], STEP), lengths, y)
    line = marks_of(np.arctan(2.0 * sharpness * y), np.hypot(1.0, 2.0 * sharpness * y))
    assert line == []


def test_a_wave_turns_both_ways_within_its_reach():
    s = along(1.0)

    def waves(degrees, period):
        found = marks_of(np.radians(degrees) * np.sin(2.0 * np.pi * s / period))
        return sum(mark.kind == WAVE for mark in found)

    # It turns by twice its amplitude between its extremes.
    assert waves(12.0, 0.1) >= 18
    assert waves(9.0, 0.1) == 0
    assert waves(12.0, 1.0) == 0
    # Shorter than what is seen.
    assert waves(12.0, 0.02) == 0


def test_what_is_grey_is_not_seen():
    turned = np.where(along(0.5) < 0.2, 0.0, 1.0)
    spacing = np.pi / 32.0
    assert len(marks_of(turned, 0.9 * spacing / kinks.CLOSE)) == 1
    assert marks_of(turned, 1.1 * spacing / kinks.CLOSE) == []


# Of the ring's body.
BEAM = 2.0


def ring(across=16, along=24):
    """Control points (along, across, 3) of a ring round the z axis."""
    u = 2.0 * np.pi * np.arange(along)[:, None] / along
    v = 2.0 * np.pi * np.arange(across) / across
    r = 3.0 + np.cos(v)
    return np.stack([r * np.cos(u), r * np.sin(u), np.sin(v) + 0.0 * u], axis=-1)


def finer(points):
    """Twice as many control points along both axes, of the same uniform cubic surface."""
    for axis in (0, 1):
        before, after = np.roll(points, 1, axis), np.roll(points, -1, axis)
        both = np.stack([(before + 6.0 * points + after) / 8.0, 0.5 * (points + after)], axis + 1)
        shape = list(points.shape)
        shape[axis] *= 2
        points = both.reshape(shape)
    return points


def surface_of(points):
    n, m = points.shape[:2]
    i, j = (part.ravel() for part in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    i1, j1 = (i + 1) % n, (j + 1) % m
    faces = np.stack([i * m + j, i1 * m + j, i1 * m + j1, i * m + j1], axis=1)
    mesh = hn.ControlMesh(points.reshape(-1, 3), np.full(n * m, 4), faces.ravel())
    return hn.LimitSurface(mesh)


def counts(surface, beam):
    """{mark: how many} on all reflection lines."""
    lines = reflection_lines(surface, beam)
    found = [mark.kind for _, parts in lines for p in parts for mark in kinks.turns(p, beam)]
    return {kind: found.count(kind) for kind in (KINK, WAVE)}


def test_a_smooth_surface_has_none():
    surface = surface_of(ring())
    assert len(list(reflection_lines(surface, BEAM))) > 100
    assert counts(surface, BEAM) == {KINK: 0, WAVE: 0}


@pytest.mark.parametrize("depth, is_found", [(1e-3, False), (2e-2, True), (-2e-2, True)])
def test_a_dent_is_found_from_its_depth_on(depth, is_found):
    """Of the beam, of one control point; the surface moves 4/9 as far."""
    dented = finer(ring())
    outwards = dented[16, 28] - 3.0 * dented[16, 0] / np.linalg.norm(dented[16, 0])
    dented[16, 28] -= depth * BEAM * outwards / np.linalg.norm(outwards)
    assert (sum(counts(surface_of(dented), BEAM).values()) > 0) == is_found


def test_lines_of_a_cylinder_do_not_turn():
    v = 2.0 * np.pi * np.arange(12) / 12
    points = np.stack(
        [np.stack([0.0 * v + x, np.cos(v), np.sin(v)], axis=1) for x in np.arange(6.0)]
    )
    faces = [
        (i * 12 + j, i * 12 + (j + 1) % 12, (i + 1) * 12 + (j + 1) % 12, (i + 1) * 12 + j)
        for i in range(5)
        for j in range(12)
    ]
    mesh = hn.ControlMesh(points.reshape(-1, 3), np.full(60, 4), np.ravel(faces)[::-1].copy())
    lines = list(reflection_lines(hn.LimitSurface(mesh), 2.0))
    assert lines
    for _, parts in lines:
        for part in parts:
            assert np.abs(part.turned).max(initial=0.0) < 1e-6


def test_a_finer_mesh_of_the_same_surface_has_the_same():
    dented = finer(ring())
    dented[16:20, 2] *= 0.99
    coarse = counts(surface_of(dented), BEAM)
    assert sum(coarse.values()) > 5
    assert counts(surface_of(finer(dented)), BEAM) == coarse


# Points of the coaster at the deck and bilge aft.
@pytest.mark.parametrize("point", [15, 23, 29])
def test_a_dent_of_a_hull_is_found_and_may_be_wanted(point):
    data = vessels.vessel("coaster").data
    beam = data.particulars.beam
    before = counts(vessels.surface_of(data), beam)
    data.points[point, 1] -= 8e-3 * beam
    wanted = [("reflection", kind, 9, {"x": (-9.0, 999.0)}, "a dent") for kind in (KINK, WAVE)]
    lines = judged(vessels.surface_of(data), beam, wanted)
    found = [mark for line in lines if line.kind == "reflection" for mark in line.found]
    assert len(found) > sum(before.values())
    assert {mark.reason for mark in found} == {"a dent"}
