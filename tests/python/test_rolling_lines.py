# SPDX-License-Identifier: GPL-3.0-or-later
"""The rolling line of plates and the radius of its bend: of cylinders, cones and spheres by closed
forms, of doubly curved plates by the curvatures at points of the surface, laid on the plane by
differences of the places there; as it is drawn."""

import math

import hull_native as hn
import numpy as np
import pytest
from plate_hulls import grid_surface, one, sphere, through
from test_plate_layouts import bilge

RADIUS = 3.0
# From the ends of the profile's spline, which has no curvature there: 0.27 of it is left a cell.
MARGIN = 12


def along(line):
    """The direction of a straight line (k, 2) of the plane, an angle from 0 to π."""
    return math.atan2(*(line[-1] - line[0])[::-1]) % math.pi


def apart(one_angle, other):
    """Of two directions without sense, rad."""
    return abs(math.remainder(one_angle - other, math.pi))


def round_cylinder(parts=72, turn=1.8, length=6.0, rows=6):
    """Of the radius RADIUS, along x, over an arc about the top: (LimitSurface, the step of its
    angle)."""
    a = np.linspace(-0.5 * turn, 0.5 * turn, parts + 1)
    profile = through(RADIUS * np.stack([0.0 * a, np.sin(a), np.cos(a)], axis=1))
    x = np.linspace(0.0, length, rows + 1)
    return grid_surface(profile[None] + x[:, None, None] * [1.0, 0.0, 0.0]), turn / parts


def round_cone(slope=0.3, parts=72, turn=1.8, rows=6):
    """About x, of the radius slope x at x from 4 to 10, as round_cylinder()."""
    a = np.linspace(-0.5 * turn, 0.5 * turn, parts + 1)
    profile = through(np.stack([0.0 * a, np.sin(a), np.cos(a)], axis=1))
    x = np.linspace(4.0, 10.0, rows + 1)[:, None, None]
    return grid_surface(x * ([1.0, 0.0, 0.0] + slope * profile[None])), turn / parts


def plane_at(angle):
    """Through the x axis, so far from the vertical to port."""
    return [0.0, math.cos(angle), -math.sin(angle), 0.0]


def between_planes(surface, angle, *more):
    """The plate in the middle of those that planes through the x axis, at an angle to both sides,
    and other planes leave."""
    curves = hn.HullCurves(surface, 1e-5)
    planes = [plane_at(-angle), plane_at(angle), *more]
    seams = [c for plane in planes for c in curves.in_plane(plane, "seam")]
    middle = surface.mesh.points.mean(axis=0) * [1.0, 0.0, 1.0]
    found = min(
        hn.plates(surface, seams, size=0.3), key=lambda p: np.linalg.norm(p.centre - middle)
    )
    return curves, found


@pytest.mark.parametrize("lean", [0.0, 0.5, -1.5])
def test_of_a_cylinder(lean):
    """Along the generator, however the plate is cut: its longer way is elsewhere at other leans.
    The interpolant's curvature is off the circle's by the step's square over 12 at most."""
    surface, step = round_cylinder()
    ends = [[1.0, lean, 0.0, x] for x in (1.5, 4.5)]
    curves, plate = between_planes(surface, 0.9 - MARGIN * step, *ends)
    flat = plate.flat()
    assert flat.developed
    for height in (-0.3, 0.4):
        generator = one(curves.in_plane(hn.plane_across("y", height)))
        ((line, _),) = flat.marks(generator)
        assert apart(flat.rolling_angle, along(line)) < 1e-12
    assert flat.rolling_radius == pytest.approx(RADIUS, rel=step**2 / 12.0)


def test_of_a_cone():
    """The ruling in its middle. At the distance s from the tip the bend is 1 / (s tan) of the half
    angle, so that its mean from s1 to s2 is 2 / ((s1 + s2) tan); the turn of the rulings by β to
    both sides in the plane leaves (1 + sin 2β / 2β) / 2 of it across the middle one."""
    slope = 0.3
    surface, step = round_cone(slope)
    turn = 0.9 - MARGIN * step
    curves, plate = between_planes(surface, turn)
    flat = plate.flat()
    assert flat.developed
    middle = one(curves.in_plane(hn.plane_across("y", 0.0)))
    ((line, _),) = flat.marks(middle)
    assert apart(flat.rolling_angle, along(line)) < 1e-9
    slant = math.hypot(1.0, slope)
    beta = turn * slope / slant
    mean = 2.0 / ((4.0 + 10.0) * slant * slope)
    bend = mean * (1.0 + math.sin(2.0 * beta) / (2.0 * beta)) / 2.0
    assert 1.0 / flat.rolling_radius == pytest.approx(bend, rel=step**2 / 12.0 + 1e-5)
    # The roll is one, the rulings are not: half the plate has that in its own middle.
    seams = [c for angle in (turn, 0.0) for c in curves.in_plane(plane_at(angle), "seam")]
    half = hn.plates(surface, seams)
    flat = min(half, key=lambda p: abs(p.centre[1] - 0.8)).flat()
    ((line, _),) = flat.marks(one(curves.in_plane(plane_at(0.5 * turn))))
    assert apart(flat.rolling_angle, along(line)) < 1e-5


