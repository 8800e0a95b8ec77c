# SPDX-License-Identifier: GPL-3.0-or-later
"""Combs, inflections, colours, reflections and flats, against closed forms and differences."""

import hull_native as hn
import numpy as np
import pytest
from height_fields import SIDE, grid


def turned(mesh, rotation):
    return hn.ControlMesh(
        mesh.points @ rotation.T, mesh.face_sizes, mesh.face_vertices, mesh.creases
    )


def rotation(seed):
    q, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    return q * np.sign(np.linalg.det(q))


def ring(radius, n=16, rows=6, height=1.0):
    """A tube about z with its faces turned outwards; n control points around."""
    angle = 2 * np.pi * np.arange(n) / n
    points = np.concatenate(
        [
            np.stack([radius * np.cos(angle), radius * np.sin(angle), 0 * angle + z], axis=1)
            for z in np.arange(rows + 1) * height
        ]
    )
    k = np.arange(n)
    faces = [
        np.stack([j * n + k, j * n + (k + 1) % n, (j + 1) * n + (k + 1) % n, (j + 1) * n + k], 1)
        for j in range(rows)
    ]
    faces = np.concatenate(faces)
    return hn.ControlMesh(points, np.full(len(faces), 4), faces.ravel())


# ---------------------------------------------------------------------------------------- curves


def test_comb_of_a_cubic():
    """Cubic B-splines reproduce x^3 up to a linear part: z = a x^3 + b x, b = a of x^3's control
    points; curvature z'' / (1 + z'^2)^1.5."""
    a = 0.02
    surface = hn.LimitSurface(grid(lambda x, y: a * x**3))
    (curve,) = hn.section_fairness(surface, [[0, 1, 0, 0.25]], count=101)[0]
    inner = np.abs(curve.points[:, 0]) < SIDE / 2 - 1
    x, z = curve.points[inner, 0], curve.points[inner, 2]
    np.testing.assert_allclose(z, a * (x**3 + x), atol=1e-13)
    slope = a * (3 * x**2 + 1)
    expected = 6 * a * x / (1 + slope**2) ** 1.5
    # It runs with z above on the left, seen against the normal (0, 1, 0), whichever way that is.
    sign = np.sign(curve.tangents[inner, 0]) * -1
    np.testing.assert_allclose(curve.curvatures[inner], sign * expected, atol=1e-12)
    # The vector points to the centre of curvature: up where the cubic is hollow above.
    bent = np.abs(x) > 1e-6
    assert (np.sign(curve.curvature_vectors[inner, 2]) == np.sign(x))[bent].all()
    np.testing.assert_allclose(
        np.linalg.norm(curve.curvature_vectors, axis=1), np.abs(curve.curvatures), atol=1e-14
    )
    lines = curve.comb(scale=2.0)
    assert lines.shape == (101 + 100, 2, 3)
    np.testing.assert_array_equal(lines[:101, 0], curve.points)
    np.testing.assert_allclose(lines[:101, 1], curve.points - 2 * curve.curvature_vectors)
    np.testing.assert_array_equal(lines[101:, 0], lines[:100, 1])
    np.testing.assert_array_equal(lines[101:, 1], lines[1:101, 1])


def test_inflection_and_extrema_of_a_cubic():
    a = 0.02
    surface = hn.LimitSurface(grid(lambda x, y: a * (x - 0.3) ** 3))
    (curve,) = hn.section_fairness(surface, [[0, 1, 0, 0.25]])[0]
    marks = curve.marks
    assert sorted(marks.kinds) == ["inflection", "maximum", "minimum"]
    assert curve.inflection_count == 1 and curve.extremum_count == 2
    at = marks.kinds.index("inflection")
    assert abs(marks.points[at, 0] - 0.3) < 1e-9
    assert marks.values[at] == 0.0 and not marks.peaks[at]
    others = np.delete(np.arange(3), at)
    assert marks.peaks[others].all()
    # Where the derivative of 6 a x / (1 + (a (3 x^2 + 1))^2)^1.5 vanishes, by a fine search.
    x = np.linspace(0.0, SIDE / 2 - 1.3, 2_000_001)
    k = 6 * a * x / (1 + (a * (3 * x**2 + 1)) ** 2) ** 1.5
    inside = np.abs(np.abs(marks.points[others, 0] - 0.3) - x[k.argmax()]) < 1e-4
    assert inside.any()
    np.testing.assert_allclose(np.abs(marks.values[others][inside]), k.max(), rtol=1e-9)


