# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape fields by distances along the surface: of shapes that unroll, of parts that no way leads
to, and across the centre plane."""

import hull_native as hn
import numpy as np
import pytest
from vessels import surface_of_sample

SEED = 20261124
COUNT = 1500


def sheet(m, n, place):
    """The surface of a grid of control points place(u, v), u and v from 0 to 1."""
    points = [place(i / m, j / n) for i in range(m + 1) for j in range(n + 1)]
    faces = [i * (n + 1) + j + k for i in range(m) for j in range(n) for k in (0, n + 1, n + 2, 1)]
    corners = [0, n, m * (n + 1), (m + 1) * (n + 1) - 1]
    return hn.LimitSurface(hn.ControlMesh(points, [4] * (m * n), faces, [], corners))


def somewhere(surface):
    random = np.random.default_rng(SEED)
    cells = random.integers(0, surface.cell_count, COUNT)
    return surface.evaluate(cells, random.random((COUNT, 2)))[0]


def along(surface, base, points, mirrored=False):
    """Distances of points from a point, m."""
    net = hn.GeodesicNet(surface, mirrored=mirrored)
    field = hn.ShapeField.at_point(base, extent=1e3, protects=True).along_surface(net)
    return hn.ShapeFields([field]).deltas(0, points) * 1e3


@pytest.mark.parametrize("length", [8.0, 80.0])  # cells as long as wide, and ten times as long
def test_on_a_flat_sheet_they_are_straight(length):
    surface = sheet(8, 8, lambda u, v: (length * u, 8.0 * v, 0.0))
    points = somewhere(surface)
    straight = np.linalg.norm(points - points[0], axis=1)
    off = np.abs(along(surface, points[0], points) - straight)
    assert (off < 0.025 * straight + 1e-9).all() or off.max() < 0.025 * length
    far = straight > 0.1 * length
    assert (off[far] < 0.025 * straight[far]).all() and far.sum() > 500
    assert off[0] == 0.0


def test_on_a_cylinder_they_are_those_unrolled():
    surface = sheet(24, 12, lambda u, v: (3 * np.cos(np.pi * u), 6 * v, 3 * np.sin(np.pi * u)))
    points = somewhere(surface)
    angles = np.arctan2(points[:, 2], points[:, 0])
    radius = np.linalg.norm(points[:, [0, 2]], axis=1).mean()
    unrolled = np.hypot(radius * (angles - angles[0]), points[:, 1] - points[0, 1])
    far = unrolled > 1.0
    off = np.abs(along(surface, points[0], points) - unrolled)
    assert (off[far] < 0.025 * unrolled[far]).all()
    straight = np.linalg.norm(points - points[0], axis=1)
    assert (unrolled / np.maximum(straight, 1e-9)).max() > 1.2  # it is not the straight distance


def test_what_no_way_leads_to_is_beyond_all_extents():
    one = sheet(4, 4, lambda u, v: (u, v, 0.0)).mesh
    points = np.concatenate([one.points, one.points + [0.0, 0.0, 0.05]])
    faces = np.concatenate([one.face_vertices, one.face_vertices + len(one.points)])
    surface = hn.LimitSurface(hn.ControlMesh(points, [4] * 32, faces, [], []))
    net = hn.GeodesicNet(surface)
    field = hn.ShapeField.at_point((0.5, 0.5, 0.0), (0, 0, 1), extent=0.4).along_surface(net)
    places = hn.SurfacePlaces(surface).positions
    shifts, gradients = hn.ShapeFields([field]).at(places)
    assert np.isfinite(gradients).all()
    other = places[:, 2] > 0.01
    assert shifts[~other].any() and not shifts[other].any() and other.any()


@pytest.mark.parametrize("off", [0.0, 1e-8, -4e-6])
def test_ways_lead_across_the_centre_plane_of_halves(off):
    """A keel as a gutter: from one side to the other the way goes down and up again. Off the plane,
    m, by what rounding leaves, it is in it for this as for all else."""
    half = sheet(8, 8, lambda u, v: (4 * u, 2 * v + off * (v == 0.0), 4 * v))
    assert abs(off) < hn.tolerances.ON_CENTRE_PLANE * half.mesh.size
    points = somewhere(half)
    base = points[np.abs(points - (2.0, 1.0, 2.0)).sum(axis=1).argmin()]
    image = points * [1.0, -1.0, 1.0]
    # Unrolled, the other side lies beyond the keel.
    along_keel = points[:, 0] - base[0]
    up, from_keel = np.hypot(points[:, 1], points[:, 2]), np.hypot(base[1], base[2])
    unrolled = np.hypot(along_keel, up + from_keel)
    found = along(half, base, image, mirrored=True)
    inside = (points[:, 0] > 0.5) & (points[:, 0] < 3.5)
    np.testing.assert_allclose(found[inside], unrolled[inside], rtol=0.03)
    straight = np.linalg.norm(image - base, axis=1)
    assert (found[inside] > 1.2 * straight[inside]).sum() > 50


def test_a_base_that_is_not_on_the_surface_is_refused():
    surface = surface_of_sample("coaster")
    net = hn.GeodesicNet(surface, mirrored=True)
    with pytest.raises(ValueError, match="nowhere on the hull"):
        hn.ShapeField.at_point((0, 100, 0), extent=5).along_surface(net)


def test_the_base_is_met_and_gradients_are_bounded():
    surface = surface_of_sample("coaster")
    places = hn.SurfacePlaces(surface).positions
    net = hn.GeodesicNet(surface, mirrored=True)
    base, shift, extent = places[100], np.array([0.0, 0.3, 0.0]), 15.0
    field = hn.ShapeField.at_point(base, shift, extent=extent).along_surface(net)
    fields = hn.ShapeFields([field], mirrored=True)
    np.testing.assert_allclose(fields.at([base])[0], [shift], atol=1e-12)
    gradients = hn.ShapeFields([field]).at(hn.FieldPlaces(places))[1]
    # The steepest slope of the falloff 0.5 is 2.
    assert np.linalg.norm(gradients, axis=(1, 2)).max() < 1.05 * 2.0 * 0.3 / extent
    # Where they are straight, both ways of measuring agree.
    straight = hn.ShapeFields([hn.ShapeField.at_point(base, shift, extent=extent)], mirrored=True)
    near = np.linalg.norm(places - base, axis=1) < 0.2 * extent
    np.testing.assert_allclose(fields.at(places)[0][near], straight.at(places)[0][near], atol=0.01)


def test_a_curve_becomes_another_along_the_surface():
    surface = surface_of_sample("coaster")
    crease = max(hn.crease_curves(surface), key=lambda c: hn.FieldCurve.of_crease(c).length)
    curve = hn.FieldCurve.of_crease(crease)
    lengths = np.linspace(0.0, curve.length, 200)
    other = hn.FieldCurve(
        curve.points_at(lengths)
        + np.outer(np.sin(np.pi * lengths / curve.length) ** 2, (0, 0, 0.3))
    )
    net = hn.GeodesicNet(surface, mirrored=True)
    field = hn.ShapeField.to_curve(curve, other, extent=3.0).along_surface(net)
    on_it = curve.points_at(lengths[[50, 100, 150]])
    found = hn.ShapeFields([field]).at(on_it)[0]
    straight = hn.ShapeFields([hn.ShapeField.to_curve(curve, other, extent=3.0)]).at(on_it)[0]
    np.testing.assert_allclose(found, straight, atol=1e-9)
    assert straight[1, 2] == pytest.approx(0.3, abs=0.01)
