# SPDX-License-Identifier: GPL-3.0-or-later
"""Inflections and dips that are seen: of curves with known curvature, and of hulls with a dent."""

import copy

import hull_native as hn
import numpy as np
import pytest
import vessels
from hull_fairness.inflections import marks as marks_seen
from hull_fairness.lines import Found, found_through, judged, with_reasons

LEAST = 0.001


def kinds(lengths, curvatures, least=LEAST):
    return [mark.kind for mark in marks_seen(lengths, curvatures, least)]


def test_waves_have_their_inflections():
    s = np.linspace(0.0, 60.0, 2001)
    found = marks_seen(s, 0.1 * np.cos(0.3 * s), LEAST)
    assert [mark.kind for mark in found] == ["inflection"] * 6
    places = [s[mark.index] for mark in found]
    assert places == pytest.approx((np.arange(6) + 0.5) * np.pi / 0.3, abs=0.05)


def test_one_bend_is_fair():
    s = np.linspace(0.0, 10.0, 501)
    for curvature in (0.0 * s, 0.1 + 0.0 * s, 0.01 * s, np.exp(-((s - 4.0) ** 2)), -np.exp(-s)):
        assert kinds(s, curvature) == []
        assert kinds(s, -curvature) == []


def test_a_flat_between_two_bends_is_a_dip_in_its_middle():
    s = np.linspace(0.0, 10.0, 1001)
    curvature = np.exp(-4.0 * (s - 1.5) ** 2) + np.exp(-4.0 * (s - 8.0) ** 2)
    (mark,) = marks_seen(s, curvature, LEAST)
    assert mark.kind == "dip"
    assert s[mark.index] == pytest.approx(4.75, abs=0.3)


def test_a_flat_is_a_mark_as_long_as_it_is_flat():
    s = np.linspace(0.0, 10.0, 1001)
    curvature = np.clip(np.abs(s - 4.0) - 3.0, 0.0, None)
    (mark,) = marks_seen(s, curvature, LEAST)
    # Bends by a hundredth of the lesser one beside it, which is 2.0, are none.
    assert (s[mark.first], s[mark.last]) == pytest.approx((1.0, 7.0), abs=0.03)


def test_an_inflection_is_as_long_as_nothing_is_seen_of_a_bend():
    """Of k = c s, which leaves the chord of 0 to l by c l³ / (9 √3)."""
    s, c = np.linspace(-10.0, 10.0, 4001), 0.01
    (mark,) = marks_seen(s, c * s, LEAST, 0.0)
    far = (9.0 * np.sqrt(3.0) * LEAST / c) ** (1.0 / 3.0)
    assert (s[mark.first], s[mark.last]) == pytest.approx((-far, far), abs=0.02)


def test_ripple_counts_from_its_depth_on():
    """A circle with a ripple r cos(w s) of its radius: the curvature's is r w²."""
    s, waves = np.linspace(0.0, 1.5, 1501), 24.0

    def dips(r):
        return kinds(s, 1.0 + r * waves**2 * np.cos(waves * s)).count("dip")

    assert dips(0.5 * LEAST) == 0
    assert dips(2.0 * LEAST) == 5


def test_noise_is_not_counted():
    s = np.linspace(0.0, 10.0, 1001)
    noise = np.random.default_rng(1).normal(scale=1e-4, size=len(s))
    assert kinds(s, noise) == []
    assert kinds(s, 0.05 * s / s[-1] + noise) == []


def test_depth_is_that_of_the_chord():
    """Of an arc of 40 m radius, hollow, between two round ones."""
    s = np.linspace(0.0, 12.0, 1201)
    curvature = np.where(np.abs(s - 6.0) < 2.0, -1.0 / 40.0, 0.2)
    marks = [m for m in marks_seen(s, curvature, LEAST) if m.kind == "inflection"]
    assert [m.depth for m in marks] == pytest.approx([4.0**2 / 8.0 / 40.0] * 2, rel=0.02)
    assert [m.kind for m in marks_seen(s, curvature, 0.06)] == ["dip"]


