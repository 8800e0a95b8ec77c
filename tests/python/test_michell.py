# SPDX-License-Identifier: GPL-3.0-or-later
"""Michell's integral on exact surfaces: Wigley's hull (1942) by its closed form, scaling,
derivatives by differences, the spectrum's energy; and the ITTC 1957 line."""

import math

import hull_native as hn
import numpy as np
import pytest
from transformation_hulls import Sample, grid_mesh

LENGTH, BEAM, DRAFT = 10.0, 1.0, 0.625
NODES, WEIGHTS = np.polynomial.legendre.leggauss(16)


def simpson(values, step):
    """The integral by an odd count of values."""
    return (
        step
        / 3.0
        * (values[0] + values[-1] + 4.0 * values[1::2].sum() + 2.0 * values[2:-1:2].sum())
    )


def speed_at(froude, length=LENGTH):
    return froude * math.sqrt(hn.GRAVITY * length)


def control_values(values):
    """Of the cubic B-spline through values, straight at its ends as surfaces are across borders."""
    count = len(values)
    rows = np.eye(count)
    for i in range(1, count - 1):
        rows[i, i - 1 : i + 2] = 1 / 6, 4 / 6, 1 / 6
    return np.linalg.solve(rows, values)


def wigley(stations, waterlines, beam=BEAM):
    """LimitSurface near Wigley's y = B/2 (1 - 4 x²/L²) (1 - z²/T²), afloat at z = 0: its nodes lie
    on it, close to one another at the ends, where its waterlines are not quite parabolas."""
    t = np.linspace(-1.0, 1.0, stations)
    x = LENGTH / 2 * (0.97 * np.sin(math.pi / 2 * t) + 0.03 * t)
    t = np.linspace(0.0, 1.0, waterlines)
    z = 1.3 * DRAFT * t**2 * (1.6 - 0.6 * t) - DRAFT
    along = control_values(1.0 - (2.0 * x / LENGTH) ** 2)
    down = control_values(1.0 - (z / DRAFT) ** 2)
    y = beam / 2 * along[:, None] * down
    shape = y.shape
    points = [np.broadcast_to(control_values(x)[:, None], shape), y]
    points.append(np.broadcast_to(control_values(z), shape))
    return hn.LimitSurface(grid_mesh(np.stack(points, axis=-1)))


def wigley_resistance(speed, density=hn.SEA_WATER_DENSITY):
    """Michell's integral of Wigley's hull: the inner double integral in closed form, the outer one
    by Gauss's rule on short intervals up to waves of λ = 2000."""
    nu = hn.GRAVITY / speed**2
    ends = np.concatenate([np.linspace(1, 200, 200 * int(nu * LENGTH / 6 + 4)), [400, 2000]])
    ends = np.arccosh(ends)
    half = 0.5 * np.diff(ends)[:, None]
    wave = np.cosh(ends[:-1, None] + half * (1.0 + NODES))
    k, decay, a = nu * wave, nu * wave**2, LENGTH / 2
    along = -8 * BEAM / LENGTH**2 * (np.sin(k * a) / k**2 - a * np.cos(k * a) / k)
    bottom = np.exp(-decay * DRAFT)
    square = 2 / decay**3 - bottom * (
        DRAFT**2 / decay + 2 * DRAFT / decay**2 + 2 / decay**3
    )
    down = (1 - bottom) / decay - square / DRAFT**2
    total = np.sum(half * WEIGHTS * (along * down * wave) ** 2)
    return 4 * density * hn.GRAVITY**2 / (math.pi * speed**2) * total


def resistances(surface, speeds, mirrored=True, draft=0.0, **how):
    body = hn.HullBody(surface, mirrored=mirrored)
    results = hn.MichellIntegral(body, draft=draft, **how).resistance(speeds)
    return np.array([result.resistance for result in results])


def test_wigley_hull():
    speeds = [speed_at(froude) for froude in (0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.5, 0.6)]
    found = resistances(wigley(111, 31), speeds, tolerance=2e-7)
    wanted = np.array([wigley_resistance(speed) for speed in speeds])
    np.testing.assert_allclose(found, wanted, rtol=1e-6)


def test_error_is_a_bound():
    surface = wigley(31, 13)
    speeds = [speed_at(0.2), speed_at(0.4)]
    body = hn.HullBody(surface, mirrored=True)
    exact = hn.MichellIntegral(body, draft=0.0, tolerance=1e-6).resistance(speeds)
    for coarse, fine in zip(hn.MichellIntegral(body, draft=0.0).resistance(speeds), exact):
        assert 0.0 < fine.resistance - coarse.resistance < coarse.error < 1e-3 * fine.resistance
        assert coarse.shortest < fine.shortest


