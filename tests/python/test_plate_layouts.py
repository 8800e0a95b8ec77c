# SPDX-License-Identifier: GPL-3.0-or-later
"""Plates of any shape settle, whatever triangles their seams leave; plates across the centre plane;
seams by rules."""

import hull_native as hn
import numpy as np
import pytest
from hull_native import surface_areas
from plate_hulls import grid_surface, sphere, through
from plate_shells import coaster_shell
from production_hulls import body_of


def ratio(flat):
    least, largest = flat.stretch
    return largest / least


def bilge(bulge, parts=16, rows=12, radius=1.5, length=12.0):
    """A quarter circle along x whose radius grows by `bulge` amidships."""
    a = np.linspace(0.0, np.pi / 2, parts + 1)
    x = np.linspace(0.0, length, rows + 1)
    r = radius + bulge * np.sin(np.pi * x / length)
    points = np.stack(
        [
            np.broadcast_to(x[:, None], (rows + 1, parts + 1)),
            -r[:, None] * np.cos(a),
            -r[:, None] * np.sin(a),
        ],
        axis=-1,
    )
    points = through(points)
    return grid_surface(through(points.swapaxes(0, 1)).swapaxes(0, 1)[:, ::-1])


@pytest.fixture(scope="module")
def coaster_plates():
    return hn.plates(*coaster_shell())


def test_plates_of_a_coaster_settle(coaster_plates):
    """Those at the forefoot are pointed, and seams leave thin triangles there."""
    flats = [p.flat() for p in coaster_plates]
    told = [(k + 1, f.stretch, f.stretch_error) for k, f in enumerate(flats) if not f.converged]
    assert not told
    assert max(ratio(f) for f in flats) < 1.005


def test_other_triangles_have_the_same_stretch(coaster_plates):
    """The most pointed plate with half the size of triangles, and seams ten times as fine."""
    areas = np.array([p.area for p in coaster_plates])
    ratios = {}
    finer = hn.plates(*coaster_shell(1e-4), size=0.2)
    for number in np.argsort(areas)[:3]:
        plate = coaster_plates[number]
        near = min(finer, key=lambda p: np.linalg.norm(p.centre - plate.centre))
        # The seams' chords are 1 mm off at most.
        assert near.area == pytest.approx(plate.area, rel=5e-3)
        one_flat, other = plate.flat(), near.flat()
        ratios[int(number)] = ratio(one_flat), ratio(other)
        allowed = 2.0 * (one_flat.stretch_error + other.stretch_error) + 5e-4
        assert ratio(one_flat) == pytest.approx(ratio(other), abs=allowed), ratios


@pytest.mark.one_in(2)
@pytest.mark.parametrize("bulge", [1e-3, 1e-2])
def test_bilges_have_no_stretch_of_the_elements_own(bulge):
    """All but developable: over the breadth b Gauss's curvature K of the bulge takes K b² / 8 of
    stretch, that of a long strip, and the rest is no more than the error that is told of the least
    and the largest. Elements on triangles told 1 % whatever the bulge, and so did splines of
    which two coarse grids missed the ends of the arc alike."""
    (plate,) = hn.plates(bilge(bulge), [])
    flat = plate.flat()
    assert flat.converged
    curvature = bulge * (np.pi / 12.0) ** 2 / 1.5
    breadth = 1.5 * np.pi / 2
    least = 0.125 * curvature * breadth**2
    assert least < ratio(flat) - 1.0 < 1.1 * least + 2.0 * flat.stretch_error