@pytest.mark.parametrize("tolerance", [1e-2, 1e-5, 1e-7])
def test_samples_do_not_depend_on_the_sections_own(tolerance):
    surface = hn.LimitSurface(grid(lambda x, y: 0.3 * np.sin(x) + 0.2 * np.cos(0.7 * y + x)))
    plane = [[0.6, 0.8, 0, 0.1]]
    (fine,) = hn.section_fairness(surface, plane, count=64, chord_tolerance=1e-8)[0]
    (curve,) = hn.section_fairness(surface, plane, count=64, chord_tolerance=tolerance)[0]
    assert np.abs(curve.points @ [0.6, 0.8, 0] - 0.1).max() < 1e-13
    assert hn.SurfaceTree(surface).closest_points(curve.points).distances.max() < 1e-12
    # Arc lengths are those of cubics through the points.
    assert np.linalg.norm(curve.points - fine.points, axis=1).max() < 1e-5
    assert curve.marks.kinds == fine.marks.kinds
    np.testing.assert_allclose(curve.marks.points, fine.marks.points, atol=1e-5)
    np.testing.assert_allclose(curve.marks.values, fine.marks.values, atol=1e-9)


def test_curvature_of_samples_by_differences():
    surface = hn.LimitSurface(grid(lambda x, y: 0.3 * np.sin(x) + 0.2 * np.cos(0.7 * y + x)))
    (curve,) = hn.section_fairness(surface, [[0.6, 0.8, 0, 0.1]], count=4001)[0]
    p, h = curve.points, curve.length / 4000
    second = (p[2:] - 2 * p[1:-1] + p[:-2]) / h**2
    assert np.abs(second - curve.curvature_vectors[1:-1]).max() < 1e-2
    assert np.median(np.abs(second - curve.curvature_vectors[1:-1])) < 1e-4
    first = (p[2:] - p[:-2]) / (2 * h)
    assert np.abs(first - curve.tangents[1:-1]).max() < 1e-4


def test_curves_turn_with_the_surface():
    mesh = grid(lambda x, y: 0.3 * np.sin(x) + 0.2 * np.cos(0.7 * y + x), creases=[(38, 39)])
    (before,) = hn.section_fairness(hn.LimitSurface(mesh), [[0.6, 0.8, 0, 0.1]], count=40)[0]
    r = rotation(3)
    (after,) = hn.section_fairness(
        hn.LimitSurface(turned(mesh, r)), [[*(r @ [0.6, 0.8, 0]), 0.1]], count=40
    )[0]
    np.testing.assert_allclose(after.points, before.points @ r.T, atol=1e-6)
    np.testing.assert_allclose(after.curvatures, before.curvatures, atol=1e-5)
    assert after.marks.kinds == before.marks.kinds
    np.testing.assert_allclose(after.marks.points, before.marks.points @ r.T, atol=1e-5)


def test_round_sections_are_closed_and_have_no_inflections():
    surface = hn.LimitSurface(ring(3.0))
    (curve,) = hn.section_fairness(surface, [[0, 0, 1, 2.6]], count=65, relative_noise=0.1)[0]
    assert curve.closed and curve.inflection_count == 0 and curve.extremum_count == 0
    np.testing.assert_allclose(curve.points[0], curve.points[-1], atol=1e-12)
    # A convex body has positive curvature.
    assert curve.curvatures.min() > 0.3
    radius = np.linalg.norm(curve.points[:, :2], axis=1).mean()
    assert abs(curve.length - 2 * np.pi * radius) < 1e-3
    (finer,) = hn.section_fairness(surface, [[0, 0, 1, 2.6]], relative_noise=0.0, noise=1e-9)[0]
    # The uniform cubic spline of 16 points on a circle: a maximum and a minimum a point.
    assert finer.inflection_count == 0 and finer.extremum_count == 32
    assert finer.marks.kinds.count("maximum") == 16 and finer.marks.peaks.sum() == 16


