# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves in which cylinders cut hulls, tunnels and stern tubes: closed forms, rays along the
cylinder as another way, and the tunnels that are cut out of bodies."""

import math

import hull_native as hn
import numpy as np
import pytest
from plate_hulls import cylinder, grid_surface, one, sphere
from production_hulls import SAMPLES, body_of
from test_appendages import BEAM, DEPTH, LENGTH, RADIUS, boxes

UP = (0.0, 0.0, 1.0)


def unit(v):
    return np.asarray(v, dtype=float) / np.linalg.norm(v)


def size_of(surface):
    return float(np.linalg.norm(np.ptp(surface.mesh.points, axis=0)))


def off_axis(points, point, direction):
    """Distances from the axis."""
    return np.linalg.norm(np.cross(points - np.asarray(point), unit(direction)), axis=1)


def lengths(points):
    return np.linalg.norm(np.diff(points, axis=0), axis=1)


def is_closed(curve):
    return bool((curve.points[0] == curve.points[-1]).all())


def angles(points, point, direction):
    """Around the axis."""
    along = unit(direction)
    first = unit(np.cross(along, [0.3, 0.5, 0.8]))
    off = np.asarray(points) - point
    return np.arctan2(off @ np.cross(along, first), off @ first)


def passes(curve, point, direction, angle):
    """How often a curve passes a line of the cylinder, by its chords."""
    turn = angles(curve.points, point, direction) - angle
    turn = np.arctan2(np.sin(turn), np.cos(turn))
    changes = (turn[:-1] < 0.0) != (turn[1:] < 0.0)
    return int((changes & (np.abs(turn[:-1]) < 1.0) & (np.abs(turn[1:]) < 1.0)).sum())


def checked(surface, curves, point, direction, radius, tolerance):
    """Asserts that points are on surface and cylinder to 1e-10 of the size, chords within the
    tolerance, and that rays along the cylinder meet the surface as often as curves pass them."""
    size, tree = size_of(surface), hn.SurfaceTree(surface)
    for curve in curves:
        begin = surface.evaluate(curve.cells, curve.starts)[0]
        assert np.abs(begin - curve.points[:-1]).max() < 1e-12 * size
        assert np.abs(off_axis(curve.points, point, direction) - radius).max() < 1e-10 * size
        middles = 0.5 * (curve.points[1:] + curve.points[:-1])
        assert tree.closest_points(middles).distances.max() < 1.5 * tolerance
        assert np.abs(off_axis(middles, point, direction) - radius).max() < 1.5 * tolerance
    along = unit(direction)
    first = unit(np.cross(along, [0.3, 0.5, 0.8]))
    for angle in np.random.default_rng(2315).uniform(-math.pi, math.pi, 24):
        out = math.cos(angle) * first + math.sin(angle) * np.cross(along, first)
        origin = np.asarray(point) + radius * out - 10.0 * size * along
        hits = tree.all_ray_hits(origin, along)
        met = sum(passes(curve, point, direction, angle) for curve in curves)
        assert met == len(hits), f"seed 2315, angle {angle}"


@pytest.mark.parametrize("lean", [0.0, 0.35])
def test_through_a_box(lean):
    """A circle on each side, or an ellipse with 1 / cos of the angle between axis and normal."""
    surface = hn.LimitSurface(boxes(((0, -BEAM / 2, 0), (LENGTH, BEAM / 2, DEPTH))))
    point, direction = np.array([5.0, 0.0, 1.4]), (math.sin(lean), math.cos(lean), 0.0)
    curves = hn.HullCurves(surface, 1e-5).on_cylinder(
        point, direction=direction, radius=RADIUS, name="tunnel"
    )
    assert sorted(c.points[0, 1] for c in curves) == pytest.approx([-BEAM / 2, BEAM / 2])
    for curve in curves:
        assert curve.name == "tunnel" and is_closed(curve)
        side = curve.points[0, 1]
        assert np.abs(curve.points[:, 1] - side).max() < 1e-12
        x = curve.points[:, 0] - point[0] - side * math.tan(lean)
        z = curve.points[:, 2] - point[2]
        assert np.abs(np.hypot(x * math.cos(lean), z) - RADIUS).max() < 1e-9
        area = 0.5 * abs(np.sum(x[:-1] * z[1:] - x[1:] * z[:-1]))
        assert area == pytest.approx(math.pi * RADIUS**2 / math.cos(lean), rel=1e-4)
    checked(surface, curves, point, direction, RADIUS, 1e-5)


@pytest.mark.parametrize(
    "point, direction, radius",
    [
        ((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), 3.0),  # a circle of latitude
        ((2.0, 0.5, 0.0), (0.2, -0.1, 1.0), 2.5),
        ((0.0, 0.0, 8.5), (1.0, 0.3, 0.1), 1.2),  # enters and leaves
        ((0.0, 0.0, 9.9), (1.0, 0.3, 0.0), 1.2),  # half of it within
    ],
)
def test_through_a_sphere(point, direction, radius):
    surface = sphere()
    curves = hn.HullCurves(surface, 1e-4).on_cylinder(point, direction=direction, radius=radius)
    checked(surface, curves, point, direction, radius, 1e-4)
    for curve in curves:
        # The spline has no curvature across its border, and is off the sphere there.
        off = np.abs(np.linalg.norm(curve.points, axis=1) - 10.0)
        inside = np.abs(curve.points[:, :2]).max(axis=1) < 4.0
        assert off.max() < 1e-3 and off[inside].max(initial=0.0) < 5e-6
    if direction == (0.0, 0.0, 1.0):
        assert one(curves).points[:, 2] == pytest.approx(math.sqrt(91.0), abs=5e-6)
        assert lengths(one(curves).points).sum() == pytest.approx(6.0 * math.pi, rel=1e-4)


def test_finer_chords_are_nearer():
    """Length to second order in the points' distances."""
    surface, point = sphere(), (2.0, 0.5, 0.0)
    sums = [
        sum(
            lengths(c.points).sum()
            for c in hn.HullCurves(surface, tolerance).on_cylinder(
                point, direction=(0.2, -0.1, 1.0), radius=2.5
            )
        )
        for tolerance in (1e-2, 1e-4, 1e-8)
    ]
    assert abs(sums[1] - sums[2]) < 0.03 * abs(sums[0] - sums[2]) < 0.03