def test_quadratic_in_beam():
    speeds = [speed_at(0.2), speed_at(0.35)]
    slim, broad = (resistances(wigley(21, 9, beam), speeds) for beam in (1.0, 1.7))
    np.testing.assert_allclose(broad / slim, 1.7**2, rtol=1e-9)


def test_speeds_do_not_see_each_other():
    surface = wigley(21, 9)
    speeds = [speed_at(froude) for froude in (0.2, 0.3, 0.45)]
    alone = [resistances(surface, [speed])[0] for speed in speeds]
    np.testing.assert_allclose(resistances(surface, speeds), alone, rtol=1e-8)


def test_whole_hull_is_its_half_twice():
    points = wigley(21, 9).mesh.points.reshape(21, 9, 3)
    starboard = points[:, ::-1] * [1.0, -1.0, 1.0]
    whole = hn.LimitSurface(grid_mesh(np.concatenate([starboard[:, :-1], points], axis=1)))
    # Smooth across the keel, where the half is straight: the same half, then, with a crease.
    edges = np.stack([np.arange(20) * 17 + 8, np.arange(1, 21) * 17 + 8], axis=1)
    mesh = hn.ControlMesh(whole.mesh.points, whole.mesh.face_sizes, whole.mesh.face_vertices, edges)
    speed = [speed_at(0.3)]
    half = resistances(wigley(21, 9), speed)
    np.testing.assert_allclose(
        resistances(hn.LimitSurface(mesh), speed, mirrored=False), half, rtol=1e-9
    )


@pytest.mark.parametrize("name, froude", [("container_ship", 0.25), ("sailing_yacht", 0.35)])
def test_gradient_by_differences(name, froude):
    hull = Sample(name)
    points, draft = hull.mesh.points.copy(), hull.ship.draft
    speed = speed_at(froude, hull.ship.length_pp)
    moves = np.random.default_rng(25).normal(size=points.shape)
    if hull.half:
        moves[np.abs(points[:, 1]) <= hn.tolerances.ON_CENTRE_PLANE * hull.mesh.size, 1] = 0.0

    def integral(step):
        hull.surface.set_points(points + step * moves)
        hull.body.update()
        return hn.MichellIntegral(hull.body, draft=draft)

    gradient = integral(0.0).gradient(hn.BodyDerivatives(hull.body), speed)
    step = 1e-6 * hull.mesh.size
    ahead, back = (integral(s).resistance([speed])[0].resistance for s in (step, -step))
    assert np.sum(gradient * moves) == pytest.approx((ahead - back) / (2 * step), rel=1e-6)


@pytest.mark.parametrize("draft", [0.25, 0.5])
def test_gradient_where_a_row_of_points_lies_on_the_water(draft):
    x, z = np.linspace(0.0, LENGTH, 13), np.linspace(0.0, 1.0, 5)
    y = BEAM / 2 * np.sin(math.pi * x / LENGTH)[:, None] * (z / z[-1]) ** 0.4
    points = np.stack(np.broadcast_arrays(x[:, None], y, z), axis=-1)
    surface = hn.LimitSurface(grid_mesh(points))
    body = hn.HullBody(surface, mirrored=True)
    points, speed = surface.mesh.points.copy(), speed_at(0.3)
    moves = np.random.default_rng(27).normal(size=points.shape)
    moves[points[:, 1] == 0.0, 1] = 0.0

    def integral(step):
        surface.set_points(points + step * moves)
        body.update()
        return hn.MichellIntegral(body, draft=draft)

    step = 1e-6 * surface.mesh.size
    gradient = integral(0.0).gradient(hn.BodyDerivatives(body), speed)
    ahead, back = (integral(s).resistance([speed])[0].resistance for s in (step, -step))
    assert np.sum(gradient * moves) == pytest.approx((ahead - back) / (2 * step), rel=1e-6)


def test_spectrum_has_the_energy():
    speed = speed_at(0.3)
    integral = hn.MichellIntegral(hn.HullBody(wigley(21, 9), mirrored=True), draft=0.0)
    ends = np.linspace(0.0, math.radians(85.0), 41)
    half = 0.5 * np.diff(ends)[:, None]
    angles = ends[:-1, None] + half * (1.0 + NODES)
    amplitudes = integral.amplitudes(speed, angles.ravel()).reshape(angles.shape)
    energy = 2.0 * np.sum(half * WEIGHTS * np.abs(amplitudes) ** 2 * np.cos(angles) ** 3)
    result = integral.resistance([speed])[0]
    found = math.pi / 2 * hn.SEA_WATER_DENSITY * speed**2 * energy
    assert found == pytest.approx(result.resistance, abs=result.error)


