# SPDX-License-Identifier: GPL-3.0-or-later
"""Plates between seams and their expansion: areas sum to the hull's, Milnor's bound on the stretch
of spherical caps, developable plates without strain."""

import math

import hull_native as hn
import numpy as np
import pytest
from hull_native import surface_areas
from numpy.polynomial import chebyshev
from plate_hulls import cone, cylinder, grid_surface, one, sphere
from plate_shells import coaster_shell, planing_boat_shell
from production_hulls import body_of


def in_plane(curves, axis, position, name=""):
    return curves.in_plane(hn.plane_across(axis, position), name)


@pytest.mark.parametrize("shell, least", [(planing_boat_shell, 8), (coaster_shell, 36)])
def test_areas_sum_to_the_hull(shell, least):
    """Against the cells' areas by another quadrature, without any seams."""
    surface, curves = shell()
    plates = hn.plates(surface, curves)
    whole, centre = surface_areas(surface).of(slice(None))
    assert len(plates) >= least
    assert sum(p.area for p in plates) == pytest.approx(whole, rel=1e-10)
    moment = sum(p.area * p.centre for p in plates)
    np.testing.assert_allclose(moment / whole, centre, rtol=1e-10, atol=1e-9)
    # A seam belongs to the plates on both sides of it, so that borders' lengths pair up.
    lengths = {}
    for p in plates:
        for loop in p.loops:
            for name, line in loop:
                step = np.linalg.norm(np.diff(line, axis=0), axis=1).sum()
                lengths[name] = lengths.get(name, 0.0) + step
    assert min(lengths.values()) > 0.0


def test_area_of_a_strip_is_exact():
    """The cylinder's area between x = a and b, and a slanted cut, by the profile's length."""
    surface = cylinder()
    curves = hn.HullCurves(surface, 1e-6)
    seams = in_plane(curves, "x", 1.3) + in_plane(curves, "x", 4.0)
    plates = hn.plates(surface, seams)
    whole = sum(p.area for p in plates)
    assert [p.area / whole for p in plates] == pytest.approx([1.3 / 6, 2.7 / 6, 2.0 / 6], rel=1e-9)


@pytest.mark.parametrize("alpha", [0.1, 0.2, 0.35, 0.5])
def test_spherical_cap(alpha):
    """No flat map of a cap has a ratio of largest to smallest stretch below α / sin α (Milnor)."""
    surface = sphere()
    seam = in_plane(hn.HullCurves(surface, 1e-5), "z", 10.0 * math.cos(alpha), "edge")
    plates = hn.plates(surface, seam, size=10.0 * alpha / 12)
    (cap,) = [p for p in plates if len(p.loops) == 1]
    # The border is of chords no further than 1e-5 from the circle.
    exact = 200.0 * math.pi * (1.0 - math.cos(alpha))
    assert cap.area == pytest.approx(exact, rel=4e-6 / alpha)
    flat = cap.flat()
    bound = alpha / math.sin(alpha)
    least, largest = flat.stretch
    assert flat.converged and not flat.developed
    assert bound <= largest / least <= 1.02 * bound
    # The excess itself: that of the elastic disc is 1 % above Milnor's for ν = 0.3; thin triangles
    # at the rim add to what is told.
    assert largest / least - 1.0 <= 1.3 * (bound - 1.0)


def path(count=24):
    """Chebyshev's points of a curve in (u, v) of one cell, and its parameter."""
    t = -np.cos(math.pi * (np.arange(count) + 0.5) / count)
    return t, np.stack([0.5 + 0.4 * t, 0.45 + 0.3 * t**2 - 0.1 * t], axis=1)


def derivative(t, values):
    """Of Chebyshev's interpolant."""
    return np.stack(
        [
            chebyshev.chebval(t, chebyshev.chebder(chebyshev.chebfit(t, column, len(t) - 1)))
            for column in values.T
        ],
        axis=1,
    )


@pytest.mark.parametrize("make", [cylinder, cone])
def test_developable_plates_keep_lengths_and_geodesic_curvature(make):
    surface = make()
    curves = hn.HullCurves(surface, 1e-4)
    slanted = curves.in_plane([1.0, 0.3, 0.1, 2.5], "slanted")
    plates = hn.plates(surface, slanted)
    assert len(plates) == 2
    checked = 0
    for plate in plates:
        flat = plate.flat()
        assert flat.developed and flat.area == plate.area and flat.stretch == (1.0, 1.0)
        t, uv = path()
        for cell in range(surface.cell_count):
            cells = np.full(len(t), cell)
            places = flat.places(cells, uv)
            if np.isnan(places).any():
                continue
            points = surface.evaluate(cells, uv)[0]
            d1, p1 = derivative(t, places), derivative(t, points)
            d2, p2 = derivative(t, d1), derivative(t, p1)
            speed = np.linalg.norm(p1, axis=1)
            np.testing.assert_allclose(np.linalg.norm(d1, axis=1), speed, rtol=1e-8)
            normals = surface.normals(cells, uv)
            on_hull = np.einsum("ij,ij->i", normals, np.cross(p1, p2)) / speed**3
            on_plane = (d1[:, 0] * d2[:, 1] - d1[:, 1] * d2[:, 0]) / speed**3
            np.testing.assert_allclose(on_plane, on_hull, atol=1e-8)
            checked += 1
    assert checked > 20