def test_curves_without_marks():
    surface = hn.LimitSurface(grid(lambda x, y: 0.02 * x**3))
    for curves in (
        hn.section_fairness(surface, [[0, 1, 0, 0.25]], marks=False)[0],
        hn.feature_fairness(surface, marks=False),
    ):
        assert curves and all(len(c.marks) == 0 and len(c.points) > 10 for c in curves)


def test_straight_and_trembling_lines_have_no_marks():
    random = np.random.default_rng(5)
    noise = 1e-9 * random.normal(size=(SIDE + 1, SIDE + 1))
    for height in (lambda x, y: 0.4 * x, lambda x, y: 0.4 * x + noise):
        surface = hn.LimitSurface(grid(height))
        for curves in hn.section_fairness(surface, [[0, 1, 0, 0.3], [1, 0, 0, -1.1]]):
            for curve in curves:
                assert len(curve.marks) == 0
                assert np.abs(curve.curvatures).max() < 1e-6


def test_one_bump_is_found_where_it_is():
    """A fair tube with one control point out of line."""
    fair, n = ring(3.0, n=24, rows=10), 24
    points = fair.points.copy()
    bumped = 5 * n + 7
    points[bumped] *= [1.03, 1.03, 1.0]
    mesh = hn.ControlMesh(points, fair.face_sizes, fair.face_vertices)
    planes = [[0, 0, 1, z] for z in (1.5, 5.0, 8.5)]
    options = {"relative_noise": 0.05}
    before = [c[0] for c in hn.section_fairness(hn.LimitSurface(fair), planes, **options)]
    after = [c[0] for c in hn.section_fairness(hn.LimitSurface(mesh), planes, **options)]
    assert [c.extremum_count for c in before] == [0, 0, 0]
    assert [c.extremum_count > 0 for c in after] == [False, True, False]
    assert [c.inflection_count for c in after][::2] == [0, 0]
    peak = after[1].marks.points[np.abs(after[1].marks.values).argmax()]
    assert np.linalg.norm(peak - points[bumped]) < 0.5
    # The colours tell it, too: what has changed most is beside it.
    tess = hn.LimitSurface(mesh).tessellate(6)
    now = hn.surface_field(hn.LimitSurface(mesh), tess, kind="mean")
    was = hn.surface_field(hn.LimitSurface(fair), tess, kind="mean")
    places = tess.normal_cells, tess.normal_uv
    worst = hn.LimitSurface(mesh).positions(*places)[np.abs(now - was).argmax()]
    assert np.linalg.norm(worst - points[bumped]) < 0.7
    # So do reflection lines: away from the bump they are where they were.
    light = dict(
        line_direction=(0, 0, 1), light_direction=(1, 0, 0), spacing=0.2, eye_direction=(1, 1, 0.3)
    )
    moved = hn.reflection_field(tess, **light) - hn.reflection_field(
        hn.LimitSurface(fair).tessellate(6), **light
    )
    far = np.linalg.norm(hn.LimitSurface(mesh).positions(*places) - points[bumped], axis=1) > 2.5
    assert np.nanmax(np.abs(moved[far])) < 1e-9 and np.nanmax(np.abs(moved[~far])) > 0.1


