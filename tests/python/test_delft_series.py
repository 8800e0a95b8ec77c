# SPDX-License-Identifier: GPL-3.0-or-later
"""The Delft series' regressions against tank tests of the series' first model, and the yachts YD-40
and YD-41 of Larsson, Eliasson & Orych's book."""

import dataclasses
import math

import hull_native as hn
import numpy as np
import pytest
from test_appendages import box_body
from transformation_hulls import Sample

# Sysser 1, the parent of the series: particulars and upright resistance of the bare model, N, as
# the series' database has them; fresh water of about 20 °C.
PARENT = hn.DelftYacht(
    length=1.6,
    beam=0.5072,
    draft=0.12704,
    volume=0.0376136,
    waterplane_area=0.558566,
    wetted_surface=0.642534,
    prismatic=0.5644,
    midship=0.646,
    lcb=0.53664 * 1.6,
    lcf=0.55328 * 1.6,
)
TANK = {"water_density": 0.9982, "viscosity": 1.004e-6}
MEASURED = [
    (0.594, 0.616414), (0.792, 1.1084), (0.990, 1.88482), (1.189, 3.01934), (1.387, 4.75255),
    (1.585, 9.79318), (1.783, 19.4122), (1.981, 32.7027), (2.179, 44.5576), (2.377, 51.149),
]  # fmt: skip
# Half loaded; waterplane and centre of flotation the book does not give.
YD40 = hn.DelftYacht(
    length=10.02,
    beam=3.17,
    draft=0.57,
    volume=7.63,
    waterplane_area=22.0,
    wetted_surface=25.2,
    prismatic=0.56,
    midship=0.75,
    lcb=0.535 * 10.02,
    lcf=0.55 * 10.02,
)
KEEL = hn.DelftFin(4.4, 1.45, thickness=0.1, volume=0.25, total_draft=2.07, centre=0.7)
# Half loaded, as the fifth edition of the book has her in its Appendix 1: LCB 4.2 %, LCF 7.3 %
# abaft the middle. The keel's centre of buoyancy is not printed; `centre` is a guess.
YD41 = hn.DelftYacht(
    length=11.90,
    beam=3.18,
    draft=0.40,
    volume=6.05,
    waterplane_area=26.75,
    wetted_surface=28.20,
    prismatic=0.56,
    midship=0.715,
    lcb=0.542 * 11.90,
    lcf=0.573 * 11.90,
)
YD41_KEEL = hn.DelftFin(3.4, 0.89, volume=0.275, total_draft=2.30, centre=1.4)
BOOK = {"water_density": 1.025, "gravity": 9.81, "viscosity": 1.004e-6}
# Half a unit of the last digit that is printed.
ROUNDING = {
    "length": 0.005, "beam": 0.005, "draft": 0.005, "volume": 0.005, "waterplane_area": 0.005,
    "wetted_surface": 0.005, "prismatic": 0.005, "midship": 0.0005, "lcb": 0.0005 * 11.9,
    "lcf": 0.0005 * 11.9,
}  # fmt: skip


def yd41_at(froude, yacht=YD41, **how):
    speed = froude * math.sqrt(9.81 * yacht.length)
    return hn.delft(yacht, [speed], keel=YD41_KEEL, **BOOK, **how)[0]


def test_published_yacht():
    """Figures 5.8, 5.18, 5.22 and 5.23 of the book: at Fn = 0.35, 3.78 m/s, friction 512.7 N,
    residuary resistance 394.9 N; at 20° of heel 33 N more of the canoe body's and 134 N of the
    keel's, whose coefficient is 1.13."""
    friction = hn.delft(YD41, [3.78], **BOOK)[0].friction
    assert round(1e3 * friction, 1) == 512.7
    found = yd41_at(0.35, heel_deg=20.0)
    assert round(1e3 * found.heeled_residuary) == 33
    assert round(1e3 * found.heeled_keel) == 134
    weight = 0.275 * 1.025 * 9.81
    assert round(found.heeled_keel / (weight * 0.35**2 * math.radians(20.0)), 2) == 1.13


def moved_particulars(share):
    """The yacht with each particular moved by a share of half a unit of its last digit, to less
    residuary resistance."""
    found, moved = yd41_at(0.35).residuary, {}
    for name, half in ROUNDING.items():
        more = getattr(YD41, name) + half
        falls = yd41_at(0.35, dataclasses.replace(YD41, **{name: more})).residuary < found
        moved[name] = getattr(YD41, name) + (share if falls else -share) * half
    return dataclasses.replace(YD41, **moved)


