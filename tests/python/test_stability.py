# SPDX-License-Identifier: GPL-3.0-or-later
"""Equilibrium, righting levers and criteria in Python: shapes and words."""

import hull_native as hn
import numpy as np
import pytest

LENGTH, BEAM, DEPTH, DRAFT = 20.0, 8.0, 5.0, 2.0
HEELS = np.radians(np.arange(0, 95, 5))


def box_surface():
    corners = [(x, y, z) for x in (0, LENGTH) for y in (-BEAM / 2, BEAM / 2) for z in (0, DEPTH)]
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    edges = [(a, a | bit) for a in range(8) for bit in (1, 2, 4) if not a & bit]
    mesh = hn.ControlMesh(np.array(corners), [4] * 6, np.ravel(faces), creases=edges)
    return hn.LimitSurface(mesh)


@pytest.fixture(scope="module")
def box():
    return hn.HullBody(box_surface(), mirrored=False)


def load(**changes):
    case = dict(mass_t=LENGTH * BEAM * DRAFT, centre_of_gravity=(10, 0, 2.5), water_density=1.0)
    return {**case, **changes}


def test_equilibrium_of_a_box(box):
    rest = hn.equilibrium(box, **load(centre_of_gravity=(10.3, 0, 2.5)), draft_at=10)
    assert rest.status == "stable", rest.message
    assert rest.draft(0) < rest.draft_mean < rest.draft(LENGTH)
    assert rest.draft(10) == pytest.approx(rest.draft_mean)
    assert rest.heel == pytest.approx(0, abs=1e-11)
    assert rest.trim < 0
    assert rest.left is None
    assert rest.immersion.volume == pytest.approx(320, rel=1e-11)
    assert rest.immersion.waterplane_second.shape == (3, 3)
    np.testing.assert_allclose(np.linalg.norm(rest.immersion.water_normal), 1, rtol=1e-14)
    assert abs(rest.volume_residual) < 1e-11 and rest.lever_residual < 1e-9


def test_angle_of_loll(box):
    top_heavy = load(centre_of_gravity=(10, 0, 1 + 64 / 24 + 0.05))
    rest = hn.equilibrium(box, **top_heavy)
    assert rest.status == "stable"
    assert np.tan(rest.heel) == pytest.approx(np.sqrt(0.1 * 24 / 64), rel=1e-7)
    assert rest.left.gm_transverse == pytest.approx(-0.05, abs=1e-10)
    upright = hn.equilibrium(box, **top_heavy, leave_unstable=False)
    assert upright.status == "unstable"
    assert "transverse" in upright.message


def test_impossible_loads(box):
    heavy = hn.equilibrium(box, **load(mass_t=1000))
    assert heavy.status == "sinks"
    assert "1000 t" in heavy.message and "800 t" in heavy.message
    for wrong, word in [
        (dict(mass_t=0), "mass"),
        (dict(mass_t=-3), "mass"),
        (dict(water_density=0), "density"),
        (dict(centre_of_gravity=(1, 2)), "shape"),
        (dict(centre_of_gravity=(1, 2, np.inf)), "finite"),
    ]:
        with pytest.raises(ValueError, match=word):
            hn.equilibrium(box, **load(**wrong))
    with pytest.raises(ValueError, match="sinks"):
        hn.righting_levers(box, **load(mass_t=1000), heels=HEELS)
    with pytest.raises(ValueError, match="centres_of_gravity"):
        hn.equilibria(box, masses_t=[1.0, 2.0], centres_of_gravity=[[1, 0, 0]])
    assert hn.equilibria(box, masses_t=[], centres_of_gravity=np.zeros((0, 3))) == []