def test_features_in_plan_and_profile():
    mesh = grid(lambda x, y: 0.05 * x**2 + 0.02 * y**3)
    surface = hn.LimitSurface(mesh)
    crease = hn.crease_curves(surface)
    judged = hn.feature_fairness(surface, count=20)
    assert [c.kind for c in judged] == [c.kind for c in crease]
    for curve, exact in zip(judged, crease):
        assert (curve.vertices == exact.vertices).all()
        # Borders lie in planes x or y = constant: z'' / (1 + z'^2)^1.5 by differences of t.
        t = np.linspace(0, exact.edge_count, 200_001)
        p = exact.evaluate(t)[0]
        assert abs(np.linalg.norm(np.diff(p, axis=0), axis=1).sum() - curve.length) < 1e-8
        assert np.abs(curve.points[[0, -1]] - p[[0, -1]]).max() < 1e-12
        # Seen from above all are straight.
    for curve in hn.feature_fairness(surface, direction=(0, 0, 5)):
        assert np.abs(curve.curvatures).max() < 1e-12 and len(curve.marks) == 0
    along_y = [c for c in judged if np.ptp(c.points[:, 0]) < 1e-9]
    assert len(along_y) == 2 and all(c.inflection_count == 1 for c in along_y)
    for curve in along_y:
        at = curve.marks.kinds.index("inflection")
        assert abs(curve.marks.points[at, 1]) < 1e-8


@pytest.mark.parametrize("apart", [0.0, 1e-200, 1e-160, 1e-100, 1e-20, 1e-14])
def test_borders_have_curvature_where_control_points_bunch_up(apart):
    mesh = grid(lambda x, y: 0.1 * y * y)
    points = np.array(mesh.points)
    (border,) = [
        np.asarray(c.vertices)
        for c in hn.crease_curves(hn.LimitSurface(mesh))
        if (points[np.asarray(c.vertices), 0] == points[:, 0].min()).all()
    ]
    # The first two are one, but for so much.
    points -= points[border[0]]
    points[border[1]] = (0.0, 0.0, apart)
    for direction in (None, (1.0, 0.0, 0.0)):
        curves = hn.feature_fairness(
            hn.LimitSurface(mesh.with_points(points)), step=0.05, marks=False, direction=direction
        )
        for curve in curves:
            for values in (curve.points, curve.arc_lengths, curve.curvatures):
                assert np.isfinite(values).all()
            assert np.abs(curve.curvatures).max() < 1e9


def test_comb_scale():
    surface = hn.LimitSurface(ring(3.0))
    curves = hn.section_fairness(surface, [[0, 0, 1, 2.6]])[0]
    scale = hn.suggested_comb_scale(curves, height=0.5)
    teeth = curves[0].comb(scale=scale)[: len(curves[0].points)]
    lengths = np.linalg.norm(teeth[:, 1] - teeth[:, 0], axis=1)
    assert 0.45 < np.median(lengths) <= 0.55
    # Away from the centre of curvature: outside of the tube.
    outward = ((teeth[:, 1] - teeth[:, 0]) * teeth[:, 0])[:, :2].sum(axis=1)
    assert (outward > 0).all()


@pytest.mark.parametrize(
    "options, message",
    [
        ({"step": 0.0}, "step"),
        ({"step": 1.0, "count": 4}, "either"),
        ({"count": 1}, "2 to 100000"),
        ({"noise": -1.0}, "Noise"),
        ({"relative_noise": float("nan")}, "Noise"),
    ],
)
def test_curve_options_out_of_range(options, message):
    surface = hn.LimitSurface(grid(lambda x, y: 0 * x))
    with pytest.raises(ValueError, match=message):
        hn.section_fairness(surface, [[1, 0, 0, 0]], **options)
    with pytest.raises(ValueError, match=message):
        hn.feature_fairness(surface, **options)


# --------------------------------------------------------------------------------------- colours


