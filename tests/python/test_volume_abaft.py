# SPDX-License-Identifier: GPL-3.0-or-later
"""The displaced volume abaft a station: closed forms, sums over stations, the whole's moment."""

import hull_native as hn
import numpy as np
import pytest
from transformation_hulls import SAMPLES, Sample, wigley_areas


def test_wigleys_area_curve_integrated():
    surface, area = wigley_areas(17)
    body = hn.HullBody(surface, mirrored=True)
    for x in np.linspace(-0.1, 2.1, 45):
        along = np.clip(x, 0.0, 2.0) - 1.0
        wanted = area * (along - along**3 / 3 + 2 / 3)
        assert hn.volume_abaft(body, x, draft=2.0) == pytest.approx(wanted, abs=1e-13 * area)


@pytest.mark.parametrize("draft", [2.0, 0.4, 4.9])
def test_a_trimmed_box(draft):
    """Its water meets bottom and deck within its length; knuckles run across the stations."""
    points = [(x, y, z) for z in (0, 5) for y in (-4, 4) for x in (0, 40)]
    faces = [0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5]
    creases = [(a, a | bit) for a in range(8) for bit in (1, 2, 4) if not a & bit]
    surface = hn.LimitSurface(hn.ControlMesh(points, [4] * 6, faces, creases, range(8)))
    body = hn.HullBody(surface, mirrored=False)
    for trim in (-0.07, 0.0, 0.05):
        for x in (0.0, 3.7, 20.0, 20.00001, 31.0, 40.0):
            found = hn.volume_abaft(body, x, draft=draft, trim=trim, draft_at=20.0)
            assert found == pytest.approx(8.0 * box_profile(x, draft, trim), abs=1e-10)


def box_profile(x, draft, trim):
    """m², of the profile below the water from 0 to x: between the corners of a broken line."""
    slope = -np.tan(trim)
    ends = [20.0 + (level - draft) / slope for level in (0.0, 5.0)] if trim else []
    cuts = np.sort([0.0, x, *(end for end in ends if 0.0 < end < x)])
    heights = np.clip(draft + slope * (cuts - 20.0), 0.0, 5.0)
    return np.trapz(heights, cuts)


@pytest.mark.parametrize("trim", [0.0, 0.012])
@pytest.mark.parametrize("name", SAMPLES)
def test_samples(name, trim):
    sample = Sample(name)
    body, length = sample.body, sample.ship.length_pp
    where = {"draft": sample.ship.draft, "trim": trim, "draft_at": 0.5 * length}
    whole = hn.hydrostatics(body, **where)
    knots = body.surface.mesh.points[:, 0]
    low, high = knots.min() - 1.0, knots.max() + 1.0
    assert hn.volume_abaft(body, low, **where) == 0.0
    volume = whole.displaced_volume
    assert hn.volume_abaft(body, high, **where) == pytest.approx(volume, rel=1e-12)
    # What lies between two stations is the integral of the sectional areas.
    nodes, weights = np.polynomial.legendre.leggauss(12)
    for at in np.random.default_rng(7).uniform(0.05, 0.95, 12) * length:
        step = 1e-3 * length
        areas = hn.section_areas(body, at + step * nodes, **where).areas
        ends = [hn.volume_abaft(body, x, **where) for x in (at - step, at + step)]
        assert ends[1] - ends[0] == pytest.approx(step * weights @ areas, abs=1e-10 * volume)
    # ∫ V(x) dx by parts is the moment about the end ahead.
    edges = np.unique(np.concatenate([np.linspace(low, high, 61), np.round(knots, 9)]))
    half, centre = 0.5 * np.diff(edges), 0.5 * (edges[1:] + edges[:-1])
    nodes, weights = np.polynomial.legendre.leggauss(6)
    stations = (centre[:, None] + half[:, None] * nodes).ravel()
    values = [hn.volume_abaft(body, station, **where) for station in stations]
    moment = (half[:, None] * weights).ravel() @ values
    assert moment == pytest.approx(volume * (high - whole.lcb), rel=1e-7)


def test_of_hulls_alone():
    surface, _ = wigley_areas(9)
    body = hn.HullBody(surface, mirrored=True)
    body.join([hn.cylinder((0.9, -1.0, 1.6), (0.9, 1.0, 1.6), 0.1, cut=True)])
    with pytest.raises(ValueError, match="ask one of the hull alone"):
        hn.volume_abaft(body, 1.0, draft=2.0)


def test_a_station_is_a_number():
    surface, _ = wigley_areas(9)
    body = hn.HullBody(surface, mirrored=True)
    with pytest.raises(ValueError, match="station's x must be a finite number"):
        hn.volume_abaft(body, float("nan"), draft=2.0)
