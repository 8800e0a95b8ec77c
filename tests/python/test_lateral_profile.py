# SPDX-License-Identifier: GPL-3.0-or-later
"""Areas that water and wind meet from the side: closed forms, the border and lines as another way,
and what is joined to a hull counted once."""

import math

import hull_native as hn
import numpy as np
import pytest
from test_appendages import DEPTH, LENGTH, box_body, box_hull
from test_demihull_layouts import whole
from transformation_hulls import Sample

DRAFT = 1.2


def parts(found):
    """(area, x, z) below and above the water."""
    return [(one.area, one.centre[0], one.centre[2]) for one in (found.below, found.above)]


def close(found, wanted, rel=1e-9):
    for part, (area, x, z) in zip(parts(found), wanted):
        assert part[0] == pytest.approx(area, rel=rel)
        assert part[1:] == pytest.approx((x, z), rel=rel, abs=1e-9)


def polygon(points):
    """(area, x, z) of a polygon (n, 2), counter-clockwise, by its corners."""
    x, z = np.asarray(points, dtype=float).T
    x2, z2 = np.roll(x, -1), np.roll(z, -1)
    cross = x * z2 - x2 * z
    area = cross.sum() / 2
    return area, ((x + x2) * cross).sum() / (6 * area), ((z + z2) * cross).sum() / (6 * area)


def summed(*signed):
    """(area, x, z) of parts (sign, (area, x, z))."""
    area = sum(sign * part[0] for sign, part in signed)
    centre = (sum(sign * part[0] * part[k] for sign, part in signed) / area for k in (1, 2))
    return area, *centre


def test_a_barge_upright():
    _, body = box_hull()
    dry = DEPTH - DRAFT
    wanted = [(LENGTH * DRAFT, 5.0, 0.6), (LENGTH * dry, 5.0, DRAFT + dry / 2)]
    close(hn.lateral_profile(body, draft=DRAFT), wanted)
    found = hn.hydrostatics(body, draft=DRAFT, length_pp=LENGTH)
    assert (found.lateral_area, found.lateral_x, found.lateral_z) == pytest.approx(wanted[0])
    assert (found.wind_area, found.wind_x, found.wind_z) == pytest.approx(wanted[1])


@pytest.mark.parametrize("trim", [0.05, -0.2])
def test_a_barge_trimmed(trim):
    """Two trapezoids of water that falls by tan(trim) from aft."""
    _, body = box_hull()
    sides = [DRAFT + math.tan(trim) * 5.0, DRAFT - math.tan(trim) * 5.0]
    water = [(0, sides[0]), (LENGTH, sides[1])]
    below = polygon([(0, 0), (LENGTH, 0), water[1], water[0]])
    above = polygon([water[0], water[1], (LENGTH, DEPTH), (0, DEPTH)])
    close(hn.lateral_profile(body, draft=DRAFT, trim=trim, draft_at=5.0), [below, above])


def test_nothing_is_above_a_ship_under_water():
    _, body = box_hull()
    found = hn.lateral_profile(body, draft=2 * DEPTH)
    assert parts(found)[1] == (0.0, 0.0, 0.0)
    assert found.below.area == pytest.approx(LENGTH * DEPTH, rel=1e-12)
    dry = hn.lateral_profile(body, draft=-1.0)
    assert dry.below.area == 0.0 and dry.above.area == pytest.approx(LENGTH * DEPTH, rel=1e-12)


KEEL = {"root_chord": 2.0, "tip_chord": 2.0, "name": "keel"}


def test_a_fin_below_a_box_counts_once():
    """A rectangle of 2 m by 2.5 m, half a metre of it inside the box."""
    _, body = box_hull()
    body.join([hn.foil("0012", root=(6.0, 0, 0.5), tip=(6.0, 0, -2.0), **KEEL)])
    below = summed((1, (LENGTH * DRAFT, 5.0, DRAFT / 2)), (1, (4.0, 5.0, -1.0)))
    dry = DEPTH - DRAFT
    close(hn.lateral_profile(body, draft=DRAFT), [below, (LENGTH * dry, 5.0, DRAFT + dry / 2)])
    assert hn.hydrostatics(body, draft=DRAFT).lateral_area == pytest.approx(below[0], rel=1e-9)


