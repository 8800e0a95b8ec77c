# SPDX-License-Identifier: GPL-3.0-or-later
"""Particulars, sectional areas and Bonjean curves in Python."""

import math

import hull_native as hn
import numpy as np
import pytest

LENGTH, BEAM, DEPTH = 40.0, 8.0, 5.0


@pytest.fixture
def box():
    """A HullBody of a box, all its edges creases."""
    points = [(x, y, z) for z in (0, DEPTH) for y in (-BEAM / 2, BEAM / 2) for x in (0, LENGTH)]
    faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    creases = [(a, a | bit) for a in range(8) for bit in (1, 2, 4) if not a & bit]
    mesh = hn.ControlMesh(
        np.array(points, dtype=float), np.full(6, 4), np.ravel(faces), creases=creases
    )
    return hn.HullBody(hn.LimitSurface(mesh), mirrored=False)


def test_particulars_of_a_box(box):
    found = hn.hydrostatics(
        box, draft=2.0, length_pp=LENGTH, beam=BEAM, design_draft=2.0, water_density=1.0
    )
    assert found.displacement_t == pytest.approx(640.0, rel=1e-12)
    assert (found.lcb, found.kb, found.lcf) == pytest.approx((20.0, 1.0, 20.0), rel=1e-12)
    assert found.tpc == pytest.approx(3.2, rel=1e-12)
    assert found.mtc == pytest.approx(BEAM * LENGTH**2 / 1200.0, rel=1e-12)
    assert found.km_transverse == pytest.approx(1.0 + BEAM**2 / 24.0, rel=1e-12)
    for coefficients in (found.project, found.immersed):
        assert coefficients.block == pytest.approx(1.0, rel=1e-12)
        assert coefficients.vertical_prismatic == pytest.approx(1.0, rel=1e-12)
    assert found.half_angle_of_entrance == pytest.approx(math.pi / 2)
    assert found.midship_section.area == pytest.approx(16.0, rel=1e-12)
    assert found.midship_section.centroid == pytest.approx((20.0, 0.0, 1.0), abs=1e-12)
    assert found.lateral_area == pytest.approx(80.0, rel=1e-12)


def test_the_draft_is_that_of_midship_unless_said_otherwise(box):
    slope = math.tan(0.02)
    at_midship = hn.hydrostatics(box, draft=2.0, trim=0.02, length_pp=LENGTH)
    at_stern = hn.hydrostatics(box, draft=2.0 + 20.0 * slope, trim=0.02, draft_at=0.0)
    assert at_midship.displaced_volume == pytest.approx(640.0, rel=1e-12)
    assert at_stern.displaced_volume == pytest.approx(640.0, rel=1e-12)
    assert (at_midship.trim, at_midship.draft_at) == (0.02, 20.0)


def test_section_areas_of_a_box(box):
    curve = hn.section_areas(box, np.linspace(0.0, LENGTH, 5), draft=2.0)
    np.testing.assert_allclose(curve.areas, 16.0, rtol=1e-12)
    np.testing.assert_allclose(curve.girths, BEAM + 4.0, rtol=1e-12)
    np.testing.assert_allclose(curve.breadths, BEAM, rtol=1e-12)
    np.testing.assert_allclose(curve.centroids[:, 2], 1.0, rtol=1e-12)
    assert curve.centroids.shape == (5, 3)
    assert curve.positions[-1] == LENGTH
    assert (curve.area_errors < 1e-10).all()


def test_section_areas_of_a_trimmed_box(box):
    curve = hn.section_areas(box, [10.0, 30.0], draft=2.0, trim=0.01, draft_at=20.0)
    rise = 10.0 * math.tan(0.01)
    np.testing.assert_allclose(curve.areas, [BEAM * (2.0 + rise), BEAM * (2.0 - rise)], rtol=1e-12)


def test_bonjean_curves_of_a_box(box):
    curves = hn.bonjean(box, stations=[5.0, 20.0, 50.0], drafts=[0.0, 1.0, 2.0, 5.0, 6.0])
    assert curves.areas.shape == (3, 5)
    # 5 m is the very depth: the water is in the plane of the deck.
    np.testing.assert_allclose(curves.areas[1], [0.0, 8.0, 16.0, 40.0, 40.0], atol=1e-12)
    np.testing.assert_allclose(curves.areas[2], 0.0)
    np.testing.assert_allclose(curves.centroids[0, :, 2], [0.0, 0.5, 1.0, 2.5, 2.5], atol=1e-12)
    assert curves.stations.tolist() == [5.0, 20.0, 50.0]


def test_table(box):
    rows = hn.hydrostatic_table(box, drafts=[1.0, 2.0], trims=[0.0, 0.01], length_pp=LENGTH)
    assert [(row.draft, row.trim) for row in rows] == [
        (1.0, 0.0),
        (2.0, 0.0),
        (1.0, 0.01),
        (2.0, 0.01),
    ]
    assert rows[3].displaced_volume == pytest.approx(640.0, rel=1e-12)


@pytest.mark.parametrize(
    "arguments, message",
    [
        ({"draft": math.nan}, "draft must be a finite"),
        ({"draft": 1.0, "trim": 1.6}, "less than 90 degrees"),
        ({"draft": 1.0, "beam": -2.0}, "must be positive"),
        ({"draft": 1.0, "water_density": 0.0}, "density must be positive"),
    ],
)
def test_words_on_mistakes(box, arguments, message):
    with pytest.raises(ValueError, match=message):
        hn.hydrostatics(box, **arguments)


def test_a_station_is_a_finite_number(box):
    with pytest.raises(ValueError, match="station must be a finite number"):
        hn.section_areas(box, [math.inf], draft=1.0)
