# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections shifted to a wanted displacement and centre of buoyancy, hulls lengthened, sections
inflated: known numbers of Wigley's area curve, and all samples within their limits."""

import os
import re

import hull_native as hn
import numpy as np
import pytest
from transformation_hulls import SAMPLES, Sample, grid_mesh, tube, wigley_areas

# Sweeps over all samples and sizes of change instead of a few.
IS_LONG = bool(os.environ.get("HULL_LONG_TRANSFORMATIONS"))

# form-design: Cp = 2/3 + 0.3786075 A and LCB = 0.4 B half lengths, so that these give Cp = 0.70 and
# LCB = 0.02 half lengths forward; checked here by quadrature of the shifted area curve.
A, B = 0.0880419, 0.0492127


def wigley_shift(stations, **how):
    surface, area = wigley_areas(stations)
    body = hn.HullBody(surface, mirrored=True)
    return surface, area, hn.SectionShift(body, draft=2.0, length_pp=2.0, **how)


def moved_body(surface, moves):
    surface = hn.LimitSurface(surface.mesh.with_points(surface.mesh.points + moves))
    return surface, hn.HullBody(surface, mirrored=True)


def test_coefficients_are_those_of_the_shifted_area_curve():
    x, weights = np.polynomial.legendre.leggauss(200)
    x, weights = np.concatenate([(x - 1) / 2, (x + 1) / 2]), np.concatenate([weights, weights]) / 2
    area = 1 - x**2
    shift = A * x * np.sin(np.pi * np.abs(x)) + B * area
    stretch = (
        1 + A * (np.sin(np.pi * np.abs(x)) + np.pi * np.abs(x) * np.cos(np.pi * x)) - 2 * B * x
    )
    volume = weights @ (area * stretch)
    assert volume / 2 == pytest.approx(0.70, abs=1e-7)
    assert weights @ (area * stretch * (x + shift)) / volume == pytest.approx(0.02, abs=1e-7)


def test_wigley_area_curve_is_exact():
    surface, area = wigley_areas(9)
    body = hn.HullBody(surface, mirrored=True)
    x = np.linspace(0.01, 1.99, 23)
    found = hn.section_areas(body, x, draft=2.0).areas
    assert np.abs(found / area - (1 - (x - 1) ** 2)).max() < 1e-12


def test_wigley_prismatic_and_lcb():
    surface, area, shift = wigley_shift(65)
    result = shift.solve(volume=0.70 * area * 2.0, lcb=1.02)
    assert result.converged and result.iterations <= 4
    assert np.abs(result.coefficients - (A, B)).max() < 1e-6
    _, body = moved_body(surface, result.moves)
    found = hn.hydrostatics(body, draft=2.0, length_pp=2.0)
    assert found.displaced_volume / (2.0 * area) == pytest.approx(0.70, abs=1e-9)
    assert found.lcb == pytest.approx(1.02, abs=1e-9)
    assert (result.volume, result.lcb) == pytest.approx((found.displaced_volume, found.lcb), 1e-12)


def test_hulls_are_transformed_without_what_is_joined():
    surface, area, _ = wigley_shift(17)
    body, where = hn.HullBody(surface, mirrored=True), {"draft": 2.0}

    def answers():
        shift = hn.SectionShift(body, length_pp=2.0, **where)
        shifted = shift.solve(volume=0.70 * area * 2.0, lcb=1.02)
        longer = hn.lengthen(body, 1.0, 0.5, stretched=(0.2, 1.8), **where)
        return [shifted.moves, shifted.volume, shifted.lcb, longer.moves, longer.volume_change]

    bare = answers()
    body.join([hn.cylinder((0.9, -1.0, 1.6), (0.9, 1.0, 1.6), 0.1, cut=True)])
    for one, other in zip(bare, answers()):
        assert np.array_equal(one, other)