def test_a_turned_hull_has_the_turned_curve():
    surface = sphere(parts=16)
    turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    shift = np.array([5.0, -3.0, 2.0])
    points = np.asarray(surface.mesh.points) @ turn.T + shift
    moved = grid_surface(points.reshape(17, 17, 3))
    point, direction = np.array([1.0, 0.5, 0.0]), np.array([0.2, -0.1, 1.0])
    both = [
        one(hn.HullCurves(s, 1e-4).on_cylinder(p, direction=d, radius=2.0))
        for s, p, d in (
            (surface, point, direction),
            (moved, turn @ point + shift, turn @ direction),
        )
    ]
    assert lengths(both[0].points).sum() == pytest.approx(lengths(both[1].points).sum(), rel=1e-6)
    found = hn.SurfaceTree(moved).closest_points(both[0].points @ turn.T + shift)
    assert found.distances.max() < 1e-12 * 20


def tunnel_of(sample):
    """(point, direction, radius) of a tunnel athwartships, low in the bow's section."""
    points = np.asarray(sample.surface.mesh.points)
    x = points[:, 0].min() + 0.85 * np.ptp(points[:, 0])
    (cut,) = hn.sections(sample.surface, [[1.0, 0.0, 0.0, x]])
    heights = np.concatenate([curve.points[:, 2] for curve in cut])
    z = heights.min() + 0.35 * np.ptp(heights)
    return (x, 0.0, z), (0.0, 1.0, 0.0), 0.008 * sample.ship.length_pp


@pytest.mark.parametrize("name", SAMPLES)
def test_tunnels_near_the_bow(name):
    sample, body = body_of(name)
    surface = body.surface
    tolerance = 1e-6 * size_of(surface)
    point, direction, radius = tunnel_of(sample)
    curves = hn.HullCurves(surface, tolerance).on_cylinder(
        point, direction=direction, radius=radius, name="tunnel"
    )
    assert all(is_closed(curve) for curve in curves)
    checked(surface, curves, point, direction, radius, tolerance)