def test_wave_pattern():
    """By another quadrature; level lines behind the stern are transverse waves of 2π/ν."""
    speed = speed_at(0.4)
    nu = hn.GRAVITY / speed**2
    integral = hn.MichellIntegral(hn.HullBody(wigley(21, 9), mirrored=True), draft=0.0)
    points = np.array([[-25.0, 0.0], [-30.0, 5.0], [-30.0, -5.0]])
    steepest = math.radians(70.0)
    found = hn.wave_heights(integral, speed, points, gravity=hn.GRAVITY, steepest=steepest)
    angles = np.linspace(-steepest, steepest, 20001)
    amplitudes = integral.amplitudes(speed, angles)
    for (x, y), height in zip(points, found):
        phase = nu * (x * np.cos(angles) + y * np.sin(angles)) / np.cos(angles) ** 2
        waves = (amplitudes * np.exp(-1j * phase)).real
        assert height == pytest.approx(simpson(waves, angles[1] - angles[0]), rel=1e-6)
    assert found[1] == pytest.approx(found[2], rel=1e-12)
    x = np.linspace(-60.0, -40.0, 401)
    track = np.stack([x, np.zeros_like(x)], axis=1)
    heights = hn.wave_heights(integral, speed, track, gravity=hn.GRAVITY, steepest=0.3)
    zeros = x[1:][heights[1:] * heights[:-1] < 0.0]
    assert np.diff(zeros).mean() == pytest.approx(math.pi / nu, rel=0.03)
    with pytest.raises(ValueError, match="shape"):
        hn.wave_heights(integral, speed, [1.0, 2.0], gravity=hn.GRAVITY)
    with pytest.raises(ValueError, match="speed must be a number above zero"):
        hn.wave_heights(integral, 0.0, points, gravity=hn.GRAVITY)
    with pytest.raises(ValueError, match="too far away"):
        hn.wave_heights(integral, speed, [[-1e6, 0.0]], gravity=hn.GRAVITY)


def test_wave_field_is_wave_heights():
    speed, how = speed_at(0.35), {"gravity": hn.GRAVITY, "steepest": math.radians(65.0)}
    integral = hn.MichellIntegral(hn.HullBody(wigley(11, 7), mirrored=True), draft=0.0)
    x, y = np.linspace(-40.0, -10.0, 7), np.array([-6.0, 0.0, 2.5])
    field = hn.wave_field(integral, speed, x, y, **how)
    points = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    heights = hn.wave_heights(integral, speed, points, **how).reshape(3, 7)
    # Other nodes: their quadrature is told by the farthest point.
    np.testing.assert_allclose(field, heights, rtol=0.0, atol=1e-12 * np.abs(heights).max())
    with pytest.raises(ValueError, match="of one row each"):
        hn.wave_field(integral, speed, points, y, **how)


def test_waves_behind_fill_kelvin_s_wedge():
    """And are those of the formula for points; waves too short for the cuts are left out."""
    speed, how = speed_at(0.35), {"gravity": hn.GRAVITY}
    integral = hn.MichellIntegral(hn.HullBody(wigley(11, 7), mirrored=True), draft=0.0)
    found = hn.waves_behind(integral, speed, stern=-LENGTH / 2, **how)
    wave = 2.0 * math.pi * speed**2 / hn.GRAVITY
    assert found.x[0] == pytest.approx(wave / 2) and found.x[-1] == pytest.approx(3 * LENGTH)
    points = [[-LENGTH / 2 - found.x[i], found.y[j]] for i, j in ((0, 0), (150, 5), (300, 15))]
    heights = hn.wave_heights(integral, speed, points, steepest=found.steepest, **how)
    scale = np.abs(found.heights).max()
    at = [found.heights[j, i] for i, j in ((0, 0), (150, 5), (300, 15))]
    np.testing.assert_allclose(at, heights, rtol=0.0, atol=1e-9 * scale)
    # Of a wave of the steepest direction crests are two spacings from one another across.
    crests = wave * math.cos(found.steepest) ** 2 / math.sin(found.steepest)
    assert crests == pytest.approx(2.0 * found.y[1])
    slope = math.tan(math.radians(19.4712))
    for x, column in list(zip(found.x, found.heights.T))[100:151:50]:
        beyond = found.y > 1.3 * slope * (x + LENGTH)
        assert np.abs(column[beyond]).max() < 0.05 * np.abs(column).max()
    fast = hn.waves_behind(integral, speed_at(1.0), stern=-LENGTH / 2, **how)
    assert fast.x[-1] == pytest.approx(6.0 * math.pi * LENGTH)  # three waves