@pytest.mark.parametrize("make", [cylinder, cone])
def test_developable_plates_keep_areas(make):
    """The polygon through the flat outline and the plate's exact area differ by what the
    border's chords leave: second order in them."""
    surface = make()
    off = []
    for tolerance, size in ((1e-3, 0.4), (1e-5, 0.1)):
        curves = hn.HullCurves(surface, tolerance)
        for plate in hn.plates(surface, curves.in_plane([1.0, 0.3, 0.1, 2.5]), size=size):
            line = np.concatenate([side[:-1] for _, side in plate.flat().sides])
            x, y = line.T
            area = 0.5 * (x * np.roll(y, -1) - y * np.roll(x, -1)).sum()
            off.append(abs(area / plate.area - 1.0))
    assert max(off[2:]) < 0.3 * max(off[:2]) < 3e-3


def area_around(flat, cell, count=24):
    """Of a cell on the flat plate: ∮ x dy along its sides."""
    t = -np.cos(math.pi * (np.arange(count) + 0.5) / count)
    nodes, weights = np.polynomial.legendre.leggauss(count)
    corners, area = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]), 0.0
    for k in range(4):
        begin, end = corners[k], corners[(k + 1) % 4]
        uv = begin + 0.5 * (t[:, None] + 1.0) * (end - begin)
        places = flat.places(np.full(count, cell), uv)
        x, y = (chebyshev.chebfit(t, column, count - 1) for column in places.T)
        slope = chebyshev.chebval(nodes, chebyshev.chebder(y))
        area += np.sum(weights * chebyshev.chebval(nodes, x) * slope)
    return abs(area)


@pytest.mark.parametrize("make", [cylinder, cone])
def test_areas_of_developable_plates_by_their_borders(make):
    """To 1e-8, of each cell and of all: the plane's by Green's theorem, the hull's by points."""
    surface = make()
    (plate,) = hn.plates(surface, [])
    flat = plate.flat()
    assert flat.developed
    areas = np.array([area_around(flat, cell) for cell in range(surface.cell_count)])
    np.testing.assert_allclose(areas, surface_areas(surface).areas, rtol=1e-8)
    assert areas.sum() == pytest.approx(plate.area, rel=1e-8)


def test_nearly_flat_plates_need_no_strain_of_their_own():
    """A developable plate by the least energy: ν and the start do not show."""
    surface = sphere(radius=1000.0, half=0.01, parts=8)
    (plate,) = hn.plates(surface, [])
    assert plate.flat().stretch == pytest.approx((1.0, 1.0), abs=2e-4)


def test_marks_are_clipped_at_seams():
    surface = cylinder()
    curves = hn.HullCurves(surface, 1e-4)
    mark = one(in_plane(curves, "y", 2.5, "B1"))
    left, right = hn.plates(surface, in_plane(curves, "x", 2.0))
    for plate, length in ((left, 2.0), (right, 4.0)):
        ((flat, on_hull),) = plate.flat().marks(mark)
        assert np.linalg.norm(flat[-1] - flat[0]) == pytest.approx(length, abs=1e-9)
        np.testing.assert_allclose(on_hull[:, 1], 2.5, atol=1e-9)


def test_marks_that_begin_and_end_in_the_centre_plane_have_their_other_half():
    """A moon pool's circle and a keel line on a level bottom across the centre plane."""
    x, y = np.meshgrid(np.arange(7.0), np.arange(5.0), indexing="ij")
    surface = grid_surface(np.stack([x, y, 0.0 * x], axis=-1))
    curves = hn.HullCurves(surface, 1e-5)
    flat = one(hn.plates(surface, [], across_centre=True)).flat()
    circle = one(curves.on_cylinder((3.0, 0.0, 0.0), direction=(0.0, 0.0, 1.0), radius=1.0))
    ((line, on_hull),) = flat.marks(circle)
    np.testing.assert_allclose(np.hypot(on_hull[:, 0] - 3.0, on_hull[:, 1]), 1.0, atol=1e-5)
    np.testing.assert_allclose(line[0], line[-1], atol=1e-9)
    around = np.linalg.norm(np.diff(line, axis=0), axis=1).sum()
    assert around == pytest.approx(2.0 * np.pi, rel=1e-4)
    # Along the centre plane there is no other half.
    (keel,) = (c for c in curves.borders() if np.abs(c.points[:, 1]).max() < 1e-9)
    ((line, _),) = flat.marks(keel)
    assert np.linalg.norm(np.diff(line, axis=0), axis=1).sum() == pytest.approx(6.0, rel=1e-9)