@pytest.mark.parametrize("name", SAMPLES)
def test_stern_tubes(name):
    """Along the ship in the centre plane, or in a demihull's middle: bow, stern and borders."""
    sample, body = body_of(name)
    surface = body.surface
    tolerance = 1e-6 * size_of(surface)
    points = np.asarray(surface.mesh.points)
    low, high = points.min(axis=0), points.max(axis=0)
    y = 0.5 * (low[1] + high[1]) if low[1] > 0.1 or not sample.half else 0.0
    point, direction = (0.0, y, low[2] + 0.3 * (high[2] - low[2])), (1.0, 0.0, 0.02)
    radius = 0.004 * sample.ship.length_pp
    curves = hn.HullCurves(surface, tolerance).on_cylinder(
        point, direction=direction, radius=radius, name="stern tube"
    )
    checked(surface, curves, point, direction, radius, tolerance)


@pytest.mark.parametrize("name", SAMPLES)
def test_random_cylinders(name):
    """Of any place, direction and size: rays meet the hull as often as curves pass them, and none
    where there is no curve."""
    _, body = body_of(name)
    surface = body.surface
    points, size = np.asarray(surface.mesh.points), size_of(surface)
    random = np.random.default_rng(2316)
    for trial in range(12):
        point = random.choice(points) + 0.01 * size * random.normal(size=3)
        direction = random.normal(size=3) if trial % 2 else np.eye(3)[random.integers(3)]
        radius = size * 10.0 ** random.uniform(-3.0, -1.0)
        try:
            curves = hn.HullCurves(surface, 1e-5 * size).on_cylinder(
                point, direction=direction, radius=radius
            )
        except ValueError as error:
            assert "does not meet" in str(error), f"seed 2316, trial {trial}"
            curves = []
        checked(surface, curves, point, direction, radius, 1e-5 * size)


def test_it_is_the_edge_of_the_tunnel_that_is_cut():
    """What a tunnel takes from the coaster's shell is the plate within the curve, and what it adds
    is the cylinder up to it: ∮ 2 y r dθ."""
    sample, body = body_of("coaster")
    ship = sample.ship
    x, z, radius, reach = 0.93 * ship.length_pp, 2.0, 0.7, 0.6 * ship.beam
    before = body.immersion(UP, 50.0)
    body.join([hn.cylinder((x, -reach, z), (x, reach, z), radius, name="tunnel", cut=True)])
    after = body.immersion(UP, 50.0)
    seam = one(
        hn.HullCurves(body.surface, 1e-6).on_cylinder(
            (x, 0.0, z), direction=(0, 1, 0), radius=radius, name="tunnel"
        )
    )
    hole = min(hn.plates(body.surface, hull_seams(body.surface, seam)), key=lambda p: p.area)
    turn = np.unwrap(np.arctan2(seam.points[:, 2] - z, seam.points[:, 0] - x))
    breadths = seam.points[:, 1]
    inside = abs(np.sum(0.5 * (breadths[1:] + breadths[:-1]) * np.diff(turn))) * 2.0 * radius
    assert abs(turn[-1] - turn[0]) == pytest.approx(2.0 * math.pi, abs=1e-9)
    found = after.wetted_surface - before.wetted_surface
    assert found == pytest.approx(inside - 2.0 * hole.area, abs=1e-5)


def hull_seams(surface, seam):
    """With the knuckles, which plates may not go over."""
    return hn.HullCurves(surface, 1e-4).knuckles() + [seam]


def test_on_plates():
    """A mark on a developed plate is as long as on the hull, and around what the hole takes."""
    surface = cylinder()
    curves = hn.HullCurves(surface, 1e-4)
    tunnel = one(
        curves.on_cylinder((3.0, 2.5, 0.0), direction=(0, 0.1, 1), radius=0.6, name="tunnel")
    )
    (plate,) = hn.plates(surface, [])
    listed = hn.ListedPlate("P1", plate, 0.01, plate.flat())
    drawing = hn.plate_drawing(listed, marks=[("SEAMS", tunnel)])
    marks = [line / 1000.0 for layer, line in drawing.lines if layer == "SEAMS"]
    length = sum(lengths(line).sum() for line in marks)
    assert length == pytest.approx(lengths(tunnel.points).sum(), rel=1e-4)
    line = one(marks)
    assert line[0] == pytest.approx(line[-1], abs=1e-9)
    x, y = line.T
    area = 0.5 * abs(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]))
    hole = min(hn.plates(surface, [tunnel]), key=lambda p: p.area)
    assert area == pytest.approx(hole.area, rel=1e-3)
    assert hole.area == pytest.approx(hole.flat().area, rel=1e-9)