def test_fields_of_a_quadric():
    a, b = 0.1, -0.05
    surface = hn.LimitSurface(grid(lambda x, y: a * x * x + b * y * y))
    tess = surface.tessellate(4)
    points = surface.positions(tess.normal_cells, tess.normal_uv)
    inner = np.abs(points[:, :2]).max(axis=1) < SIDE / 2 - 1.01
    x, y = points[inner, 0], points[inner, 1]
    fx, fy = 2 * a * x, 2 * b * y
    w = 1 + fx * fx + fy * fy
    gaussian = 4 * a * b / w**2
    mean = -((1 + fy * fy) * a + (1 + fx * fx) * b) / w**1.5
    half = np.sqrt(mean**2 - gaussian)
    expected = {
        "gaussian": gaussian,
        "mean": mean,
        "maximum": mean + half,
        "minimum": mean - half,
        "slope": np.arccos(1 / np.sqrt(w)),
    }
    for kind, values in expected.items():
        field = hn.surface_field(surface, tess, kind=kind)
        assert field.shape == (len(tess.normals),)
        np.testing.assert_allclose(field[inner], values, atol=1e-12)
        at = hn.surface_field_at(surface, tess.normal_cells, tess.normal_uv, kind=kind)
        np.testing.assert_allclose(at, field, atol=1e-12)
    up = hn.surface_field(surface, tess, kind="slope", direction=(0, 0, -3))
    np.testing.assert_allclose(up, np.pi - hn.surface_field(surface, tess, kind="slope"))
    plane = hn.LimitSurface(grid(lambda x, y: 0.3 * x))
    weights = hn.field_weights(plane.tessellate(3))
    assert abs(weights.sum() - SIDE * SIDE * np.sqrt(1.09)) < 1e-11 and weights.min() > 0


def test_fields_at_irregular_points_are_finite_means():
    mesh = ring(3.0, n=5, rows=2)
    # Pyramids of triangles close it: valence 5 at the tips, irregular rims.
    points = np.vstack([mesh.points, [[0, 0, -1], [0, 0, 3]]])
    sizes, faces = list(mesh.face_sizes), list(mesh.face_vertices)
    for k in range(5):
        sizes += [3, 3]
        faces += [(k + 1) % 5, k, 15, 10 + k, 10 + (k + 1) % 5, 16]
    surface = hn.LimitSurface(hn.ControlMesh(points, sizes, faces))
    tess = surface.tessellate(4)
    curvature = surface.curvature(tess.normal_cells, tess.normal_uv)
    assert curvature.at_irregular_knot.any()
    for kind in ("gaussian", "mean", "maximum", "minimum"):
        field = hn.surface_field(surface, tess, kind=kind)
        assert np.isfinite(field).all()
        for knot in np.flatnonzero(curvature.at_irregular_knot):
            rows = tess.normal_indices[(tess.normal_indices == knot).any(axis=1)]
            ring_of_values = []
            for row in rows:
                k = list(row).index(knot)
                ring_of_values += [field[row[(k + 1) % 4]], field[row[(k + 3) % 4]]]
            assert abs(field[knot] - np.mean(ring_of_values)) < 1e-12


def test_scale_of_signed_values():
    values = np.concatenate([np.linspace(-1, 2, 3001), [1000.0, np.nan]])
    scale = hn.colour_scale(values, kind="gaussian", percentile=0.9)
    assert scale.signed and scale.low == -scale.high and scale.unit == "1/m²"
    assert abs(scale.high - np.quantile(np.abs(values[:-1]), 0.9)) < 2e-3
    for mapping in ("linear", "logarithmic"):
        scale = hn.colour_scale(values, kind="mean", mapping=mapping, limits=(-1, 2))
        assert (scale.low, scale.high, scale.unit) == (-2, 2, "1/m")
        position = scale.normalised([-3, -2, 0, 2, 3, np.nan])
        np.testing.assert_allclose(position[:5], [0, 0, 0.5, 1, 1], atol=1e-15)
        assert np.isnan(position[5])
        order = scale.normalised(np.linspace(-2, 2, 101))
        assert (np.diff(order) > 0).all()
        np.testing.assert_allclose(order + order[::-1], 1, atol=1e-12)
        np.testing.assert_allclose(
            scale.normalised(scale.tick_values), scale.tick_positions, atol=1e-15
        )
        assert (np.diff(scale.tick_positions) > 0).all() and 4 <= len(scale.tick_labels) <= 11
        assert "0" in scale.tick_labels
    # Weights: what has no area does not count.
    weights = (np.abs(values) < 0.5).astype(float)
    scale = hn.colour_scale(values, kind="mean", weights=weights, percentile=1.0)
    assert abs(scale.high - 0.5) < 2e-3