def test_coefficients_alone():
    surface, area, shift = wigley_shift(65)
    for a in (-0.4, 0.1, 0.3):
        prismatic = shift.shifted([a, 0.0]).volume / (2.0 * area)
        assert prismatic == pytest.approx(2 / 3 + 0.3786075 * a, abs=2e-6)
    for b in (-0.2, 0.1):
        result = shift.shifted([0.0, b])
        assert result.volume / (2.0 * area) == pytest.approx(2 / 3, abs=2e-6)
        assert result.lcb - 1.0 == pytest.approx(0.4 * b, abs=2e-6)


def test_one_target_leaves_the_other_coefficient():
    surface, area, shift = wigley_shift(17)
    assert shift.solve(prismatic=0.68).coefficients[1] == 0.0
    assert shift.solve(lcb=1.01).coefficients[0] == 0.0


def test_monotone_range_of_wigleys_curve():
    _, _, shift = wigley_shift(17)
    for a, is_monotone in ((-0.7188, 1), (-0.7190, 0), (0.3183, 1), (0.3184, 0)):
        assert (shift.least_stretch([a, 0.0], 0.0, 2.0) > 0.0) == is_monotone


def test_prismatic_is_of_the_station_amidships_then():
    surface, _, shift = wigley_shift(33)
    result = shift.solve(prismatic=0.69, lcb=1.05)
    _, body = moved_body(surface, result.moves)
    found = hn.hydrostatics(body, draft=2.0, length_pp=2.0)
    assert found.project.prismatic == pytest.approx(0.69, abs=1e-9)
    assert found.lcb == pytest.approx(1.05, abs=1e-9)


def test_halves_apart_leave_the_other_half():
    surface, area, shift = wigley_shift(33, part="fore")
    result = shift.solve(volume=0.68 * 2.0 * area)
    moves, x = np.abs(result.moves[:, 0]), surface.mesh.points[:, 0]
    # What is left of the bend amidships is halved from each row of control points to the next.
    assert moves[x < 0.7].max() < 3e-4 * moves.max()
    _, _, apart = wigley_shift(33, part="apart")
    result = apart.solve(volume=0.68 * 2.0 * area, lcb=1.01)
    _, body = moved_body(surface, result.moves)
    found = hn.hydrostatics(body, draft=2.0, length_pp=2.0)
    assert found.displaced_volume == pytest.approx(0.68 * 2.0 * area, rel=1e-10)
    assert found.lcb == pytest.approx(1.01, abs=1e-9)
    with pytest.raises(ValueError, match="One half of the body alone"):
        shift.solve(volume=1.0, lcb=1.0)


def test_refusals_tell_the_reachable_range():
    _, area, shift = wigley_shift(17)
    with pytest.raises(ValueError, match="Cp can be ") as refused:
        shift.solve(prismatic=0.95)
    low, high = map(float, re.findall(r"\d\.\d+", str(refused.value)))
    # The end's slope, as sharp as the control points let it be.
    assert low == pytest.approx(2 / 3 - 0.3786075 * 0.7189, abs=5e-3)
    assert high == pytest.approx(2 / 3 + 0.3786075 / np.pi, abs=2e-2)
    for value in (low + 1e-3, high - 1e-3):
        assert shift.solve(prismatic=value).converged
    for value in (low - 1e-3, high + 1e-3):
        with pytest.raises(ValueError, match="Cp can be "):
            shift.solve(prismatic=value)


@pytest.mark.parametrize(
    "how, message",
    [
        ({"part": "middle"}, "part is"),
        ({"length_pp": 0.0}, "Give Lpp"),
        ({"length_pp": np.nan}, "finite numbers"),
        ({"parallel": (1.2, 0.8)}, "aft end first"),
        ({"parallel": (0.9, 1.1), "parallel_wanted": (0.0, 3.0)}, "wanted must lie between"),
        ({"parallel_wanted": (0.8, 1.2)}, "no parallel middle body"),
        ({"kept_ranges": [(1.0, 0.5, 0.1)]}, "from aft forward"),
        ({"kept_ranges": [(0.5, 1.0, 0.0)]}, "fades within"),
        ({"draft": -1.0}, "Nothing of the hull is immersed"),
    ],
)
def test_settings_are_checked(how, message):
    surface, _ = wigley_areas(5)
    body = hn.HullBody(surface, mirrored=True)
    with pytest.raises(ValueError, match=message):
        hn.SectionShift(body, **{"draft": 2.0, "length_pp": 2.0, **how})