def test_butts_end_on_seams():
    """Staggered butts: pieces of plane curves between two seams."""
    surface = cylinder()
    curves = hn.HullCurves(surface, 1e-4)
    seams = in_plane(curves, "y", 1.5, "S1") + in_plane(curves, "y", 3.5, "S2")
    butts = []
    for strake, x in enumerate((2.0, 3.0, 2.5)):
        pieces = curves.pieces(one(in_plane(curves, "x", x, f"B{strake}")), seams)
        assert len(pieces) == 3
        butts.append(sorted(pieces, key=lambda p: p.points[:, 1].mean())[strake])
    plates = hn.plates(surface, seams + butts)
    assert len(plates) == 6
    names = {name for p in plates for loop in p.loops for name, _ in loop}
    assert names == {"", "S1", "S2", "B0", "B1", "B2"}


def test_closed_curves_are_cut_at_crossings_alone():
    """Not where they begin, but for a crossing there."""
    surface = cylinder()
    curves = hn.HullCurves(surface, 1e-4)
    circle = one(curves.on_cylinder((3.0, 2.5, 0.0), direction=(0.0, 0.0, 1.0), radius=1.0))
    start = circle.points[0]
    assert np.linalg.norm(start - circle.points[-1]) < 1e-9
    whole = length(circle)
    assert len(curves.pieces(circle, [])) == 1
    for x in (2.3, 3.4, start[0]):
        pieces = curves.pieces(circle, in_plane(curves, "x", x, "S"))
        assert len(pieces) == 2
        for piece in pieces:
            np.testing.assert_allclose(piece.points[[0, -1], 0], x, atol=1e-6)
        assert sum(map(length, pieces)) == pytest.approx(whole, rel=1e-9)


def length(curve):
    return np.linalg.norm(np.diff(curve.points, axis=0), axis=1).sum()


def test_plates_over_knuckles_are_refused():
    sample, body = body_of("planing_boat")
    with pytest.raises(ValueError, match="A plate goes over a knuckle of .*: put a seam along"):
        hn.plates(body.surface, [])


@pytest.mark.parametrize("reach", [1e3, 1e9])
def test_lines_far_longer_than_the_hull_meet_it(reach):
    line = [(3.0 - reach, 2.5, 9.0), (3.0 + reach, 2.5, 9.0)]
    curve = one(hn.HullCurves(cylinder(), 1e-3).projected(line, direction=(0, 0, -1)))
    np.testing.assert_allclose(curve.points[[0, -1], 0], [0.0, 6.0], atol=1e-6)


def test_bad_input_has_its_sentence():
    surface = cylinder()
    curves = hn.HullCurves(surface)
    with pytest.raises(ValueError, match="does not meet the hull"):
        in_plane(curves, "x", 60.0, "far")
    with pytest.raises(ValueError, match="chord tolerance .* above 0"):
        hn.HullCurves(surface, 0.0)
    for least in (math.nan, math.inf, -0.1):
        with pytest.raises(ValueError, match="least angle of knuckles .* 0 or more"):
            curves.knuckles(least)
    with pytest.raises(ValueError, match="above 0 m"):
        hn.plates(surface, [], size=0.0)
    whole = one(in_plane(curves, "x", 3.0, "half"))
    half = curves.pieces(whole, in_plane(curves, "y", 2.0))[0]
    with pytest.raises(ValueError, match='"half" has the same plate on both sides'):
        hn.plates(surface, [half])
    with pytest.raises(ValueError, match="Poisson"):
        hn.plates(surface, [])[0].flat(0.7)


def test_progress_may_end_the_work():
    class Stopped(Exception):
        pass

    def stop(share):
        raise Stopped

    with pytest.raises(Stopped):
        hn.plates(cylinder(), [], progress=stop)


def test_a_mirrored_surface_has_the_same_plates():
    """Turned by 90° and moved: areas and stretches stay."""
    surface = sphere(parts=16)
    seam = in_plane(hn.HullCurves(surface, 1e-4), "z", 9.5)
    cap = min(hn.plates(surface, seam, size=0.6), key=lambda p: p.area)
    turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    points = np.asarray(surface.mesh.points) @ turn.T + [5.0, -3.0, 2.0]
    moved = grid_surface(points.reshape(17, 17, 3))
    seam = in_plane(hn.HullCurves(moved, 1e-4), "z", 11.5)
    other = min(hn.plates(moved, seam, size=0.6), key=lambda p: p.area)
    assert other.area == pytest.approx(cap.area, rel=1e-10)
    assert other.flat().stretch == pytest.approx(cap.flat().stretch, rel=1e-6)