def test_a_box_keel_of_the_same_mesh():
    """Two boxes that overlap: added up as they are, counted once where they are joined."""
    ends = ((0, -2, 0), (10, 2, 3)), ((3, -0.5, -1), (7, 0.5, 1))
    surface, body = box_body(*ends)
    box, keel = (LENGTH * DRAFT, 5.0, DRAFT / 2), (4.0 * 2.0, 5.0, 0.0)
    above = (LENGTH * (DEPTH - DRAFT), 5.0, (DEPTH + DRAFT) / 2)
    close(hn.lateral_profile(body, draft=DRAFT), [summed((1, box), (1, keel)), above])
    body.join([])
    once = summed((1, box), (1, (4.0, 5.0, -0.5)))
    close(hn.lateral_profile(body, draft=DRAFT), [once, above])


def test_light_falls_through_a_tunnel_across_the_ship():
    """A circle of 1024 chords: 6e-6 of πr²."""
    _, body = box_hull()
    body.join([hn.cylinder((7, -3, 0.6), (7, 3, 0.6), radius=0.4, cut=True)])
    below = hn.lateral_profile(body, draft=DRAFT).below
    hole = math.pi * 0.4**2
    assert LENGTH * DRAFT - below.area == pytest.approx(hole, rel=1e-5)
    _, along = box_hull()
    along.join([hn.cylinder((-1, 0, 0.6), (3, 0, 0.6), radius=0.3, cut=True)])
    assert hn.lateral_profile(along, draft=DRAFT).below.area == pytest.approx(LENGTH * DRAFT)


def test_rudders_on_both_sides_and_a_mast():
    """What one hides of the other counts once; a mast above the deck meets the wind."""
    _, body = box_hull()
    rudder = hn.foil(
        "0012", root=(1.0, 1.2, 0.5), tip=(1.0, 1.2, -1.0), root_chord=0.8, tip_chord=0.8,
        mirrored=True,
    )  # fmt: skip
    mast = hn.cylinder((5, 0, 2.5), (5, 0, 9.0), radius=0.1)
    body.join([rudder, mast])
    found = hn.lateral_profile(body, draft=DRAFT)
    assert found.below.area == pytest.approx(LENGTH * DRAFT + 0.8, rel=1e-9)
    hull = (LENGTH * (DEPTH - DRAFT), 5.0, (DEPTH + DRAFT) / 2)
    above = summed((1, hull), (1, (0.2 * 6.0, 5.0, 6.0)))
    assert found.above.area == pytest.approx(above[0], rel=1e-5)
    assert found.above.centre[2] == pytest.approx(above[2], rel=1e-5)


def test_the_weather_criterion_has_what_is_joined():
    """A mast of 0.2 m by 6 m above the deck, in the wind; a fin below lowers the lever's foot."""
    _, body = box_hull()
    load = {"mass_t": LENGTH * 4.0 * DRAFT * 1.025, "centre_of_gravity": (5.0, 0.0, 1.0)}
    options = {"midship": 5.0, "roll_period": 6.0}
    before = hn.weather_criterion(body, **load, **options)
    body.join([hn.cylinder((5, 0, 2.5), (5, 0, 9.0), radius=0.1)])
    after = hn.weather_criterion(body, **load, **options)
    assert after.wind_area - before.wind_area == pytest.approx(1.2, rel=1e-5)
    hull, mast = before.wind_area * (DRAFT + DEPTH) / 2, 1.2 * 6.0
    lever = (hull + mast) / after.wind_area - DRAFT / 2
    assert after.wind_lever == pytest.approx(lever, rel=1e-5)


def test_a_half_with_a_keel_is_as_its_whole():
    """Of a half the border encloses the profile, of a whole the section of the centre plane."""
    sample, surface = Sample("coaster"), whole("coaster")
    bodies = hn.HullBody(sample.surface, mirrored=True), hn.HullBody(surface, mirrored=False)
    found = []
    for body in bodies:
        body.join([hn.foil("0012", root=(9.0, 0, 4.0), tip=(8.0, 0, -2.0), root_chord=8.0,
                           tip_chord=5.0)])  # fmt: skip
        found.append(parts(hn.lateral_profile(body, draft=sample.ship.draft, trim=0.02)))
    np.testing.assert_allclose(found[0], found[1], rtol=1e-6)