def test_a_hull_at_one_x_is_refused():
    # Its volume is rounding, above zero: found by chance, it ended the process.
    corners = [(0, 0), (0, 3), (2, 0), (2, 3)]
    points = [(5.0, *corner) for corner in corners + corners]
    faces = [2, 3, 7, 6, 0, 2, 6, 4, 0, 1, 3, 2, 4, 6, 7, 5]
    creases = [
        (0, 1),
        (0, 2),
        (2, 3),
        (0, 4),
        (4, 5),
        (2, 6),
        (6, 7),
        (5, 7),
        (1, 3),
        (3, 7),
        (4, 6),
    ]
    surface = hn.LimitSurface(hn.ControlMesh(points, [4] * 4, faces, creases))
    for mirrored in (False, True):
        body = hn.HullBody(surface, mirrored=mirrored)
        with pytest.raises(ValueError, match="immersed of the hull has no length|Nothing"):
            hn.SectionShift(body, draft=1.8, length_pp=10.0)


@pytest.mark.parametrize(
    "wanted, message",
    [
        ({"volume": np.nan}, "no number"),
        ({"volume": 1.0, "block": 0.5}, "say the same"),
        ({"block": 0.5}, "Give the beam"),
        ({"volume": 1e30}, "can be"),
        ({"lcb": -1e30}, "LCB can be"),
    ],
)
def test_targets_are_checked(wanted, message):
    _, _, shift = wigley_shift(5)
    with pytest.raises(ValueError, match=message):
        shift.solve(**wanted)


def test_cp_needs_an_area_at_half_the_length():
    surface, _ = wigley_areas(9)
    body = hn.HullBody(surface, mirrored=True)
    shift = hn.SectionShift(body, draft=2.0, length_pp=6.0)
    with pytest.raises(ValueError, match="no area under water at half the Lpp"):
        shift.solve(prismatic=0.6)


def test_kept_ranges_and_locked_points_stay():
    surface, area = wigley_areas(33)
    body = hn.HullBody(surface, mirrored=True)
    x = surface.mesh.points[:, 0]
    locked = np.flatnonzero(x > 1.8)
    shift = hn.SectionShift(
        body,
        draft=2.0,
        length_pp=2.0,
        kept_ranges=[(1.7, 2.0, 0.3)],
        limits=hn.TransformLimits(locked=locked),
    )
    result = shift.solve(volume=0.68 * 2.0 * area, lcb=1.01)
    assert result.converged
    assert (result.moves[locked] == 0.0).all()
    _, body = moved_body(surface, result.moves)
    areas = hn.section_areas(body, np.array([1.75, 1.9, 1.99]), draft=2.0).areas / area
    assert np.abs(areas - (1 - np.array([0.75, 0.9, 0.99]) ** 2)).max() < 1e-4


# A circle, and what is straight


def circle_error(surface, x, radius=5.0):
    curves = hn.sections(surface, [hn.plane_across("x", x)], 1e-6)[0]
    points = np.concatenate([curve.points for curve in curves])
    distances = np.hypot(points[:, 1], points[:, 2] - radius)
    return np.ptp(distances), distances.mean()


def test_inflated_circle_is_one():
    surface = tube(9)
    body = hn.HullBody(surface, mirrored=False)
    before, radius = circle_error(surface, 20.0)
    area = hn.section_areas(body, [20.0], draft=5.0).areas[0]
    for factor in (0.8, 1.0, 1.3):
        result = hn.inflate(body, 20.0, factor * area, draft=5.0)
        assert result.converged
        inflated = hn.LimitSurface(surface.mesh.with_points(surface.mesh.points + result.moves))
        after = hn.HullBody(inflated, mirrored=False)
        found = hn.section_areas(after, [20.0], draft=5.0).areas[0]
        assert found == pytest.approx(factor * area, rel=1e-10)
        error, now = circle_error(inflated, 20.0)
        assert error < 1e-6 * 5.0


# Parallel middle bodies