def test_resistance_by_direction_sums_up():
    speed, directions = speed_at(0.3), np.radians(np.linspace(0.0, 86.0, 4301))
    integral = hn.MichellIntegral(hn.HullBody(wigley(21, 9), mirrored=True), draft=0.0)
    amplitudes = integral.amplitudes(speed, directions)
    how = {"speed": speed, "water_density": hn.SEA_WATER_DENSITY}
    power = hn.resistance_by_direction(amplitudes, directions, **how)
    total = simpson(power, directions[1])
    (found,) = integral.resistance([speed])
    assert total == pytest.approx(found.resistance, rel=1e-3)
    transverse = simpson(power[:1763], directions[1])  # 35.24°
    share = hn.transverse_share(np.degrees(directions), power)
    assert share == pytest.approx(transverse / total, abs=2e-3)
    plot = hn.wave_spectrum_plot(np.degrees(directions), np.radians(power))
    assert plot.curve_names == ["Wave resistance"]
    with pytest.raises(ValueError, match="must rise"):
        hn.wave_spectrum_plot([1.0, 0.0], [1.0, 1.0])
    with pytest.raises(ValueError, match="one length"):
        hn.wave_spectrum_plot([1.0, 2.0], [1.0])


def test_plot_of_a_pattern():
    x, y = np.linspace(10.0, 50.0, 5), np.array([0.0, 4.0])
    heights = np.array([[0.0, 0.3, 0.0, -0.3, 0.0], [0.1, 0.0, -0.1, 0.0, 0.1]])
    plot = hn.wave_pattern_plot(x, y, heights)
    assert len(plot.curve_names) == 3  # the track once, the cut beside it to both sides
    # 0.3 m reach over three cuts of 4 m at most: 40 times, and 20 is the round number below.
    assert plot.subtitles == ["heights 20 times as large"]
    assert hn.lay_out_plot(plot, width_mm=150.0, height_mm=100.0).strokes
    assert hn.wave_pattern_plot(x, y, 0.0 * heights)
    with pytest.raises(ValueError, match="shape"):
        hn.wave_pattern_plot(x, y, heights.T)


def test_ends_make_the_phase():
    """Moved along, a hull's amplitudes turn as its waves do."""
    speed, angle = speed_at(0.3), 0.4
    surface = wigley(21, 9)
    body = hn.HullBody(surface, mirrored=True)
    before = hn.MichellIntegral(body, draft=0.0).amplitudes(speed, [angle])[0]
    surface.set_points(surface.mesh.points + [0.7, 0.0, 0.0])
    body.update()
    after = hn.MichellIntegral(body, draft=0.0).amplitudes(speed, [angle])[0]
    phase = hn.GRAVITY / speed**2 / math.cos(angle) * 0.7
    assert after / before == pytest.approx(complex(math.cos(phase), math.sin(phase)), abs=1e-8)


@pytest.mark.parametrize(
    "how, said",
    [
        ({"draft": -1.0}, "out of the water"),
        ({"draft": math.nan}, "draft"),
        ({"draft": 0.0, "tolerance": 0.0}, "tolerance"),
        ({"draft": 0.0, "gravity": -1.0}, "gravity"),
        ({"draft": 0.0, "water_density": 0.0}, "density"),
    ],
)
def test_bad_water(how, said):
    with pytest.raises(ValueError, match=said):
        hn.MichellIntegral(hn.HullBody(wigley(11, 7), mirrored=True), **how)


def test_catamarans_are_refused():
    hull = Sample("catamaran")
    with pytest.raises(ValueError, match="beside the centre plane"):
        hn.MichellIntegral(hull.body, draft=hull.ship.draft)


@pytest.mark.parametrize("speed", [0.0, -3.0, math.nan, math.inf, 0.1, 500.0])
def test_bad_speeds(speed):
    integral = hn.MichellIntegral(hn.HullBody(wigley(11, 7), mirrored=True), draft=0.0)
    with pytest.raises(ValueError, match="no speed for Michell's integral"):
        integral.resistance([5.0, speed])
    with pytest.raises(ValueError, match="within 89°"):
        integral.amplitudes(5.0, [1.56])


def test_ittc_line():
    for number in (2e5, 1e6, 8.8e8, 2.5e9):
        expected = 0.075 / (math.log(number) / math.log(10.0) - 2.0) ** 2
        assert hn.ittc_1957(number) == pytest.approx(expected, rel=1e-12)
    for number in (0.0, 100.0, -1.0, math.nan, math.inf):
        with pytest.raises(ValueError, match="Reynolds number"):
            hn.ittc_1957(number)