def test_of_a_sphere_and_a_plane():
    surface = sphere()
    seam = hn.HullCurves(surface, 1e-4).in_plane(hn.plane_across("z", 10.0 * math.cos(0.3)))
    cap = min(hn.plates(surface, seam, size=0.4), key=lambda p: p.area)
    # All rolls do alike; laying the cap out turns none of the bend away.
    assert cap.flat().rolling_radius == pytest.approx(10.0, rel=1e-3)
    flat_points = np.stack(np.meshgrid(np.arange(5.0), np.arange(4.0), [0.0]), axis=-1)[:, :, 0]
    (plate,) = hn.plates(grid_surface(flat_points.swapaxes(0, 1)), [])
    assert plate.flat().rolling_radius == math.inf


def mean_bending(surface, flat, parts=6, step=1e-4):
    """(2, 2) The mean of the second fundamental form over the places of a flat plate, in the
    plane's axes by central differences of where it lies."""
    total, area = np.zeros((2, 2)), 0.0
    at = (np.arange(parts) + 0.5) / parts
    uv = np.stack(np.meshgrid(at, at), axis=-1).reshape(-1, 2)
    for cell in range(surface.cell_count):
        cells = np.full(len(uv), cell)
        there = [
            flat.places(cells, uv + way)
            for way in step * np.array([[1, 0], [-1, 0], [0, 1], [0, -1]])
        ]
        slopes = np.stack([there[0] - there[1], there[2] - there[3]], axis=-1) / (2.0 * step)
        _, du, dv, duu, duv, dvv = surface.evaluate(cells, uv, derivatives=2)
        normals = np.cross(du, dv)
        areas = np.linalg.norm(normals, axis=1)
        second = -np.einsum(
            "nk,nak->na", normals / areas[:, None], np.stack([duu, duv, duv, dvv], axis=1)
        ).reshape(-1, 2, 2)
        on = np.isfinite(slopes).all(axis=(1, 2))
        back = np.linalg.inv(slopes[on])
        total += np.einsum("n,nji,njk,nkl->il", areas[on], back, second[on], back)
        area += areas[on].sum()
    return total / area


@pytest.mark.parametrize("bulge, lean", [(0.05, 0.4), (0.3, -0.6)])
def test_of_doubly_curved_plates(bulge, lean):
    """The direction in which the mean bend is least, and the radius across it."""
    surface = bilge(bulge, parts=8, rows=6)
    curves = hn.HullCurves(surface, 1e-4)
    seams = [c for x in (3.7, 5.2) for c in curves.in_plane([1.0, lean, -0.5 * lean, x], "seam")]
    plate = max(hn.plates(surface, seams), key=lambda p: -abs(p.centre[0] - 4.4))
    flat = plate.flat()
    assert not flat.developed and flat.converged
    bends, ways = np.linalg.eigh(mean_bending(surface, flat))
    least = int(np.abs(bends).argmin())
    assert abs(bends[least]) < 0.2 * abs(bends[1 - least])
    # Sums over points of a grid that the border cuts, and stretches that differ from 1.
    assert apart(flat.rolling_angle, math.atan2(*ways[::-1, least])) < 1e-4
    assert 1.0 / flat.rolling_radius == pytest.approx(abs(bends[1 - least]), rel=2e-3)
    # About as the bilge's own: the roll lies along the ship, the plate's longer way does not.
    assert apart(flat.rolling_angle, 0.0) > 0.3
    assert flat.rolling_radius == pytest.approx(1.5 + 0.6 * bulge, rel=0.15)
    frame = one(curves.in_plane(hn.plane_across("x", 4.5)))
    ((line, _),) = flat.marks(frame)
    assert apart(flat.rolling_angle, along(line)) == pytest.approx(math.pi / 2, abs=0.02)


def test_as_it_is_drawn():
    """A line through the middle with its word; a plane plate has none."""
    surface, step = round_cylinder()
    _, plate = between_planes(
        surface, 0.9 - MARGIN * step, [1.0, 0.5, 0.0, 1.5], [1.0, 0.5, 0.0, 4.5]
    )
    (listed,) = hn.plate_list([plate], thickness=0.01)
    drawing = hn.plate_drawing(listed)
    ((_, line),) = [drawn for drawn in drawing.lines if drawn[0] == "ROLLING"]
    flat = listed.flat
    assert apart(along(np.asarray(line)), flat.rolling_angle) < 1e-12
    middle = 500.0 * (flat.points.min(axis=0) + flat.points.max(axis=0))
    assert np.asarray(line).mean(axis=0) == pytest.approx(middle, abs=1e-9)
    inside = np.asarray(line)
    assert (inside > 0.0).all() and (inside < 1000.0 * flat.points.max(axis=0)).all()
    plane = np.stack(np.meshgrid(np.arange(5.0), np.arange(4.0), [0.0]), axis=-1)[:, :, 0]
    listed = hn.plate_list(hn.plates(grid_surface(plane.swapaxes(0, 1)), []), thickness=0.01)
    assert not [layer for layer, _ in hn.plate_drawing(listed[0]).lines if layer == "ROLLING"]