def ship_shape(stations=25, length=120.0):
    """Half a ship of one outline, narrower towards both ends, with its middle third parallel."""
    x = np.linspace(0.0, length, stations)
    from_middle = np.clip(np.abs(x / length - 0.5) - 1 / 6, 0.0, None) * 3.0
    breadths = np.array([0.0, 4.0, 7.2, 8.0, 8.0, 8.0, 8.2])
    heights = np.array([0.0, 0.0, 0.4, 2.0, 5.0, 8.0, 10.0])
    narrow = 1.0 - 0.9 * from_middle[:, None] ** 2
    points = np.stack(
        [x[:, None] + 0.0 * breadths, narrow * breadths, heights + 0.0 * x[:, None]], axis=-1
    )
    return hn.LimitSurface(grid_mesh(points))


def volume_of(surface, draft=6.0):
    return hn.upright_hydrostatics(surface, draft=draft, mirrored=True).displaced_volume


@pytest.mark.parametrize("length", [10.0, 33.3, -7.0])
def test_parallel_body_inserted_adds_its_area_times_its_length(length):
    surface = ship_shape()
    body = hn.HullBody(surface, mirrored=True)
    aft, forward = hn.parallel_body(body, draft=6.0)
    assert 40.0 <= aft < 60.0 < forward <= 80.0
    result = hn.lengthen(body, 60.0, length, draft=6.0)
    assert result.is_parallel
    before = volume_of(surface)
    after, _ = moved_body(surface, result.moves)
    assert volume_of(after) - before == pytest.approx(result.area * length, abs=1e-9 * before)
    assert result.volume_change == pytest.approx(result.area * length, abs=1e-9 * before)
    x = surface.mesh.points[:, 0]
    assert (result.moves[x < 40.0] == 0.0).all()
    assert (result.moves[x > 80.0, 0] == length).all()
    assert (np.diff(np.unique(x + result.moves[:, 0])) > 0.0).all()


def test_lengthening_refusals():
    surface = ship_shape()
    body = hn.HullBody(surface, mirrored=True)
    last = hn.TransformLimits(locked=[len(surface.mesh.points) - 1])
    for place, length, how, message in (
        (60.0, -60.0, {}, "can be taken out"),
        (10.0, 5.0, {}, "not parallel at x = 10 m"),
        (500.0, 5.0, {}, "no hull on both sides"),
        (60.0, 0.0, {}, "Give a length"),
        (60.0, np.nan, {}, "Give a length"),
        (60.0, 5.0, {"stretched": (80.0, 40.0)}, "from aft forward"),
        (60.0, -30.0, {"stretched": (40.0, 80.0)}, "longer than"),
        (60.0, 5.0, {"limits": last}, "locked"),
        (60.0, 5.0, {"limits": last, "stretched": (40.0, 80.0)}, "locked"),
    ):
        with pytest.raises(ValueError, match=message):
            hn.lengthen(body, place, length, draft=6.0, **how)


def test_stretched_range_moves_ends_as_one():
    surface = ship_shape()
    body = hn.HullBody(surface, mirrored=True)
    result = hn.lengthen(body, 30.0, 6.0, draft=6.0, stretched=(10.0, 50.0))
    x = surface.mesh.points[:, 0]
    assert not result.is_parallel and result.largest < 0.02
    assert (result.moves[x == 0.0] == 0.0).all()
    assert (result.moves[x > 60.0, 0] == 6.0).all()
    after, _ = moved_body(surface, result.moves)
    change = volume_of(after) - volume_of(surface)
    assert result.volume_change == pytest.approx(change, rel=1e-9)
    places = np.linspace(10.0, 50.0, 401)
    areas = hn.section_areas(body, places, draft=6.0).areas
    t = (places - 10.0) / 40.0
    slope = 30.0 * t**2 * (1.0 - t) ** 2 / 40.0  # of the smooth step
    assert change == pytest.approx(6.0 * np.trapz(areas * slope, places), rel=2e-3)