def test_published_yacht_s_residuary_resistance():
    """394.9 N, which is that of particulars that round to those printed: each moved by 0.07 of half
    a unit. With LCB, LCF, volume and dimensions alone that is no more than a third of one."""
    newton = [1e3 * yd41_at(0.35, moved_particulars(share)).residuary for share in (0.0, 0.07, 1.0)]
    assert round(newton[1], 1) == 394.9
    assert newton[2] < 394.9 < newton[0] < 394.9 * (1.0 + 1.1e-3)
    known = dataclasses.replace(moved_particulars(1.0 / 3.0), prismatic=YD41.prismatic)
    assert 1e3 * yd41_at(0.35, known).residuary < 394.9
    assert not yd41_at(0.35).outside


def test_published_yacht_s_keel():
    """Figure 5.19: 0.01406 and 39 N. Where the keel's centre lies is not printed: that 1.40 m below
    the hull, as of a bulb keel, gives both shows no more than that one place does."""
    keel = yd41_at(0.35).keel_residuary
    assert round(1e3 * keel) == 39
    assert keel / (0.275 * 1.025 * 9.81) == pytest.approx(0.01406, rel=5e-4)


def test_parent_in_the_tank():
    """Within 5 % from Fn 0.15 to 0.6: the scatter of the regression, which has many models."""
    for found, (speed, newton) in zip(hn.delft(PARENT, [v for v, _ in MEASURED], **TANK), MEASURED):
        assert found.speed == speed
        assert 1000.0 * found.total == pytest.approx(newton, rel=0.05)
        assert not [text for text in found.outside if "Froude" not in text]


def test_friction_of_the_yacht():
    """Page 64: 408.6 N at 3.5 m/s on 10 m and 25.2 m²."""
    yacht = dataclasses.replace(YD40, length=10.0)
    found = hn.delft(yacht, [3.5], water_density=1.025, viscosity=1.004e-6)[0]
    assert 1000.0 * found.friction == pytest.approx(408.6, rel=1e-3)


def test_values_at_the_tables_froude_numbers():
    """At these the formula is the polynomial with the table's own row, written out."""
    y, g = YD40, hn.GRAVITY
    speed = 0.35 * math.sqrt(g * y.length)
    found = hn.delft(y, [speed], heel_deg=20.0, keel=KEEL, water_density=1.025)[0]
    third = y.volume ** (1 / 3)
    light = third * third
    own = 0.0032 + third / y.length * (
        -0.1011 * 0.535 - 0.0813 * 0.56 - 0.0382 * light / 22.0 + 0.0320 * 3.17 / 10.02
        - 0.1481 * light / 25.2 + 0.0837 * 0.535 / 0.55 + 0.0223 * 0.535**2 + 0.1587 * 0.56**2
    )  # fmt: skip
    assert found.residuary == pytest.approx(7.63 * 1.025 * g * own, rel=1e-12)
    keel = -0.00713 + 0.02632 * 2.07 / 3.17 - 0.00232 * (0.57 + 0.7) / 0.25 ** (1 / 3)
    keel += 0.00039 * 7.63 / 0.25
    assert found.keel_residuary == pytest.approx(0.25 * 1.025 * g * keel, rel=1e-12)
    broad = 3.17 / 0.57
    heel = (
        1.6433 - 0.2144 * 10.02 / 3.17 - 0.1640 * broad + 0.0199 * broad**2
        - 0.0540 * -3.5 - 0.0268 * 3.5**2
    )  # fmt: skip
    turned = 6.0 * math.radians(20.0) ** 1.7
    assert found.heeled_residuary == pytest.approx(
        7.63 * 1.025 * g * 1e-3 * heel * turned, rel=1e-9
    )
    surface = 0.01 * (1.850 - 1.200 * broad - 0.109 * broad**2 + 5.364 * 0.75)
    assert found.heeled_friction == pytest.approx(surface * found.friction, rel=1e-12)
    factor = -3.5837 * 0.57 / 2.07 - 0.0518 * broad + 0.5958 * 3.17 / 2.07
    factor += 0.2055 * y.length / third
    turned = 0.35**2 * math.radians(20.0)
    assert found.heeled_keel == pytest.approx(0.25 * 1.025 * g * factor * turned, rel=1e-12)
    parts = dataclasses.astuple(found)[2:10]
    assert found.total == pytest.approx(sum(parts), rel=1e-14)
    assert found.effective_power == found.total * speed