def test_half_a_cap_across_the_centre():
    """One plate with its mirror image where it is smooth there, as near to Milnor's bound as the
    whole one; else two, and by how much they are bent is told."""
    alpha, parts = 0.35, 56
    whole = np.asarray(sphere(parts=parts).mesh.points).reshape(parts + 1, parts + 1, 3)
    # y rises along the second axis.
    whole = whole if whole[0, 0, 1] < whole[0, -1, 1] - 1.0 else whole.swapaxes(0, 1)
    half = whole[:, parts // 2 :].copy()
    half[:, 0, 1] = 0.0
    knuckled = grid_surface(half)
    half[:, 0, 2] = half[:, 1, 2]
    caps = {}
    for name, surface in (("smooth", grid_surface(half)), ("knuckled", knuckled)):
        seam = hn.HullCurves(surface, 1e-5).in_plane(
            hn.plane_across("z", 10.0 * np.cos(alpha)), "edge"
        )
        for largest in (0.5, 5.0):
            plates = hn.plates(
                surface, seam, size=10.0 * alpha / 12, across_centre=True,
                largest_knuckle=np.radians(largest),
            )  # fmt: skip
            caps[name, largest] = max(plates, key=lambda p: p.centre[2])
    assert [caps[key].across for key in sorted(caps)] == [False, True, True, True]
    assert caps["smooth", 0.5].centre_knuckle < np.radians(0.5)
    # A border has no curvature across it, so that the slope there is that of the control points:
    # of those at angles of 0 and h it is h / 2.
    knuckle, h = caps["knuckled", 0.5].centre_knuckle, 0.7 * 2.0 / parts
    assert knuckle == pytest.approx(2.0 * h / 2.0, rel=0.05)
    flat = caps["smooth", 0.5].flat()
    bound = alpha / np.sin(alpha)
    assert flat.converged and bound <= ratio(flat) <= 1.02 * bound
    exact = 200.0 * np.pi * (1.0 - np.cos(alpha))
    # The surface is off the sphere beside the centre plane by 2 mm of 10 m.
    assert caps["smooth", 0.5].area == pytest.approx(exact, rel=1e-3)


@pytest.mark.parametrize("share", [0.0, 0.5, 2.0])
def test_plates_end_in_the_centre_plane_as_all_else_does(share):
    """What is on the centre plane is told by the tolerance of the whole program."""
    parts = 24
    half = np.asarray(sphere(parts=parts).mesh.points).reshape(parts + 1, parts + 1, 3)
    half = half if half[0, 0, 1] < half[0, -1, 1] - 1.0 else half.swapaxes(0, 1)
    half = half[:, parts // 2 :].copy()
    half[:, 0, 2] = half[:, 1, 2]
    half[:, 0, 1] = 0.0
    half[:, 0, 1] = share * hn.tolerances.ON_CENTRE_PLANE * grid_surface(half).mesh.size
    surface = grid_surface(half)
    seam = hn.HullCurves(surface, 1e-5).in_plane(hn.plane_across("z", 10.0 * np.cos(0.35)), "edge")
    plates = hn.plates(surface, seam, size=0.6, across_centre=True)
    assert max(plates, key=lambda p: p.centre[2]).across == (share < 1.0)


def test_keel_plates_of_the_coaster_are_one():
    """From seam to seam, with frames across and areas that sum to both sides."""
    _, body = body_of("coaster")
    rules = [hn.SeamRule("strakes", 2.4), hn.SeamRule("butts", 12.0)]
    curves, seams = hn.seams_by_rules(body.surface, rules)
    plates = hn.plates(body.surface, seams, across_centre=True)
    across = [p for p in plates if p.across]
    assert len(across) >= 4
    listed = hn.plate_list(across[2:3], thickness=0.01, mirrored=True)
    assert listed[0].name == "P1" and not listed[0].is_pair
    whole = surface_areas(body.surface).areas.sum()
    both = sum(p.area * (1.0 if p.across else 2.0) for p in plates)
    assert both == pytest.approx(2.0 * whole, rel=1e-9)
    plate = across[2]
    middle = 0.5 * (plate.box[0][0] + plate.box[1][0])
    frame = curves.in_plane(hn.plane_across("x", middle), "frame")
    flat = plate.flat()
    marks = [mark for curve in frame for mark in flat.marks(curve)]
    assert len(marks) == 1
    line, on_hull = marks[0]
    assert on_hull[0, 1] == pytest.approx(-on_hull[-1, 1], abs=1e-9)
    # The mark is symmetric about the axis, square to it in its middle.
    assert np.linalg.norm(line[0] - line[-1]) == pytest.approx(
        np.linalg.norm(on_hull[0] - on_hull[-1]), rel=2e-2
    )


def test_rules_follow_the_hull():
    """The same rules on the hull and on one that is twice as large, with doubled numbers."""
    _, body = body_of("coaster")
    surface = body.surface
    large = hn.LimitSurface(surface.mesh.with_points(2.0 * surface.mesh.points), surface.scheme)
    counts = []
    for hull, factor in ((surface, 1.0), (large, 2.0)):
        rules = [
            hn.SeamRule("from_deck", 2.0 * factor),
            hn.SeamRule("from_centre", 1.5 * factor),
            hn.SeamRule("station", 30.0 * factor),
            hn.SeamRule("butts", 20.0 * factor),
        ]
        _, seams = hn.seams_by_rules(hull, rules, tolerance=2e-3 * factor)
        plates = hn.plates(hull, seams)
        counts.append([p.area / factor**2 for p in plates])
    assert len(counts[0]) > 8
    assert counts[1] == pytest.approx(counts[0], rel=1e-6)


def test_rules_off_the_hull_have_their_sentence():
    _, body = body_of("coaster")
    for rule in (
        hn.SeamRule("waterline", 300.0),
        hn.SeamRule("from_deck", 90.0),
        hn.SeamRule("station", -50.0),
        hn.SeamRule("projected", line=np.array([[0.0, 9.0, 90.0], [9.0, 9.0, 90.0]])),
    ):
        with pytest.raises(ValueError, match="Nothing of the hull is met by the rule"):
            hn.seams_by_rules(body.surface, [rule])
    with pytest.raises(ValueError, match="must be above 0 m"):
        hn.SeamRule("strakes", 0.0)
    with pytest.raises(ValueError, match="give a line"):
        hn.SeamRule("projected")
    with pytest.raises(ValueError, match="There are no seams by"):
        hn.SeamRule("magic", 1.0)