def test_length_of_the_parallel_body():
    surface = ship_shape()
    body = hn.HullBody(surface, mirrored=True)
    where = {"draft": 6.0, "length_pp": 120.0, "beam": 16.4}
    aft, forward = hn.parallel_body(body, draft=6.0)
    before = hn.hydrostatics(body, **where)
    for length in (forward - aft, 30.0, 20.0):
        wanted = (60.0 - length / 2, 60.0 + length / 2)
        shift = hn.SectionShift(body, **where, parallel=(aft, forward), parallel_wanted=wanted)
        result = shift.solve(block=before.project.block, lcb=before.lcb)
        _, now = moved_body(surface, result.moves)
        found = hn.parallel_body(now, draft=6.0)
        # Where exactly it ends the control points say, which follow nearly.
        assert found[1] - found[0] == pytest.approx(length, abs=0.6)
        after = hn.hydrostatics(now, **where)
        assert after.displaced_volume == pytest.approx(before.displaced_volume, rel=1e-9)
        assert after.lcb == pytest.approx(before.lcb, abs=1e-9 * 120.0)


def test_groups_over_the_same_stretch_move_as_one():
    surface, area = wigley_areas(33)
    body = hn.HullBody(surface, mirrored=True)
    points = surface.mesh.points
    # Sections at a quarter of the length: their upper points and their lower ones.
    near = np.abs(points[:, 0] - 0.5) < 0.1
    upper, lower = (
        np.flatnonzero(near & (part > 0)) for part in (points[:, 2] - 1.6, 1.6 - points[:, 2])
    )
    ways = []
    for rigid in ([np.concatenate([upper, lower])], [upper, lower]):
        limits = hn.TransformLimits(rigid=rigid)
        shift = hn.SectionShift(body, draft=2.0, length_pp=2.0, limits=limits)
        ways.append(shift.shifted([0.05, 0.02]))
    one, two = ways
    assert np.ptp(one.moves[upper, 0]) == 0.0
    np.testing.assert_allclose(two.moves, one.moves, atol=1e-12)
    assert two.largest == pytest.approx(one.largest, abs=1e-12)


# Sectional area curves


@pytest.mark.parametrize("by, largest", [("shift", 0.012), ("inflate", 0.03)])
def test_another_area_curve(by, largest):
    surface, area = wigley_areas(33)
    body = hn.HullBody(surface, mirrored=True)
    x = np.linspace(0.0, 2.0, 41)
    wanted = area * np.clip(1 - np.abs(x - 1.03) ** 2.2, 0.0, None)
    result = hn.match_areas(body, x, wanted, draft=2.0, by=by, tolerance=1e-4)
    assert result.difference_before > 0.05
    assert result.difference < largest
    _, now = moved_body(surface, result.moves)
    compared = np.linspace(0.01, 1.99, 121)
    found = hn.section_areas(now, compared, draft=2.0).areas
    target = hn.target_area_curve(x, wanted, compared)
    assert np.abs(found - target).max() / area <= result.difference + 2e-3
    found = hn.hydrostatics(now, draft=2.0)
    assert result.volume == pytest.approx(found.displaced_volume, rel=1e-12)


def test_shifts_compare_areas_in_parts_of_the_largest():
    surface, area = wigley_areas(33)
    body = hn.HullBody(surface, mirrored=True)
    x = np.linspace(0.0, 2.0, 41)
    wanted = area * np.clip(1 - np.abs(x - 1.03) ** 2.2, 0.0, None)
    own, twice = (hn.match_areas(body, x, k * wanted, draft=2.0, tolerance=0.02) for k in (1, 2))
    assert own.converged and twice.converged
    assert twice.difference_before == own.difference_before
    assert twice.difference == own.difference
    assert np.array_equal(twice.moves, own.moves)


def test_a_jump_of_areas_does_not_end_the_search():
    """At the naval vessel's transom the largest difference stands, and all others fall."""
    sample = Sample("naval_vessel")
    points = sample.surface.mesh.points
    x = np.linspace(points[:, 0].min(), points[:, 0].max(), 161)
    areas = hn.section_areas(sample.body, x, draft=sample.ship.draft).areas
    x, areas = x[areas > 0.0], areas[areas > 0.0]
    along = (x - x[0]) / (x[-1] - x[0])
    wanted = areas * (1.0 + 0.12 * np.sin(np.pi * along) ** 2 * (along - 0.5))
    result = hn.match_areas(
        sample.body, x, wanted, draft=sample.ship.draft, by="shift", tolerance=1e-4
    )
    _, now = moved_body(sample.surface, result.moves)
    found = hn.section_areas(now, x, draft=sample.ship.draft).areas
    before, after = (np.sqrt(np.mean((one - wanted) ** 2)) for one in (areas, found))
    assert after < 0.7 * before