def test_heel_adds_what_it_should():
    """With the centre of buoyancy in per cent, 20° add to the parent's residuary resistance at
    every Froude number from 0.3; with fractions they would lessen it by half at 0.45."""
    speeds = [fn * math.sqrt(hn.GRAVITY * 1.6) for fn in np.linspace(0.3, 0.55, 26)]
    for found in hn.delft(PARENT, speeds, heel_deg=20.0, **TANK):
        assert 0.0 < found.heeled_residuary < 0.35 * found.residuary
    upright = hn.delft(PARENT, speeds, **TANK)
    assert all(f.heeled_residuary == f.heeled_friction == f.heeled_keel == 0.0 for f in upright)


def test_smooth_between_the_tables_numbers():
    """No jumps: values fifty times as dense change by less than a tenth of a step of the table."""
    speeds = np.linspace(0.1, 0.6, 501) * math.sqrt(hn.GRAVITY * YD40.length)
    values = np.array([f.residuary for f in hn.delft(YD40, speeds)])
    slopes = np.diff(values)
    assert np.abs(np.diff(slopes)).max() < 0.12 * np.abs(slopes).max()


def test_sizes_by_froude_s_law():
    """Residuary resistance of a yacht λ times as long at the same Froude number is λ³ of it."""
    large = hn.DelftYacht(
        *(16.0, 5.072, 1.2704, 37.6136, 55.8566, 64.2534, 0.5644, 0.646, 8.58624, 8.85248)
    )
    small = hn.delft(PARENT, [1.4])[0].residuary
    found = hn.delft(large, [1.4 * math.sqrt(10.0)])[0].residuary
    assert found == pytest.approx(1000.0 * small, rel=1e-12)


def test_outside_is_told():
    wide = dataclasses.replace(YD40, beam=5.0, prismatic=0.7)
    found = hn.delft(wide, [8.0], heel_deg=10.0)[0]
    assert [text.split(" 0.")[0].split(" 2")[0] for text in found.outside] == [
        "Froude number", "length to beam", "prismatic coefficient", "Froude number heeled",
    ]  # fmt: skip


def test_exact_hull():
    """The sample yacht's canoe body: what hydrostatics say, and another value for one of it."""
    sample = Sample("sailing_yacht")
    draft = sample.ship.draft
    yacht = hn.delft_yacht(sample.body, draft=draft)
    water = hn.hydrostatics(sample.body, draft=draft)
    assert yacht.volume == water.displaced_volume and yacht.length == water.waterline_length
    middle = 0.5 * (water.waterline_forward + water.waterline_aft)
    assert yacht.lcb_percent == pytest.approx(100 * (water.lcb - middle) / yacht.length, abs=1e-12)
    given = hn.delft_yacht(sample.body, draft=draft, volume=6.0, midship=0.7)
    assert (given.volume, given.midship, given.beam) == (6.0, 0.7, yacht.beam)
    rows = hn.delft_table(given, [2.0, 3.0], heel_deg=15.0, keel=KEEL, rudder=KEEL)
    for row, found in zip(rows, hn.delft(given, [2.0, 3.0], heel_deg=15, keel=KEEL, rudder=KEEL)):
        assert row["total_kN"] == found.total
        parts = [row[f"{name}_kN"] for name in ("friction", "residuary", "keel", "rudder", "heel")]
        assert sum(parts) == pytest.approx(found.total, rel=1e-14)
    assert hn.resistance_csv(rows).count("\n") == 3


@pytest.mark.parametrize("name, is_told", [("catamaran", True), ("sailing_yacht", False)])
def test_hulls_beside_one_another_are_told(name, is_told):
    sample = Sample(name)
    yacht = hn.delft_yacht(sample.body, draft=sample.ship.draft)
    (found,) = hn.delft(yacht, [3.0])
    assert any("beside one another" in text for text in found.outside) == is_told