def test_a_mark_is_wanted_once_in_its_box():
    wanted = [("station", "dip", 1, {"x": (0.0, 5.0), "z": (1.0, 2.0)}, "the chine")]
    inside, outside = (3.0, 0.0, 1.5), (3.0, 0.0, 2.5)

    def reasons(kind, *points):
        marks = [Found("dip", point, "1.0 mm deep") for point in points]
        return [m.reason for m in with_reasons(kind, marks, wanted)]

    assert reasons("station", inside, inside) == ["the chine", None]
    assert reasons("station", outside, inside) == [None, "the chine"]
    assert reasons("waterline", inside) == [None]


def test_what_is_no_mark_is_refused():
    with pytest.raises(ValueError, match="'peak' of a 'station'"):
        judged(None, 1.0, [("station", "peak", 1, {}, "")])


def marks_by_line(data):
    lines = judged(vessels.surface_of(data), data.particulars.beam)
    return [len(line.found) for line in lines]


@pytest.fixture(scope="module")
def marks_of_the_coaster():
    return marks_by_line(vessels.vessel("coaster").data)


# Points of the coaster where it is gently bent.
@pytest.mark.parametrize("point", [30, 62, 78])
@pytest.mark.parametrize("mille", [4.0, -4.0])
def test_a_dent_and_a_bump_are_found(point, mille, marks_of_the_coaster):
    data = vessels.vessel("coaster").data
    dented = copy.deepcopy(data)
    dented.points[point, 1] -= mille * 1e-3 * data.particulars.beam
    after = marks_by_line(dented)
    assert max(b - a for a, b in zip(marks_of_the_coaster, after)) >= 1


def test_what_is_found_within_a_box_is_what_is_found_there():
    """On a sheet with waves along it."""
    x, z = np.meshgrid(np.arange(10.0), np.arange(4.0), indexing="ij")
    points = np.stack([x, 3.0 + 0.2 * np.sin(1.8 * x) - 0.1 * z**2, z], axis=2).reshape(-1, 3)
    first = (np.arange(9)[:, None] * 4 + np.arange(3)).ravel()
    faces = np.stack([first, first + 4, first + 5, first + 1], axis=1)
    surface = hn.LimitSurface(hn.ControlMesh(points, np.full(27, 4), faces.ravel()))
    low, high = np.array([5.0, 0.0, 0.0]), np.array([9.0, 10.0, 2.0])
    told = []
    whole = judged(surface, 6.0, progress=told.append)
    part = {line.name: line for line in judged(surface, 6.0, within=(low, high))}
    for line in whole:
        inside = [
            found
            for found in line.found
            if (low <= found.point).all() and (found.point <= high).all()
        ]
        assert inside == (part[line.name].found if line.name in part else [])
    assert 0 < sum(len(line.found) for line in part.values()) and len(part) < len(whole)
    assert told == sorted(told) and len(told) == len(whole) and 0.0 < told[0] < 0.01


def test_a_hull_narrower_than_any_ship_is_judged_by_no_more_samples(monkeypatch):
    """They are set by the beam, of which this one has nearly none."""
    data = copy.deepcopy(vessels.vessel("coaster").data)
    data.points[:, 1] *= 1e-4
    surface, whole, steps = vessels.surface_of(data), hn.section_fairness, []

    def recorded(*arguments, step, **options):
        steps.append(step)
        return whole(*arguments, step=step, **options)

    monkeypatch.setattr(hn, "section_fairness", recorded)
    judged(surface, 1e-4 * data.particulars.beam)
    assert min(steps) >= surface.mesh.size / 20001.0
    steps.clear()
    list(found_through(surface, 1e-4, "station", surface.mesh.points[:1]))
    assert steps and min(steps) >= surface.mesh.size / 20001.0


def test_ripples_go_one_by_one_the_least_first():
    """Sides of a rippled bend: only the two that are deep are left, wherever the ripples are."""
    s = np.linspace(0.0, 100.0, 20001)
    ripples = 1e-3 * np.sin(7.0 * s) * (1.0 + 0.3 * np.sin(0.9 * s))
    wave = 0.1 * np.where(s < 50.0, 1.0, -1.0) * np.sin(np.pi * s / 50.0) ** 2
    (mark,) = marks_seen(s, wave + ripples, LEAST)
    assert mark.kind == "inflection" and s[mark.index] == pytest.approx(50.0, abs=1.0)