def test_righting_levers_of_a_box(box):
    levers = hn.righting_levers(
        box,
        **load(),
        heels=HEELS,
        deck_edge=[1, 3, 5, 7],
        downflooding_points=[[10, -3, 5.5]],
        area_intervals=[(0, 0.3), (0, 0.4)],
    )
    assert levers.levers.shape == levers.slopes.shape == levers.trims.shape == HEELS.shape
    np.testing.assert_array_equal(levers.heels, HEELS)
    bm, gm = 64 / 24, 1 + 64 / 24 - 2.5
    assert levers.gm == pytest.approx(gm, abs=1e-10)
    small = HEELS[1:5]
    wall_sided = np.sin(small) * (gm + bm / 2 * np.tan(small) ** 2)
    np.testing.assert_allclose(levers.levers[1:5], wall_sided, atol=1e-10)
    assert levers.drafts(10.0)[0] == pytest.approx(DRAFT)
    assert levers.areas.shape == (2,) and levers.areas[1] > levers.areas[0] > 0
    assert 0 < levers.deck_edge_heel < levers.downflooding_heel < np.pi / 2
    assert not levers.greatest_lever_at_end
    assert levers.greatest_lever >= levers.levers.max()
    assert len(levers.immersions) == len(HEELS)
    plain = hn.righting_levers(box, **load(), heels=[0.1])
    assert not plain.has_deck_edge and plain.deck_edge_heel is None
    assert not plain.can_flood and plain.vanishing_heel is None
    assert plain.greatest_lever_at_end


def test_cross_curves_of_a_box(box):
    curves = hn.cross_curves(box, displacements_t=[160, 320], heels=HEELS[:4], water_density=1.0)
    assert curves.levers.shape == curves.trims.shape == (2, 4)
    np.testing.assert_allclose(curves.lcg, 10, atol=1e-10)
    levers = hn.righting_levers(box, **load(), heels=HEELS[:4])
    np.testing.assert_allclose(
        levers.levers, curves.levers[1] - 2.5 * np.sin(HEELS[:4]), atol=1e-10
    )
    with pytest.raises(ValueError, match="whole body"):
        hn.cross_curves(box, displacements_t=[1000], heels=[0.1], water_density=1.0)


def test_criteria_of_a_box(box):
    report = hn.stability_criteria(box, **load(), downflooding_points=[[10, -1, 7], [10, 1, 7]])
    assert [c.paragraph for c in report.criteria] == ["2.2.1"] * 3 + ["2.2.2", "2.2.3", "2.2.4"]
    assert [c.limit for c in report.criteria][:4] == [0.055, 0.09, 0.03, 0.2]
    assert all((c.value >= c.limit) == (c.outcome == "pass") for c in report.criteria)
    assert report.passes == all(c.outcome == "pass" for c in report.criteria)
    assert report.downflooding_heel > np.radians(40)


def test_weather_criterion_of_a_box(box):
    given = load(mass_t=LENGTH * BEAM * DRAFT, centre_of_gravity=(10, 0, 2.2))
    found = hn.weather_criterion(
        box,
        **given,
        deck_edge=[1, 3, 5, 7],
        wind_areas=[(20, 7.0)],
        midship=10,
        roll_period=8.0,
    )
    area = LENGTH * (DEPTH - DRAFT) + 20
    lever = (LENGTH * 3 * 3.5 + 20 * 7) / area - 1
    assert found.wind_area == pytest.approx(area)
    assert found.wind_lever == pytest.approx(lever)
    assert found.steady_lever == pytest.approx(504 * area * lever / (9810 * 320))
    assert found.gust_lever == 1.5 * found.steady_lever
    assert (found.draft, found.beam) == (pytest.approx(DRAFT), pytest.approx(BEAM))
    roll = found.roll
    expected = 109 * roll.k * roll.x1 * roll.x2 * np.sqrt(roll.r * roll.s)
    assert np.degrees(roll.angle) == pytest.approx(expected)
    assert "B/d is 4" in roll.out_of_range
    heel, areas = found.criteria
    assert (heel.paragraph, heel.bound) == ("2.3.1.2", "at most")
    assert (areas.paragraph, areas.bound) == ("2.3.1.4", "at least")
    assert areas.value == found.area_b and areas.limit == found.area_a
    # The same areas from the levers of the same curve, by the trapezoidal rule.
    heels = np.linspace(found.windward_heel, found.gust_heel, 401)
    levers = hn.righting_levers(box, **given, heels=heels).levers
    assert found.area_a == pytest.approx(np.trapz(found.gust_lever - levers, heels), abs=1e-5)
    with pytest.raises(ValueError, match="wind area"):
        hn.weather_criterion(box, **given, hull_profile=False)


def test_density_of_sea_water_is_the_default(box):
    assert hn.SEA_WATER_DENSITY == 1.025
    default = hn.hydrostatics(box, draft=DRAFT).displacement_t
    assert default == hn.hydrostatics(box, draft=DRAFT, water_density=1.025).displacement_t