def test_target_curves_rise_and_fall_as_their_points():
    x, areas = [0.0, 1.0, 2.0, 5.0, 6.0], [0.0, 8.0, 10.0, 10.0, 0.0]
    curve = hn.target_area_curve(x, areas, np.linspace(0.0, 6.0, 601))
    assert (np.diff(curve[:200]) >= 0.0).all() and (np.diff(curve[500:]) <= 0.0).all()
    assert curve.max() == pytest.approx(10.0, rel=1e-14)
    assert hn.target_area_curve(x, areas, [-1.0, 7.0]).tolist() == [0.0, 0.0]
    for bad_x, bad_areas, message in (
        ([0.0, 1.0], [0.0, 1.0], "three points"),
        ([0.0, 1.0, 1.0], [0.0, 1.0, 0.0], "must rise"),
        ([0.0, 1.0, 2.0], [0.0, -1.0, 0.0], "Point 2"),
        ([0.0, 1.0, 2.0], [0.0, np.nan, 0.0], "Point 2"),
        ([0.0, 1.0, 2.0], [0.0, 0.0, 0.0], "no area at all"),
    ):
        with pytest.raises(ValueError, match=message):
            hn.target_area_curve(bad_x, bad_areas, [0.0])


# All samples


def changes(name):
    """(change of Cb, of LCB in parts of Lpp): two for each, all where there is time."""
    found = [(c, x) for c in (-0.02, 0.0, 0.02) for x in (-0.01, 0.0, 0.01) if c or x]
    return found if IS_LONG else [found[SAMPLES.index(name) % len(found)], (0.01, 0.0)]


def knuckles(surface):
    """The mean angle, rad, of each crease that is no border; NaN for a border."""
    found = []
    for index in range(len(hn.crease_curves(surface))):
        try:
            found.append(hn.knuckle_angles(surface, index, samples_per_edge=2).mean)
        except ValueError:
            found.append(np.nan)
    return np.array(found)


@pytest.mark.parametrize("name", SAMPLES)
def test_samples_reach_what_is_wanted_or_tell_what_can_be(name):
    sample = Sample(name)
    length, where = sample.ship.length_pp, sample.where()
    before = hn.hydrostatics(sample.body, **where)
    shift = hn.SectionShift(sample.body, limits=sample.limits(), **where)
    angles = knuckles(sample.surface)
    for block_change, lcb_change in changes(name):
        block = before.project.block + block_change
        lcb = before.lcb + lcb_change * length
        try:
            result = shift.solve(block=block, lcb=lcb)
        except ValueError as refused:
            assert re.search(r"(Cb|LCB) can be [\d.e+-]+( m)? to [\d.e+-]+", str(refused))
            continue
        assert result.converged
        surface, body = sample.moved(result.moves)
        after = hn.hydrostatics(body, **where)
        assert after.project.block == pytest.approx(block, abs=1e-9)
        assert after.lcb == pytest.approx(lcb, abs=1e-9 * length)
        points = surface.mesh.points
        for flat, normal in sample.flats:
            assert np.ptp(points[flat] @ normal) <= 1e-12 * length
        # Points keep their breadths and heights, so what was parallel is so.
        assert (result.moves[:, 1:] == 0.0).all()
        for group in hn.plane_ends(sample.surface):
            assert np.ptp(result.moves[group, 0]) == 0.0
        # Creases are creases still, to the same side: slopes beside them change as sections shift.
        now = knuckles(surface)
        assert np.array_equal(np.isnan(now), np.isnan(angles))
        sharp = np.abs(angles) > np.radians(2.0)
        assert (now[sharp] / angles[sharp] > 0.5).all()