def test_decades_of_distances_are_of_millimetres():
    limits = {0.05: "10", 0.1: "100", 2e-4: "0.1"}
    for high, top in limits.items():
        scale = hn.colour_scale([0.0], kind="distance", mapping="logarithmic", limits=(-high, high))
        assert scale.unit == "mm" and scale.tick_labels[-1] == top
        decades = float(top) * np.array([-1, -0.1, -0.01, 0, 0.01, 0.1, 1])
        np.testing.assert_allclose(scale.tick_values, decades, rtol=1e-12)
        np.testing.assert_allclose(scale.normalised(decades / 1000), scale.tick_positions)


def test_scale_of_slopes_is_in_degrees():
    scale = hn.colour_scale(np.radians(np.linspace(10, 80, 701)), kind="slope", percentile=1.0)
    assert not scale.signed and scale.unit == "°"
    assert scale.tick_labels == ["10", "20", "30", "40", "50", "60", "70", "80"]
    np.testing.assert_allclose(scale.tick_positions, (np.arange(10, 81, 10) - 10) / 70, atol=1e-12)


def lightness(colours):
    rgb = np.where(colours <= 0.04045, colours / 12.92, ((colours + 0.055) / 1.055) ** 2.4)
    y = rgb @ [0.2126729, 0.7151522, 0.0721750]
    return 116 * np.cbrt(y) - 16


def as_seen_by_deuteranopes(colours):
    """Viénot, Brettel and Mollon 1999, in linear light."""
    rgb = np.where(colours <= 0.04045, colours / 12.92, ((colours + 0.055) / 1.055) ** 2.4)
    return rgb @ np.array([[0.29275, 0.70725, 0], [0.29275, 0.70725, 0], [-0.02234, 0.02234, 1]]).T


def test_colours_can_be_told_apart():
    signed = hn.colour_scale([-1.0, 1.0], kind="mean", limits=(-1, 1)).legend_colours(101)
    slope = hn.colour_scale([0.0, 1.0], kind="slope", limits=(0, 1)).legend_colours(101)
    for colours in (signed, slope):
        assert colours.shape == (101, 3) and colours.min() >= 0 and colours.max() <= 1
    light = lightness(signed)
    assert light.argmax() == 50 and light[50] > 94
    assert (np.diff(light[:51]) > 0).all() and (np.diff(light[50:]) < 0).all()
    assert (np.diff(lightness(slope)) > 0).all()
    # Below zero blue, above it orange; and so for those who don't tell red from green.
    seen = as_seen_by_deuteranopes(signed)
    assert (signed[:40, 2] > signed[:40, 0]).all() and (signed[61:, 2] < signed[61:, 0]).all()
    assert (seen[:40, 2] > seen[:40, 0]).all() and (seen[61:, 2] < seen[61:, 0]).all()
    np.testing.assert_array_equal(
        hn.colour_scale([1.0], kind="mean", limits=(-1, 1)).colours([-1, 1, 7]),
        signed[[0, 100, 100]],
    )


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda s, t: hn.surface_field(s, t, kind="mene"), "kind is"),
        (lambda s, t: hn.surface_field(s, t, kind="slope", direction=(0, 0, 0)), "direction"),
        (lambda s, t: hn.colour_scale([1.0], kind="mean", mapping="log"), "mapping is"),
        (lambda s, t: hn.colour_scale([1.0], kind="mean", weights=[1.0, 2.0]), "weights"),
        (lambda s, t: hn.colour_scale([1.0], kind="mean", percentile=0.0), "above 0"),
        (lambda s, t: hn.colour_scale([1.0], kind="slope", limits=(1, 1)), "rise"),
        (lambda s, t: hn.surface_field(hn.LimitSurface(ring(1, rows=1)), t, kind="mean"), "anew"),
    ],
)
def test_wrong_fields_and_scales(call, message):
    surface = hn.LimitSurface(grid(lambda x, y: 0 * x))
    with pytest.raises(ValueError, match=message):
        call(surface, surface.tessellate(2))