class Border:
    """A half hull's border, seen from the side, by edges of a fine grid that only one face has."""

    def __init__(self, surface):
        net = surface.tessellate(32)
        quads = np.asarray(net.quads)
        sides = np.concatenate([quads[:, [i, (i + 1) % 4]] for i in range(4)])
        _, index, count = np.unique(
            np.sort(sides, axis=1), axis=0, return_index=True, return_counts=True
        )
        self.lines = np.asarray(net.points)[sides[index[count == 1]]][:, :, [0, 2]]

    def profile(self, water):
        """(area, x, z) below z = water(x) and above it: ∮ over the lines, cut there."""
        cut = [piece for line in self.lines for piece in split(line, water)]
        sums = [np.zeros(3), np.zeros(3)]
        for a, b in cut:
            middle = (a + b) / 2
            dry = middle[1] > water(middle[0])
            sums[int(dry)] += strip(a, b, water)
        return [(abs(area), mx / area, mz / area) for area, mx, mz in sums]

    def spans(self, x):
        """[(low, high), …] of what is inside at x."""
        a, b = self.lines[:, 0], self.lines[:, 1]
        over = (a[:, 0] < x) != (b[:, 0] < x)
        a, b = a[over], b[over]
        z = np.sort(a[:, 1] + (b[:, 1] - a[:, 1]) * (x - a[:, 0]) / (b[:, 0] - a[:, 0]))
        return list(zip(z[::2], z[1::2]))


def split(line, water):
    a, b = line
    at_a, at_b = (p[1] - water(p[0]) for p in line)
    if (at_a > 0.0) == (at_b > 0.0):
        return [(a, b)]
    middle = a + at_a / (at_a - at_b) * (b - a)
    return [(a, middle), (middle, b)]


def strip(a, b, water):
    """Area and moments between a line and the water, signed by the way it runs: Gauss' rule of two
    nodes, exact for them."""
    total = np.zeros(3)
    for node in (0.5 - math.sqrt(1 / 12), 0.5 + math.sqrt(1 / 12)):
        x, z = a + node * (b - a)
        level = water(x)
        height = (z - level) * (b[0] - a[0]) / 2
        total += height, height * x, height * (z + level) / 2
    return total


@pytest.mark.parametrize("name", ["coaster", "sailing_yacht"])
def test_a_sample_by_its_border(name):
    sample = Sample(name)
    assert sample.half
    draft, trim = sample.ship.draft, 0.01
    found = hn.lateral_profile(sample.body, draft=draft, trim=trim)
    wanted = Border(sample.surface).profile(lambda x: draft - math.tan(trim) * x)
    for part, (area, x, z) in zip(parts(found), wanted):
        assert part[0] == pytest.approx(area, rel=5e-6)
        assert part[1:] == pytest.approx((x, z), rel=2e-6)


def test_a_keel_below_a_sample_by_lines():
    """At many x the length of what hull or keel has, below the water."""
    sample = Sample("coaster")
    draft, border = sample.ship.draft, Border(sample.surface)
    body = hn.HullBody(sample.surface, mirrored=True)
    alone = hn.lateral_profile(body, draft=draft)
    low, high = sample.mesh.points[:, 2].min() - 2.0, draft - 1.0
    body.join([hn.foil("0012", root=(8.0, 0, high), tip=(7.0, 0, low), root_chord=9.0,
                       tip_chord=6.0)])  # fmt: skip
    found = hn.lateral_profile(body, draft=draft)
    assert found.above.area == pytest.approx(alone.above.area, rel=1e-12)
    x = np.linspace(-4.0, 9.0, 13001)
    gained = [keel_length(border, at, low, high) for at in x]
    area = np.trapezoid(gained, x) if hasattr(np, "trapezoid") else np.trapz(gained, x)
    assert found.below.area - alone.below.area == pytest.approx(area, rel=1e-4)
    assert 10.0 < area


def keel_length(border, x, low, high):
    """Of the trapezoid, leading edge from (8, high) to (7, low), trailing edge from (-1, high) to
    (1, low), at x outside of the hull."""
    bottom, top = low, high
    if x > 7.0:
        bottom = low + (high - low) * (x - 7.0)
    elif x < 1.0:
        bottom = low + (high - low) * (1.0 - x) / 2.0
    if bottom >= top:
        return 0.0
    inside = sum(max(0.0, min(top, end) - max(bottom, begin)) for begin, end in border.spans(x))
    return top - bottom - inside