@pytest.mark.parametrize(
    "make, said",
    [
        (lambda: dataclasses.replace(YD40, volume=0.0), "volume must be above zero"),
        (lambda: dataclasses.replace(YD40, lcb=11.0), "lcb must lie on the waterline"),
        (lambda: hn.DelftFin(4.4, 1.45, volume=0.2), "volume, total_draft and centre together"),
        (lambda: hn.delft(YD40, [0.0]), "speed must be a number above zero"),
        (lambda: hn.delft(YD40, [3.0], heel_deg=40.0), "heel must be up to 35"),
        (lambda: hn.delft(YD40, [3.0], viscosity=-1.0), "viscosity must be a number above zero"),
        (lambda: hn.delft_yacht(Sample("coaster").body, draft=-1.0), "out of the water"),
        (lambda: hn.delft_yacht(Sample("coaster").body, draft=5.0, breadth=1), "no field"),
    ],
)
def test_what_is_refused(make, said):
    with pytest.raises(ValueError, match=said):
        make()


def canoe_and_fins():
    """(body, fins): a box with a fin, its bulb, a rudder, a shaft and a tunnel."""
    _, body = box_body(((0.0, -1.5, 0.0), (10.0, 1.5, 2.0)))
    fin = hn.foil("0012", (6.0, 0.0, 0.4), (6.0, 0.0, -1.6), 1.5, tip_chord=1.0, name="fin")
    bulb = hn.bulb("0012", (6.4, 0.0, -1.6), (4.6, 0.0, -1.6), 0.4, name="bulb")
    rudder = hn.foil("0015", (0.9, 0.0, 0.4), (0.9, 0.0, -1.1), 0.5, name="rudder")
    shaft = hn.cylinder((3.0, 0.0, 0.3), (2.0, 0.0, -0.4), 0.04, name="shaft")
    tunnel = hn.cylinder((9.0, -2.0, 0.4), (9.0, 2.0, 0.4), 0.1, name="tunnel", cut=True)
    body.join([fin, bulb, rudder, shaft, tunnel])
    return body


def test_fins_of_a_hull():
    """What lies in the after quarter is the rudder; volumes and areas by closed forms."""
    body = canoe_and_fins()
    fins = hn.delft_fins(body, draft=0.8)
    assert [fin.name for fin in fins.keels] == ["fin", "bulb"]
    assert [fin.name for fin in fins.rudders] == ["rudder"]
    assert fins.left_out == ("shaft", "tunnel")
    fin, bulb = fins.keels
    (rudder,) = fins.rudders
    # A fifth of the fin's span is within the hull, and chords shrink by a third.
    assert fin.chord == pytest.approx(1.5 - 0.5 * 0.6, rel=1e-9)
    assert (fin.thickness, rudder.thickness) == pytest.approx((0.12, 0.15), rel=1e-9)
    assert (bulb.chord, bulb.thickness) == pytest.approx((1.8, 0.4 / 1.8), rel=1e-9)
    assert (fin.total_draft, bulb.total_draft) == pytest.approx((2.4, 2.6), rel=1e-3)
    profile = hn.foil("0015", (0.0, 0.0, 0.0), (0.0, 0.0, -1.1), 0.5)
    assert rudder.volume == pytest.approx(profile.volume, rel=1e-7)
    assert rudder.centre == pytest.approx(0.55, rel=1e-6)
    # Both ends' sections: one at the hull that is covered, one below that is not.
    assert rudder.wetted_surface == pytest.approx(
        profile.area - 2.0 * profile.volume / 1.1, rel=1e-6
    )
    bare = hn.delft_yacht(body, draft=0.8)
    assert bare.volume == pytest.approx(24.0, rel=1e-9)
    assert hn.delft_fins(hn.HullBody(body.surface, mirrored=False), draft=0.8) == hn.DelftFins()


def test_several_keels_are_one():
    """Their friction adds up; their waves are those of one keel about their centre."""
    halves = [
        dataclasses.replace(KEEL, wetted_surface=2.2, volume=0.125, centre=z) for z in (0.6, 0.8)
    ]
    one, two = (hn.delft(YD40, [3.0], heel_deg=10.0, keel=keel)[0] for keel in (KEEL, halves))
    for name in ("keel_friction", "keel_residuary", "heeled_keel", "total"):
        assert getattr(one, name) == pytest.approx(getattr(two, name), rel=1e-12)