def test_openings_of_appendages():
    """Of cylinders alone, between their ends, on both sides where they are mirrored."""
    surface = hn.LimitSurface(boxes(((0, -BEAM / 2, 0), (LENGTH, BEAM / 2, DEPTH))))
    curves = hn.HullCurves(surface, 1e-4)
    appendages = [
        hn.cylinder((7.0, -3.0, 1.2), (7.0, 3.0, 1.2), RADIUS, name="thruster", cut=True),
        hn.cylinder((-1.0, 1.0, 1.0), (2.0, 1.0, 1.0), 0.2, name="tube", mirrored=True),
        hn.cylinder((3.0, 0.0, -1.0), (3.0, 0.0, 1.0), 0.3, end_radius=0.2, name="cone"),
        hn.foil("0012", (6, 0, 0.5), (5.7, 0, -1.5), 2.0, tip_chord=1.2, name="keel"),
        hn.cylinder((30.0, 0.0, 0.0), (31.0, 0.0, 0.0), 0.1, name="elsewhere"),
    ]
    marks = hn.opening_marks(curves, appendages)
    assert {layer for layer, _ in marks} == {"OUTLINE"}
    assert [curve.name for _, curve in marks] == ["thruster"] * 2 + ["tube"] * 2
    middles = sorted(tuple(np.round(c.points[:-1].mean(axis=0), 1)) for _, c in marks[2:])
    assert [m[:2] for m in middles] == [(0.0, -1.0), (0.0, 1.0)]
    with pytest.raises(ValueError, match='"side" touches the hull'):
        hn.opening_marks(curves, [hn.cylinder((1.0, 2.5, 1.0), (3.0, 2.5, 1.0), 0.5, name="side")])


@pytest.mark.parametrize(
    "point, direction, radius, words",
    [
        ((5.0, 9.0, 1.0), (1, 0, 0), 0.5, '"tube" does not meet the hull'),
        ((5.0, 2.5, 1.0), (1, 0, 0), 0.5, '"tube" touches the hull at .*move it or change'),
        ((5.0, 0.0, 1.0), (0, 0, 0), 0.5, "must be a direction"),
        ((5.0, 0.0, 1.0), (1, 0, math.nan), 0.5, "finite|direction"),
        ((math.nan, 0.0, 1.0), (1, 0, 0), 0.5, "finite"),
        ((5.0, 0.0, 1.0), (1, 0, 0), 0.0, 'radius of "tube" must be a length above 0'),
        ((5.0, 0.0, 1.0), (1, 0, 0), math.nan, 'radius of "tube" must be a length above 0'),
    ],
)
def test_refused(point, direction, radius, words):
    surface = hn.LimitSurface(boxes(((0, -BEAM / 2, 0), (LENGTH, BEAM / 2, DEPTH))))
    curves = hn.HullCurves(surface)
    with pytest.raises(ValueError, match=words):
        curves.on_cylinder(point, direction=direction, radius=radius, name="tube")


def test_touching_a_sphere():
    """From outside and just within."""
    surface = sphere()
    curves = hn.HullCurves(surface, 1e-4)
    with pytest.raises(ValueError, match="touches the hull at .*10.0"):
        curves.on_cylinder((0.0, 0.0, 12.0), direction=(1, 0, 0), radius=2.0)
    small = curves.on_cylinder((0.0, 0.0, 12.0), direction=(1, 0, 0), radius=2.0 + 1e-6)
    assert lengths(one(small).points).sum() < 0.05
    with pytest.raises(ValueError, match="does not meet"):
        curves.on_cylinder((0.0, 0.0, 12.0), direction=(1, 0, 0), radius=2.0 - 1e-6)
