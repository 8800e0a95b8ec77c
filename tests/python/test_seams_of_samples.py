# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams by girth, by planes and by projection on doubly curved hulls: against the length of fine
chords along the surface's sections, and against those sections."""

import hull_native as hn
import numpy as np
import pytest
from hull_native.production.seam_rules import centre_line
from plate_hulls import one
from production_hulls import body_of

# Chords of a section so near to it, m, are shorter than it by a third of that times its curvature.
FINE = 1e-9
# Girths, m, and chord tolerances of the seams, m.
GIRTHS, TOLERANCES = (0.7, 1.5, 2.6), (1e-2, 1e-3)


def deck_edge(curves):
    return max(curves.borders(), key=lambda c: c.points[:, 1].mean())


def located(line, point):
    """(distance, length from the beginning) of a place on a polyline (k, d)."""
    steps = np.diff(line, axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    share = np.sum((point - line[:-1]) * steps, axis=1) / np.maximum(lengths**2, 1e-300)
    share = np.clip(share, 0.0, 1.0)
    off = np.linalg.norm(line[:-1] + share[:, None] * steps - point, axis=1)
    k = int(off.argmin())
    return off[k], lengths[:k].sum() + share[k] * lengths[k]


def girth_to(surface, base, point):
    """The length of the section at a point from its end on the border `base`, m."""
    found = []
    for curve in hn.section(surface, "x", point[0], FINE):
        off, from_first = located(curve.points, point)
        if off > 1e-6:
            continue
        whole = np.linalg.norm(np.diff(curve.points, axis=0), axis=1).sum()
        ends = ((0, from_first), (-1, whole - from_first))
        found += [(located(base.points, curve.points[k])[0], girth) for k, girth in ends]
    return min(found)[1]


@pytest.mark.parametrize(
    "name, base_of, towards",
    [
        ("coaster", centre_line, (0, 1, 0)),
        ("coaster", deck_edge, (0, 0, -1)),
        ("catamaran", deck_edge, (0, 0, -1)),
    ],
)
def test_seams_at_girths(name, base_of, towards):
    """Above the base's own points lengths are of the fourth order in the chords: of the second in
    the tolerance, and 2e-7 of the girth at most were found at 10 mm. Between these the seam is
    within the tolerance."""
    _, body = body_of(name)
    surface, worst = body.surface, []
    for tolerance in TOLERANCES:
        curves, off = hn.HullCurves(surface, tolerance), 0.0
        base = base_of(curves)
        for girth in GIRTHS:
            points = np.vstack([c.points for c in curves.at_girth(base, girth, towards=towards)])
            # In the plane of a transom sections are its border.
            points = points[points[:, 0] > base.points[:, 0].min() + 1e-6]
            of_base = np.abs(points[:, :1] - base.points[:, 0]).min(axis=1) < 1e-10
            assert of_base.sum() > 15
            for k, point in enumerate(points):
                if of_base[k]:
                    off = max(off, abs(girth_to(surface, base, point) / girth - 1.0))
            between = np.flatnonzero(~of_base)
            for k in between[:: max(1, len(between) // 12)]:
                assert abs(girth_to(surface, base, points[k]) - girth) < tolerance
        worst.append(off)
    assert worst[0] < 1e-6 and worst[1] < worst[0] / 20.0, worst


@pytest.mark.parametrize("name", ["coaster", "catamaran", "naval_vessel"])
@pytest.mark.parametrize("plane", [[1.0, 0.0, 0.0, 0.31], [0.2, 0.1, 1.0, 0.45]])
def test_seams_in_planes(name, plane):
    """Points in the plane and on the surface, steps within the chord tolerance of it, and all of
    the section is there, the plane lying at a part of the hull's extent across it."""
    _, body = body_of(name)
    surface, tolerance = body.surface, 2e-3
    normal = np.array(plane[:3]) / np.linalg.norm(plane[:3])
    heights = surface.positions(
        np.arange(surface.cell_count), np.full((surface.cell_count, 2), 0.5)
    )
    heights = heights @ normal
    position = heights.min() + plane[3] * np.ptp(heights)
    seams = hn.HullCurves(surface, tolerance).in_plane([*normal, position], "seam")
    tree, length, fine = hn.SurfaceTree(surface), 0.0, 0.0
    for seam in seams:
        on = (
            surface.evaluate(seam.cells, seam.starts)[0],
            surface.evaluate(seam.cells, seam.ends)[0],
        )
        assert np.abs(seam.points[:-1] - on[0]).max() < 1e-9
        assert np.abs(seam.points[1:] - on[1]).max() < 1e-9
        assert np.abs(seam.points @ normal - position).max() < 1e-9
        middles = 0.5 * (seam.points[1:] + seam.points[:-1])
        assert tree.closest_points(middles).distances.max() < tolerance
        length += np.linalg.norm(np.diff(seam.points, axis=0), axis=1).sum()
    for curve in hn.section(surface, normal, position, 1e-6):
        fine += np.linalg.norm(np.diff(curve.points, axis=0), axis=1).sum()
    # Chords are shorter by a third of tolerance times curvature in the mean.
    assert 0.0 <= fine - length < 1e-3 * fine


def test_a_seam_by_projection():
    """A line over the coaster's bulb and bow, seen from port: points lie on it from there, on the
    surface, and where nothing of the section is further out."""
    _, body = body_of("coaster")
    surface, tolerance = body.surface, 1e-3
    line = np.array([[55.0, 30.0, 4.5], [78.0, 30.0, 3.0], [86.0, 30.0, 2.2]])
    curves = hn.HullCurves(surface, tolerance)
    seam = one(curves.projected(line, direction=(0, -1, 0), name="seam"))
    assert seam.points[0, 0] == pytest.approx(55.0, abs=1e-9) and seam.points[-1, 0] > 80.0
    on = surface.evaluate(seam.cells, seam.ends)[0]
    assert np.abs(seam.points[1:] - on).max() < 1e-9
    heights = np.interp(seam.points[:, 0], line[:, 0], line[:, 2])
    assert np.abs(seam.points[:, 2] - heights).max() < tolerance
    # The ends of its chords on the line are there to rounding; those on cells' borders are not.
    assert (np.abs(seam.points[:, 2] - heights) < 1e-9).sum() > 20
    for point in seam.points[1:-1:3]:
        breadths = []
        for curve in hn.section(surface, "x", point[0], 1e-6):
            y, z = curve.points[:, 1:].T
            k = np.flatnonzero((z[:-1] - point[2]) * (z[1:] - point[2]) <= 0.0)
            share = (point[2] - z[k]) / np.where(z[k + 1] == z[k], 1.0, z[k + 1] - z[k])
            breadths += list(y[k] + share * (y[k + 1] - y[k]))
        assert point[1] == pytest.approx(max(breadths), abs=1e-4)


@pytest.mark.parametrize("name", ["coaster", "catamaran", "naval_vessel"])
def test_girths_of_the_frame_table(name):
    """Against sections of fine chords: less by a third of the chords' tolerance times the angle by
    which the section turns, at most."""
    _, body = body_of(name)
    surface = body.surface
    low, high = surface.mesh.points[:, 0].min(), surface.mesh.points[:, 0].max()
    table = hn.frame_table([(0, 12, (high - low) / 13.0)])
    tolerance, compared = 1e-5 * surface.mesh.size, 0
    for row in hn.frame_rows(table, surface, mirrored=True):
        curves = hn.section(surface, "x", row["x_m"], FINE)
        exact = 2.0 * sum(np.linalg.norm(np.diff(c.points, axis=0), axis=1).sum() for c in curves)
        ways = [np.diff(c.points[:, 1:], axis=0) for c in curves]
        angles = [np.unwrap(np.arctan2(way[:, 1], way[:, 0])) for way in ways]
        turned = 2.0 * sum(np.abs(np.diff(one)).sum() for one in angles)
        assert -1e-8 < exact - row["girth_m"] < tolerance * turned / 3.0 + 1e-8
        compared += row["girth_m"] > 1.0
    assert compared >= 10
